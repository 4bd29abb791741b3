"""Plans: the YAML file that says what to run. All that is wrong is found at once, with its line."""
from __future__ import annotations

import glob
import os
import pathlib
import re
import sys
from dataclasses import dataclass
from typing import Any, Callable

from . import findings
from .errors import USAGE, BatchError, Finding, did_you_mean
from .findings import Kind

DEFAULT_KEEP: tuple[str, ...] = ("result.json", "vehicle.urdf", "study.yaml", "parameters.csv")
ENGINES = ("auto", "reduced", "full")
MODES = ("heave", "pitch", "roll", "warp")
MOST = 1_000_000
"""Numbers in one range."""


@dataclass(frozen=True)
class Entry:
    """An item of a section: `values` by key, and its line."""

    section: str
    line: int
    values: dict[str, Any]

    def __getitem__(self, key: str) -> Any:
        return self.values[key]

    def get(self, key: str, default: Any = None) -> Any:
        return self.values.get(key, default)


@dataclass(frozen=True)
class Plan:
    """What a file asks for; paths in it are absolute."""

    file: pathlib.Path
    """The plan's."""
    shown: str
    """The file as it was named."""
    entries: list[Entry]
    """Of all sections, in the order of the file: `section`, `line`, and `values` by key."""
    keep: tuple[str, ...] = DEFAULT_KEEP
    """Patterns of files in the folder of a fit that its result holds."""

    def of(self, section: str) -> list[Entry]:
        """Entries of a section, such as "fits"."""
        return [entry for entry in self.entries if entry.section == section]


class _Reader:
    """Reads values of YAML nodes, and collects what is wrong with them."""

    def __init__(self, file: pathlib.Path, shown: str):
        self.file, self.shown, self.findings = file, shown, list[Finding]()

    def refuse(self, node: Any, kind: Kind, *words: object) -> None:
        self.findings.append(kind(*words, file=self.shown, line=node.start_mark.line + 1))

    def wrong(self, node: Any, key: str, remedy: str) -> None:
        shown = {"sequence": "a list", "mapping": "keys with values"}.get(node.id) or f"'{str(node.value)[:80]}'"
        self.refuse(node, findings.VALUE_WRONG, key, shown, remedy)

    # Each reads the value of `key`; nothing, and reported, where that is none.

    def text(self, node: Any, key: str) -> str | None:
        if node.id == "scalar" and node.value.strip() and not node.tag.endswith(":null"):
            return str(node.value)
        self.wrong(node, key, "write a word or a number")
        return None

    def name(self, node: Any, key: str) -> str | None:
        """One that may be a folder."""
        text = self.text(node, key)
        if text is None or re.fullmatch(r"\w[\w.+-]*", text):
            return text
        self.wrong(node, key, "write letters, digits, '_', '-', '+' and '.'")
        return None

    def texts(self, node: Any, key: str) -> list[str]:
        items = node.value if node.id == "sequence" else [node]
        return [text for item in items if (text := self.text(item, key)) is not None]

    def flag(self, node: Any, key: str) -> bool | None:
        if node.tag.endswith(":bool"):
            return bool(node.value.lower() in ("true", "yes", "on"))
        self.wrong(node, key, "write true or false")
        return None

    def whole(self, node: Any, key: str) -> int | None:
        if node.id == "scalar" and re.fullmatch(r"\d{1,15}", node.value) and int(node.value) > 0:
            return int(node.value)
        self.wrong(node, key, "write a whole number above 0")
        return None

    def numbers(self, node: Any, key: str) -> list[int] | None:
        """Of "1..20", of 7, or of a list of such."""
        found: list[int] = []
        for item in node.value if node.id == "sequence" else [node]:
            ends = re.fullmatch(r"(\d{1,18})(?:\.\.(\d{1,18}))?", item.value) if item.id == "scalar" else None
            first, last = (int(ends[1]), int(ends[2] or ends[1])) if ends else (1, 0)
            if last < first or last - first >= MOST:
                self.wrong(item, key, "write whole numbers, as 1..20, 7 or [1, 2, 5]")
                return None
            found += range(first, last + 1)
        if len(set(found)) < len(found):
            self.wrong(node, key, "name each number once")
            return None
        return found

    def files(self, node: Any, key: str) -> list[pathlib.Path]:
        """Paths and patterns, relative to the plan."""
        return self._paths(node, key, pathlib.Path.is_file)

    def folders(self, node: Any, key: str) -> list[pathlib.Path]:
        """The same of folders."""
        return self._paths(node, key, pathlib.Path.is_dir)

    def _paths(self, node: Any, key: str, fits: Callable[[pathlib.Path], bool]) -> list[pathlib.Path]:
        found: list[pathlib.Path] = []
        for text, item in zip(self.texts(node, key), node.value if node.id == "sequence" else [node]):
            path = self.file.parent / text
            if glob.has_magic(text) and not path.exists():
                names = sorted(glob.glob(text, root_dir=self.file.parent, recursive=True))
                paths = [one for name in names if fits(one := self.file.parent / name)]
            else:
                paths = [path] if path.exists() else []
            if not paths:
                near = did_you_mean(path.name, os.listdir(path.parent)) if path.parent.is_dir() else ""
                self.refuse(item, findings.FILE_MISSING, text, near)
            found += (pathlib.Path(os.path.abspath(one)) for one in paths)
        return found

    def mode(self, node: Any, key: str) -> str | None:
        text = self.text(node, key)
        if text is not None and text not in MODES and "=" not in text:
            self.wrong(node, key, f"write one of {', '.join(MODES)}, or the share of each post, such as FL=1,FR=-1")
        return text

    def engine(self, node: Any, key: str) -> str | None:
        text = self.text(node, key)
        if text is not None and text not in ENGINES:
            self.wrong(node, key, f"write one of {', '.join(ENGINES)}")
        return text

    def settings(self, node: Any, key: str) -> dict[str, str] | None:
        """Values of parameters: {k: 20 kN/m}."""
        if node.id != "mapping":
            self.wrong(node, key, "write parameters with their values, as {k: 20 kN/m}")
            return None
        values = {}
        for name, value in node.value:
            if value.id == "scalar" and value.value.strip() and not value.tag.endswith(":null"):
                values[str(name.value)] = str(value.value)
            else:
                self.wrong(value, name.value, "write one value with its unit, such as 20 kN/m; for several values write "
                           "an entry for each, with a 'name' of its own")
        return values


