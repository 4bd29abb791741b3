"""A unit is computed: on whatever machine, in a folder of its own, which goes with it."""
from __future__ import annotations

import atexit
import contextlib
import errno
import fnmatch
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from typing import Any, Mapping

from .errors import DEFECT, Trouble
from .program import find_program
from .store import Store, file_hash
from .unit import FIT_FOLDER, Unit, result_text

FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS}
FINDING = re.compile(r"(^|: )(error|warning): .*\[[a-z0-9-]+\]$")
SCRATCH = "fourpost-batch-"
# Of these the program ended by its inputs, or by a defect that it would meet again: results like others. All else is tried again.
RESULT_CODES = (0, 1, 2, 3, 4, DEFECT)


def _environment() -> dict[str, str]:
    """What a unit sees: nothing on which its result might depend."""
    passed = ("PATH", "LD_LIBRARY_PATH", "HOME", "TMPDIR")
    one_thread = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
    fixed = {"LANG": "C.UTF-8", "TZ": "UTC", "NO_COLOR": "1", "PYTHONHASHSEED": "0", "PYTHONDONTWRITEBYTECODE": "1"}
    return {**{name: os.environ[name] for name in passed if name in os.environ}, **one_thread, **fixed}


def _purge(parent: pathlib.Path) -> None:
    """Folders of workers that were killed."""
    for old in parent.glob(SCRATCH + "*"):
        number = old.name.split("-")[2]
        try:
            is_old = time.time() - old.stat().st_mtime > 3600 and old.stat().st_uid == os.getuid()
        except OSError:
            continue
        if is_old and number.isdigit() and not pathlib.Path("/proc", number).exists():
            shutil.rmtree(old, ignore_errors=True)


def _kill(process: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)


