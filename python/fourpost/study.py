"""Studies: a vehicle, experiments and a search; and what a fit of one minimises."""
from __future__ import annotations

import os
from dataclasses import KW_ONLY, dataclass, field
from typing import Mapping, Sequence, overload

import numpy as np
import numpy.typing as npt
import pandas as pd

from . import _arrays, _core, _html
from ._arrays import Floats
from .errors import refuse
from .vehicle import Path, Vehicle


@dataclass(frozen=True)
class Measured:
    """A measured response of a sensor, one value per frequency."""

    frf: npt.ArrayLike
    """F, complex, SI, as Response.frf."""
    relative_sd: npt.ArrayLike = 0.01
    """Standard deviation, F or one for all: relative to the gain, without unit; the phase's is the same in radians."""
    mean: npt.ArrayLike = ()
    """F, SI, as Response.mean; empty where it was not measured. Those of struts are fitted: they alone distinguish bump
    from rebound."""
    mean_sd: npt.ArrayLike = ()
    """Standard deviation of the mean, in its unit, F or one for all; empty where it is not known."""


@dataclass(frozen=True)
class SteppedSine:
    """A stepped sine on posts."""

    frequency: npt.ArrayLike
    """F, Hz."""
    amplitude: npt.ArrayLike
    """Of the reference post [m]: F, or one for all."""
    channels: Mapping[str, Measured | npt.ArrayLike]
    """F values, SI, by the name of their sensor: an array is a `Measured` with its standard deviation of 1 %. A
    sensor of one test is fitted in all tests of a study."""
    posts: str = "heave"
    """As `mode` of Vehicle.response."""
    name: str = ""
    """Of the recording in results; default: its file in the run's folder `inputs`."""
    _: KW_ONLY
    validation: bool = False
    """Left out of the fit and predicted after it."""


@dataclass(frozen=True)
class TimeHistory:
    """A recording over time on moving posts."""

    posts: pd.DataFrame | Mapping[str, npt.ArrayLike]
    """N heights [m] of each post by its name, as in Vehicle.simulate."""
    channels: pd.DataFrame | Mapping[str, npt.ArrayLike]
    """N readings of each sensor by its name, in its SI unit."""
    rate: float | None = None
    """Hz; needed where `posts` is no frame over time."""
    noise: Mapping[str, float] = field(default_factory=dict)
    """Standard deviation of a sensor's reading at rest, in its SI unit; zero of those that are not named."""
    low_pass: tuple[int, float] | None = None
    """Order and cut-off [Hz] of the causal Butterworth filter through which all was recorded."""
    validation: bool = False
    """Left out of the fit and predicted after it."""
    name: str = ""
    """Of the recording in results; default: its file in the run's folder `inputs`."""


@dataclass(frozen=True)
class Bench:
    """A damper on its bench."""

    rate: float
    """Hz"""
    displacement: npt.ArrayLike
    """N samples of the damper's extension [m]."""
    force: npt.ArrayLike
    """N samples of its tension [N]."""
    validation: bool = False
    """Left out of the fit and predicted after it."""


@dataclass(frozen=True)
class ModelError:
    """What a model cannot show of its data, beside their noise, as one standard deviation."""

    gain_dB: float = 1
    """Of responses to stepped sines."""
    phase_deg: float = 5
    """The same of phases."""
    floor: float = 0.03
    """Least error next to a node, as a share of the largest channel of that unit at that frequency."""
    history: float = 0.02
    """As a share of the standard deviation of each channel."""
    bench: float = 0.05
    """Of forces on a bench, as a share of their standard deviation."""
    mean: float = 0.3e-3
    """Of mean offsets of struts [m], beside their `mean_sd`."""


class Study:
    """What a fit is asked for: a study file, which decides all by itself, or a vehicle and arrays in memory.

    model: a Vehicle, or the path of a study file, with which all below keep their values.
    tests: experiments in memory.
    free: parameters to fit; none: all that have a range.
    band: fitted frequencies of stepped sines [Hz]; none: all.
    static_loads: load and standard deviation [N] of each tyre that was weighed; with tyre forces they set the scale of
        masses and rates.
    seed, evaluations, starts: of the search; `starts` of its distinct good points are refined.

    What is wrong with the arrays is raised when the study is used.
    """

    name: str
    """Of the vehicle, or the path of the study file."""

    def __init__(self, model: Vehicle | Path, tests: Sequence[SteppedSine | TimeHistory | Bench] = (), *,
                 free: str | Sequence[str] = (), band: tuple[float, float] | None = None,
                 model_error: ModelError | None = None, static_loads: Mapping[str, tuple[float, float]] | None = None,
                 seed: int = 1, evaluations: int = 100, starts: int = 4):
        self._core = _core.Study(model._core if isinstance(model, Vehicle) else os.fspath(model))
        self.name = model.name if isinstance(model, Vehicle) else os.fspath(model)
        for test in tests:
            self._add(test)
        self._core.free = [free] if isinstance(free, str) else list(free)
        self._core.band_Hz = band
        self._core.seed, self._core.evaluations, self._core.starts = seed, evaluations, starts
        self._core.set_loads(dict(static_loads or {}))
        if model_error is not None:
            self._core.set_model_error(model_error.gain_dB, model_error.phase_deg, model_error.floor,
                                       model_error.history, model_error.bench, model_error.mean)

    def _add(self, test: SteppedSine | TimeHistory | Bench) -> None:
        if isinstance(test, SteppedSine):
            channels = {name: _measured(name, one) for name, one in test.channels.items()}
            self._core.add_sine(test.name, test.posts, _arrays.vector("frequency", test.frequency),
                                _arrays.vector("amplitude", test.amplitude), channels, test.validation)
        elif isinstance(test, TimeHistory):
            posts, rate = _arrays.series("posts", test.posts, test.rate)
            channels_, _ = _arrays.series("channels", test.channels, rate)
            self._core.add_history(test.name, rate, posts, channels_, dict(test.noise), test.low_pass, test.validation)
        else:
            self._core.add_bench(test.rate, _arrays.vector("displacement", test.displacement),
                                 _arrays.vector("force", test.force), test.validation)

    def write(self, folder: Path) -> str:
        """Writes a study from arrays with its vehicle and recordings into a folder, and returns its file; a study file
        is returned as it is."""
        return os.fspath(self._core.write(os.fspath(folder)))

    def objective(self) -> Objective:
        """What a fit of it minimises, for an optimiser or a sampler of your own. Raises InputError."""
        return Objective(self)


