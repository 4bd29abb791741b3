"""Modes of a vehicle about static equilibrium, and its state space."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
import pandas as pd

from . import _html
from ._arrays import Complexes, Floats
from .errors import Finding, refuse

AXES = ("x", "y", "z", "about x", "about y", "about z")


@dataclass(frozen=True)
class StateSpace:
    """X' = a X + b z, y = c X + d z + d_rate z' + d_acceleration z'': heights z of P posts, readings y of S sensors,
    n internal states X. SI."""

    posts: list[str]
    """P, in the order of z [m]."""
    sensors: list[str]
    """S, in the order of y, each in its SI unit."""
    a: Floats
    """n x n, SI."""
    b: Floats
    """n x P, SI."""
    c: Floats
    """S x n, SI."""
    d: Floats
    """S x P, SI."""
    d_rate: Floats
    """S x P, SI; not zero where a sensor feels how fast a post moves, as that of a tyre with damping does."""
    d_acceleration: Floats
    """S x P, SI."""


@dataclass(frozen=True)
class Modes:
    """Modes about static equilibrium in the design pose, laws of dampers and springs at their mean rates."""

    table: pd.DataFrame
    """A row per mode by name, by rising frequency: kind ("oscillating", "overdamped", "free", "diverging"), frequency_Hz,
    damped_frequency_Hz, damping_ratio, rise_time_s, settling_time_s, pole [1/s], complex, of an overdamped mode the slow
    one. Frequency and damping ratio of free and diverging modes are 0, times NaN."""
    poles: list[Complexes]
    """A row per mode: on and above the real axis [1/s], two of an overdamped one."""
    energy: pd.DataFrame
    """A row per mode, a column per motion ("heave", "pitch", ...): shares of the kinetic energy, without unit."""
    bodies: list[str]
    """B, names."""
    shapes: Complexes
    """A row per mode, B x 6 each: motion of the centres of mass along x, y, z [m] and of the bodies about x, y, z [rad];
    the largest component of a mode is 1, rotations times the body's radius of gyration."""
    state_space: StateSpace
    """Of the same equations."""
    warnings: list[Finding]
    """What speaks against them: an unstable pose."""

    def __len__(self) -> int:
        """How many."""
        return len(self.table)

    def shape(self, mode: str) -> pd.DataFrame:
        """A row per body, complex: x, y, z [m] and about x, y, z [rad], of the first mode of that name. Raises
        InputError (`name-unknown`)."""
        names = list(self.table.index)
        if mode not in names:
            raise refuse("name-unknown", f"there is no mode '{mode}'; there are: {', '.join(names)}")
        return pd.DataFrame(self.shapes[names.index(mode)], index=self.bodies, columns=list(AXES))

    def _repr_html_(self) -> str:
        shown = self.table.drop(columns="pole")
        title = _html.heading("Modes", [f"{len(self)} about static equilibrium"])
        return title + _html.frame(shown) + _html.findings(self.warnings)


def modes_of(rows: Sequence[Any], space: tuple[Any, ...], warnings: list[Finding]) -> Modes:
    """Of what the library gives."""
    numbers = ["kind", "frequency_Hz", "damped_frequency_Hz", "damping_ratio", "rise_time_s", "settling_time_s"]
    index = pd.Index([row[0] for row in rows], name="mode")
    table = pd.DataFrame([row[1:7] for row in rows], columns=numbers, index=index)
    poles = [np.array(row[7], dtype=complex) for row in rows]
    table["pole"] = [one[0] if len(one) else 0j for one in poles]
    energy = pd.DataFrame([row[8] for row in rows], index=index).fillna(0.0)
    bodies = rows[0][9][0] if rows else []
    shapes = np.array([row[9][1] for row in rows], dtype=complex).reshape(len(rows), len(bodies), 6)
    return Modes(table, poles, energy, bodies, shapes, StateSpace(*space), warnings)