class Workplace:
    """What one worker has: its program, its scratch folder, and the store or the files that were shipped."""

    def __init__(self, store: str, store_id: str, build: str, program: str, files: Mapping[str, bytes] | None = None):
        self.store = Store(store)
        self.sees_store = bool(store_id) and self.store.id == store_id
        self.build, self.hint, self.shipped = build, program, files
        self.worker = f"{socket.gethostname()}:{os.getpid()}"
        self.journal = os.environ.get("FOURPOST_BATCH_JOURNAL")
        self._scratch: pathlib.Path | None = None
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen[bytes]] = set()
        self._is_stopped = False
        self._killer = [path, "--pdeathsig", "KILL", "--"] if (path := shutil.which("setpriv")) else []

    def check(self) -> None:
        """Raises Trouble where this worker can do none of the units."""
        program = find_program(self.hint)
        try:
            build = program.build
        except (OSError, subprocess.CalledProcessError) as fault:
            raise Trouble("program", f"{program.path} does not run: {fault}", self.worker) from None
        if build != self.build:
            raise Trouble("build", f"{build} ({program.path})", self.worker)
        if not self.sees_store and self.shipped is None:
            raise Trouble("files", f"the folder {self.store.folder}", self.worker)
        self.program = program.path

    def run(self, unit: Unit, fit: dict[str, Any] | None = None) -> tuple[str, bytes | None]:
        """Computes a unit, and keeps its result where the store is seen: ("found" or "paid", nothing), else ("paid",
        the bytes). `fit` is the result that it needs, where the store is not seen. Raises Trouble."""
        key = unit.key
        if self.sees_store and self.store.has(key):
            return "found", None
        try:
            self.check()
            self._note("begin", key)
            with tempfile.TemporaryDirectory(dir=self._own_folder(), prefix="unit-") as folder:
                text = result_text(key, self._compute(unit, fit, pathlib.Path(folder)))
        except OSError as fault:
            if fault.errno in FULL:
                raise Trouble("disk", str(fault), self.worker) from None
            raise Trouble("failed", str(fault), self.worker) from None
        if not self.sees_store:
            self._note("paid", key)
            return "paid", text
        try:
            self.store.put(key, text)
        except OSError:
            # The one who began the batch will say why.
            return "paid", text
        self._note("paid", key)
        return "paid", None

    def stop(self) -> None:
        """Ends the units that are running, and those that a thread begins from now on; they are lost."""
        self._is_stopped = True
        for process in list(self._running):
            _kill(process)

    def _outcome(self, words: list[str], place: pathlib.Path) -> tuple[int, bytes, bytes]:
        """Exit code, what was printed, messages."""
        with subprocess.Popen(self._killer + words, cwd=place, env=_environment(), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True) as process:
            self._running.add(process)
            if self._is_stopped:
                _kill(process)
            try:
                printed, said = process.communicate()
            finally:
                self._running.discard(process)
        return process.returncode, printed, said

    def close(self) -> None:
        if self._scratch is not None:
            shutil.rmtree(self._scratch, ignore_errors=True)

    def _note(self, what: str, key: str) -> None:
        if self.journal:
            with open(self.journal, "a") as stream:
                stream.write(f"{time.time():.6f} {what} {key} {self.worker}\n")

    def _own_folder(self) -> pathlib.Path:
        with self._lock:
            if self._scratch is None or not self._scratch.is_dir():
                parent = pathlib.Path(tempfile.gettempdir())
                _purge(parent)
                self._scratch = pathlib.Path(tempfile.mkdtemp(prefix=f"{SCRATCH}{os.getpid()}-", dir=parent))
                (self._scratch / "files").mkdir()
                atexit.register(self.close)
            return self._scratch

    def _file(self, name: str, digest: str) -> pathlib.Path:
        """An input on this machine; it is brought here once."""
        here = self._own_folder() / "files" / digest
        if here.exists():
            return here
        handle, beside = tempfile.mkstemp(dir=here.parent)
        os.close(handle)
        try:
            self._bring(name, digest, pathlib.Path(beside))
            os.replace(beside, here)
        except BaseException:
            os.unlink(beside)
            raise
        return here

    def _bring(self, name: str, digest: str, target: pathlib.Path) -> None:
        if self.shipped is not None and digest in self.shipped:
            target.write_bytes(self.shipped[digest])
        elif self.sees_store and self.store.file(digest).exists():
            shutil.copyfile(self.store.file(digest), target)
            if file_hash(target) != digest:
                raise Trouble("files", f"'{name}' unaltered in {self.store.folder}/files", self.worker)
        else:
            raise Trouble("files", f"'{name}' ({digest[:12]})", self.worker)

    def _lay(self, unit: Unit, fit: dict[str, Any] | None, folder: pathlib.Path) -> pathlib.Path:
        """Puts the inputs in their places; returns the folder in which the unit runs, deep enough for '../'."""
        names = [name for name, _ in unit.inputs]
        place = folder.joinpath(*["d"] * max([1] + [name.split("/").count("..") + 1 for name in names]))
        place.mkdir(parents=True)
        for name, digest in unit.inputs:
            target = pathlib.Path(os.path.normpath(place / name))
            target.parent.mkdir(parents=True, exist_ok=True)
            source = self._file(name, digest)
            # A script may write into its files, the program does not.
            if unit.kind == "coverage":
                shutil.copyfile(source, target)
            else:
                os.link(source, target)
        if unit.after:
            fit = fit or self.store.get(unit.after)
            if fit is None:
                raise Trouble("failed", "the fit that it needs is gone", self.worker)
            (place / FIT_FOLDER).mkdir()
            for name, text in fit["files"].items():
                (place / FIT_FOLDER / os.path.basename(name)).write_bytes(text.encode("utf-8", "surrogateescape"))
        return place

    def _compute(self, unit: Unit, fit: dict[str, Any] | None, folder: pathlib.Path) -> dict[str, Any]:
        place = self._lay(unit, fit, folder)
        words = [self.program if word == "{program}" else sys.executable if word == "{python}" else word
                 for word in unit.command]
        code, output, said = self._outcome(words, place)
        messages = said.decode("utf-8", "replace").splitlines()
        self._judge(unit, code, messages)
        files = {}
        if unit.kind == "fit" and code < 2:
            for path in sorted((place / FIT_FOLDER).iterdir()):
                if any(fnmatch.fnmatch(path.name, pattern) for pattern in unit.keep):
                    files[path.name] = path.read_bytes().decode("utf-8", "surrogateescape")
        printed = output.decode("utf-8", "surrogateescape")
        if '"interrupted": true' in printed or '"termination": "interrupted"' in files.get("result.json", ""):
            raise Trouble("lost", "it was interrupted", self.worker)
        return {"code": code, "printed": printed, "files": files,
                "messages": [line for line in messages if FINDING.search(line)]}

    def _judge(self, unit: Unit, code: int, messages: list[str]) -> None:
        said = [line.strip() for line in messages if line.strip()]
        errors = [line for line in said if "error: " in line]
        last = " / ".join((errors or said)[-3:])[-500:] or "it said nothing"
        if code < 0:
            raise Trouble("lost", f"its process was ended by {signal.Signals(-code).name}", self.worker)
        if code == 5:
            raise Trouble("disk", last, self.worker)
        if code == 71:
            raise Trouble("memory", last, self.worker)
        # A script that ends by itself would do so again.
        if code not in RESULT_CODES and unit.kind != "coverage":
            raise Trouble("failed", f"code {code}: {last}", self.worker)
