# SPDX-License-Identifier: Apache-2.0
"""Exceptions that end a script on one of several ranks.

The other ranks would hang in their next collective call. The interpreter reports the exception, then all
ranks end.
"""

from __future__ import annotations

import sys
from types import TracebackType
from typing import Any, Callable, Optional

from .errors import BlewUp, SceneError

# Raised on all ranks: for a refused scene, a simulation that blows up, and a signal to mpirun.
RAISED_ON_ALL = (BlewUp, SceneError, KeyboardInterrupt)

_installed = False


def end_all_ranks_on_exceptions(abort: Callable[[], Any]) -> None:
    """Calls `abort` after the report of an exception that ends the script. Further calls have no effect."""
    global _installed
    if _installed:
        return
    _installed = True
    report = sys.excepthook

    def report_and_end(
        kind: type[BaseException], error: BaseException, trace: Optional[TracebackType]
    ) -> None:
        report(kind, error, trace)
        if isinstance(error, RAISED_ON_ALL):
            return
        sys.stdout.flush()
        sys.stderr.flush()
        abort()

    sys.excepthook = report_and_end
