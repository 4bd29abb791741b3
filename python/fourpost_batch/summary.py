"""Tables of all results, in the order of the plan; they hold nothing of when, where and by whom units were run."""
from __future__ import annotations

import csv
import io
import json
import os
import pathlib
from dataclasses import dataclass
from typing import Any, Iterable, Iterator

from . import findings
from .errors import Finding
from .store import Store, write_whole
from .unit import Unit

PRINTED = {"fit": "printed.txt", "coverage": "result.csv"}
"""Files for what units print; that of the others is JSON."""


@dataclass(frozen=True)
class State:
    """What became of a unit."""

    unit: Unit
    state: str
    """"done"; "failed": by its inputs; "blocked": the fit that it needs has failed; "missing": not run yet, or lost."""
    code: int | None
    """Exit code, of one that has a result."""
    warnings: int
    """That it gave."""
    store: Store | None

    @property
    def result(self) -> dict[str, Any] | None:
        """Read anew: those of a large batch are more than memory holds."""
        return self.store.get(self.unit.key) if self.store and self.code is not None else None


def states(units: Iterable[Unit], store: Store | None) -> list[State]:
    """In the order of the units."""
    units, found = list(units), []
    results = ((unit.key, store.get(unit.key) if store else None) for unit in units)
    facts: dict[str, tuple[int, int]] = {key: (result["code"], len(warnings_of(result))) for key, result in results if result}
    for unit in units:
        code, warnings = facts.get(unit.key, (None, 0))
        if code is not None:
            state = "done" if code < (1 if unit.kind == "coverage" else 2) else "failed"
        else:
            state = "blocked" if facts.get(unit.after, (0, 0))[0] >= 2 else "missing"
        found.append(State(unit, state, code, warnings, store))
    return found


def warnings_of(result: dict[str, Any]) -> list[Finding]:
    return findings.read("\n".join(result["messages"]), "warning")


def write_tables(found: list[State], store: Store, *, keeps: bool = False) -> None:
    """results.csv, and one table for each kind of unit that has rows for it; `keeps` those of other kinds, of a plan that
    had such units before. Raises OSError."""
    # After an update of the program nothing of the plan is there yet, and the tables are all that shows earlier results.
    if all(one.code is None for one in found) and (store.folder / "results.csv").exists():
        return
    tables = {"results": _csv(["unit", "kind", "state", "code", "warnings", "key"],
                              [[s.unit.name, s.unit.kind, s.state, s.code, s.warnings, s.unit.key] for s in found]),
              "parameters": _parameters(found), "predictions": _predictions(found),
              "comparisons": _comparisons(found), "choices": _choices(found), "coverage": _coverage(found)}
    for name, text in tables.items():
        if text:
            write_whole(store.folder / f"{name}.csv", text.encode("utf-8", "surrogateescape"))
        elif not keeps and all(one.state != "missing" for one in found):
            (store.folder / f"{name}.csv").unlink(missing_ok=True)


def unpack(found: list[State], store: Store) -> None:
    """Files of results as `runs/NAME/...`, for reports and other programs. Raises OSError."""
    for one in found:
        result = one.result
        if result is None:
            continue
        folder = store.folder / "runs" / pathlib.PurePosixPath(one.unit.name)
        folder.mkdir(parents=True, exist_ok=True)
        files = dict(result["files"])
        if result["printed"]:
            files[PRINTED.get(one.unit.kind, "result.json")] = result["printed"]
        for name, text in files.items():
            write_whole(folder / os.path.basename(name), text.encode("utf-8", "surrogateescape"))


def _csv(head: list[str], rows: list[list[Any]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue() if rows else ""


def _documents(found: list[State], kind: str) -> Iterator[tuple[Unit, dict[str, Any]]]:
    """Results in JSON."""
    for one in found:
        result = one.result if one.unit.kind == kind and one.state == "done" else None
        text = (result["files"].get("result.json") if kind == "fit" else result["printed"]) if result else None
        if text:
            yield one.unit, json.loads(text)


def _parameters(found: list[State]) -> str:
    head = ["unit", "study", "seed", "set", "parameter", "value", "value_unit", "sd", "lower", "upper", "state", "cost",
            "misfit", "explains_data", "termination"]
    rows = []
    for unit, result in _documents(found, "fit"):
        values = "; ".join(word.removeprefix("--set=") for word in unit.command if word.startswith("--set="))
        explains = (result["verdict"] or {}).get("explains_data")
        of_fit = [result["cost"], result["misfit"], None if explains is None else str(explains).lower(), result["termination"]]
        for one in result["parameters"]:
            low, high = one.get("interval_95") or (None, None)
            rows.append([unit.name, result["study"], result["seed"], values, one["name"], one["value"], one["unit"],
                         one["sd"], low, high, one["state"], *of_fit])
    return _csv(head, rows)


def _predictions(found: list[State]) -> str:
    rows = [[unit.name, result["recording"], one["name"], one["nmse_percent"]]
            for unit, result in _documents(found, "prediction") for one in result.get("channels", [])]
    return _csv(["unit", "recording", "channel", "nmse_percent"], rows)


def _comparisons(found: list[State]) -> str:
    rows = [[unit.name, one["name"], one["runs"], one["successes"], one["expected_evaluations"]]
            for unit, result in _documents(found, "comparison") for one in result.get("methods", [])]
    return _csv(["unit", "method", "runs", "successes", "expected_evaluations"], rows)


def _choices(found: list[State]) -> str:
    rows = [[unit.name, knob, position] for unit, result in _documents(found, "choice")
            for knob, position in ((result.get("best") or {}).get("setting") or {}).items()]
    return _csv(["unit", "knob", "best"], rows)


def _coverage(found: list[State]) -> str:
    """What the scripts printed, one after the other; a first line that all have stands once."""
    done = (one.result for one in found if one.unit.kind == "coverage" and one.state == "done")
    texts: list[str] = [result["printed"] for result in done if result]
    heads = {text.split("\n", 1)[0] for text in texts}
    if len(texts) < 2 or len(heads) > 1:
        return "".join(texts)
    return texts[0] + "".join(text.split("\n", 1)[1] if "\n" in text else "" for text in texts[1:])
