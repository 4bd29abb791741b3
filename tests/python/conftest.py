"""The module as a notebook sees it, beside the program."""
import os
import pathlib
import subprocess

import pytest

import fourpost as fp

SOURCE = pathlib.Path(__file__).resolve().parents[2]
STARTER = SOURCE / "studies/starter"


def program(*words, folder=None):
    """What `fourpost` prints; it must succeed."""
    outcome = subprocess.run([os.environ["FOURPOST"], *map(str, words)], cwd=folder, capture_output=True, text=True)
    assert outcome.returncode == 0, outcome.stderr
    return outcome.stdout


@pytest.fixture
def car():
    return fp.load(STARTER / "vehicle.urdf")


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    return fp.fit(STARTER / "study.yaml", tmp_path_factory.mktemp("fit") / "run", threads=1)
