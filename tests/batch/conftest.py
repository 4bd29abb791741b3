"""Plans in a folder that goes with the test, run by the program or by one that stands in for it."""
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "python"))
STUB = SOURCE / "tests/batch/stub_program"
STARTER = SOURCE / "studies/starter"
FOURPOST = os.environ["FOURPOST"]


class Batch:
    """A folder with a plan."""

    def __init__(self, folder):
        self.folder = folder

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def study(self, name, first_line):
        """One for the stub."""
        return self.write(name, f"# {first_line}\nproblem: none\n")

    def run(self, *words, program=STUB, code=0, **environment):
        """What `fourpost batch plan.yaml` says; `program` does the work."""
        command = [sys.executable, "-m", "fourpost_batch", "--program", program, "--plan", "plan.yaml", *words]
        outcome = subprocess.run([str(word) for word in command], cwd=self.folder, capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": str(SOURCE / "python"), **environment}, timeout=120)
        assert outcome.returncode == code, outcome.stderr + outcome.stdout
        return outcome

    def json(self, *words, **more):
        return json.loads(self.run(*words, "--json", **more).stdout)


def content(folder):
    """Results and tables of a batch, without what says who computed them, and who was killed while writing."""
    folder = pathlib.Path(folder)
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted([*folder.glob("units/*/[!.]*"), *folder.glob("*.csv")])}


def states_in(batch):
    """Of all units, by the table."""
    with open(batch.folder / "out/results.csv") as table:
        return sorted(row["state"] for row in csv.DictReader(table))


@pytest.fixture
def batch(tmp_path):
    return Batch(tmp_path)


@pytest.fixture
def starter(batch):
    """With the study that `fourpost init` writes."""
    shutil.copytree(STARTER, batch.folder / "car")
    return batch
