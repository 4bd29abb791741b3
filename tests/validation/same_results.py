"""Runs two builds of fourpost over every shipped study and compares their result.json, to the last bit.

    python3 tests/validation/same_results.py [--old-files FOLDER] [--numbers] OLD/fourpost NEW/fourpost [STUDY...]

--old-files: a checkout with studies and vehicles that the old build reads, where spellings have changed. --numbers:
texts do not count. Versions, times and the order of keys, of warnings and of named entries never do. Prints a line for each study, and
where values differ; the exit code is the number of studies that do.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
IGNORED = {"versions"}
TEXTS = {"warnings", "conclusions", "message", "reasons"}


def studies():
    for path in sorted((ROOT / "studies").rglob("*.yaml")):
        if "problem:" not in path.read_text() and "methods" not in path.stem:
            yield path


def key_of(entry):
    if isinstance(entry, dict):
        return str([entry.get(key) for key in ("recording", "name", "tyre", "id", "text")])
    return str(entry)


def unordered(value, key=""):
    """Lists of named entries, and of warnings, in one order."""
    if isinstance(value, dict):
        return {k: unordered(v, k) for k, v in value.items() if k not in IGNORED}
    if isinstance(value, list):
        values = [unordered(v) for v in value]
        named = values and all(isinstance(v, dict) and ("name" in v or "recording" in v) for v in values)
        return sorted(values, key=key_of) if named or key == "warnings" else values
    return value


def differences(old, new, where=""):
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(old.keys() | new.keys()):
            if key not in old or key not in new:
                yield f"{where}/{key}: only {'before' if key in old else 'now'}"
            else:
                yield from differences(old[key], new[key], f"{where}/{key}")
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, f"{where}/{i}")
    elif old != new:
        yield f"{where}: {old!r} -> {new!r}"


def result(program, study, folder):
    run = subprocess.run([program, "fit", study, "-o", folder, "--accept-implausible", "--accept-unidentified"],
                         capture_output=True, text=True, check=False)
    file = pathlib.Path(folder) / "result.json"
    return unordered(json.loads(file.read_text())) if file.exists() else {"failed": run.stderr[-500:]}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--old-files", type=pathlib.Path, default=ROOT)
    parser.add_argument("--numbers", action="store_true")
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("studies", nargs="*")
    words = parser.parse_args()
    if words.numbers:
        IGNORED.update(TEXTS)
    wanted = [pathlib.Path(name).resolve() for name in words.studies] or list(studies())
    worse = 0
    for study in wanted:
        with tempfile.TemporaryDirectory() as folder:
            before = result(words.old, words.old_files / study.relative_to(ROOT), folder + "/old")
            found = list(differences(before, result(words.new, study, folder + "/new")))
        print(f"{study.relative_to(ROOT)}: {'same' if not found else f'{len(found)} differences'}", flush=True)
        for line in found[:20]:
            print("  " + line[:300])
        worse += bool(found)
    return worse


if __name__ == "__main__":
    sys.exit(main())
