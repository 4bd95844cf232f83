# SPDX-License-Identifier: Apache-2.0
"""Exceptions of the package. Each has one message, which names the file and what was expected."""
from __future__ import annotations

import difflib
import re
from typing import Any, Dict, Iterable


class ThawError(Exception):
    """Base class of all exceptions of this package."""


class FileError(ThawError):
    """A file or folder is missing, damaged, half written, or not of thaw. `path` names it."""

    def __init__(self, path: object, problem: str) -> None:
        self.path = str(path)
        super().__init__(f'{self.path}: {problem}')


class SceneError(ThawError, ValueError):
    """A scene is unusable. A line for each error: file, line, column, key and what was expected.

    file, line, column, message: of the first error; line and column are 0 without a place.
    errors: a dict of these four for each error.
    """

    def __init__(self, text: str = '') -> None:
        super().__init__(text)
        self.errors = [_placed(line) for line in text.splitlines()] or [_placed('')]
        self.file: str = self.errors[0]['file']
        self.line: int = self.errors[0]['line']
        self.column: int = self.errors[0]['column']
        self.message: str = self.errors[0]['message']


def _placed(text: str) -> Dict[str, Any]:
    """Splits `file:line:column: error: message`."""
    match = re.fullmatch(r'(?:(.*?)(?::(\d+):(\d+))?: )?error: (.*)', text)
    if not match:
        return {'file': '', 'line': 0, 'column': 0, 'message': text}
    return {
        'file': match[1] or '',
        'line': int(match[2] or 0),
        'column': int(match[3] or 0),
        'message': match[4],
    }


class BlewUp(ThawError, RuntimeError):
    """A step failed, and no retry is left. The message has the particle, the cause and the retries."""


class FieldError(ThawError, KeyError):
    """A field, column or body has no such name. The message lists the valid names."""

    def __str__(self) -> str:
        return str(self.args[0])  # KeyError would quote the message


class MissingError(ThawError, LookupError):
    """A run or a frame has no such part: no surface, no sheets, no checkpoint."""


class ProgramError(ThawError):
    """The program thaw was not found, or it failed."""


class DamageWarning(UserWarning):
    """A damaged or incomplete file at the end of a run was left out."""


def unknownName(
    name: object, known: Iterable[str], owner: str, what: str = 'field', optional: Iterable[str] = ()
) -> FieldError:
    """Returns the exception for an unknown name, with the nearest known one and a list of all.

    optional: fields that a scene may write and this one does not.
    """
    names = sorted(known)
    near = difflib.get_close_matches(str(name), {*names, *optional}, 1, 0.6)
    text = f"{owner} has no {what} '{name}'"
    if near and near[0] != name:
        text += f"; did you mean '{near[0]}'?"
    else:
        text += '.'
    text += f' There are: {", ".join(names)}.' if names else ' There are none.'
    if near and near[0] not in names:
        text += f" '{near[0]}' is written where [output] fields of the scene lists it."
    return FieldError(text)
