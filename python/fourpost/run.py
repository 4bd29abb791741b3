"""Fits, the folders that they write, and what follows from them."""
from __future__ import annotations

import json
import os
import pathlib
import re
import shutil
import tempfile
import weakref
from dataclasses import dataclass
from typing import Any, Callable, Mapping

import pandas as pd

from . import _arrays, _core, _html
from .errors import Finding, refuse
from .inspection import recorded
from .study import Study
from .vehicle import Path, Vehicle, load


@dataclass(frozen=True)
class Progress:
    """How far a fit is."""

    stage: str
    """"search", "refine", ..."""
    evaluations: int
    """New ones so far."""
    failed: int
    """Of these, without a result."""
    best_cost: float
    """By the loss of the refinement; infinite before the first."""

    def __str__(self) -> str:
        return f"{self.stage}: {self.evaluations} evaluations, {self.failed} failed, best cost {self.best_cost:.5g}"


@dataclass(frozen=True)
class Prediction:
    """How well a fitted vehicle predicts a recording."""

    result: dict[str, Any]
    """As `fourpost predict --json` prints it (docs/reference.md)."""
    warnings: list[Finding]
    """What speaks against the prediction."""

    @property
    def channels(self) -> pd.DataFrame:
        """A row per channel, NMSE in percent and what else its kind of recording has."""
        return pd.DataFrame(self.result["channels"])

    def _repr_html_(self) -> str:
        title = _html.heading(self.result["recording"], ["predicted"])
        return title + _html.frame(self.channels) + _html.findings(self.warnings)


@dataclass(frozen=True)
class Choice:
    """The best of many settings of a vehicle."""

    result: dict[str, Any]
    """As `fourpost choose --json` prints it (docs/reference.md)."""
    warnings: list[Finding]
    """What speaks against the choice."""

    @property
    def best(self) -> dict[str, str] | None:
        """Position of each knob; nothing where no setting is admitted."""
        return self.result["best"]["setting"] if self.result["best"] else None

    @property
    def notable(self) -> pd.DataFrame:
        """A row per setting, with the numbers and units of `result`: the best, the present one, and those that cannot be
        distinguished from the best."""
        return pd.json_normalize(self.result["notable"])

    def _repr_html_(self) -> str:
        facts = [f"{knob} {position}" for knob, position in (self.best or {"no setting": "is admitted"}).items()]
        return _html.heading("Best setting", facts) + _html.frame(self.notable) + _html.findings(self.warnings)


