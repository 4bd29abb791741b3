"""Units are run: those that have no result yet, each after the fit that it needs."""
from __future__ import annotations

import collections
import time
from dataclasses import dataclass, field
from typing import Any, Callable, Iterable, Protocol

from . import findings
from .errors import CANNOT_WRITE, NOT_DONE, BatchError, Finding, Trouble
from .store import Store
from .unit import Unit

Outcome = tuple[str, "bytes | None"]
"""As Workplace.run() returns it."""


class Crew(Protocol):
    """Workers somewhere, by a scheduler that is not ours."""

    stops_at: tuple[str, ...]
    """Kinds of trouble that no other worker would be spared."""
    carries: bool
    """Whether workers do not see the store, so that fits go to them with the units that need them."""

    def send(self, units: list[tuple[Unit, dict[str, Any] | None]]) -> None:
        """Asks for results; each unit with the fit that it needs, where the crew carries it."""

    def receive(self) -> tuple[str, Outcome | Trouble]:
        """Waits for the next answer to a key. Raises BatchError when none can come."""

    def warnings(self) -> list[Finding]:
        """Of workers, since the last call."""

    def close(self) -> None: ...


@dataclass
class Tally:
    """What became of the units of one run."""

    found: int = 0
    """Results that were there before."""
    paid: int = 0
    """Computed now."""
    tried_again: int = 0
    """Attempts that ended without a result."""
    lost: dict[str, Trouble] = field(default_factory=dict)
    """By key: units that were given up."""
    warnings: list[Finding] = field(default_factory=list)
    """Of workers and of the store."""


def run(units: Iterable[Unit], store: Store, crew: Crew, *, tries: int = 10,
        progress: Callable[[Tally, int], None] = lambda tally, left: None) -> Tally:
    """Brings the results of all units into the store.

    crew: who computes: `fourpost_batch.local.LocalCrew`, `fourpost_batch.dask_crew.DaskCrew`, or one of your own.
    tries: units that were lost so often are given up, and are in the tally.
    progress: called with the tally and the number of units left.

    Raises BatchError where workers or the store are gone; results so far are kept.
    """
    return _Run(units, store, crew, tries, progress).run()


class _Run:
    def __init__(self, units: Iterable[Unit], store: Store, crew: Crew, tries: int,
                 progress: Callable[[Tally, int], None]):
        # The same work under two names is done once.
        self.units = {unit.key: unit for unit in units}
        self.store, self.crew, self.tries, self.progress = store, crew, tries, progress
        self.tally = Tally()
        self.attempts: collections.Counter[str] = collections.Counter()
        self.waiting: dict[str, list[str]] = collections.defaultdict(list)
        self.asked: set[str] = set()

    def run(self) -> Tally:
        there = {key: result["code"] for key in self.units if (result := self.store.get(key))}
        self.tally.found = len(there)
        ready = []
        for key, unit in self.units.items():
            if key in there:
                continue
            if unit.after and unit.after not in there:
                self.waiting[unit.after].append(key)
            elif not unit.after or there[unit.after] < 2:
                ready.append(key)
        self._send(ready)
        while self.asked:
            key, answer = self.crew.receive()
            self.tally.warnings += self.crew.warnings()
            if isinstance(answer, Trouble):
                self._take_trouble(key, answer)
            else:
                self._take(key, *answer)
            self.progress(self.tally, len(self.asked) + sum(map(len, self.waiting.values())))
        return self.tally

    def _send(self, keys: list[str]) -> None:
        self.asked.update(keys)
        units = [self.units[key] for key in keys]
        if units:
            self.crew.send([(unit, self._fit_for(unit)) for unit in units])

    def _fit_for(self, unit: Unit) -> dict[str, Any] | None:
        return self.store.get(unit.after) if unit.after and self.crew.carries else None

    def _take(self, key: str, how: str, text: bytes | None) -> None:
        if key not in self.asked:
            return
        if text is not None:
            try:
                self.store.put(key, text)
            except OSError as fault:
                raise BatchError([findings.CANNOT_WRITE(fault)], CANNOT_WRITE) from None
        result = self._see(key)
        if result is None:
            self._take_trouble(key, Trouble("lost", "its result does not appear in the folder"))
            return
        self.tally.paid += how == "paid"
        self.tally.found += how == "found"
        self.asked.discard(key)
        if result["code"] < 2:
            self._send(self.waiting.pop(key, []))

    def _see(self, key: str) -> dict[str, Any] | None:
        """A result that another machine has written, which a shared folder may show some seconds later."""
        for _ in range(100):
            result = self.store.get(key)
            if result is not None:
                return result
            time.sleep(0.1)
        return None

    def _take_trouble(self, key: str, trouble: Trouble) -> None:
        if key not in self.asked:
            return
        if trouble.kind in self.crew.stops_at:
            code = CANNOT_WRITE if trouble.kind == "disk" else NOT_DONE
            raise BatchError([finding_of(trouble)], code)
        self.tally.tried_again += 1
        self.attempts[key] += 1
        if self.attempts[key] >= self.tries:
            self.asked.discard(key)
            self.tally.lost[key] = trouble
        else:
            self._send([key])


def finding_of(trouble: Trouble, plan_build: str = "another build") -> Finding:
    """What a worker that leaves says of itself."""
    worker = trouble.worker or "here"
    if trouble.kind == "disk":
        return findings.WORKER_DISK_FULL(worker, trouble.text)
    if trouble.kind == "build":
        return findings.WORKER_OF_OTHER_BUILD(worker, trouble.text, plan_build)
    if trouble.kind == "files":
        return findings.WORKER_LACKS_FILES(worker, trouble.text)
    return findings.WORKER_LACKS_PROGRAM(worker, trouble.text)
