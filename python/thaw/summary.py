# SPDX-License-Identifier: Apache-2.0
"""summary.json as a dict with attributes, and the state of the process of a run."""
from __future__ import annotations

import json
import os
import socket
from typing import Any, Dict, Optional

from .errors import FileError, unknownName


class Summary(Dict[str, Any]):
    """A dict whose keys are also attributes: `summary.ledger.now.kinetic_J`."""

    _path = ''

    def __getattr__(self, name: str) -> Any:
        if name in self:
            return self[name]
        if name.startswith('__'):
            raise AttributeError(name)
        raise AttributeError(str(unknownName(name, self, self._path or 'this part of the summary', 'key')))


def readSummary(path: str) -> Summary:
    """Raises FileError if the file is missing or damaged."""
    try:
        with open(path, encoding='utf-8') as file:
            summary = json.load(file, object_hook=Summary)
    except FileNotFoundError:
        raise FileError(path, 'no such file; a run writes it when it begins to step') from None
    except OSError as error:
        raise FileError(path, f'cannot be read: {error.strerror}') from error
    except ValueError as error:
        raise FileError(path, f'is not JSON: {error}') from error
    if not isinstance(summary, Summary):
        raise FileError(path, 'is not a summary of a run; expected an object of JSON')
    summary._path = path
    return summary


def isLive(lock: str) -> Optional[bool]:
    """Whether the process that a lock names still runs; None if this host cannot determine it."""
    try:
        with open(lock, encoding='utf-8') as file:
            holder = json.load(file)
        host, pid, began = holder['host'], int(holder['pid']), int(holder['began_ticks'])
    except FileNotFoundError:
        return False
    except (OSError, ValueError, KeyError, TypeError):
        return None
    if host != socket.gethostname():
        return None
    try:
        with open(f'/proc/{pid}/stat', encoding='utf-8', errors='replace') as file:
            fields = file.read().rsplit(')', 1)[1].split()
    except (OSError, IndexError):
        return os.path.exists(f'/proc/{pid}')
    return fields[0] not in 'ZX' and int(fields[19]) == began
