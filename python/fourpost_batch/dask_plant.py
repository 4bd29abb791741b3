"""What a Dask worker is given once: the source of this package, and with --ship the files of all units.

This module goes to workers by value and uses none of the others, so that a worker needs no more of fourpost than its
program.
"""
from __future__ import annotations

import hashlib
import importlib
import pathlib
import sys
import time
from typing import Any, Mapping

import distributed

NAME = "fourpost-batch-"
"""Of plug-ins, and of the resource of workers that can do the units; that of the client of a batch follows, so that
several batches use a scheduler, also of several builds."""
SETUP_S = 60
"""How long a unit waits for the plug-in of its batch."""
NOT_SET_UP = ("failed", "the worker was not set up", "")
"""The answer of one that waited in vain."""


class Plant(distributed.WorkerPlugin):
    """A workplace on a Dask worker. One that can do the units has the resource of this name; another one says why, and
    is passed by. One whose disk is full is sent away, as it can do those of no batch."""

    def __init__(self, name: str, sources: Mapping[str, str], of: tuple[str, str, str, str],
                 files: Mapping[str, bytes] | None):
        self.name, self.sources, self.of, self.files = name, sources, of, files

    async def setup(self, worker: Any) -> None:
        self.worker = worker
        self.trouble: tuple[str, ...] | None = None
        try:
            self.unpack(worker)
        except OSError as fault:
            self.leave(("disk", str(fault), worker.address))
        if self.trouble is None:
            await self.offer(worker.state.nthreads)

    async def offer(self, units: int) -> None:
        """So many at a time."""
        await self.worker.set_resources(**{self.name: units})

    def unpack(self, worker: Any) -> None:
        """The package, under a name that no other build of it has here."""
        package = "fourpost_batch_" + hashlib.sha256(repr(sorted(self.sources.items())).encode()).hexdigest()[:16]
        folder = pathlib.Path(worker.local_directory)
        (folder / package).mkdir(exist_ok=True)
        for name, text in self.sources.items():
            (folder / package / name).write_text(text)
        sys.path.insert(0, str(folder))
        self.errors = importlib.import_module(package + ".errors")
        self.unit = importlib.import_module(package + ".unit").Unit
        self.place = importlib.import_module(package + ".work").Workplace(*self.of, self.files)
        self.place.worker = worker.address
        try:
            self.place.check()
        except self.errors.Trouble as trouble:
            self.leave((trouble.kind, trouble.text, worker.address))

    async def teardown(self, worker: Any) -> None:
        if hasattr(self, "place"):
            self.place.stop()
            self.place.close()
        # One that closes perhaps because its scheduler is gone does not call it.
        if worker.status.name == "running" and self.trouble is None:
            await self.offer(0)

    def run(self, unit: dict[str, Any], fit: dict[str, Any] | None) -> tuple[Any, ...]:
        """("found" or "paid", bytes or nothing), or the three parts of a Trouble."""
        answer = self.trouble
        if answer is None:
            try:
                return tuple(self.place.run(self.unit.of(unit), fit))
            except self.errors.Trouble as trouble:
                answer = (trouble.kind, trouble.text, trouble.worker or self.worker.address)
                if trouble.kind not in self.errors.LEAVES:
                    return answer
                self.leave(answer)
                self.worker.loop.add_callback(self.offer, 0)
        if answer[0] == "disk":
            # What it was given meanwhile goes elsewhere when it is gone.
            time.sleep(5)
        return answer

    def leave(self, trouble: tuple[str, ...]) -> None:
        if self.trouble is None:
            self.trouble = trouble
            self.worker.loop.add_callback(self.worker.loop.call_later, 0.1, self.say_why)

    def say_why(self) -> None:
        # A worker that joins is set up before it can speak.
        if self.worker.status.name != "running":
            self.worker.loop.call_later(0.1, self.say_why)
            return
        self.worker.log_event(self.name, list(self.trouble or ()))


def work(name: str, unit: dict[str, Any], fit: dict[str, Any] | None) -> tuple[Any, ...]:
    """By the plug-in of this name."""
    for _ in range(10 * SETUP_S):
        plant: Any = distributed.get_worker().plugins.get(name)
        if plant is not None and hasattr(plant, "place"):
            return tuple(plant.run(unit, fit))
        # A worker that joins may get a unit before it is set up.
        time.sleep(0.1)
    return NOT_SET_UP
