"""The program that units call, and which build it is."""
from __future__ import annotations

import functools
import os
import shutil
import subprocess

from .errors import Trouble
from .store import file_hash


@functools.lru_cache(maxsize=8)
def _build_of(path: str, size: int, changed: int) -> str:
    version = subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return f"{version} {file_hash(path)[:16]}"


class Program:
    """An executable of fourpost."""

    path: str
    """Absolute."""

    def __init__(self, path: str | os.PathLike[str]):
        self.path = os.path.abspath(path)

    @property
    def build(self) -> str:
        """Its version and the hash of its bytes. Raises OSError, subprocess.CalledProcessError."""
        status = os.stat(self.path)
        return _build_of(self.path, status.st_size, status.st_mtime_ns)

    @property
    def version(self) -> str:
        """Such as "0.2.0"."""
        return self.build.split()[0]


def find_program(hint: str) -> Program:
    """That of FOURPOST_PROGRAM, else `hint`, a path on another machine, if it is here as well, else that of PATH.
    Raises Trouble."""
    chosen = os.environ.get("FOURPOST_PROGRAM")
    path = chosen or (hint if os.access(hint, os.X_OK) else shutil.which("fourpost"))
    if not path or not os.access(path, os.X_OK):
        raise Trouble("program", f"there is no {chosen}" if chosen else f"neither {hint} nor one on PATH")
    return Program(path)
