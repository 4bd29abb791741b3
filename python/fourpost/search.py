"""The search methods on residuals of any kind."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Mapping, NamedTuple

import numpy.typing as npt

from . import _core
from ._arrays import Floats
from .errors import SimulationError


class Axis(NamedTuple):
    """One variable of a search: lower, lower + precision, ... up to upper."""

    lower: float
    """First value."""
    upper: float
    """Last value."""
    precision: float
    """Step between values."""
    discrete: bool = False
    """Nothing lies between its values: a number of teeth, a place in a catalogue."""


@dataclass(frozen=True)
class Minimum:
    """Where a search ended."""

    values: dict[str, float]
    """By the name of their axis."""
    cost: float
    """Sum of squared residuals."""
    evaluations: int
    """Distinct points."""
    reason: str
    """Which rule ended the search."""


def minimise(axes: Mapping[str, Axis | tuple[float, float, float]], residuals: Callable[[Floats], npt.ArrayLike], *,
             method: str = "dvhde", seed: int = 1, evaluations: int = 10000, target: float | None = None) -> Minimum:
    """Finds the values of the least sum of squared residuals on a grid.

    axes: by name.
    residuals: N numbers at p values in the order and units of the axes; what it raises, NaN and infinity count as a
        failed evaluation.
    method: as `fourpost compare --methods`.
    target: ends the search where the cost is as low.

    Raises InputError (`search-axes`, `search-method`), and SimulationError where every evaluation fails, with the first
    exception of `residuals` as its cause.
    """
    rows = [(name, float(axis[0]), float(axis[1]), float(axis[2]), len(axis) > 3 and bool(axis[-1]))
            for name, axis in axes.items()]
    causes: list[Exception] = []

    def watched(x: Floats) -> npt.ArrayLike:
        try:
            return residuals(x)
        except Exception as cause:
            if not causes:
                causes.append(cause)
            raise

    try:
        values, cost, count, reason = _core.minimise(rows, watched, method, seed, evaluations, target)
    except SimulationError as failure:
        raise failure from (causes[0] if causes else None)
    return Minimum(dict(zip(axes, map(float, values))), cost, count, reason)