class Run:
    """The folder of a fit: `fit` makes one, `read_run` opens it again."""

    folder: pathlib.Path
    """Where its files are (docs/reference.md)."""
    termination: str
    """"converged", "not_converged" or "interrupted"."""
    explains_data: bool
    """False where the model is no explanation of the data."""
    cost: float
    """Final sum of squared residuals over their standard deviations."""
    residuals: int
    """Their number."""
    warnings: list[Finding]
    """What speaks against the result."""

    def __init__(self, folder: Path):
        self.folder = pathlib.Path(folder)
        (self.termination, self.explains_data, self.cost, self.residuals, self._parameters,
         self.warnings) = _core.read_result(os.fspath(folder))

    @property
    def converged(self) -> bool:
        """Whether the fit came to its end."""
        return self.termination == "converged"

    @property
    def parameters(self) -> pd.DataFrame:
        """A row per fitted parameter by name, SI: value, sd (standard deviation), lower_95, upper_95, start, unit, state
        ("determined", "undetermined", "at_bound", ..., docs/reference.md) and at_bound. NaN without a standard
        deviation."""
        columns = ["value", "sd", "lower_95", "upper_95", "start", "unit", "state", "at_bound"]
        return _arrays.parameter_frame(self._parameters, columns)

    @property
    def vehicle(self) -> Vehicle:
        """The fitted one."""
        return load(self.folder / "vehicle.urdf")

    @property
    def result(self) -> dict[str, Any]:
        """result.json (docs/reference.md)."""
        content: dict[str, Any] = json.loads((self.folder / "result.json").read_text(encoding="utf-8"))
        return content

    @property
    def report(self) -> pathlib.Path:
        """The page of the fit."""
        return self.folder / "report.html"

    @property
    def response(self) -> Any:
        """Measured and modelled stepped sines, SI, the columns of response.csv, over recording, channel and
        frequency_Hz: an xarray.Dataset, NaN where a recording lacks a frequency. A frame with these as index without
        xarray, or where a recording has a frequency twice."""
        frame = self.table("response").set_index(["recording", "channel", "frequency_Hz"])
        try:
            import xarray  # noqa: F401
        except ImportError:
            return frame
        return frame.to_xarray() if frame.index.is_unique else frame

    def table(self, name: str) -> pd.DataFrame:
        """A table of the folder, with the columns and units that docs/reference.md names: "response", "history",
        "validation", "parameters" or another one.

        Raises InputError for one that the folder lacks.
        """
        tables = sorted(file.stem for file in self.folder.glob("*.csv"))
        if name not in tables:
            raise refuse("name-unknown", f"there is no table '{name}' in {self.folder}; there are: {', '.join(tables)}")
        return pd.read_csv(self.folder / f"{name}.csv", float_precision="round_trip")

    def draws(self, count: int = 200, *, seed: int = 1, noise_of: Path | None = None, threads: int = 0) -> pd.DataFrame:
        """Parameter values that the fit allows, count x p, a column per fitted parameter, SI; `attrs["units"]` has the
        units.

        noise_of: the file of the study that was fitted, of arrays `inputs/arrays.yaml` in the folder, to draw of the
            likelihood alone, as `fourpost draws --noise-only`; default: of all that the intervals allow for.
        """
        if count < 2:
            raise refuse("value-out-of-range", f"count is {count}: draw 2 or more")
        study = os.fspath(noise_of or "")
        names, units, values, _, warnings = _core.draw(os.fspath(self.folder), count, seed, study, threads)
        _arrays.warn(warnings)
        frame = pd.DataFrame(values, columns=names)
        frame.attrs["units"] = dict(zip(names, units))
        return frame

    def predict(self, recording: Path | pd.DataFrame, *, units: Mapping[str, str] | None = None, engine: str = "auto",
                posts: str = "", release: str = "", start_s: float | None = None, output: Path | None = None) -> Prediction:
        """How well the fitted vehicle predicts a recording.

        recording: a file, or a frame over time [s], a column for each channel that the study names, in `units`.
            Of a study of arrays: FL or post_FL, ... and the sensors.
        units: of each column of a frame; columns with the name of a post are in m unless stated.
        posts: how they moved, as `mode` of Vehicle.response; default: to be found in the recording.
        release: from where the vehicle was let go, as `--release` of `fourpost predict`: "at rest", "z_body=50 mm";
            default: as the study states.
        start_s: when, or from when on the recording counts; default: as the study states.
        output: a folder for the curves.
        """
        if isinstance(recording, pd.DataFrame):
            recording, units = _with_posts(recording, units or {}, self)
        with recorded(recording, units, _HINT) as file:
            text, warnings = _core.predict(os.fspath(self.folder), file, engine, posts, release, start_s,
                                           os.fspath(output or ""))
        return Prediction(json.loads(text), warnings)

    def __repr__(self) -> str:
        return f"<fourpost.Run '{self.folder}': {self.termination}, cost {self.cost:.6g}>"

    def _repr_html_(self) -> str:
        facts = [self.termination, f"cost {self.cost:.5g} for {self.residuals} residuals",
                 "explains the data" if self.explains_data else "does not explain the data", str(self.report)]
        return (_html.heading(str(self.folder), facts) + _html.frame(self.parameters.drop(columns="at_bound")) +
                _html.findings(self.warnings))


def _with_posts(frame: pd.DataFrame, units: Mapping[str, str], run: Run) -> tuple[pd.DataFrame, Mapping[str, str]]:
    """Posts by their own names, FL, where the run's study of arrays has them as post_FL; all are in m."""
    study = run.folder / "study.yaml"
    known = set(re.findall(r"\bpost_[\w.-]+", study.read_text())) if study.exists() else set()
    names = {name: f"post_{name}" for name in frame if f"post_{name}" in known and f"post_{name}" not in frame}
    units = {names.get(name, name): unit for name, unit in units.items()}
    posts = {name: "m" for name in [*frame, *names.values()] if name in known or name in run.vehicle.posts}
    return frame.rename(columns=names), {**posts, **units}


