"""Workers are tasks of Slurm arrays: each runs its share of the units. Slurm queues, places and requeues them."""
from __future__ import annotations

import json
import os
import pathlib
import shlex
import shutil
import subprocess
import time
from typing import Any, Callable

from . import findings
from .errors import LEAVES, NOT_DONE, USAGE, BatchError, Finding, Trouble
from .run import Tally, finding_of
from .store import Store, write_whole
from .unit import Unit
from .work import Workplace

MOST_TASKS = 1000
"""Of an array: Slurm's MaxArraySize is 1001 unless its administrator changed it."""
ASK_EVERY_S = 2
PATIENCE_S = 30
"""Tasks work on while the controller is away for so long."""
AWAY = ("Unable to contact", "Connection refused", "timed out", "Zero Bytes were transmitted", "Socket")
"""Of sbatch where its controller does not answer; all else it says is a refusal."""
Progress = Callable[[Tally, int], None]


def _in_a_line(said: str) -> str:
    return " ".join(said.split()) or "it said nothing"


def write_task_file(path: pathlib.Path, units: list[Unit], shares: int, workplace: Workplace) -> None:
    """What the tasks of an array read."""
    content = {"store": str(workplace.store.folder), "build": workplace.build, "program": workplace.hint,
               "shares": shares, "units": [unit.to_dict() for unit in units]}
    write_whole(path, json.dumps(content).encode())


def run_share(units: list[Unit], workplace: Workplace, troubles: pathlib.Path) -> bool:
    """Runs units one after the other; what has none is written into `troubles`. Whether all have results."""
    lost: list[dict[str, str]] = []
    for unit in units:
        try:
            _, text = workplace.run(unit)
            if text is not None:
                raise Trouble("disk", f"cannot write into {workplace.store.folder}", workplace.worker)
        except Trouble as trouble:
            lost.append({"key": unit.key, "kind": trouble.kind, "text": trouble.text, "worker": trouble.worker})
            if trouble.kind in LEAVES:
                break
    if lost:
        troubles.parent.mkdir(exist_ok=True)
        write_whole(troubles, json.dumps(lost).encode())
    return not lost


def run_task(path: str) -> int:
    """One task of an array: the share of SLURM_ARRAY_TASK_ID. Returns an exit code."""
    try:
        content: dict[str, Any] = json.loads(pathlib.Path(path).read_text())
        share = int(os.environ["SLURM_ARRAY_TASK_ID"])
    except (OSError, ValueError) as fault:
        raise BatchError([findings.FILE_MISSING(path, f" ({fault})")]) from None
    except KeyError:
        raise BatchError([findings.LAUNCHER_UNKNOWN()], USAGE)
    store = Store(content["store"])
    workplace = Workplace(content["store"], store.id, content["build"], content["program"])
    units = [Unit.of(unit) for unit in content["units"]]
    troubles = pathlib.Path(path).with_suffix("") / f"{share}.json"
    try:
        return 0 if run_share(units[share::content["shares"]], workplace, troubles) else NOT_DONE
    finally:
        workplace.close()


