"""One of several workers that mpirun, srun or a shell started on the same plan: each runs its share.

mpirun ends all workers for one that ends with another code than 0. So each ends with 0 and leaves a mark of what it gave
up; the last one to leave it answers for all.
"""
from __future__ import annotations

import hashlib
import json
import os
import secrets
import shutil
import time
from typing import Callable, Iterable

from . import findings
from .errors import LEAVES, USAGE, BatchError, Trouble
from .run import Tally, finding_of
from .store import Store, write_whole
from .unit import Unit
from .work import Workplace

RANKS = (("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE"), ("PMI_RANK", "PMI_SIZE", "PMI_JOBID"),
         ("PMIX_RANK", "PMIX_SIZE", "PMIX_NAMESPACE"),
         ("SLURM_PROCID", "SLURM_NTASKS", "SLURM_JOB_ID", "SLURM_STEP_ID", "SLURM_RESTART_COUNT"))
"""Variables of the number of a worker and of all; the others distinguish one start of workers from the next."""
SIGHT_S = 10
"""How long a shared folder may hide what another machine has written."""


def share_of_this() -> tuple[int, int, str]:
    """Number of this worker, from 0, and of all; what workers that were started together share. Raises BatchError."""
    share = os.environ.get("FOURPOST_BATCH_SHARE", "").split("/")
    found = [[os.environ.get(name, "") for name in names] for names in RANKS]
    for rank, count, *start in ([share] if len(share) == 2 else []) + found:
        if rank.isdigit() and count.isdigit() and int(rank) < int(count):
            return int(rank), int(count), "/".join(start).strip("/")
    raise BatchError([findings.LAUNCHER_UNKNOWN()], USAGE)


class Marks:
    """What each worker of one start leaves in the folder of the batch at its end: the units that it gave up."""

    def __init__(self, store: Store, rank: int, count: int, start: str):
        self.parent, self.count = store.folder / "launched", count
        self.folder = self.parent / f"{count}-{hashlib.sha256(start.encode()).hexdigest()[:16]}"
        self.own = self.folder / f"{rank}.json"
        # Of a start that was killed, where the launcher gives starts no names.
        self.own.unlink(missing_ok=True)

    def leave(self, lost: dict[str, Trouble]) -> dict[str, Trouble] | None:
        """What all have given up, for the last worker alone. Raises OSError."""
        self.folder.mkdir(parents=True, exist_ok=True)
        write_whole(self.own, json.dumps({key: (one.kind, one.text, one.worker) for key, one in lost.items()}).encode())
        if len(list(self.folder.glob("*.json"))) < self.count:
            return None
        taken = self.parent / f".{secrets.token_hex(8)}"
        try:
            # Of two that see all marks, one.
            self.folder.rename(taken)
        except FileNotFoundError:
            return None
        marks = [json.loads(path.read_bytes()) for path in sorted(taken.glob("*.json"))]
        shutil.rmtree(taken, ignore_errors=True)
        return {key: Trouble(*words) for mark in marks for key, words in mark.items()}


def run_launched(units: list[Unit], workplace: Workplace, tries: int,
                 progress: Callable[[Tally, int], None]) -> tuple[Tally, bool]:
    """Runs the share of this worker: fits, each with all that needs it. Whether it is the last worker; what is lost is
    then that of all."""
    rank, count, start = share_of_this()
    store, tally = workplace.store, Tally()
    by_fit: dict[str, list[Unit]] = {}
    for unit in {unit.key: unit for unit in units}.values():
        by_fit.setdefault(unit.after or unit.key, []).append(unit)
    mine = [unit for group in list(by_fit.values())[rank::count] for unit in group]
    marks = Marks(store, rank, count, start or "".join(unit.key for unit in units))
    try:
        _run_share(mine, workplace, tries, tally, progress)
    finally:
        workplace.close()
    lost = marks.leave(tally.lost)
    if lost is None:
        return tally, False
    tally.lost = _still_missing(units, store, lost)
    return tally, True


def _run_share(mine: list[Unit], workplace: Workplace, tries: int, tally: Tally,
               progress: Callable[[Tally, int], None]) -> None:
    store, end = workplace.store, None
    for done, unit in enumerate(mine):
        fit = store.get(unit.after) if unit.after else None
        if not unit.after or (fit is not None and fit["code"] < 2):
            if end is None:
                end = _bring(unit, workplace, tries, tally)
            elif not store.has(unit.key):
                tally.lost[unit.key] = end
        progress(tally, len(mine) - done - 1)


def _bring(unit: Unit, workplace: Workplace, tries: int, tally: Tally) -> Trouble | None:
    """Why this worker can do none of the others either, if so."""
    for attempt in range(tries):
        try:
            how, text = workplace.run(unit)
        except Trouble as trouble:
            tally.tried_again += 1
            if trouble.kind in LEAVES:
                tally.warnings.append(finding_of(trouble, workplace.build))
                tally.lost[unit.key] = trouble
                return trouble
            if attempt + 1 == tries:
                tally.lost[unit.key] = trouble
            continue
        if text is not None:
            full = tally.lost[unit.key] = Trouble("disk", f"cannot write into {workplace.store.folder}", workplace.worker)
            return full
        tally.paid += how == "paid"
        tally.found += how == "found"
        return None
    return None


def _still_missing(units: Iterable[Unit], store: Store, lost: dict[str, Trouble]) -> dict[str, Trouble]:
    """Of units without a result, why; those of which no worker says so may still come into sight."""
    lost = {key: trouble for key, trouble in lost.items() if not store.path(key).exists()}
    hidden, end = list(units), time.monotonic() + SIGHT_S
    while hidden := [unit for unit in hidden if not _is_settled(unit, store, lost)]:
        if time.monotonic() > end:
            return {**lost, **{unit.key: Trouble("lost", "its result does not appear in the folder") for unit in hidden}}
        time.sleep(0.1)
    return lost


def _is_settled(unit: Unit, store: Store, lost: dict[str, Trouble]) -> bool:
    if store.path(unit.key).exists() or unit.key in lost or unit.after in lost:
        return True
    fit = store.get(unit.after) if unit.after else None
    return fit is not None and int(fit["code"]) >= 2
