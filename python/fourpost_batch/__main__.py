"""`fourpost batch`: the program checks the words, and runs this."""
from __future__ import annotations

import argparse
import contextlib
import logging
import os
import sys
from typing import Any, Callable

from . import findings
from .errors import CANNOT_WRITE, INTERRUPTED, NOT_DONE, USAGE, BatchError, did_you_mean
from .expand import Expanded, expand
from .page import ProgressPage
from .plan import read_plan
from .program import Program
from .progress import ProgressLine
from .report import findings_of_units, of_units, print_report, print_some, warnings_of_units
from .run import Tally, run
from .store import Store
from .summary import states, unpack, write_tables
from .work import Workplace

UNIT_FAILED = 1
"""Of units that failed by their inputs."""
PLACES = ("local", "dask:", "slurm", "launcher")


def options_of(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python3 -m fourpost_batch", description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--plan")
    parser.add_argument("--output")
    parser.add_argument("--on", default="local")
    parser.add_argument("--workers", type=int, default=0)
    parser.add_argument("--tries", type=int, default=10)
    parser.add_argument("--slurm", default="")
    parser.add_argument("--task", default="")
    for flag in ("--ship", "--list", "--unpack", "--json"):
        parser.add_argument(flag, action="store_true")
    return parser.parse_args(words)


def _check_place(on: str) -> None:
    if on not in ("local", "slurm", "launcher") and not (on.startswith("dask:") and len(on) > 7):
        raise BatchError([findings.PLACE_UNKNOWN(on, did_you_mean(on.partition("//")[0], PLACES), file="--on")], USAGE)


def _dask(options: argparse.Namespace, workplace: Workplace, files: dict[str, bytes] | None, page: ProgressPage) -> Any:
    from .dask_crew import DaskCrew
    # Dask logs tracebacks where a scheduler goes away; a finding says so.
    logging.disable(logging.CRITICAL)
    place = options.on.removeprefix("dask:")
    crew = DaskCrew("tcp:" + place if place.startswith("//") else place, workplace, files)
    page.link = crew.dashboard
    if page.link:
        print(f"dashboard: {page.link}", file=sys.stderr)
    return crew


def _run(options: argparse.Namespace, expanded: Expanded, store: Store, line: ProgressLine) -> tuple[Tally, bool]:
    """Runs what has no result. Whether this process speaks for the whole batch."""
    for digest, path in expanded.sources.items():
        store.add_file(path, digest)
    units = expanded.units
    workplace = Workplace(str(store.folder), store.id, Program(options.program).build, options.program)
    workplace.store = store
    if options.on == "launcher":
        from .launcher import run_launched
        return run_launched(units, workplace, options.tries, line)
    page = ProgressPage(store, line.total, options.on)

    def progress(tally: Tally, left: int) -> None:
        line(tally, left)
        page(tally, left)
    tally = _run_here_or_there(options, expanded, workplace, page, progress)
    page.write(tally, line.total - tally.found - tally.paid, is_over=True)
    return tally, True


def _run_here_or_there(options: argparse.Namespace, expanded: Expanded, workplace: Workplace, page: ProgressPage,
                       progress: Callable[[Tally, int], None]) -> Tally:
    if options.on == "slurm":
        from .slurm import Slurm
        return Slurm(workplace, options.slurm, options.workers).run(expanded.units, options.tries, progress)
    if options.on == "local":
        from .local import LocalCrew
        crew: Any = LocalCrew(workplace, options.workers)
    else:
        store, digests = workplace.store, expanded.sources if options.ship else {}
        shipped = {digest: store.file(digest).read_bytes() for digest in digests}
        crew = _dask(options, workplace, shipped or None, page)
    try:
        return run(expanded.units, workplace.store, crew, tries=options.tries, progress=progress)
    finally:
        crew.close()


def main(words: list[str]) -> int:
    options = options_of(words)
    if options.task:
        from .slurm import run_task
        return run_task(options.task)
    _check_place(options.on)
    expanded = expand(read_plan(options.plan), Program(options.program))
    if options.list:
        there = Store(options.output) if options.output and Store(options.output).id else None
        found = states(expanded.units, there)
        print_report(options, found, Tally(), warnings_of_units(found))
        if there and any(one.code is not None for one in found):
            write_tables(found, there, keeps=True)
        return 0
    store = Store.make(options.output)
    line = ProgressLine(len({unit.key for unit in expanded.units}))
    try:
        tally, is_whole = _run(options, expanded, store, line)
    except (BatchError, KeyboardInterrupt):
        # Of what is done; why it ended matters more than a full disk.
        with contextlib.suppress(OSError):
            write_tables(states(expanded.units, store), store, keeps=True)
        raise
    finally:
        line.end()
    found = states(expanded.units, store)
    if is_whole:
        write_tables(found, store)
        if options.unpack:
            unpack(found, store)
    if store.damaged:
        tally.warnings.append(findings.RESULT_DAMAGED(len(store.damaged)))
    line.tell_warnings(tally)
    # Of several workers of a launcher the last one speaks for all; mpirun would end the others for a code of this one.
    faults = findings_of_units(found, tally) if is_whole else []
    warned = warnings_of_units(found) if is_whole else []
    print_some(f"{of_units(names)}: {finding}" for finding, names in warned)
    print_some(faults)
    print_report(options, found, tally, warned)
    return 0 if not is_whole else NOT_DONE if tally.lost else UNIT_FAILED if faults else 0


def guarded(words: list[str]) -> int:
    """main() with its errors on stderr."""
    try:
        code = main(words)
        sys.stdout.flush()
        return code
    except BatchError as fault:
        for finding in fault.findings:
            print(finding, file=sys.stderr)
        return fault.code
    except KeyboardInterrupt:
        print("interrupted: results so far are kept; the same command goes on", file=sys.stderr)
        return INTERRUPTED
    except OSError as fault:
        print(findings.CANNOT_WRITE(fault), file=sys.stderr)
        return CANNOT_WRITE


if __name__ == "__main__":
    code = guarded(sys.argv[1:])
    try:
        sys.stderr.flush()
    finally:
        # Threads that wait for units do not keep the program.
        os._exit(code)
