"""What recordings hold before there is a fit, and frequency responses of time histories."""
from __future__ import annotations

import json
import os
import tempfile
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any, Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt
import pandas as pd

from . import _arrays, _core, _html
from ._arrays import Complexes, Floats, Quantity
from .errors import Error, Finding, InputError, refuse
from .study import Measured, SteppedSine
from .units import to_si
from .vehicle import Path


@contextmanager
def recorded(recording: Path | pd.DataFrame, units: Mapping[str, str] | None,
             hint: str = "`units` has that of each") -> Iterator[str]:
    """The file of a recording; that of a frame is temporary, and errors about it are about the frame."""
    if not isinstance(recording, pd.DataFrame):
        yield os.fspath(recording)
        return
    units = units or {}
    with tempfile.TemporaryDirectory() as scratch:
        file = os.path.join(scratch, "recording.csv")
        table = recording.rename_axis("time").reset_index()
        of_columns = {"time": "s", **units}
        table.columns = pd.MultiIndex.from_tuples([(name, of_columns.get(str(name), "")) for name in table])
        table.to_csv(file, index=False)
        try:
            yield file
        except Error as error:
            raise _about_frame(error, recording, units, file, hint) from None


def _about_frame(error: Error, frame: pd.DataFrame, units: Mapping[str, str], file: str, hint: str) -> Error:
    """With the frame's columns in place of lines."""
    findings = [finding._replace(file="the frame", line=0) if finding.file == file else finding
                for finding in error.findings]
    columns = ", ".join(f"{name} [{units.get(str(name), 'no unit')}]" for name in frame)
    message = "\n".join(str(finding) for finding in findings) or str(error).replace(file, "the frame")
    return type(error)(f"{message}\nthe frame has the columns {columns}; {hint}", findings)


def _in_frame(findings: list[Finding], recording: Path | pd.DataFrame, file: str) -> list[Finding]:
    if not isinstance(recording, pd.DataFrame):
        return findings
    return [finding._replace(file="the frame", line=0) if finding.file == file else finding for finding in findings]


@dataclass(frozen=True)
class Info:
    """What a recording or a study holds, and what is doubtful about it."""

    result: dict[str, Any]
    """A member of `files` of `fourpost info --json` (docs/reference.md)."""
    text: str
    """As the program prints it; so does print()."""
    warnings: list[Finding]
    """Of a study: channels that contradict the others."""

    @property
    def kind(self) -> str:
        """"stepped_sine", "time_history", "study", ..."""
        return str(self.result["kind"])

    @property
    def channels(self) -> pd.DataFrame:
        """A row per channel, with the numbers and units of `result`: of a recording its unit, span, level, noise at rest
        and so on; of a study what each leaves over of the motion that all agree on. Empty without an audit."""
        rows = self.result.get("channels") or (self.result.get("audit") or {}).get("channels") or []
        return pd.DataFrame(rows)

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        title = _html.heading(str(self.result["file"]), [self.kind.replace("_", " ")])
        rows = self.channels.apply(lambda column: column.map(lambda x: "; ".join(x) if isinstance(x, list) else x))
        return title + _html.frame(rows) + _html.findings([*self.result.get("refusals", []), *self.warnings])


def info(recording: Path | pd.DataFrame, *, units: Mapping[str, str] | None = None) -> Info:
    """What a recording or a study holds, as `fourpost info`: channels with units, rate, gaps, spans, clipping, drift and
    noise at rest, and why a fit would refuse it; of a study which channels contradict the others.

    recording: a file, or a frame of N samples over time [s].
    units: of each column of a frame.

    Warnings are those of Python. Raises InputError.
    """
    with recorded(recording, units) as file:
        text, shown, warnings = _core.describe(file)
    result = json.loads(text)
    if isinstance(recording, pd.DataFrame):
        result["file"], shown = "the frame", shown.replace(file, "the frame")
        warnings = _in_frame(warnings, recording, file)
    _arrays.warn(warnings)
    return Info(result, shown, warnings)


