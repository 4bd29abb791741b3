"""Arrays, tables and time axes as callers have them, to those of the library."""
from __future__ import annotations

import warnings
from typing import Any, Iterable, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt
import pandas as pd

from .errors import Finding, InputWarning, SimulationError, refuse

Floats = npt.NDArray[np.float64]
Complexes = npt.NDArray[np.complex128]
Values = Union[npt.ArrayLike, pd.DataFrame]
Quantity = Union[str, float]
"""A number in SI, or a text with a unit: "50 kN/m"."""


def numbers_of(what: str, numbers: npt.ArrayLike, dtype: type = float) -> npt.NDArray[Any]:
    """An array of any dimension; texts and rows of different lengths are refused."""
    try:
        return np.asarray(numbers, dtype=dtype)
    except (TypeError, ValueError) as fault:
        raise refuse("table-shape", f"{what} cannot be made an array of numbers ({fault}): give numbers in SI, rows of "
                     "one length") from None


def vector(what: str, numbers: npt.ArrayLike) -> Floats:
    """One dimension; a single number is one value."""
    array: Floats = np.atleast_1d(numbers_of(what, numbers))
    if array.ndim != 1:
        raise refuse("table-shape", f"{what} has {array.ndim} dimensions: give one")
    return array


def table(values: Values, names: Sequence[str] | None) -> tuple[list[str], Floats]:
    """Names of the columns and n x p numbers."""
    if isinstance(values, pd.DataFrame):
        names = [str(name) for name in values.columns] if names is None else names
        values = values.to_numpy()
    if names is None:
        raise refuse("table-shape", "an array does not say which parameters its columns are: name them by 'parameters'")
    twice = sorted({name for name in names if list(names).count(name) > 1})
    if twice:
        raise refuse("table-shape", f"values have more than one column for {', '.join(twice)}: leave one of each")
    array = numbers_of("values", values)
    if array.ndim != 2 or array.shape[1] != len(names):
        raise refuse("table-shape", f"values have the shape {array.shape}: give rows of {len(names)} parameters")
    return list(names), np.asfortranarray(array)


def series(what: str, columns: pd.DataFrame | Mapping[str, npt.ArrayLike],
           rate: float | None) -> tuple[dict[str, Floats], float]:
    """Columns by name and their rate [Hz], that of the index of a frame unless it is given."""
    if isinstance(columns, pd.DataFrame) and rate is None:
        rate = _rate(what, numbers_of(f"the index of {what}", columns.index))
    if rate is None:
        raise refuse("rate-not-positive", f"{what} have no time: give 'rate' in Hz, or a frame with seconds as index")
    return {str(name): vector(f"{what} '{name}'", column) for name, column in columns.items()}, float(rate)


def _rate(what: str, time: Floats) -> float:
    steps = np.diff(time)
    # Of times as printed with 4 digits of a step and more.
    is_even = len(steps) > 0 and np.all(np.abs(steps - steps.mean()) < 1e-3 * steps.mean())  # NaN is not
    if not is_even:
        raise refuse("time-drifts", f"the index of {what} is not evenly rising seconds: resample, or give 'rate'")
    return float(len(steps) / (time[-1] - time[0]))


def values_of(given: Mapping[str, Quantity] | None, more: Mapping[str, Quantity]) -> dict[str, Quantity]:
    """Values of parameters by name, as a mapping and as keywords."""
    both = {**(given or {}), **more}
    for name, value in both.items():
        if not isinstance(value, str) and not (np.isscalar(value) and np.isreal(value)):
            raise refuse("value-unknown", f"'{name}' is no option of this call, and a parameter of that name would need "
                         f"a number or a text with a unit, not {type(value).__name__}")
    return {name: value if isinstance(value, str) else float(value) for name, value in both.items()}


def report_unanswered(frequency: Floats, frf: Complexes) -> None:
    """S x F: raises where no frequency has a motion, warns where some have none."""
    missing = frequency[~np.isfinite(frf).all(axis=0)]
    if missing.size == 0:
        return
    finding = Finding("response-unanswered", "warning", "", 0, "",
                      f"no steady motion was found at {', '.join(f'{hertz:g}' for hertz in missing[:5])}"
                      f"{' ...' if missing.size > 5 else ''} Hz: `check()` names what is implausible of the vehicle; values "
                      "are SI, m and not mm")
    if missing.size < frequency.size:
        warn([finding])
        return
    finding = finding._replace(severity="error")
    raise SimulationError(str(finding), [finding])


def warn(findings: Iterable[Finding]) -> None:
    """Those that are warnings, as warnings of Python."""
    for finding in findings:
        if finding.severity == "warning":
            warnings.warn(InputWarning(finding), stacklevel=3)


def parameter_frame(rows: Sequence[tuple[Any, ...]], columns: Sequence[str]) -> pd.DataFrame:
    """Rows that begin with a name, which becomes the index."""
    return pd.DataFrame(list(rows), columns=["name", *columns]).set_index("name")
