"""What can be wrong with a plan, a worker or a unit. `fourpost help ID` explains the ids."""
from __future__ import annotations

import difflib
from typing import Iterable, NamedTuple

USAGE, UNREADABLE, CANNOT_WRITE, DEFECT, NOT_DONE, INTERRUPTED = 2, 3, 5, 70, 75, 130
"""Codes of the program, see its manual page."""


class Finding(NamedTuple):
    """An error or a warning as `fourpost` prints it."""

    id: str
    """Lower case with hyphens; never changes. `fourpost help ID` explains it."""
    severity: str
    """"error" or "warning"."""
    text: str
    """What is wrong and what to do."""
    file: str = ""
    """Where it is; empty where it is in no file."""
    line: int = 0
    """From 1; 0 where it is about the file as a whole."""

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        return (f"{place}: " if place else "") + f"{self.severity}: {self.text} [{self.id}]"


class BatchError(Exception):
    """What ends a batch."""

    findings: list[Finding]
    """All that is wrong."""
    code: int
    """The exit code that fits them."""

    def __init__(self, findings: Iterable[Finding], code: int = UNREADABLE):
        self.findings = list(findings)
        self.code = code
        super().__init__("\n".join(map(str, self.findings)))


class Trouble(Exception):
    """Why a unit has no result, for reasons that are not its own: it is tried again, elsewhere if that is possible."""

    kind: str
    """"lost" (its process was killed), "disk", "build", "files", "program", "memory", "failed"."""
    text: str
    """What happened."""
    worker: str
    """Where; empty where that is not known."""

    def __init__(self, kind: str, text: str, worker: str = ""):
        super().__init__(kind, text, worker)
        self.kind, self.text, self.worker = kind, text, worker

    def __str__(self) -> str:
        return self.text


LEAVES = ("disk", "build", "files", "program")
"""Kinds of trouble of which a worker has no end: it leaves."""


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """", did you mean 'x'?", or nothing."""
    near = difflib.get_close_matches(name, list(known), 1)
    return f", did you mean '{near[0]}'?" if near else ""
