"""Errors and warnings about the input, with ids and places."""
from __future__ import annotations

from typing import NamedTuple, Sequence


class Finding(NamedTuple):
    """An error or a warning about the input, as `fourpost` prints it."""

    id: str
    """Lower case with hyphens; never changes. `fourpost help ID` explains it."""
    severity: str
    """"error" or "warning"."""
    file: str
    """Where it is; empty and line 0 where it is in no file or about the file as a whole."""
    line: int
    """From 1."""
    argument: str
    """The option of the command line that it is about, where it is about one: "--mode"."""
    text: str
    """What is wrong and what to do."""

    def __str__(self) -> str:
        place = self.argument or (f"{self.file}:{self.line}" if self.line else self.file)
        return (f"{place}: " if place else "") + f"{self.severity}: {self.text} [{self.id}]"


class Error(Exception):
    """What ends a call."""

    findings: list[Finding]
    """All that was found, errors and warnings."""

    def __init__(self, message: str, findings: Sequence[Finding] = ()):
        super().__init__(message)
        self.findings = list(findings)

    @property
    def ids(self) -> list[str]:
        """Those of the findings."""
        return [finding.id for finding in self.findings]


class InputError(Error, ValueError):
    """The input cannot be used: a file, a name, a value, the shape of an array."""


class SimulationError(Error):
    """No motion could be computed."""


class OutputError(Error):
    """Results cannot be written."""


class InputWarning(UserWarning):
    """A warning about the input."""

    finding: Finding
    """With its id and its place."""

    def __init__(self, finding: Finding):
        super().__init__(str(finding))
        self.finding = finding


def refuse(id: str, text: str) -> InputError:
    """An error about an argument."""
    finding = Finding(id, "error", "", 0, "", text)
    return InputError(str(finding), [finding])
