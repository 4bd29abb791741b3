"""Runs the program as a user does: FOURPOST names it, in a folder that goes with the test."""
import csv
import math
import os
import pathlib
import random
import re
import shutil
import sqlite3
import statistics
import struct
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


def drop_swept_sine(study):
    """Of a study of the Land Rover's: to predict it takes most of the time of a quick fit, which does without."""
    part = r"# The same car on a swept sine.*?(?=(?:# [^\n]*\n)?static_loads:)"
    text, found = re.subn(part, "", study.read_text(), flags=re.S)
    assert found == 1, study
    study.write_text(text)


class Archive:
    """All that an archive of evaluations holds, over all contexts; nothing of a file that is not there or empty."""

    def __init__(self, path):
        """Takes in the log of a killed program, as every program does that opens the file."""
        rows = []
        if path.exists() and path.stat().st_size > 0:
            database = sqlite3.connect(path)
            try:
                rows = database.execute(
                    "SELECT paid, parameters, vehicle, data, settings, version, residuals, failure, detail, violation "
                    "FROM evaluation JOIN context ON context.id = evaluation.context "
                    "ORDER BY vehicle, data, settings, version, parameters").fetchall()
            finally:
                database.close()
        counts = [self.evaluations_of(row[1]) for row in rows]
        self.evaluations = sum(counts)
        # How often one of them was evaluated; above `evaluations` where programs at once evaluated the same.
        self.paid = sum(count * row[0] for count, row in zip(counts, rows))
        # In the order of their keys: the same for the same content, in whichever order it was stored.
        self.content = [row[1:] for row in rows]

    @staticmethod
    def evaluations_of(values):
        """Of a row with these values: a Jacobian, whose last one is NaN, counts as one for each parameter."""
        jacobian = len(values) >= 8 and math.isnan(struct.unpack("=d", values[-8:])[0])
        return len(values) // 8 - 1 if jacobian else 1

    @classmethod
    def evaluations_at_work(cls, path):
        """Their number in an archive that a program is writing, or was killed with.

        Of a copy, since whoever opens the file itself takes in its log; 0 where its files do not fit together.
        """
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "copy.sqlite"
            for part in ("", "-wal", "-journal"):
                try:
                    shutil.copyfile(f"{path}{part}", f"{copy}{part}")
                except FileNotFoundError:
                    pass
            try:
                return cls(copy).evaluations
            except sqlite3.DatabaseError:
                return 0


def add_noise(clean, noisy, share, seed):
    """A copy of a recording with white noise on all its channels, posts too: `share` of their standard deviations.

    Returns these of each channel, with their units.
    """
    with open(clean, newline="") as file:
        names, units, *rows = csv.reader(file)
    columns = [list(map(float, column)) for column in zip(*rows)]
    draw = random.Random(seed)
    added = {}
    for name, unit, column in zip(names[1:], units[1:], columns[1:]):
        sd = share * statistics.pstdev(column)
        column[:] = [value + draw.gauss(0, sd) for value in column]
        added[name] = f"{sd:.6g} {unit}"
    with open(noisy, "w", newline="") as file:
        csv.writer(file).writerows([names, units, *zip(*columns)])
    return added


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

    def start_program(self, *words):
        """The program at work, to send signals to; killed with its test."""
        program = subprocess.Popen([FOURPOST, *map(str, words)], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

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


class FittedStarter(ProgramTest):
    """In a folder with the starter study, `car`, and its fit, `run`, which are made once for the tests of a class."""

    @classmethod
    def setUpClass(cls):
        cls.make_kept()
        cls.run_kept("init", "car")
        cls.run_kept("fit", "car/study.yaml", "-o", "run")

    def setUp(self):
        super().setUp()
        shutil.copytree(self.kept, self.folder, dirs_exist_ok=True)
