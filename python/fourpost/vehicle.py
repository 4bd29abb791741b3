"""A vehicle file, its responses and its motion."""
from __future__ import annotations

import os
from typing import Mapping, Sequence

import numpy as np
import numpy.typing as npt
import pandas as pd

from . import _arrays, _core, _html
from ._arrays import Floats, Quantity, Values
from .errors import Finding, refuse
from .modes import Modes, modes_of
from .response import History, Response, Responses

Path = str | os.PathLike[str]


class Vehicle:
    """A vehicle description, see `load`. It never changes: `at` gives another one.

    All values are SI, angles in radians. Posts, sensors and parameters go by their names in the file.
    """

    def __init__(self, core: _core.Vehicle):
        self._core = core

    @property
    def name(self) -> str:
        """As the file has it."""
        return self._core.name

    @property
    def links(self) -> list[str]:
        """Names of the bodies."""
        return self._core.links

    @property
    def posts(self) -> list[str]:
        """Names."""
        return self._core.posts

    @property
    def sensors(self) -> dict[str, str]:
        """SI unit of the readings by name."""
        return self._core.sensors

    @property
    def parameters(self) -> pd.DataFrame:
        """A row per number that can be fitted, by name: value, lower, upper and unit, SI. Without a range both bounds
        are the value."""
        return _arrays.parameter_frame(self._core.parameters, ["value", "lower", "upper", "unit"])

    def __getitem__(self, parameter: str) -> float:
        """The value of a parameter, SI. Raises InputError (`name-unknown`)."""
        return self._core.value(parameter)

    def at(self, values: Mapping[str, Quantity] | None = None, /, **more: Quantity) -> Vehicle:
        """The vehicle at other values of some parameters: numbers in SI, or texts with a unit ("50 kN/m").

        Raises InputError for names, units and signs that cannot be; a value outside its range is allowed.
        """
        core = self._core.copy()
        for name, value in _arrays.values_of(values, more).items():
            core.set(name, value)
        return Vehicle(core)

    def check(self) -> list[Finding]:
        """What is implausible, as `fourpost check` warns: odd numbers, places, motion ratios, loads."""
        return _core.check_vehicle(self._core)

    def text(self) -> str:
        """The text of the file with the present values, for a file in the same folder."""
        return self._core.text()

    def response(self, mode: str = "heave", *, frequency: npt.ArrayLike | None = None,
                 amplitude: npt.ArrayLike | None = None, engine: str = "auto", stroke: float = 0.15,
                 **values: Quantity) -> Response:
        """The steady response to a stepped sine on the posts.

        mode: "heave" or "bounce", "pitch", "roll", "warp", or shares of posts, "FL=1,FR=-1".
        frequency: F positive numbers [Hz] in the order of the sweep; default: 40 from 0.5 to 30 Hz.
        amplitude: of the reference post [m], F or one for all; of a pattern that is the front left post, or the front
            one of a planar car. Default: at most 12 mm, 0.15 m/s, 6 m/s^2. Both as `fourpost response` has them.
        engine: "reduced": kinematics linearised about static equilibrium, all laws exact; "full": the full geometry;
            "auto": the reduced model, and the full geometry where the two visibly differ; "time_integration".
        stroke: of posts without one in the file, from end to end [m].
        values: of parameters, as in `at`.

        Frequencies without a steady motion hold NaN; a warning names them. Raises InputError, and SimulationError where
        no motion could be computed at any.
        """
        car = self.at(values)._core
        sine = _sine(car, mode, frequency, amplitude)
        frf, mean, second, by, dB, deg = _core.respond(car, *sine, mode, stroke, engine)
        _arrays.report_unanswered(sine[0], frf[0])
        return Response(mode, sine[0], sine[1], car.sensors, frf[0], mean[0], second[0], by, dB, deg)

    def responses(self, values: Values, parameters: Sequence[str] | None = None, mode: str = "heave", *,
                  frequency: npt.ArrayLike | None = None, amplitude: npt.ArrayLike | None = None,
                  engine: str = "reduced", stroke: float = 0.15, threads: int = 0) -> Responses:
        """Responses of n cars in one pass, to the last bit those of `response` at their values.

        values: n x p, SI, a car a row; of a frame the columns are the parameters, as of `Run.draws`.
        parameters: names of the columns of an array.
        frequency, amplitude: F [Hz] and F or one for all [m], as in `response`; so are mode and stroke.
        engine: as in `response`; "reduced" takes the geometry once for all cars.
        threads: 0: one per processor. No influence on the result.

        A car that has no response is one of
        `failures`, with NaN in its row. Raises InputError for what cannot be used of any car.
        """
        names, rows = _arrays.table(values, parameters)
        sine = _sine(self._core, mode, frequency, amplitude)
        frf, mean, second, engines, failures = _core.respond_at(self._core, names, rows, *sine, mode, stroke, engine,
                                                                threads)
        return Responses(mode, sine[0], sine[1], self.sensors, frf, mean, second, names, rows, engines, failures)

    def simulate(self, posts: pd.DataFrame | Mapping[str, npt.ArrayLike], rate: float | None = None, *,
                 engine: str = "auto", stroke: float = 0.15, **values: Quantity) -> History:
        """The car from rest over moving posts, between whose samples a spline goes.

        posts: N heights [m] of each post by its name, upward from the position under the resting vehicle; posts that
            are not named stand still. The index of a frame is time [s].
        rate: of the samples [Hz]; needed of arrays.
        engine: "reduced", "full" or "auto", as in `response`; "full" integrates in time here.
        stroke, values: as in `response`.

        Raises as `response` does.
        """
        heights, hertz = _arrays.series("posts", posts, rate)
        car = self.at(values)._core
        readings, by, change, error = _core.simulate(car, hertz, heights, stroke, engine)
        count = len(next(iter(heights.values())))
        start = float(posts.index[0]) if isinstance(posts, pd.DataFrame) and rate is None else 0.0
        time = pd.Index(start + np.arange(count) / hertz, name="time")
        frame = pd.DataFrame({name: readings[name] for name in car.sensors}, index=time)
        return History(frame, hertz, car.sensors, by, change, error)

    def modes(self, **values: Quantity) -> Modes:
        """Modes about static equilibrium with poles, damping ratios, shapes and shares of energy, and the state space, as
        `fourpost modes`.

        values: of parameters, as in `at`.

        Warnings are those of Python. Raises InputError, and SimulationError where the vehicle has no equilibrium.
        """
        rows, space, warnings = _core.find_modes(self.at(values)._core)
        _arrays.warn(warnings)
        return modes_of(rows, space, warnings)

    def poles(self, parameter: str, values: npt.ArrayLike, **others: Quantity) -> pd.DataFrame:
        """The poles while a parameter changes, followed outward from its value: n x poles, complex [1/s], a column per
        pole by the name of its mode, on or above the real axis; NaN where it is the conjugate of another.

        values: n numbers, SI.
        others: values of other parameters, as in `at`.

        Raises as `modes` does.
        """
        points = _arrays.vector("values", values)
        paths = _core.follow_poles(self.at(others)._core, parameter, points)
        columns = np.array([poles for _, poles in paths], dtype=complex).reshape(len(paths), len(points))
        return pd.DataFrame(columns.T, index=pd.Index(points, name=parameter), columns=[mode for mode, _ in paths])

    def __repr__(self) -> str:
        return f"<fourpost.Vehicle '{self.name}': {len(self.parameters)} parameters, posts {', '.join(self.posts)}>"

    def _repr_html_(self) -> str:
        sensors = ", ".join(f"{name} [{unit}]" for name, unit in self.sensors.items())
        title = _html.heading(self.name, [f"posts {', '.join(self.posts)}", f"sensors {sensors}"])
        return title + _html.frame(self.parameters)


def _sine(car: _core.Vehicle, mode: str, frequency: npt.ArrayLike | None,
          amplitude: npt.ArrayLike | None) -> tuple[Floats, Floats]:
    """Frequencies and an amplitude for each; what is not given as usual."""
    hertz = _arrays.vector("frequency", [] if frequency is None else frequency)
    if frequency is not None and (hertz.size == 0 or np.any(hertz <= 0)):
        raise refuse("value-out-of-range", "frequency must hold numbers above 0 Hz")
    hertz, metres = map(np.array, _core.usual_sine(car, mode, hertz))
    if amplitude is not None:
        metres = _arrays.vector("amplitude", amplitude)
        if np.any(metres <= 0):
            raise refuse("value-out-of-range", "amplitude must hold numbers above 0 m")
    return hertz, np.broadcast_to(metres, hertz.shape) if metres.size == 1 else metres


def load(file: Path) -> Vehicle:
    """Reads a vehicle file: URDF with the tags of urdf/README.md. Warnings are those of Python.

    Raises InputError with all faults of the file, each with its line.
    """
    core, warnings = _core.read_vehicle(os.fspath(file))
    _arrays.warn(warnings)
    return Vehicle(core)
