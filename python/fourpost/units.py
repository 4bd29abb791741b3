"""Numbers with units."""
from __future__ import annotations

from . import _core


def to_si(quantity: str, unit: str) -> float:
    """The SI value of a number with a unit ("40 kN/m") of the same dimension as `unit` ("N/m"; "1" for none).

    Raises InputError (`quantity-unreadable`) for a text without a known unit, or of another dimension.
    """
    return _core.to_si(quantity, unit)


def in_unit(si: float, unit: str) -> str:
    """The value with that unit, at the fewest digits that read back to the same double: in_unit(40e3, "kN/m").

    Raises InputError (`unit-unknown`).
    """
    return _core.in_unit(si, unit)
