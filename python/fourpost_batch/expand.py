"""A plan becomes units: each with the files that it reads, by their hashes, and its call of the program."""
from __future__ import annotations

import concurrent.futures
import fnmatch
import json
import os
import pathlib
from dataclasses import dataclass
from typing import Iterable, Sequence

from . import findings, look
from .errors import BatchError, Finding, did_you_mean
from .findings import Kind
from .plan import Entry, Plan
from .program import Program
from .store import file_hash
from .unit import FIT_FOLDER, Unit

Files = list[tuple[str, pathlib.Path]]
"""Where a file stands for the unit, and where it is here."""
MOST_NAMES = 20
"""In a message."""
RUN_FILES = ("result.json", "vehicle.urdf", "study.yaml")


@dataclass
class Expanded:
    """The units of a plan, each after the one that it needs, and where their input files are."""

    units: list[Unit]
    sources: dict[str, pathlib.Path]
    """Of input files by hash."""


def expand(plan: Plan, program: Program) -> Expanded:
    """The units of a plan, as `units`, and their input files by hash, as `sources`. Raises BatchError with all that is
    wrong: studies and recordings are read, and what the program would refuse is refused before anything is computed."""
    return _Expansion(plan, program).run()


class _Expansion:
    def __init__(self, plan: Plan, program: Program):
        self.plan, self.program = plan, program
        self.findings: list[Finding] = []
        self.units: dict[str, Unit] = {}
        self.fits: dict[str, list[tuple[Unit, Files]]] = {}
        """By all names that 'of' may use: of a study with all its seeds, of a unit, of an entry of several studies."""
        self.groups: set[str] = set()
        """Those of entries of several studies."""
        self.sources: dict[str, pathlib.Path] = {}
        self.hashes: dict[pathlib.Path, str] = {}
        self.inputs: dict[pathlib.Path, list[pathlib.Path]] = {}
        """Files by the study that reads them."""
        self.channels: dict[pathlib.Path, list[str]] = {}
        """By recordings of predictions."""

    def run(self) -> Expanded:
        self._look()
        for section, add in (("fits", self._fit), ("predictions", self._prediction), ("choices", self._choice),
                             ("comparisons", self._comparison), ("coverage", self._coverage)):
            for entry in self.plan.of(section):
                add(entry)
        if self.findings:
            raise BatchError(dict.fromkeys(self.findings))
        return Expanded(list(self.units.values()), self.sources)

    def _refuse(self, entry: Entry, kind: Kind, *words: object) -> None:
        self.findings.append(kind(*words, file=self.plan.shown, line=entry.line))

    # What the program says of files, of each once and of several at a time.

    def _look(self) -> None:
        studies = self._files("study")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            of_studies = [pool.submit(look.inputs_of, self.program, study) for study in studies]
            recordings = self._files("recordings")
            of_recordings = [pool.submit(look.channels_of, self.program, recording) for recording in recordings]
            for study, inputs in zip(studies, of_studies):
                self.inputs[study], faults = inputs.result()
                self.findings += faults
            for recording, channels in zip(recordings, of_recordings):
                self.channels[recording], faults = channels.result()
                self.findings += faults
            fits = [(entry, study) for entry in self.plan.of("fits") for study in entry["study"]]
            names = [pool.submit(look.refused_parameters, self.program, self.inputs[study], entry.get("set") or {},
                                 entry.get("profile") or []) for entry, study in fits]
            for (entry, _), refused in zip(fits, names):
                self.findings += [finding._replace(file=self.plan.shown, line=entry.line) for finding in refused.result()]

    def _files(self, key: str) -> list[pathlib.Path]:
        return list(dict.fromkeys(file for entry in self.plan.entries for file in entry.get(key) or []))

    # Sections.

    def _fit(self, entry: Entry) -> None:
        options = [f"--set={name}={value}" for name, value in (entry.get("set") or {}).items()]
        options += ["--grow"] * bool(entry.get("grow")) + ["--no-suggest"] * (entry.get("suggest") is False)
        options += ["--accept-implausible"] * bool(entry.get("accept_implausible"))
        options += ["--accept-unidentified"] * bool(entry.get("accept_unidentified"))
        options += [f"--profile={','.join(entry['profile'])}"] if entry.get("profile") else []
        group = entry.get("name") if len(entry["study"]) > 1 else None
        if group in self.fits and group not in self.groups:
            self._refuse(entry, findings.NAME_TWICE, group)
        for study, name in _names(entry, entry["study"]):
            files = _relative(self.inputs[study], study.parent)
            if name in self.fits:
                self._refuse(entry, findings.NAME_TWICE, name)
                continue
            fits = self.fits[name] = []
            for seed in entry.get("seeds") or [None]:
                seeded = [f"--seed={seed}"] if seed is not None else []
                command = ["fit", study.name, "-o", FIT_FOLDER, "--threads=1", *options, *seeded]
                unit = self._add(entry, name + (f"/seed{seed}" if seed is not None else ""), "fit", command, files,
                                 keep=self.plan.keep)
                fits.append((unit, files))
                self.fits[unit.name] = [(unit, files)] if unit.name != name else fits
            if group:
                self.groups.add(group)
                self.fits.setdefault(group, []).extend(fits)

    def _prediction(self, entry: Entry) -> None:
        options = [f"--{key}={entry[key]}" for key in ("mode", "engine") if entry.get(key)]
        for recording, label in _labels(entry["recordings"]):
            given = f"given/{recording.name}"
            command = ["predict", FIT_FOLDER, "--recording", given, "--json", *options]
            self._of_runs(entry, _named(entry, f"predict/{label}"), "prediction", command, [(given, recording)])

    def _choice(self, entry: Entry) -> None:
        for settings, label in _labels(entry["settings"]):
            given = f"given/{settings.name}"
            options = ["--settings", given, "--threads=1", "--json"] + ["--no-checks"] * (entry.get("checks") is False)
            name = _named(entry, f"choose/{label}")
            self._of_runs(entry, name, "choice", ["choose", FIT_FOLDER, *options],
                          [(given, settings)])
            for vehicle, car in _labels(entry.get("vehicle") or []):
                files = _relative([vehicle, *look.meshes_of(vehicle)], vehicle.parent) + [(given, settings)]
                self._add(entry, f"{car}/{name}", "choice",
                          ["choose", vehicle.name, *options], files)

    def _comparison(self, entry: Entry) -> None:
        options = [f"--methods={','.join(entry['methods'])}"] if entry.get("methods") else []
        options += [f"--{key}={entry[key]}" for key in ("runs", "evaluations", "near") if entry.get(key)]
        for study, label in _names(entry, entry["study"]):
            for seed in entry.get("seeds") or [1]:
                name = f"compare/{label}/seed{seed}"
                self._add(entry, name, "comparison",
                          ["compare", study.name, "--threads=1", "--json", f"--seed={seed}", *options],
                          _relative(self.inputs[study], study.parent))

    def _coverage(self, entry: Entry) -> None:
        for script, label in _names(entry, entry["script"]):
            files = _relative([script, *(entry.get("files") or [])], script.parent)
            for number in entry["numbers"]:
                words = [word.replace("{number}", str(number)) for word in entry["arguments"]]
                self._add(entry, f"{label}/{number}", "coverage", [script.name, *words], files,
                          first="{python}")

    # Units.

    def _of_runs(self, entry: Entry, name: str, kind: str, command: list[str], given: Files) -> None:
        """A unit for each fit of the plan that 'of' names, and each folder that 'run' names."""
        found: dict[str, tuple[Unit, Files]] = {}
        for pattern in entry.get("of") or []:
            chosen = {one[0].name: one for fit, fits in self.fits.items() if fnmatch.fnmatchcase(fit, pattern) for one in fits}
            if not chosen:
                names = [*self.fits][:MOST_NAMES] + ["..."] * (len(self.fits) > MOST_NAMES)
                self._refuse(entry, findings.RUN_UNKNOWN, pattern, did_you_mean(pattern, self.fits),
                             ", ".join(names) or "'fits', which are none")
            found.update(chosen)
        self._compare_channels(entry, list(found.values()), given[0][1])
        for unit, files in found.values():
            self._add(entry, f"{unit.name}/{name}", kind, command, files + given, after=unit.key)
        for folder in entry.get("run") or []:
            if self._is_of_this_version(entry, folder):
                files = [(f"{FIT_FOLDER}/{file}", folder / file) for file in RUN_FILES if (folder / file).exists()]
                self._add(entry, f"{folder.name}/{name}", kind, command, files + given)

    def _compare_channels(self, entry: Entry, fits: list[tuple[Unit, Files]], recording: pathlib.Path) -> None:
        """Of a recording to predict, with what the studies of the fits name."""
        channels = self.channels.get(recording)
        # Seeds of a study share its files.
        for unit, files in {id(files): (unit, files) for unit, files in reversed(fits)}.values() if channels else []:
            if not look.knows_one_of([path for _, path in files], channels or []):
                self._refuse(entry, findings.RECORDING_UNLIKE, unit.name, recording.name, ", ".join(channels or []))

    def _is_of_this_version(self, entry: Entry, folder: pathlib.Path) -> bool:
        try:
            version = json.loads((folder / "result.json").read_text())["versions"]["fourpost"]
        except (OSError, ValueError, KeyError, TypeError):
            self._refuse(entry, findings.FILE_MISSING, folder / "result.json", ", which a fit writes")
            return False
        if version != self.program.version:
            self._refuse(entry, findings.RUN_OF_OTHER_VERSION, folder, version, self.program.version)
        return bool(version == self.program.version)

    def _add(self, entry: Entry, name: str, kind: str, command: Sequence[str], files: Files, *, keep: Sequence[str] = (),
             after: str = "", first: str = "{program}") -> Unit:
        inputs = []
        for place, path in dict(files).items():
            if digest := self._hash(entry, path):
                inputs.append((place, digest))
        unit = Unit(name, kind, (first, *command), tuple(sorted(inputs)), self.program.build, tuple(keep), after)
        if name in self.units:
            self._refuse(entry, findings.NAME_TWICE, name)
        self.units[name] = unit
        return unit

    def _hash(self, entry: Entry, path: pathlib.Path) -> str:
        if path not in self.hashes:
            try:
                digest = self.hashes[path] = file_hash(path)
                self.sources[digest] = path
            except OSError as fault:
                self._refuse(entry, findings.FILE_MISSING, path, f" ({fault.strerror})")
                self.hashes[path] = ""
        return self.hashes[path]


def _labels(files: list[pathlib.Path]) -> list[tuple[pathlib.Path, str]]:
    """Each with its name without suffix, and with its folders below those that all have where two names are the same."""
    if len({file.stem for file in files}) == len(files):
        return [(file, file.stem) for file in files]
    common = os.path.commonpath([file.parent for file in files])
    return [(file, os.path.relpath(file.with_suffix(""), common)) for file in files]


def _names(entry: Entry, files: list[pathlib.Path]) -> list[tuple[pathlib.Path, str]]:
    """Each with the name of its units."""
    name: str | None = entry.get("name")
    if name is not None and len(files) == 1:
        return [(files[0], name)]
    return [(file, label if name is None else f"{name}/{label}") for file, label in _labels(files)]


def _named(entry: Entry, name: str) -> str:
    """With the entry's own name before it, where it has one."""
    return f"{entry['name']}/{name}" if entry.get("name") else name


def _relative(paths: Iterable[pathlib.Path], folder: pathlib.Path) -> Files:
    return [(os.path.relpath(path, folder), path) for path in paths]
