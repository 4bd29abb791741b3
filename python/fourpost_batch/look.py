"""What the program says of the files of a plan before anything is computed. Each call returns what is wrong as well."""
from __future__ import annotations

import json
import os
import pathlib
import re
import subprocess
from typing import Any, Mapping, Sequence

from . import findings
from .errors import Finding, did_you_mean
from .program import Program


def inputs_of(program: Program, study: pathlib.Path) -> tuple[list[pathlib.Path], list[Finding]]:
    """The files that a study reads, itself first."""
    try:
        is_problem = re.search(r"^problem\s*:", study.read_text("utf-8", "replace"), re.M)
    except OSError as fault:
        return [], [findings.FILE_MISSING(study, f" ({fault.strerror})")]
    if is_problem:
        return [study], []
    about, faults = _info(program, study)
    files = [pathlib.Path(os.path.abspath(name)) for name in about["inputs"]] if about else []
    return list(dict.fromkeys(files + [mesh for file in files for mesh in meshes_of(file)])), faults


def meshes_of(vehicle: pathlib.Path) -> list[pathlib.Path]:
    """What a vehicle file refers to; what is missing the program reports."""
    if vehicle.suffix != ".urdf":
        return []
    names = re.findall(r"""\bfile(?:name)?\s*=\s*["']([^"']+)["']""", vehicle.read_text("utf-8", "replace"))
    paths = (vehicle.parent / re.sub(r"^(package|file)://", "", name) for name in names)
    return [pathlib.Path(os.path.abspath(path)) for path in paths if path.is_file()]


def channels_of(program: Program, recording: pathlib.Path) -> tuple[list[str], list[Finding]]:
    """Of a recording, which is read as a whole."""
    about, faults = _info(program, recording)
    return [channel["name"] for channel in about.get("channels", [])] if about else [], faults


def knows_one_of(inputs: Sequence[pathlib.Path], channels: Sequence[str]) -> bool:
    """Whether a study or its vehicle names a channel."""
    texts = "".join(file.read_text("utf-8", "replace") for file in inputs if file.suffix in (".yaml", ".yml", ".urdf"))
    return any(re.search(rf"(?<!\w){re.escape(channel)}(?!\w)", texts) for channel in channels)


def refused_parameters(program: Program, inputs: Sequence[pathlib.Path], values: Mapping[str, str],
                       profiles: Sequence[str]) -> list[Finding]:
    """Names of `set` and `profile` that the vehicle of a study lacks, and values without their unit."""
    vehicles = [file for file in inputs if file.suffix == ".urdf"]
    return [finding for vehicle in vehicles for finding in
            _refused_settings(program, vehicle, values) + _refused_profiles(program, vehicle, profiles)]


def _refused_settings(program: Program, vehicle: pathlib.Path, values: Mapping[str, str]) -> list[Finding]:
    if not values:
        return []
    said = _say(program, "check", vehicle, *(f"--set={name}={value}" for name, value in values.items())).stderr
    return [finding for finding in findings.read(said, "error") if finding.file == "--set"]


def _refused_profiles(program: Program, vehicle: pathlib.Path, names: Sequence[str]) -> list[Finding]:
    said = _say(program, "params", vehicle, "--json") if names else None
    if said is None or said.returncode != 0:
        return []
    known = [one["name"] for one in json.loads(said.stdout)["parameters"]]
    remedy = f"write parameters of the vehicle, which has {', '.join(known)}, or all"
    return [findings.VALUE_WRONG("profile", f"'{name}'{did_you_mean(name, known)}", remedy)
            for name in names if name not in [*known, "all"]]


def _info(program: Program, file: pathlib.Path) -> tuple[dict[str, Any] | None, list[Finding]]:
    outcome = _say(program, "info", file, "--json")
    if outcome.returncode != 0:
        return None, findings.read(outcome.stderr, "error") or [findings.FILE_REFUSED(file, " ".join(outcome.stderr.split()))]
    about: dict[str, Any] = json.loads(outcome.stdout)["files"][0]
    return about, []


def _say(program: Program, *words: str | pathlib.Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program.path, *words], capture_output=True, text=True)
