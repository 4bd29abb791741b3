"""Workers of a Dask scheduler: it places units, and replaces workers that die.

What workers need is carried to them once, see dask_plant.py. While all workers can do the units, the scheduler gives
them to any. From the first one on that cannot, units ask for the resource that the others have.
"""
from __future__ import annotations

import contextlib
import json
import os
import pathlib
import queue
import sys
import time
from typing import Any, Iterator, Mapping

from . import findings
from .errors import LEAVES, NOT_DONE, USAGE, BatchError, Finding, Trouble, did_you_mean
from .run import Outcome, finding_of
from .unit import Unit
from .work import Workplace

try:
    import cloudpickle
    import distributed

    from . import dask_plant
    from .dask_plant import NAME, Plant
except ImportError:
    lacks = findings.LACKS_PACKAGE("distributed", sys.executable, "apt install python3-distributed")
    raise BatchError([lacks], USAGE) from None

PASSED_BY = ("build", "files", "program")
"""Kinds of trouble of which a worker may be one of another batch."""


class DaskCrew:
    """address: of the scheduler, tcp://HOST:PORT, or its scheduler file."""

    stops_at = ()

    def __init__(self, address: str, workplace: Workplace, files: Mapping[str, bytes] | None = None,
                 patience: float = 60):
        self.address, self.patience = address, patience
        self.build, self._store = workplace.build, workplace.store
        options: dict[str, Any] = {"address": address}
        if not address.startswith("tcp://") and not address.startswith("tls://"):
            options = {"scheduler_file": address}
            self._check_file(address)
        cloudpickle.register_pickle_by_value(dask_plant)
        try:
            self._client = distributed.Client(timeout=5, set_as_default=False, **options)
        except (OSError, TimeoutError) as fault:
            raise self._away(str(fault)) from None
        self._answers: queue.SimpleQueue[tuple[str, Any]] = queue.SimpleQueue()
        self._futures: dict[str, Any] = {}
        self._asked: dict[str, tuple[Unit, dict[str, Any] | None]] = {}
        self._is_mixed = False
        self._events: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self._sent = 0
        self.carries = files is not None
        self._alone_since: float | None = None
        self._refused: list[Finding] = []
        self._name = NAME + self._client.id
        sources = {path.name: path.read_text() for path in sorted(pathlib.Path(__file__).parent.glob("*.py"))}
        place = (str(self._store.folder), workplace.store.id, workplace.build, workplace.hint)
        with self._asking():
            self._client.subscribe_topic(self._name, lambda event: self._events.put(event[1]))
            self._forget_killed_batches()
        self._plant = Plant(self._name, sources, place, files)
        self._set_up()
        self._is_mixed = self._has_others()

    @property
    def dashboard(self) -> str:
        """Where the scheduler shows its progress; empty where it does not."""
        with self._asking():
            services = self._client.scheduler_info().get("services", {})
        return str(self._client.dashboard_link) if "dashboard" in services else ""

    def _forget_killed_batches(self) -> None:
        plugins, clients = self._client.run_on_scheduler(
            lambda dask_scheduler: (list(dask_scheduler.worker_plugins), list(dask_scheduler.clients)))
        for name in plugins:
            if name.startswith(NAME) and name.removeprefix(NAME) not in clients:
                # Another batch that begins may have been faster.
                with contextlib.suppress(ValueError, KeyError):
                    self._client.unregister_worker_plugin(name)

    def _set_up(self) -> None:
        """Gives workers what they need, unless they have it: units that run would end. Again, as another batch that begins
        while this client connects anew takes this batch for a killed one."""
        with self._asking():
            is_there = self._client.run_on_scheduler(lambda name, dask_scheduler: name in dask_scheduler.worker_plugins,
                                                     self._name)
            if not is_there:
                self._client.register_worker_plugin(self._plant, self._name)

    def _has_others(self) -> bool:
        """Whether some workers cannot do the units; one that just joins is waited for."""
        for _ in range(10):
            able, workers = self._able()
            if able == workers:
                return False
            time.sleep(0.1)
        return True

    def _able(self) -> tuple[int, int]:
        """How many workers can do the units, and how many there are."""
        with self._asking():
            able, workers = self._client.run_on_scheduler(
                lambda name, dask_scheduler: (sum(map(bool, dask_scheduler.resources.get(name, {}).values())),
                                              len(dask_scheduler.workers)), self._name)
        return int(able), int(workers)

    @contextlib.contextmanager
    def _asking(self) -> Iterator[None]:
        """A scheduler that goes away meanwhile is said, whatever Dask makes of it."""
        try:
            yield
        except (OSError, TimeoutError, distributed.TimeoutError) as fault:
            raise self._away(str(fault) or "the connection is lost") from None
        except Exception:
            if self._client.status == "running":
                raise
            raise self._away("the connection is lost") from None

    def _check_file(self, path: str) -> None:
        try:
            with open(path, encoding="utf-8") as stream:
                json.load(stream)["address"]
        except (OSError, ValueError, KeyError, TypeError) as fault:
            file = pathlib.Path(path)
            near = did_you_mean(file.name, os.listdir(file.parent)) if file.parent.is_dir() and not file.exists() else ""
            raise self._away(f"'{path}' is not a scheduler file ({fault}){near}") from None

    def _away(self, why: str) -> BatchError:
        return BatchError([findings.SCHEDULER_AWAY(self.address, why)], NOT_DONE)

    def send(self, units: list[tuple[Unit, dict[str, Any] | None]]) -> None:
        # Names of Dask's own, as a key that was lost is asked for again.
        names = [f"{unit.kind}-{unit.key[:16]}-{self._sent + i}" for i, (unit, _) in enumerate(units)]
        self._sent += len(units)
        needs = {self._name: 1} if self._is_mixed else None
        with self._asking():
            futures = self._client.map(dask_plant.work, [self._name] * len(units), [unit.to_dict() for unit, _ in units],
                                       [fit for _, fit in units], key=names, pure=False, batch_size=1000, resources=needs)
        for (unit, fit), future in zip(units, futures):
            self._futures[unit.key], self._asked[unit.key] = future, (unit, fit)
            future.add_done_callback(lambda done, key=unit.key: self._answers.put((key, done)))

    def receive(self) -> tuple[str, Outcome | Trouble]:
        while True:
            try:
                key, future = self._answers.get(timeout=1)
            except queue.Empty:
                self._check_is_there()
                continue
            if self._futures.get(key) is not future:
                continue
            del self._futures[key]
            asked = self._asked.pop(key)
            if future.status == "finished" and not self.carries and self._store.path(key).exists():
                # What the worker says of it need not travel.
                return key, ("paid", None)
            answer = self._answer_of(future)
            if not isinstance(answer, Trouble) or answer.kind not in PASSED_BY:
                return key, answer
            # No attempt: it was given to a worker that has none of its own.
            self._is_mixed = True
            self.send([asked])

    def _answer_of(self, future: Any) -> Outcome | Trouble:
        try:
            if future.status == "finished":
                answer = future.result(timeout=30)
                if tuple(answer) == dask_plant.NOT_SET_UP:
                    self._set_up()
                return Trouble(*answer) if len(answer) == 3 else answer
            if future.status == "error":
                fault = future.exception(timeout=30)
                if isinstance(fault, distributed.scheduler.KilledWorker):
                    return Trouble("lost", "several of its workers died")
                return Trouble("failed", f"{type(fault).__name__}: {fault}")
        except (OSError, TimeoutError) as fault:
            self._check_is_there()
            return Trouble("lost", f"its answer was lost: {fault}")
        self._check_is_there()
        return Trouble("lost", f"it was {future.status}")

    def _check_is_there(self) -> None:
        """Raises BatchError where the scheduler is gone, or no worker that can do the units is there for a while."""
        if self._client.status != "running":
            raise self._away("the connection is lost")
        self.warnings_so_far()
        if self._able()[0]:
            if self._alone_since is not None and self._is_mixed:
                self._send_again()
            self._alone_since = None
            return
        self._set_up()
        if self._alone_since is None:
            self._alone_since = time.monotonic()
            print(f"waits for workers of {self.address}, {self.patience:.0f} s at the most", file=sys.stderr)
        patience = min(self.patience, 2) if self._refused else self.patience
        if time.monotonic() - self._alone_since > patience:
            raise BatchError([*self._refused[:3], findings.NO_WORKERS(self.address)], NOT_DONE)

    def warnings_so_far(self) -> list[Finding]:
        while not self._events.empty():
            event = self._events.get()
            if isinstance(event, (list, tuple)) and len(event) == 3 and event[0] in LEAVES:
                trouble = Trouble(*event)
                self._refused.append(finding_of(trouble, self.build))
                if trouble.kind in PASSED_BY:
                    self._is_mixed = True
                    continue
                with self._asking():
                    self._client.run_on_scheduler(lambda name, dask_scheduler: dask_scheduler.close_worker(name),
                                                  trouble.worker)
        return self._refused

    def _send_again(self) -> None:
        """Where no worker had the resource, the scheduler does not see that one has it now."""
        units = list(self._asked.values())
        futures, self._futures = list(self._futures.values()), {}
        with self._asking():
            self._client.cancel(futures)
        self.send(units)

    def warnings(self) -> list[Finding]:
        found, self._refused = self.warnings_so_far(), []
        return found

    def close(self) -> None:
        self._futures.clear()
        with contextlib.suppress(Exception):
            # Where it is gone, nothing is left to close.
            if self._client.status == "running":
                self._client.sync(self._client._unregister_worker_plugin, name=self._name, callback_timeout=5)
        with contextlib.suppress(Exception):
            self._client.close(timeout=5)