R = _Reader
_RUN = {"of": R.texts, "run": R.folders, "name": R.name}
KEYS: dict[str, dict[str, Callable[[_Reader, Any, str], Any]]] = {
    "fits": {"study": R.files, "name": R.name, "seeds": R.numbers, "set": R.settings, "grow": R.flag,
             "suggest": R.flag, "accept_implausible": R.flag, "accept_unidentified": R.flag, "profile": R.texts},
    "predictions": {**_RUN, "recordings": R.files, "mode": R.mode, "engine": R.engine},
    "choices": {**_RUN, "vehicle": R.files, "settings": R.files, "checks": R.flag},
    "comparisons": {"study": R.files, "name": R.name, "methods": R.texts, "runs": R.whole, "seeds": R.numbers,
                    "evaluations": R.whole, "near": R.text},
    "coverage": {"script": R.files, "name": R.name, "files": R.files, "arguments": R.texts, "numbers": R.numbers},
}
"""Sections of a plan, and how each key of theirs is read."""
NEEDED = {"fits": ["study"], "predictions": ["recordings"], "choices": ["settings"], "comparisons": ["study"],
          "coverage": ["script", "arguments", "numbers"]}


def _entry(reader: _Reader, section: str, node: Any) -> Entry | None:
    if node.id != "mapping":
        reader.wrong(node, section, "write a list of entries, each with keys")
        return None
    values: dict[str, Any] = {}
    for name, value in node.value:
        known = KEYS[section]
        if name.value not in known:
            near = did_you_mean(str(name.value), known)
            reader.refuse(name, findings.KEY_UNKNOWN, name.value, near, ", ".join(known))
        elif name.value in values:
            reader.refuse(name, findings.PLAN_MALFORMED, f"the key '{name.value}' stands twice")
        else:
            values[name.value] = known[name.value](reader, value, name.value)
    for needed in NEEDED[section]:
        if needed not in values:
            reader.refuse(node, findings.KEY_MISSING, needed, f"an entry of '{section}' needs it")
    places = [key for key in ("of", "run", "vehicle") if key in values]
    if "of" in KEYS[section] and not places:
        reader.refuse(node, findings.KEY_MISSING, "of", "name an entry of 'fits', or a folder by 'run'")
    return Entry(section, node.start_mark.line + 1, values)


def read_plan(file: str | os.PathLike[str]) -> Plan:
    """Reads a plan (docs/batch.md). Raises BatchError with all that is wrong."""
    try:
        import yaml
    except ImportError:
        lacks = findings.LACKS_PACKAGE("PyYAML", sys.executable, "apt install python3-yaml")
        raise BatchError([lacks], USAGE) from None
    path = pathlib.Path(file)
    try:
        root = yaml.compose(path.read_text(encoding="utf-8"), Loader=yaml.SafeLoader)
    except FileNotFoundError:
        raise BatchError([findings.FILE_MISSING(file, "")]) from None
    except (OSError, UnicodeDecodeError) as fault:
        raise BatchError([findings.PLAN_MALFORMED(fault, file=file)]) from None
    except yaml.YAMLError as fault:
        mark = getattr(fault, "problem_mark", None)
        why = getattr(fault, "problem", None) or fault
        raise BatchError([findings.PLAN_MALFORMED(why, file=file, line=mark.line + 1 if mark else 0)]) from None
    reader = _Reader(pathlib.Path(os.path.abspath(path)), str(file))
    if root is None or root.id != "mapping":
        why = f"it has none of the sections {', '.join(KEYS)}"
        raise BatchError([findings.PLAN_MALFORMED(why, file=file, line=1)])
    entries, keep = [], DEFAULT_KEEP
    for name, value in root.value:
        if name.value == "keep":
            keep = tuple(sorted({*DEFAULT_KEEP[:3], *reader.texts(value, "keep")}))
        elif name.value not in KEYS:
            near = did_you_mean(str(name.value), [*KEYS, "keep"])
            reader.refuse(name, findings.KEY_UNKNOWN, name.value, near, ", ".join([*KEYS, "keep"]))
        elif value.id != "sequence":
            reader.wrong(value, name.value, "write a list of entries, each with keys")
        else:
            entries += [entry for item in value.value if (entry := _entry(reader, name.value, item))]
    if not reader.findings and not entries:
        reader.findings.append(findings.EMPTY(file=file, line=1))
    if reader.findings:
        raise BatchError(reader.findings)
    return Plan(reader.file, str(file), entries, keep)
