# SPDX-License-Identifier: Apache-2.0
"""Signals that batch systems and mpirun send to end a run."""

from __future__ import annotations

import signal
import threading
from typing import Any

NAMES = ("SIGTERM", "SIGUSR1", "SIGUSR2")


def interrupt(number: int, frame: Any) -> None:
    """A handler. The simulation raises its exception after the current step."""
    raise KeyboardInterrupt(f"signal {signal.Signals(number).name}")


class StopSignals:
    """Within `with`, the signals NAMES raise KeyboardInterrupt, unless the program handles them.

    always: from the construction on. Several ranks need this, since signals may arrive between steps.
    """

    def __init__(self, always: bool):
        self._before: dict[int, Any] = {}
        if always:
            self._set()

    def _set(self) -> None:
        if threading.current_thread() is not threading.main_thread():
            return
        for name in NAMES:
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) is signal.SIG_DFL:
                self._before[number] = signal.signal(number, interrupt)

    def __enter__(self) -> None:
        self._begin = not self._before
        if self._begin:
            self._set()

    def __exit__(self, *error: Any) -> None:
        if self._begin:
            for number, handler in self._before.items():
                signal.signal(number, handler)
            self._before = {}
