"""What is said of a batch at its end: units without a usable result, warnings of units, counts."""
from __future__ import annotations

import argparse
import collections
import json
import re
import sys
from typing import Iterable

from . import findings
from .errors import DEFECT, Finding, Trouble
from .run import Tally
from .summary import State, warnings_of

MOST_LINES = 20
REFUSED = {"build": "its worker has another build of fourpost", "files": "its worker does not see its files",
           "program": "its worker has no program fourpost", "disk": "the disk of its worker is full"}
"""Kinds of trouble of which a warning about the worker says more."""


Warned = list[tuple[Finding, list[str]]]
"""A finding, and the names of the units that gave it."""


def print_report(options: argparse.Namespace, found: list[State], tally: Tally, warned: Warned) -> None:
    counts = {state: sum(one.state == state for one in found) for state in ("done", "failed", "blocked", "missing")}
    if options.json:
        units = [{"name": one.unit.name, "kind": one.unit.kind, "state": one.state, "code": one.code,
                  "warnings": one.warnings, "key": one.unit.key} for one in found]
        warnings = [{"id": finding.id, "text": finding.text, "units": names}
                    for finding, names in [*((finding, []) for finding in tally.warnings), *warned]]
        print(json.dumps({"folder": str(options.output) if options.output else None, "counts": counts,
                          "work": {"found": tally.found, "paid": tally.paid, "tried_again": tally.tried_again},
                          "units": units, "warnings": warnings}, indent=2))
        return
    if options.list:
        wide = max([4] + [len(one.unit.name) for one in found])
        print(f"{'unit':{wide}}  kind        state    warnings")
        for one in found:
            print(f"{one.unit.name:{wide}}  {one.unit.kind:10}  {one.state:7}  {one.warnings or ''}".rstrip())
    kinds = collections.Counter(one.unit.kind for one in found)
    print(f"{len(found)} unit{'s' * (len(found) != 1)} ({', '.join(f'{kind}: {count}' for kind, count in kinds.items())}): " +
          ", ".join(f"{count} {state}" for state, count in counts.items() if count))
    if not options.list:
        print(f"computed now {tally.paid}, there before {tally.found}, tried again {tally.tried_again}")


def print_some(lines: Iterable[object]) -> None:
    """On stderr."""
    lines = list(lines)
    for line in lines[:MOST_LINES]:
        print(line, file=sys.stderr)
    if len(lines) > MOST_LINES:
        print(f"and {len(lines) - MOST_LINES} more; results.csv has the state of all", file=sys.stderr)


def of_units(names: list[str]) -> str:
    others = len(names) - 1
    return f"the unit '{names[0]}'" + (f" and {others} other{'s' * (others > 1)}" if others else "")


def findings_of_units(found: list[State], tally: Tally) -> list[Finding]:
    """Of those without a usable result; units with the same reason share one."""
    names = {one.unit.key: one.unit.name for one in found}
    results = {one.unit.name: f"units/{one.unit.key[:2]}/{one.unit.key}.json" for one in found}
    groups: dict[tuple[findings.Kind, tuple[object, ...]], list[str]] = collections.defaultdict(list)
    for one in found:
        result = one.result if one.state == "failed" else None
        if result:
            why = next((text for text in result["messages"] if "error: " in text), "it said nothing")
            # A script of coverage may end with any code.
            is_defect = one.code == DEFECT and one.unit.kind != "coverage"
            kind, words = (findings.UNIT_DEFECT, (why,)) if is_defect else (findings.UNIT_FAILED, (one.code, why))
            groups[kind, words].append(one.unit.name)
        elif one.state == "blocked":
            groups[findings.UNIT_BLOCKED, (names.get(one.unit.after, "its fit"),)].append(one.unit.name)
        elif one.unit.key in tally.lost:
            groups[findings.UNIT_LOST, (_reason(tally.lost[one.unit.key]),)].append(one.unit.name)
    return [kind(of_units(units), *words, *([results[units[0]]] if kind is findings.UNIT_DEFECT else []))
            for (kind, words), units in groups.items()]


def warnings_of_units(found: list[State]) -> Warned:
    """Each that differs from others by more than its numbers: that of the first unit, and the names of all."""
    groups: dict[tuple[str, str], tuple[Finding, list[str]]] = {}
    for one in found:
        for finding in warnings_of(one.result or {"messages": []}) if one.warnings else []:
            _, names = groups.setdefault((finding.id, re.sub(r"[\d.]+", "", str(finding))), (finding, []))
            if one.unit.name not in names[-1:]:
                names.append(one.unit.name)
    return list(groups.values())


def _reason(trouble: Trouble) -> str:
    return REFUSED.get(trouble.kind, trouble.text)
