"""Steady responses to stepped sines, and histories over moving posts."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from ._arrays import Complexes, Floats
from .errors import refuse

if TYPE_CHECKING:
    import xarray


def _place(names: list[str], name: str) -> int:
    if name not in names:
        raise refuse("name-unknown", f"there is no sensor '{name}'; there are: {', '.join(names)}")
    return names.index(name)


@dataclass(frozen=True)
class Response:
    """The steady response to a stepped sine, S sensors at F frequencies.

    A signal of phasor X is x(t) = Re(X exp(i 2 pi f t)): a channel that lags the post has a negative phase. Axes are
    those of ISO 8855 (x forward, y left, z up); extension and rebound are positive, and so is more load on a tyre.
    """

    mode: str
    """Motion of the posts: "heave", "FL=1,FR=-1", ..."""
    frequency: Floats
    """F, Hz."""
    amplitude: Floats
    """F, m; of the reference post."""
    units: dict[str, str]
    """SI unit of each sensor's reading, in the order of the rows below."""
    frf: Complexes
    """S x F, SI: first harmonic over that of the reference post: over its acceleration for accelerometers, else over
    its displacement. NaN where no steady motion was found."""
    mean: Floats
    """S x F: mean reading less that at rest, in `units`."""
    second_harmonic: Floats
    """S x F: amplitude, in `units`."""
    engine: str
    """The one that answered."""
    kinematics_error_dB: float | None = None
    """Largest error of linear kinematics in gain, as far as engine "auto" could estimate it."""
    kinematics_error_deg: float | None = None
    """The same in phase."""

    @property
    def sensors(self) -> list[str]:
        """Names, in the order of the rows."""
        return list(self.units)

    def __getitem__(self, sensor: str) -> Complexes:
        """F, SI: the row of `frf` of a sensor. Raises InputError (`name-unknown`)."""
        row: Complexes = self.frf[_place(self.sensors, sensor)]
        return row

    def to_frame(self) -> pd.DataFrame:
        """A row per sensor and frequency, SI, with columns of response.csv: gain, phase_deg, mean, second_harmonic."""
        sensors, count = self.sensors, len(self.frequency)
        return pd.DataFrame({"channel": np.repeat(sensors, count),
                             "unit": np.repeat(list(self.units.values()), count),
                             "frequency_Hz": np.tile(self.frequency, len(sensors)),
                             "post_amplitude_m": np.tile(self.amplitude, len(sensors)),
                             "gain": np.abs(self.frf).ravel(),
                             "phase_deg": np.degrees(np.angle(self.frf)).ravel(),
                             "mean": self.mean.ravel(),
                             "second_harmonic": self.second_harmonic.ravel()})

    def to_xarray(self) -> xarray.Dataset:
        """frf, mean and second_harmonic over sensor and frequency [Hz]; needs xarray."""
        return _dataset(self, ["sensor", "frequency"], {})

    def _repr_html_(self) -> str:
        from . import _html
        peak = np.nanargmax(np.where(np.isfinite(self.frf), np.abs(self.frf), -1), axis=1)
        rows = pd.DataFrame({"unit": list(self.units.values()), "peak gain": np.abs(self.frf)[range(len(peak)), peak],
                             "at Hz": self.frequency[peak]}, index=self.sensors)
        title = _html.heading(self.mode, [f"{len(self.frequency)} frequencies", f"engine {self.engine}"])
        return title + _html.frame(rows)


@dataclass(frozen=True)
class Responses:
    """Steady responses of n cars to one stepped sine; arrays are those of Response with a first axis of n cars."""

    mode: str
    """As in Response."""
    frequency: Floats
    """F, Hz."""
    amplitude: Floats
    """F, m; of the reference post."""
    units: dict[str, str]
    """SI unit of each sensor's reading, in the order of the second axis below."""
    frf: Complexes
    """n x S x F, SI, as Response.frf; NaN in the rows of `failures`, here and below."""
    mean: Floats
    """n x S x F: mean reading less that at rest, in `units`."""
    second_harmonic: Floats
    """n x S x F: amplitude, in `units`."""
    parameters: list[str]
    """Names of the columns of `values`."""
    values: Floats
    """n x p, SI."""
    engines: list[str | None]
    """The one that answered, of each car; nothing where there is no response."""
    failures: dict[int, str]
    """Why a car has no response, by its row."""

    @property
    def sensors(self) -> list[str]:
        """Names, in the order of the second axis."""
        return list(self.units)

    def __len__(self) -> int:
        """n"""
        return len(self.values)

    def __getitem__(self, sensor: str) -> Complexes:
        """n x F, SI: `frf` of a sensor. Raises InputError (`name-unknown`)."""
        return self.frf[:, _place(self.sensors, sensor)]

    def to_xarray(self) -> xarray.Dataset:
        """frf, mean and second_harmonic over car, sensor and frequency [Hz], parameters along car; needs xarray."""
        cars = {name: ("car", self.values[:, column]) for column, name in enumerate(self.parameters)}
        return _dataset(self, ["car", "sensor", "frequency"], cars)


def _dataset(response: Response | Responses, axes: list[str], more: dict[str, Any]) -> xarray.Dataset:
    import xarray
    arrays = {name: (axes, getattr(response, name)) for name in ("frf", "mean", "second_harmonic")}
    coordinates = {"sensor": response.sensors, "unit": ("sensor", list(response.units.values())),
                   "frequency": ("frequency", response.frequency, {"units": "Hz"}),
                   "amplitude": ("frequency", response.amplitude, {"units": "m"}), **more}
    return xarray.Dataset(arrays, coordinates, {"mode": response.mode})


@dataclass(frozen=True)
class History:
    """Readings of a car over moving posts, N samples of S sensors."""

    frame: pd.DataFrame
    """N x S, a column per sensor, in `units`; the index is time [s]."""
    rate: float
    """Hz"""
    units: dict[str, str]
    """SI unit of each sensor's reading, in the order of the columns."""
    engine: str
    """The one that answered: "reduced" or "full"."""
    step_change: float | None = None
    """Largest change of a channel by the last halving of the step, over its rms; the error left is about a third."""
    kinematics_error: float | None = None
    """Largest error of linear kinematics over a channel's rms, as far as engine "auto" could estimate it."""

    def __getitem__(self, sensor: str) -> Floats:
        """N readings of a sensor, in `units`. Raises InputError (`name-unknown`)."""
        _place(list(self.units), sensor)
        column: Floats = self.frame[sensor].to_numpy()
        return column

    def _repr_html_(self) -> str:
        from . import _html
        rms = np.sqrt((self.frame ** 2).mean())
        rows = pd.DataFrame({"unit": self.units, "rms": rms, "peak": self.frame.abs().max()})
        title = f"{len(self.frame)} samples at {self.rate:g} Hz"
        return _html.heading(title, [f"engine {self.engine}"]) + _html.frame(rows)
