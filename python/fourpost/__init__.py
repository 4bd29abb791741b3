"""Identification of vehicle suspension models from rig tests.

Values are SI and angles radians, unless a name says otherwise ("_dB", "_deg"). Posts, sensors and parameters go by
their names in the vehicle file. docs/python.md is a guide.
"""
from ._core import version as _version
from .errors import Error, Finding, InputError, InputWarning, OutputError, SimulationError
from .inspection import FrfMeasurement, Info, MeasuredPattern, frf, info
from .modes import Modes, StateSpace
from .response import History, Response, Responses
from .run import Choice, Prediction, Progress, Run, choose, fit, read_run
from .search import Axis, Minimum, minimise
from .study import Bench, Measured, ModelError, Objective, SteppedSine, Study, TimeHistory
from .units import in_unit, to_si
from .vehicle import Vehicle, load

__version__ = _version()

__all__ = [
    "Axis", "Bench", "Choice", "Error", "Finding", "FrfMeasurement", "History", "Info", "InputError", "InputWarning",
    "Measured", "MeasuredPattern", "Minimum", "ModelError", "Modes", "Objective", "OutputError", "Prediction", "Progress",
    "Response", "Responses", "Run", "SimulationError", "StateSpace", "SteppedSine", "Study", "TimeHistory", "Vehicle",
    "choose", "fit", "frf", "in_unit", "info", "load", "minimise", "read_run", "to_si",
]
