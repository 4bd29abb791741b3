"""One of several workers that mpirun, srun or a shell started on the same plan: each runs its share."""
from __future__ import annotations

import os
from typing import Callable

from . import findings
from .errors import LEAVES, USAGE, BatchError, Trouble
from .run import Tally, finding_of
from .unit import Unit
from .work import Workplace

RANKS = (("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"), ("PMI_RANK", "PMI_SIZE"), ("PMIX_RANK", "PMIX_SIZE"),
         ("SLURM_PROCID", "SLURM_NTASKS"))


def share_of_this() -> tuple[int, int]:
    """Number of this worker, from 0, and of all. Raises BatchError."""
    texts = os.environ.get("FOURPOST_BATCH_SHARE", "").split("/")
    pairs = [tuple(texts)] + [(os.environ.get(rank, ""), os.environ.get(size, "")) for rank, size in RANKS]
    for pair in pairs:
        if len(pair) == 2 and all(text.isdigit() for text in pair) and int(pair[0]) < int(pair[1]):
            return int(pair[0]), int(pair[1])
    raise BatchError([findings.LAUNCHER_UNKNOWN()], USAGE)


def run_launched(units: list[Unit], workplace: Workplace, tries: int,
                 progress: Callable[[Tally, int], None]) -> tuple[Tally, bool]:
    """Runs the share of this worker: fits, each with all that needs it. Whether the units of all workers have results."""
    rank, count = share_of_this()
    store, tally = workplace.store, Tally()
    by_fit: dict[str, list[Unit]] = {}
    for unit in {unit.key: unit for unit in units}.values():
        by_fit.setdefault(unit.after or unit.key, []).append(unit)
    mine = [unit for group in list(by_fit.values())[rank::count] for unit in group]
    try:
        for done, unit in enumerate(mine):
            fit = store.get(unit.after) if unit.after else None
            if (not unit.after or (fit is not None and fit["code"] < 2)) and not _bring(unit, workplace, tries, tally):
                break
            progress(tally, len(mine) - done - 1)
    finally:
        workplace.close()
    return tally, all(store.path(unit.key).exists() for unit in units)


def _bring(unit: Unit, workplace: Workplace, tries: int, tally: Tally) -> bool:
    """False where this worker can do none of the others either."""
    for attempt in range(tries):
        try:
            how, text = workplace.run(unit)
        except Trouble as trouble:
            tally.tried_again += 1
            if trouble.kind in LEAVES or attempt + 1 == tries:
                tally.lost[unit.key] = trouble
                if trouble.kind in LEAVES:
                    tally.warnings.append(finding_of(trouble, workplace.build))
                return trouble.kind not in LEAVES
            continue
        if text is not None:
            full = f"cannot write into {workplace.store.folder}"
            tally.lost[unit.key] = Trouble("disk", full, workplace.worker)
            return False
        tally.paid += how == "paid"
        tally.found += how == "found"
        return True
    return True
