"""Many fits, predictions, coverage, comparisons and choices, here or on many machines; docs/batch.md is a guide.

A plan is expanded into units. A unit is a pure function of its inputs: the bytes of its files, its options and the
build of the program. Its key is the hash of these, its result is bytes under that key in a `Store`, whoever computed
it, and when. Python's own library suffices; PyYAML reads plans, `distributed` reaches Dask.
"""
from .errors import BatchError, Finding, Trouble
from .expand import expand
from .plan import Plan, read_plan
from .program import Program
from .run import Tally, run
from .store import Store
from .unit import Unit

__all__ = ["BatchError", "Finding", "Plan", "Program", "Store", "Tally", "Trouble", "Unit", "expand", "read_plan", "run"]