def _measured(name: str, one: Measured | npt.ArrayLike) -> tuple[npt.NDArray[np.complex128], Floats, Floats, Floats]:
    measured = one if isinstance(one, Measured) else Measured(one)
    frf = np.atleast_1d(_arrays.numbers_of(f"channel '{name}'", measured.frf, complex))
    if frf.ndim != 1:
        raise refuse("table-shape", f"channel '{name}' has {frf.ndim} dimensions: give one value per frequency")
    sd, mean_sd = (_arrays.vector(f"{what} of '{name}'", numbers)
                   for what, numbers in (("relative_sd", measured.relative_sd), ("mean_sd", measured.mean_sd)))
    return (frf, _one_for_all(sd, frf), _arrays.vector(f"the mean of '{name}'", measured.mean), _one_for_all(mean_sd, frf))


def _one_for_all(numbers: Floats, frf: npt.NDArray[np.complex128]) -> Floats:
    return np.full(frf.shape, numbers[0]) if numbers.size == 1 else numbers


class Objective:
    """Residuals of a study over its p free parameters, for an optimiser or a sampler of your own.

    x holds their values, SI, in the order of `parameters`: p numbers, or n x p for many points in one pass, computed by
    `threads` threads (0: one per processor; without influence on the result). Residuals are differences over standard
    deviations, those of priors last; complex ones count twice. It is the model before the fit's correction by the full
    geometry, which only time histories have.
    """

    study: Study
    """The one it is of."""

    def __init__(self, study: Study | Path):
        self.study = study if isinstance(study, Study) else Study(study)
        self._core = _core.Objective(self.study._core)

    @property
    def parameters(self) -> pd.DataFrame:
        """A row per free parameter by name: value in the vehicle's file, lower, upper and unit, SI."""
        return _arrays.parameter_frame(self._core.parameters, ["value", "lower", "upper", "unit"])

    @property
    def count(self) -> int:
        """Residuals, N."""
        return self._core.count

    def residuals(self, x: npt.ArrayLike, threads: int = 0) -> Floats:
        """N residuals of one point; n x N of many, NaN where the model has none, for which one point raises
        SimulationError (`evaluation-failed`).

        x: p values or n x p, SI.
        """
        points = _arrays.numbers_of("x", x)
        if points.ndim < 2:
            return self._core.residuals(_arrays.vector("x", points))
        return self._core.residuals_at(self._table(points), threads)

    def jacobian(self, x: npt.ArrayLike) -> Floats:
        """d residuals / d x, N x p, of one point within the ranges: by the model where it has derivatives, good for
        steps of a refinement, else by central differences. Raises InputError (`value-out-of-range`) outside.

        x: p values, SI.
        """
        return self._core.jacobian(_arrays.vector("x", x))

    @overload
    def cost(self, x: Sequence[float], threads: int = 0) -> float: ...
    @overload
    def cost(self, x: npt.ArrayLike, threads: int = 0) -> float | Floats: ...
    def cost(self, x: npt.ArrayLike, threads: int = 0) -> float | Floats:
        """What the fit minimises: the sum of squared residuals, or of the study's loss of them; one number, or n; NaN
        where the model has none. Half of it is the negative logarithm of the likelihood of normal noise without a
        loss.

        x: p values or n x p, SI.
        """
        points = _arrays.numbers_of("x", x)
        if points.ndim < 2:
            return float(self._core.costs_at(self._table(_arrays.vector("x", points)[None]), 1)[0])
        return self._core.costs_at(self._table(points), threads)

    def _table(self, points: Floats) -> Floats:
        return _arrays.table(points, list(self.parameters.index))[1]

    def _repr_html_(self) -> str:
        title = _html.heading(f"Objective of {self.study.name}", [f"{self.count} residuals"])
        return title + _html.frame(self.parameters)