@dataclass(frozen=True)
class MeasuredPattern:
    """Measured responses of C channels to one pattern of the posts, at F frequencies."""

    name: str
    """"heave", "posts"; "heave_2" of the second amplitude at its frequencies."""
    posts: str
    """As `mode` of Vehicle.response."""
    reference: str
    """The post that responses are relative to."""
    off_pattern: float
    """Share of the posts' motion that is not of this pattern."""
    frequency: Floats
    """F, Hz."""
    amplitude: Floats
    """F, m; of the reference post."""
    repeats: list[int]
    """Stepped sines: dwells at each frequency; else empty."""
    units: dict[str, str]
    """SI unit of each channel, in the order of the rows below."""
    frf: Complexes
    """C x F, SI, as Response.frf."""
    gain_sd: Floats
    """C x F: standard deviation of the gain, in its unit."""
    phase_sd: Floats
    """C x F: of the phase [rad]."""
    mean: Floats
    """C x F: mean reading less that at rest, in `units`; NaN where it is not known."""
    mean_sd: Floats
    """C x F: standard deviation of the mean, in `units`; NaN where it is not known."""
    second_harmonic: Floats
    """C x F: amplitude, in `units`; NaN where it is not known."""
    coherence: Floats
    """C x F, without unit, of sweeps and random motions; else NaN."""

    @property
    def channels(self) -> list[str]:
        """Names, in the order of the rows."""
        return list(self.units)

    def __getitem__(self, channel: str) -> Complexes:
        """F, SI: the row of `frf` of a channel. Raises InputError (`name-unknown`)."""
        row: Complexes = self.frf[self._place(channel)]
        return row

    def _place(self, channel: str) -> int:
        if channel not in self.units:
            raise refuse("name-unknown", f"there is no channel '{channel}'; there are: {', '.join(self.units)}")
        return self.channels.index(channel)

    def to_frame(self) -> pd.DataFrame:
        """A row per channel and frequency, SI: gain, phase_deg, gain_sd, phase_sd_deg, mean, mean_sd,
        second_harmonic, coherence."""
        count = len(self.frequency)
        return pd.DataFrame({"channel": np.repeat(self.channels, count),
                             "unit": np.repeat(list(self.units.values()), count),
                             "frequency_Hz": np.tile(self.frequency, len(self.units)),
                             "post_amplitude_m": np.tile(self.amplitude, len(self.units)),
                             "gain": np.abs(self.frf).ravel(), "phase_deg": np.degrees(np.angle(self.frf)).ravel(),
                             "gain_sd": self.gain_sd.ravel(), "phase_sd_deg": np.degrees(self.phase_sd).ravel(),
                             "mean": self.mean.ravel(), "mean_sd": self.mean_sd.ravel(),
                             "second_harmonic": self.second_harmonic.ravel(), "coherence": self.coherence.ravel()})

    def sine(self, channels: Sequence[str] | Mapping[str, str] | None = None) -> SteppedSine:
        """As an experiment of a Study.

        channels: to fit: names, if channels are called as the sensors, or channels by their sensor; default: all.

        One standard deviation stands for gain and phase, the root of the mean of both squares.
        """
        names = self.channels if channels is None else channels
        by_sensor = dict(names) if isinstance(names, Mapping) else {name: name for name in names}
        measured = {}
        for sensor, channel in by_sensor.items():
            at = self._place(channel)
            share = self.gain_sd[at] / np.abs(self.frf[at])
            sd = np.sqrt((share ** 2 + self.phase_sd[at] ** 2) / 2)
            mean: npt.ArrayLike = self.mean[at] if np.isfinite(self.mean[at]).all() else ()
            mean_sd: npt.ArrayLike = self.mean_sd[at] if np.isfinite(self.mean_sd[at]).all() else ()
            measured[sensor] = Measured(self.frf[at], sd, mean, mean_sd)
        return SteppedSine(self.frequency, self.amplitude, measured, posts=self.posts, name=self.name)