class Slurm:
    """sbatch with options of the user's; each round is one array of the units that have no result."""

    def __init__(self, workplace: Workplace, options: str, tasks: int):
        self.workplace, self.store = workplace, workplace.store
        self.tasks = tasks or 100
        try:
            self.options = shlex.split(options)
        except ValueError as fault:
            raise BatchError([findings.SLURM_REFUSES(f"{fault} in '{options}'")], USAGE) from None
        self.folder = self.store.folder / "slurm"
        if shutil.which("sbatch") is None:
            raise BatchError([findings.LACKS_PACKAGE("sbatch", "PATH", "apt install slurm-client")], USAGE)

    def run(self, units: list[Unit], tries: int, progress: Progress) -> Tally:
        tally = Tally()
        chosen = {unit.key: unit for unit in units}
        there = {key for key in chosen if self.store.has(key)}
        tally.found = len(there)
        # Fits first, then what needs them.
        for is_after in (False, True):
            self._bring([unit for unit in chosen.values() if bool(unit.after) == is_after], tally, tries, progress)
        return tally

    def _is_ready(self, unit: Unit) -> bool:
        fit = self.store.get(unit.after) if unit.after else None
        return not unit.after or (fit is not None and fit["code"] < 2)

    def _bring(self, units: list[Unit], tally: Tally, tries: int, progress: Progress) -> None:
        troubles: dict[str, Trouble] = {}
        for attempt in range(tries):
            missing = [unit for unit in units if not self.store.has(unit.key) and self._is_ready(unit)]
            tally.tried_again += len(missing) if attempt else 0
            if not missing:
                return
            troubles = self._submit(missing, tally, progress)
            if troubles and {trouble.kind for trouble in troubles.values()} <= {"build", "files", "program"}:
                # Another round would meet the same.
                break
        for unit in units:
            if not self.store.has(unit.key) and self._is_ready(unit):
                tally.lost[unit.key] = troubles.get(unit.key, Trouble("lost", "the task of its array ended"))

    def _submit(self, units: list[Unit], tally: Tally, progress: Progress) -> dict[str, Trouble]:
        """One array, to its end. What workers said, by key."""
        self.folder.mkdir(exist_ok=True)
        shares = min(self.tasks, MOST_TASKS, len(units))
        name = f"{time.time_ns()}"
        task_file = self.folder / f"{name}.json"
        write_task_file(task_file, units, shares, self.workplace)
        script = self.folder / f"{name}.sh"
        script.write_text("#!/bin/sh\n"
                          f"hint={shlex.quote(self.workplace.hint)}\n"
                          'program="${FOURPOST_PROGRAM:-$hint}"\n'
                          '[ -x "$program" ] || program=fourpost\n'
                          f'exec "$program" batch --task {shlex.quote(str(task_file))}\n')
        command = ["sbatch", "--parsable", "--requeue", f"--array=0-{shares - 1}", "--job-name=fourpost",
                   f"--output={self.folder}/{name}-%a.out", *self.options, str(script)]
        outcome = subprocess.run(command, capture_output=True, text=True)
        if outcome.returncode != 0:
            if any(word in outcome.stderr for word in AWAY):
                raise self._away(outcome.stderr)
            raise BatchError([findings.SLURM_REFUSES(_in_a_line(outcome.stderr))], USAGE)
        job = outcome.stdout.strip().split(";")[0]
        try:
            self._wait(job, {unit.key for unit in units}, tally, progress)
        except BaseException:
            subprocess.run(["scancel", job], capture_output=True)
            raise
        return self._troubles(task_file, tally)

    @staticmethod
    def _away(said: str) -> BatchError:
        return BatchError([findings.SCHEDULER_AWAY("Slurm", _in_a_line(said))], NOT_DONE)

    def _wait(self, job: str, left: set[str], tally: Tally, progress: Progress) -> None:
        """Until all have results, or the array has ended."""
        asked = answered = time.monotonic()
        while left:
            time.sleep(0.2)
            self._count(left, tally, progress)
            if time.monotonic() - asked < ASK_EVERY_S:
                continue
            outcome = subprocess.run(["squeue", "--noheader", f"--jobs={job}"], capture_output=True, text=True)
            asked = time.monotonic()
            if outcome.returncode == 0 or "Invalid job id" in outcome.stderr:
                answered = asked
                if not outcome.stdout.strip():
                    break
            elif asked - answered > PATIENCE_S:
                raise self._away(outcome.stderr)
        self._count(left, tally, progress)

    def _count(self, left: set[str], tally: Tally, progress: Progress) -> None:
        came = {key for key in left if self.store.path(key).exists()}
        left -= came
        tally.paid += len(came)
        progress(tally, len(left))

    def _troubles(self, task_file: pathlib.Path, tally: Tally) -> dict[str, Trouble]:
        found = {}
        for path in sorted(task_file.with_suffix("").glob("*.json")):
            for one in json.loads(path.read_text()):
                trouble = Trouble(one["kind"], one["text"], one["worker"])
                found[one["key"]] = trouble
                if trouble.kind in LEAVES:
                    self._warn(finding_of(trouble, self.workplace.build), tally)
        return found

    @staticmethod
    def _warn(finding: Finding, tally: Tally) -> None:
        if finding not in tally.warnings:
            tally.warnings.append(finding)
