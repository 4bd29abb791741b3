"""The folder of a batch: results and input files under their hashes.

Each file is written beside its place and renamed into it, so that a killed writer leaves none half done, and writers of
the same key do not mind each other. The order in which results come leaves no trace.
"""
from __future__ import annotations

import hashlib
import itertools
import json
import os
import pathlib
import secrets
import shutil
import socket
import threading
from typing import Any, Iterator

from . import findings
from .errors import UNREADABLE, BatchError
from .unit import read_result

MARK = "batch.json"
_count = itertools.count()


def file_hash(path: str | os.PathLike[str]) -> str:
    """SHA-256 of a file that may be larger than memory."""
    with open(path, "rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest() if hasattr(hashlib, "file_digest") else _slow(stream)


def _slow(stream: Any) -> str:
    digest = hashlib.sha256()
    while piece := stream.read(1 << 20):
        digest.update(piece)
    return digest.hexdigest()


def write_whole(path: pathlib.Path, content: bytes) -> None:
    """All of it or nothing, also where others write the same. Raises OSError."""
    beside = path.parent / f".{socket.gethostname()}.{os.getpid()}.{threading.get_ident()}.{next(_count)}"
    try:
        with open(beside, "wb") as stream:
            stream.write(content)
            # On the disk before it has its name, so that a power failure leaves no empty file of that name.
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(beside, path)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise


class Store:
    """Results by the keys of their units, and input files by their hashes. Any number of processes may use a folder."""

    folder: pathlib.Path
    """Absolute."""
    damaged: set[str]
    """Keys of results found altered so far; they count as missing."""

    def __init__(self, folder: str | os.PathLike[str]):
        self.folder = pathlib.Path(folder).absolute()
        self.damaged = set()

    @staticmethod
    def make(folder: str | os.PathLike[str]) -> Store:
        """That of a new or empty folder, or of a batch. Raises BatchError for another one, OSError."""
        store = Store(folder)
        if not (store.folder / MARK).exists():
            names = os.listdir(store.folder) if store.folder.is_dir() else []
            # Another one may have begun meanwhile.
            if MARK not in names and any(not name.startswith(".") for name in names):
                raise BatchError([findings.FOLDER_OTHER(file=folder)], UNREADABLE)
            store.folder.mkdir(parents=True, exist_ok=True)
            mark = {"about": "results of `fourpost batch`", "id": secrets.token_hex(16)}
            # Of several that begin at once one wins.
            beside = store.folder / f".{secrets.token_hex(8)}"
            beside.write_text(json.dumps(mark) + "\n")
            try:
                os.link(beside, store.folder / MARK)
            except FileExistsError:
                pass
            beside.unlink()
        for name in ("units", "files"):
            (store.folder / name).mkdir(exist_ok=True)
        return store

    @property
    def id(self) -> str:
        """Of this folder, so that another machine can say whether it sees the same; empty where it is none."""
        try:
            return str(json.loads((self.folder / MARK).read_text())["id"])
        except (OSError, ValueError, KeyError, TypeError):
            return ""

    def path(self, key: str) -> pathlib.Path:
        """Where the result of a unit is, or would be."""
        return self.folder / "units" / key[:2] / f"{key}.json"

    def get(self, key: str) -> dict[str, Any] | None:
        """A result: `code`, `printed`, `messages` and `files`; nothing where there is none or it was altered."""
        try:
            text = self.path(key).read_bytes()
        except FileNotFoundError:
            return None
        result = read_result(key, text)
        if result is None:
            self.damaged.add(key)
        return result

    def has(self, key: str) -> bool:
        """Whether there is a result, unaltered."""
        return self.get(key) is not None

    def put(self, key: str, text: bytes) -> None:
        """Keeps what result_text() made. Raises OSError."""
        path = self.path(key)
        path.parent.mkdir(exist_ok=True)
        write_whole(path, text)

    def keys(self) -> Iterator[str]:
        """Of all results, sorted."""
        return (path.stem for path in sorted((self.folder / "units").glob("??/*.json")))

    def file(self, digest: str) -> pathlib.Path:
        """Where an input file is, or would be."""
        return self.folder / "files" / digest

    def add_file(self, path: str | os.PathLike[str], digest: str) -> None:
        """Keeps an input for workers. Raises OSError, and BatchError for a file that changes meanwhile."""
        target = self.file(digest)
        if target.exists() and file_hash(target) == digest:
            return
        beside = target.parent / f".{socket.gethostname()}.{os.getpid()}.{next(_count)}"
        try:
            shutil.copyfile(path, beside)
            if file_hash(beside) != digest:
                raise BatchError([findings.FILE_CHANGES(path)])
            os.replace(beside, target)
        finally:
            beside.unlink(missing_ok=True)
