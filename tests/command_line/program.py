"""Runs the program as a user does: FOURPOST names it, in a folder that goes with the test."""
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
FOURPOST = os.environ["FOURPOST"]


def dwells(frequencies, rate):
    """Heights of a post [m], `rate` a second: two seconds of rest, then four seconds of each frequency."""
    heights = [0.0] * (2 * rate)
    phase = 0.0
    for frequency in frequencies:
        for _ in range(4 * rate):
            phase += 2 * math.pi * frequency / rate
            heights.append(5e-3 / frequency * math.sin(phase))
    return heights


class ProgramTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *words, code=0, **more):
        """What it answered; its exit code must be `code`."""
        outcome = subprocess.run([FOURPOST, *map(str, words)], cwd=self.folder, capture_output=True, text=True, **more)
        self.assertEqual(outcome.returncode, code, outcome.stderr)
        return outcome

    def assert_finding(self, text, finding, place=""):
        """A line of `text` begins with `place` and ends with the id of `finding`."""
        self.assertTrue(any(line.startswith(place) and line.endswith(f"[{finding}]") for line in text.splitlines()),
                        f"no [{finding}] at '{place}' in\n{text}")

    def copy(self, *parts):
        for part in parts:
            shutil.copytree(SOURCE / part, self.folder / part)

    def write(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def replace_in(self, name, old, new):
        """In a file, where `old` must occur once: a good file with one thing broken."""
        text = (self.folder / name).read_text()
        self.assertEqual(text.count(old), 1, old)
        return self.write(name, text.replace(old, new))

    @classmethod
    def make_kept(cls):
        """The folder `kept`, which all tests of a class share; for setUpClass."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.kept = pathlib.Path(folder.name)

    @classmethod
    def run_kept(cls, *words):
        """As run_program, in the folder `kept`; its exit code must be 0."""
        outcome = subprocess.run([FOURPOST, *map(str, words)], cwd=cls.kept, capture_output=True, text=True)
        if outcome.returncode != 0:
            raise AssertionError(f"exit code {outcome.returncode}: {outcome.stderr}")
        return outcome