@dataclass(frozen=True)
class FrfMeasurement:
    """Frequency responses that were made of time histories."""

    kind: str
    """How the posts moved: "stepped", "sweep", "random" or "multisine"."""
    rate: float
    """Hz"""
    duration: float
    """s"""
    patterns: dict[str, MeasuredPattern]
    """By name: one for each pattern of the posts and, of stepped sines, each amplitude at the same frequency."""
    left_out: list[str]
    """Columns that are no response of a vehicle."""
    result: dict[str, Any]
    """As `fourpost frf --json` prints it (docs/reference.md)."""
    text: str
    """As the program prints it; so does print()."""
    study_section: str
    """The part of a study that takes the recordings of `output`."""
    warnings: list[Finding]
    """What speaks against the responses."""

    def __getitem__(self, pattern: str) -> MeasuredPattern:
        """By its name. Raises InputError (`name-unknown`)."""
        if pattern not in self.patterns:
            raise refuse("name-unknown", f"there is no pattern '{pattern}'; there are: {', '.join(self.patterns)}")
        return self.patterns[pattern]

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        facts = [f"{self.duration:g} s at {self.rate:g} Hz", f"patterns {', '.join(self.patterns)}"]
        rows = pd.concat([pd.DataFrame({"pattern": one.name, "unit": one.units.values(),
                                        "median sd, %": 100 * np.median(one.gain_sd / np.abs(one.frf), axis=1)},
                                       index=one.channels) for one in self.patterns.values()])
        return _html.heading(f"Responses to a {self.kind} motion", facts) + _html.frame(rows) + _html.findings(self.warnings)


def frf(recordings: Path | pd.DataFrame | Sequence[Path], *, posts: Mapping[str, str] | None = None, reference: str = "",
        kind: str = "", low_pass: tuple[int, float] | None = None, frequency: npt.ArrayLike | None = None,
        beside: Mapping[str, Quantity] | None = None, units: Mapping[str, str] | None = None,
        output: Path | None = None) -> FrfMeasurement:
    """Frequency responses of time histories of one motion, as `fourpost frf`: dwells of stepped sines, sweeps, random
    motions or multisines, with standard deviations.

    recordings: a file, several of the same channels, or a frame of N samples over time [s].
    posts: channel of the displacement of each post, by the post's name: {"FL": "LVDT 1"}; default: channels named
        post_FL, FL and the like, or with words that mean a post.
    reference: post that responses are relative to; default: the first that moves most.
    kind: "stepped", "sweep", "random", "multisine"; default: found in the posts' motion.
    low_pass: order and cut-off [Hz] of the Butterworth filter through which all was recorded.
    frequency: F rising numbers [Hz]; default: of sweeps and random motions 64 in the band of the posts, of stepped sines
        those of the dwells that are found.
    beside: files of other recorders, and by how much their clocks are ahead: s, or a text with a unit.
    units: of each column of a frame.
    output: a folder for the recordings, their pictures and the section of a study.

    Warnings are those of Python. Raises InputError, OutputError.
    """
    others = [(os.fspath(file), to_si(ahead, "s") if isinstance(ahead, str) else float(ahead))
              for file, ahead in (beside or {}).items()]
    hertz = _arrays.vector("frequency", [] if frequency is None else frequency)
    options = (dict(posts or {}), reference, kind, low_pass, hertz, others, os.fspath(output or ""))
    try:
        if isinstance(recordings, Sequence) and not isinstance(recordings, str):
            found = _measured([os.fspath(file) for file in recordings], *options)
        else:
            with recorded(recordings, units) as file:
                found = _measured([file], *options)
                found = replace(found, warnings=_in_frame(found.warnings, recordings, file))
    except InputError as error:
        if "response-posts-unknown" in error.ids and hasattr(error, "add_note"):
            error.add_note("fourpost.frf: posts={\"FL\": CHANNEL, ...}")
        raise
    _arrays.warn(found.warnings)
    return found


def _measured(files: list[str], *options: Any) -> FrfMeasurement:
    kind, rate, duration, rows, left_out, text, shown, section, warnings = _core.measure_frf(files, *options)
    patterns = {row[0]: _pattern(*row) for row in rows}
    return FrfMeasurement(kind, rate, duration, patterns, left_out, json.loads(text), shown, section, warnings)


def _pattern(name: str, posts: str, reference: str, off_pattern: float, frequency: list[float], amplitude: list[float],
             repeats: list[int], channels: Sequence[tuple[Any, ...]]) -> MeasuredPattern:
    def stacked(place: int) -> Any:
        missing = np.full(len(frequency), np.nan)
        return np.array([channel[place] if len(channel[place]) else missing for channel in channels])
    units = {channel[0]: channel[1] for channel in channels}
    return MeasuredPattern(name, posts, reference, off_pattern, np.array(frequency), np.array(amplitude), repeats, units,
                           *(stacked(place) for place in range(2, 9)))
