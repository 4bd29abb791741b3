"""All that this package can find, in the words of identify/command_line/batch_findings.h, which `fourpost help` shows."""
from __future__ import annotations

import re
from typing import NamedTuple

from .errors import Finding


class Kind(NamedTuple):
    """Called with a word for each `{}` of the text, then of the remedy, it is a finding."""

    id: str
    severity: str
    text: str
    remedy: str

    def __call__(self, *words: object, file: object = "", line: int = 0) -> Finding:
        count = self.text.count("{}")
        text = self.text.format(*words[:count])
        # After "did you mean 'fits'?" the remedy goes on.
        message = f"{text}{'' if text.endswith('?') else ':'} {self.remedy.format(*words[count:])}"
        return Finding(self.id, self.severity, message, str(file), line)


def _error(id: str, text: str, remedy: str) -> Kind:
    return Kind(id, "error", text, remedy)


def _warning(id: str, text: str, remedy: str) -> Kind:
    return Kind(id, "warning", text, remedy)


AGAIN = "run the batch again; results so far are kept"

LACKS_PACKAGE = _error("batch-lacks-package", "this needs {}, which {} does not have", "install it: {}")

# The plan.

PLAN_MALFORMED = _error("batch-plan-malformed", "not a plan: {}", "see docs/batch.md for its keys")
KEY_UNKNOWN = _error("batch-key-unknown", "unknown key '{}'{}", "the keys here are {}")
KEY_MISSING = _error("batch-key-missing", "'{}' is missing", "{}")
VALUE_WRONG = _error("batch-value-wrong", "'{}' cannot be {}", "{}")
FILE_MISSING = _error("batch-file-missing", "no file '{}'{}", "paths are relative to the plan's folder")
FILE_REFUSED = _error("batch-file-refused", "'{}' cannot be read: {}", "see what `fourpost info` says of it")
RECORDING_UNLIKE = _error("batch-recording-unlike", "the study of '{}' and its vehicle name none of the channels of '{}'",
                          "give a recording in the layout of those that are fitted; this one has {}")
FILE_CHANGES = _error("batch-file-changes", "'{}' changes while the batch reads it", "run the batch again")
NAME_TWICE = _error("batch-name-twice", "two units have the name '{}'", "give entries names of their own by 'name'")
RUN_UNKNOWN = _error("batch-run-unknown", "no fit of this plan has the name '{}'{}",
                     "name one of {}, or a folder of a fit by 'run'")
RUN_OF_OTHER_VERSION = _error("batch-run-of-other-version", "'{}' is a fit of fourpost {}, and this is {}",
                              "fit again, best as an entry of 'fits'")
EMPTY = _error("batch-empty", "the plan has no units", "add 'fits' for example")

# Where units run.

PLACE_UNKNOWN = _error("batch-place-unknown", "'{}' is not a place to run units{}",
                       "write one of local, dask://HOST:PORT, dask:FILE, slurm, launcher")
SCHEDULER_AWAY = _error("batch-scheduler-away", "the scheduler {} does not answer: {}", f"start it and {AGAIN}")
SLURM_REFUSES = _error("batch-slurm-refuses", "Slurm refuses the array: {}", f"correct the options of --slurm and {AGAIN}")
NO_WORKERS = _error("batch-no-workers", "no worker of {} takes units",
                    "start workers of this build of fourpost and run the batch again")
LAUNCHER_UNKNOWN = _error("batch-launcher-unknown", "nothing says which of how many workers this is",
                          "start it by mpirun or srun, or set FOURPOST_BATCH_SHARE to 0/8 to 7/8")

# Workers and units.

WORKER_OF_OTHER_BUILD = _warning("batch-worker-of-other-build",
                                 "the worker {} is refused: it has {}, and the plan is of {}",
                                 "install the same build there")
WORKER_LACKS_FILES = _warning("batch-worker-lacks-files", "the worker {} does not see {}",
                              "let it share the folder of the batch, or run with --ship")
WORKER_LACKS_PROGRAM = _warning("batch-worker-lacks-program", "the worker {} has no program fourpost ({})",
                                "install it, or name it by the variable FOURPOST_PROGRAM")
WORKER_DISK_FULL = _warning("batch-worker-disk-full", "the worker {} cannot write to its disk: {}",
                            "free space in its TMPDIR; its units run elsewhere or later")
UNIT_LOST = _error("batch-unit-lost", "no result for {}: {}", AGAIN)
UNIT_FAILED = _error("batch-unit-failed", "{} ended with code {}: {}", "correct the input and run the batch again")
UNIT_DEFECT = _error("batch-unit-defect", "{} met a defect of fourpost: {}",
                     "report it with the input and {}, which keeps its output; another build runs it again")
UNIT_BLOCKED = _error("batch-unit-blocked", "{} cannot run, as '{}' has no fit", "see what is said of that one")

# The folder.

FOLDER_OTHER = _error("batch-folder-other", "holds files that are not those of a batch", "name an empty or a new folder")
CANNOT_WRITE = _error("batch-cannot-write", "cannot write: {}", f"free space and {AGAIN}")
RESULT_DAMAGED = _warning("batch-result-damaged", "{} results were altered on disk and are computed again",
                          "check the disk if that was nobody's intention")


def read(text: str, severity: str) -> list[Finding]:
    """Those of this severity among what the program printed."""
    rows = (re.fullmatch(r"(?:(.*?)(?::(\d+))?: )?(error|warning): (.*) \[([a-z0-9-]+)\]", line) for line in text.splitlines())
    return [Finding(row[5], severity, row[4], row[1] or "", int(row[2] or 0)) for row in rows if row and row[3] == severity]


TABLE = [kind for kind in list(globals().values()) if isinstance(kind, Kind)]
