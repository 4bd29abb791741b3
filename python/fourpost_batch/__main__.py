"""`fourpost batch`: the program checks the words, and runs this."""
from __future__ import annotations

import argparse
import json
import os
import sys
from typing import Any, Callable

from .errors import CANNOT_WRITE, INTERRUPTED, NOT_DONE, USAGE, BatchError, Finding, error, warning
from .expand import Expanded, expand
from .page import ProgressPage
from .plan import read_plan
from .program import Program
from .progress import ProgressLine
from .run import Tally, run
from .store import Store
from .summary import State, states, unpack, write_tables
from .work import Workplace

UNIT_FAILED = 1
"""Of units that failed by their inputs."""


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
        text = f"'{on}' is not a place to run units: one of local, dask://HOST:PORT, dask:FILE, slurm, launcher"
        raise BatchError([Finding("batch-place-unknown", "error", text, "--on")], USAGE)


def _dask(options: argparse.Namespace, workplace: Workplace, files: dict[str, bytes] | None, page: ProgressPage) -> Any:
    from .dask_crew import DaskCrew
    place = options.on.removeprefix("dask:")
    crew = DaskCrew("tcp:" + place if place.startswith("//") else place, workplace, files)
    page.link = crew.dashboard
    if page.link:
        print(f"dashboard: {page.link}", file=sys.stderr)
    return crew


def _run(options: argparse.Namespace, expanded: Expanded, store: Store, line: ProgressLine) -> tuple[Tally, bool]:
    """Runs what has no result. Whether the tables are to be written."""
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


def _report(options: argparse.Namespace, found: list[State], tally: Tally, store: Store | None) -> None:
    counts = {state: sum(one.state == state for one in found) for state in ("done", "failed", "blocked", "missing")}
    if options.json:
        units = [{"name": one.unit.name, "kind": one.unit.kind, "state": one.state, "code": one.code,
                  "key": one.unit.key} for one in found]
        warnings = [{"id": finding.id, "text": finding.text} for finding in tally.warnings]
        print(json.dumps({"folder": str(options.output) if options.output else None, "counts": counts,
                          "work": {"found": tally.found, "paid": tally.paid, "tried_again": tally.tried_again},
                          "units": units, "warnings": warnings}, indent=2))
        return
    if options.list:
        wide = max([4] + [len(one.unit.name) for one in found])
        print(f"{'unit':{wide}}  kind        state")
        for one in found:
            print(f"{one.unit.name:{wide}}  {one.unit.kind:10}  {one.state}")
    kinds = {kind: sum(one.unit.kind == kind for one in found) for kind in dict.fromkeys(one.unit.kind for one in found)}
    print(f"{len(found)} units ({', '.join(f'{kind}: {count}' for kind, count in kinds.items())}): " +
          ", ".join(f"{count} {state}" for state, count in counts.items() if count))
    if not options.list:
        print(f"computed now {tally.paid}, there before {tally.found}, tried again {tally.tried_again}")


def _findings(found: list[State], tally: Tally) -> list[Finding]:
    """Of units without a usable result."""
    findings = []
    names = {one.unit.key: one.unit.name for one in found}
    for one in found:
        name = one.unit.name
        result = one.result if one.state == "failed" else None
        if result:
            why = next((text for text in result["messages"] if "error: " in text), "it said nothing")
            text = f"the unit '{name}' ended with code {one.code}: {why}: correct its input and run the batch again"
            findings.append(error("batch-unit-failed", text))
        elif one.state == "blocked":
            needed = names.get(one.unit.after, "a fit")
            findings.append(error("batch-unit-blocked", f"the unit '{name}' needs '{needed}', which has no fit: see what "
                                  "is said of that one"))
        elif one.unit.key in tally.lost:
            why = tally.lost[one.unit.key].text
            findings.append(error("batch-unit-lost", f"the unit '{name}' has no result: {why}: run the batch again; "
                                  "results so far are kept"))
    return findings


def main(words: list[str]) -> int:
    options = options_of(words)
    if options.task:
        from .slurm import run_task
        return run_task(options.task)
    _check_place(options.on)
    expanded = expand(read_plan(options.plan), Program(options.program))
    if options.list:
        is_there = options.output and os.path.isdir(options.output)
        _report(options, states(expanded.units, Store(options.output) if is_there else None), Tally(), None)
        return 0
    store = Store.make(options.output)
    line = ProgressLine(len({unit.key for unit in expanded.units}))
    try:
        tally, is_whole = _run(options, expanded, store, line)
    finally:
        line.end()
    found = states(expanded.units, store)
    if is_whole:
        write_tables(found, store)
    if options.unpack:
        unpack(found, store)
    if store.damaged:
        tally.warnings.append(warning("batch-result-damaged", f"{len(store.damaged)} results were altered on disk and are "
                                      "computed again: check the disk if that was nobody's intention"))
    line.tell_warnings(tally)
    findings = _findings(found, tally)
    for finding in findings[:20]:
        print(finding, file=sys.stderr)
    if len(findings) > 20:
        print(f"and {len(findings) - 20} more; results.csv has the state of all", file=sys.stderr)
    _report(options, found, tally, store)
    return NOT_DONE if tally.lost else UNIT_FAILED if findings else 0


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
        text = f"cannot write: {fault}: free space and run the batch again; results so far are kept"
        print(error("batch-cannot-write", text), file=sys.stderr)
        return CANNOT_WRITE


if __name__ == "__main__":
    code = guarded(sys.argv[1:])
    try:
        sys.stderr.flush()
    finally:
        # Threads that wait for units do not keep the program.
        os._exit(code)
