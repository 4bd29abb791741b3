"""Tables of all results, in the order of the plan; they hold nothing of when, where and by whom units were run."""
from __future__ import annotations

import csv
import io
import json
import os
import pathlib
from dataclasses import dataclass
from typing import Any, Iterable, Iterator

from .store import Store, write_whole
from .unit import Unit


@dataclass(frozen=True)
class State:
    """What became of a unit."""

    unit: Unit
    state: str
    """"done"; "failed": by its inputs; "blocked": the fit that it needs has failed; "missing": not run yet, or lost."""
    code: int | None
    """Exit code, of one that has a result."""
    store: Store | None

    @property
    def result(self) -> dict[str, Any] | None:
        """Read anew: those of a large batch are more than memory holds."""
        return self.store.get(self.unit.key) if self.store and self.code is not None else None


def states(units: Iterable[Unit], store: Store | None) -> list[State]:
    """In the order of the units."""
    units, found = list(units), []
    results = ((unit.key, store.get(unit.key) if store else None) for unit in units)
    codes: dict[str, int] = {key: result["code"] for key, result in results if result}
    for unit in units:
        code = codes.get(unit.key)
        if code is not None:
            state = "done" if code < (1 if unit.kind == "coverage" else 2) else "failed"
        else:
            state = "blocked" if codes.get(unit.after, 0) >= 2 else "missing"
        found.append(State(unit, state, code, store))
    return found


def write_tables(found: list[State], store: Store) -> None:
    """results.csv, and one table for each kind of unit that has rows for it. Raises OSError."""
    tables = {"results": _csv(["unit", "kind", "state", "code", "key"],
                              [[s.unit.name, s.unit.kind, s.state, s.code, s.unit.key] for s in found]),
              "parameters": _parameters(found), "predictions": _predictions(found),
              "comparisons": _comparisons(found), "choices": _choices(found), "coverage": _coverage(found)}
    for name, text in tables.items():
        if text:
            write_whole(store.folder / f"{name}.csv", text.encode("utf-8", "surrogateescape"))
        else:
            # Of a plan that had such units before.
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
            files["result.csv" if one.unit.kind == "coverage" else "result.json"] = result["printed"]
        for name, text in files.items():
            write_whole(folder / os.path.basename(name), text.encode("utf-8", "surrogateescape"))


def _csv(head: list[str], rows: list[list[Any]]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows(rows)
    return text.getvalue() if rows else ""


def _documents(found: list[State], kind: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """Results in JSON, by the name of their unit."""
    for one in found:
        result = one.result if one.unit.kind == kind and one.state == "done" else None
        if result:
            text = result["files"].get("result.json") if kind == "fit" else result["printed"]
            yield one.unit.name, json.loads(text) if text else {}


def _parameters(found: list[State]) -> str:
    rows = []
    for name, result in _documents(found, "fit"):
        for one in result.get("parameters", []):
            low, high = one.get("interval_95") or (None, None)
            rows.append([name, one["name"], one["value"], one["sd"], low, high, one["state"], result["cost"],
                         result["termination"]])
    return _csv(["unit", "parameter", "value", "sd", "lower", "upper", "state", "cost", "termination"], rows)


def _predictions(found: list[State]) -> str:
    rows = [[name, result["recording"], one["name"], one["nmse_percent"]]
            for name, result in _documents(found, "prediction") for one in result.get("channels", [])]
    return _csv(["unit", "recording", "channel", "nmse_percent"], rows)


def _comparisons(found: list[State]) -> str:
    rows = [[name, one["name"], one["runs"], one["successes"], one["expected_evaluations"]]
            for name, result in _documents(found, "comparison") for one in result.get("methods", [])]
    return _csv(["unit", "method", "runs", "successes", "expected_evaluations"], rows)


def _choices(found: list[State]) -> str:
    rows = [[name, knob, position] for name, result in _documents(found, "choice")
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
