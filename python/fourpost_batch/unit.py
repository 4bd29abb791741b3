"""A unit of work, and the bytes of its result."""
from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass
from typing import Any

FORMAT = 2
"""Of keys and results; a change makes all units be computed anew."""
FIT_FOLDER = "fourpost_fit"
"""Where a fit stands in the folder in which a unit runs."""


def canonical(value: Any) -> bytes:
    """The same bytes for the same value, whoever writes them."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False).encode()


@dataclass(frozen=True)
class Unit:
    """One call of the program, or of a script, in a folder that holds its inputs and nothing else."""

    name: str
    """For readers; without influence on the key."""
    kind: str
    """"fit", "prediction", "choice", "comparison" or "coverage"."""
    command: tuple[str, ...]
    """"{program}" and "{python}" stand for those of the worker. Paths are relative to the folder."""
    inputs: tuple[tuple[str, str], ...]
    """Path and SHA-256 of each file; a path may begin with "../"."""
    build: str
    """Of the program."""
    keep: tuple[str, ...] = ()
    """Patterns of files in FIT_FOLDER that are the result, beside what is printed."""
    after: str = ""
    """Key of the fit whose result stands in FIT_FOLDER."""

    @property
    def key(self) -> str:
        """Hash of all that the result depends on."""
        content = {**asdict(self), "format": FORMAT}
        del content["name"]
        return hashlib.sha256(canonical(content)).hexdigest()

    def to_dict(self) -> dict[str, Any]:
        """Its fields by name, for JSON."""
        return asdict(self)

    @staticmethod
    def of(content: dict[str, Any]) -> Unit:
        """The inverse of to_dict(), also after a journey through JSON."""
        lists = {name: tuple(tuple(x) if isinstance(x, list) else x for x in value)
                 for name, value in content.items() if isinstance(value, (list, tuple))}
        return Unit(**{**content, **lists})


def result_text(key: str, result: dict[str, Any]) -> bytes:
    """What a store keeps of a result: `code`, `printed`, `messages` and `files`, with a digest."""
    content = {"format": FORMAT, "key": key, "digest": hashlib.sha256(canonical(result)).hexdigest(), "result": result}
    return canonical(content) + b"\n"


def read_result(key: str, text: bytes) -> dict[str, Any] | None:
    """The inverse; nothing of bytes that were altered or are another unit's."""
    try:
        content = json.loads(text)
        result: dict[str, Any] = content["result"]
        is_sound = content["key"] == key and content["digest"] == hashlib.sha256(canonical(result)).hexdigest()
    except (ValueError, TypeError, KeyError):
        return None
    return result if is_sound else None
