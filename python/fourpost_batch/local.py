"""Workers are processes of the program on this machine; a thread of a pool waits for each."""
from __future__ import annotations

import concurrent.futures
import os
import queue
from typing import Any

from .errors import LEAVES, NOT_DONE, BatchError, Finding, Trouble
from .run import Outcome, finding_of
from .unit import Unit
from .work import Workplace


class LocalCrew:
    """A process that is killed loses its unit alone, which is tried again."""

    stops_at = LEAVES
    carries = False

    def __init__(self, workplace: Workplace, workers: int = 0):
        self.workplace = workplace
        try:
            workplace.check()
        except Trouble as trouble:
            raise BatchError([finding_of(trouble, workplace.build)], NOT_DONE) from None
        self._pool = concurrent.futures.ThreadPoolExecutor(workers or os.cpu_count())
        self._answers: queue.SimpleQueue[tuple[str, Outcome | Trouble]] = queue.SimpleQueue()

    def send(self, units: list[tuple[Unit, dict[str, Any] | None]]) -> None:
        for unit, fit in units:
            self._pool.submit(self._work, unit, fit)

    def _work(self, unit: Unit, fit: dict[str, Any] | None) -> None:
        answer: Outcome | Trouble
        try:
            answer = self.workplace.run(unit, fit)
        except Trouble as trouble:
            answer = trouble
        except Exception as fault:
            answer = Trouble("failed", f"{type(fault).__name__}: {fault}", self.workplace.worker)
        self._answers.put((unit.key, answer))

    def receive(self) -> tuple[str, Outcome | Trouble]:
        return self._answers.get()

    def warnings(self) -> list[Finding]:
        return []

    def close(self) -> None:
        self._pool.shutdown(wait=False, cancel_futures=True)
        self.workplace.stop()
        self._pool.shutdown()
        self.workplace.close()
