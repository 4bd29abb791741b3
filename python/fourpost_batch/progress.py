"""How far a batch is, on stderr: a line that changes on a terminal, else one now and then."""
from __future__ import annotations

import sys
import time

from .errors import Finding
from .run import Tally


class ProgressLine:
    def __init__(self, total: int):
        self.total, self._last, self._shown, self._told = total, time.monotonic(), False, 0
        self._is_terminal = sys.stderr.isatty()

    def __call__(self, tally: Tally, left: int) -> None:
        self.tell_warnings(tally)
        now = time.monotonic()
        if now - self._last < (0.2 if self._is_terminal else 10):
            return
        self._last = now
        text = f"units: {tally.found + tally.paid} of {self.total} have results, {left} to come"
        if tally.tried_again:
            text += f", {tally.tried_again} tried again"
        print(f"\r\x1b[K{text}" if self._is_terminal else text, end="" if self._is_terminal else "\n", file=sys.stderr,
              flush=True)
        self._shown = self._is_terminal

    def tell_warnings(self, tally: Tally) -> None:
        """Those that came since the last call."""
        for finding in tally.warnings[self._told:]:
            self.tell(finding)
        self._told = len(tally.warnings)

    def tell(self, finding: Finding) -> None:
        self.end()
        print(finding, file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._shown:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
        self._shown = False