_HINT = ("a run of arrays expects post_NAME of each post and the names of the sensors, a run of a study the channels that it "
         "names, each with its unit in `units`")


def _series(version: str) -> list[str]:
    """Within which formats are alike: "1" of 1.2.3, "0", "2" of 0.2.1."""
    numbers = version.split(".")
    return numbers[:2] if numbers[0] == "0" else numbers[:1]


def read_run(folder: Path) -> Run:
    """The folder of a fit, also of one that was interrupted; a warning where it is of another major version of fourpost, or
    of another 0.x. Raises InputError."""
    file = pathlib.Path(folder, "result.json")
    if not file.exists():
        raise refuse("result-missing", f"there is no result.json in {os.fspath(folder)}: give the folder of a fit")
    run = Run(folder)
    of_run, own = str(run.result.get("versions", {}).get("fourpost", "an unknown version")), _core.version()
    if _series(of_run) != _series(own):
        text = f"perhaps not understood, for it is of fourpost {of_run}, and this is {own}: fit again with this version"
        _arrays.warn([Finding("result-not-understood", "warning", str(file), 0, "", text)])
    return run


def fit(study: Study | Path, output: Path | None = None, *, threads: int = 0, seed: int | None = None,
        progress: Callable[[Progress], object] | None = None, resume: bool = False, accept_unidentified: bool = False,
        accept_implausible: bool = False) -> Run:
    """Fits a study by dvHDE and Ceres, as `fourpost fit` does, to the last bit.

    output: the folder of the results, which must be new, empty or that of an earlier fit, from whose archive it goes
        on. Default: a temporary one that goes with the Run.
    threads: 0: one per processor. No influence on the result.
    seed: in place of the study's.
    progress: called by this thread with a Progress, ten times a second at the most.
    resume: go on from the archive of an interrupted fit; refuse to start anew.
    accept_unidentified, accept_implausible: fit although the data leave combinations of parameters open, or contradict
        the study.

    Warnings are those of Python, as they are found. Ctrl-C raises KeyboardInterrupt after the fit has written what it
    has; its note names the folder and says whether there are results for `read_run` or only evaluations to go on from.
    Raises InputError, SimulationError, OutputError.
    """
    folder = os.fspath(tempfile.mkdtemp(prefix="fourpost-") if output is None else output)
    core = (study if isinstance(study, Study) else Study(study))._core
    show = None if progress is None else lambda *state: progress(Progress(*state))
    try:
        _core.fit(core, folder, threads, seed, resume, accept_unidentified, accept_implausible, show,
                  lambda finding: _arrays.warn([finding]))
        run = Run(folder)
    except KeyboardInterrupt as interrupt:
        if hasattr(interrupt, "add_note"):
            has_results = pathlib.Path(folder, "result.json").exists()
            interrupt.add_note(f"fourpost: results so far are in {folder}" if has_results else
                               f"fourpost: no results yet; the same call with output='{folder}' goes on")
        raise
    except BaseException:
        if output is None:
            shutil.rmtree(folder, ignore_errors=True)
        raise
    if output is None:
        weakref.finalize(run, shutil.rmtree, folder, ignore_errors=True)
    return run


def choose(run: Run | Path, settings: Path, output: Path | None = None, *, threads: int = 0) -> Choice:
    """The best of up to 100 000 settings of a vehicle on random roads, as `fourpost choose`.

    run: a fit, whose intervals are the doubt, or a vehicle file, which has none.
    settings: a file of settings (studies/README.md).
    output: a folder for tables, pictures and the page.
    """
    subject = run.folder if isinstance(run, Run) else run
    text, warnings = _core.choose(os.fspath(subject), os.fspath(settings), threads, os.fspath(output or ""))
    return Choice(json.loads(text), warnings)
