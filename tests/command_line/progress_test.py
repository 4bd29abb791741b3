"""How a long task gets on: a line of a terminal, rewritten, and now and then a plain line elsewhere."""
import fcntl
import math
import os
import pty
import re
import select
import signal
import struct
import subprocess
import termios
import time

import unittest

from program import FOURPOST, SOURCE, ProgramTest

FIT = ["fit", "endless.yaml", "-o", "run", "--threads", "1"]
COMPARE = ["compare", SOURCE / "studies/landrover110/model2.yaml", "--runs", "1000"]


class Progress(ProgramTest):
    def setUp(self):
        super().setUp()
        folder = SOURCE / "studies/landrover110"
        text = (folder / "model2.yaml").read_text().replace("file: ", f"file: {folder}/").replace("../..", str(SOURCE))
        self.assertIn("evaluations: 100\n", text)
        self.write("endless.yaml", text.replace("evaluations: 100\n", "evaluations: 100000\n  generations: 100000\n"))

    def start(self, words, stderr, **environment):
        program = subprocess.Popen([FOURPOST, *map(str, words)], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=stderr, env={**os.environ, **environment})
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        return program

    def updates(self, columns, words, count):
        """The first lines that a terminal so wide shows in one place."""
        leader, follower = pty.openpty()
        self.addCleanup(os.close, leader)
        fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("4H", 24, columns, 0, 0))
        program = self.start(words, follower, TERM="xterm")
        os.close(follower)
        told = b""
        while told.count(b"\x1b[K") < count:
            self.assertTrue(select.select([leader], [], [], 300)[0], told)
            told += os.read(leader, 1000)
        program.kill()
        lines = [part.split("\r")[-1] for part in told.decode().split("\x1b[K")[:count]]
        self.assertTrue(all(lines), lines)
        return lines

    def test_goes_into_a_line_of_the_terminal(self):
        for columns in (80, 40):
            for line in self.updates(columns, FIT, 5):
                self.assertLess(len(line), columns)
                self.assertRegex(line, r"^\w+: \d+ (of \d+ )?eval.*\.\.\.$")
        # Where the terminal tells no width.
        self.assertLess(max(map(len, self.updates(0, FIT, 5))), 80)

    def test_is_shown_again_while_one_evaluation_lasts(self):
        """Each of a release that is estimated takes some simulations of two minutes at 1 kHz."""
        rows = "".join(f"{k / 1000:.3f},{0.02 * math.exp(-k / 2000) * math.cos(k / 140):.6g}\n" for k in range(120000))
        self.write("drop.csv", "time,z\ns,m\n" + rows)
        self.write("drop.yaml", f"vehicle: {SOURCE}/urdf/quarter_car.urdf\nfree: [k, c_bump]\nhistories:\n"
                   "  - {file: drop.csv, release: estimated, channels: {z_sprung: z}}\n")
        program = self.start(["fit", "drop.yaml", "-o", "drop", "--threads", "1", "--accept-implausible"], subprocess.PIPE)
        ends = time.monotonic() + 120
        shown = b""
        while b" s so far, " not in shown and time.monotonic() < ends and program.poll() is None:
            shown += os.read(program.stderr.fileno(), 1000)
        program.stderr.close()
        self.assertRegex(shown.decode(), r"(?m)^\d+ s so far, identifiability: \d+ evaluations")

    def test_is_whole_where_there_is_room(self):
        for line in self.updates(250, FIT, 5):
            self.assertRegex(line, r"^\w+: \d+ .*evaluations.*; in all \d+ evaluations \(.* from the archive\)$")

    def test_tells_the_rate_first(self):
        line = self.updates(80, FIT, 30)[-1]
        self.assertRegex(line, r", [\d.]+ evaluations per (second|minute)")

    def test_is_plain_in_a_pipe(self):
        program = self.start(COMPARE, subprocess.PIPE)
        with program.stderr as pipe:
            line = b""
            while b"runs" not in line:
                line = pipe.readline()
                self.assertNotEqual(line, b"")
            program.send_signal(signal.SIGINT)
            rest = pipe.read()
        self.assertRegex(line, rb"^compare: \d+ of \d+ runs(, about \d+ (s|min) left)?, [\d.]+ runs per (second|minute)\n$")
        self.assertIsNone(re.search(rb"[\r\x1b]", line + rest))
        self.assertEqual(program.wait(), 130)

    def watched(self, word):
        """The page of a running fit, once it holds this word."""
        page = self.folder / "run/watch.html"
        for _ in range(600):
            text = page.read_text() if page.exists() else ""
            if word in text:
                return text
            time.sleep(0.1)
        self.fail(f"no {word} in {text}")

    def test_is_a_page_on_demand(self):
        program = self.start([*FIT, "--watch"], subprocess.DEVNULL)
        page = self.watched("Best values so far")
        self.assertIn('http-equiv="refresh"', page)
        self.assertIn("url=watch.html", page)
        self.assertIn("<td>k_front</td>", page)
        program.send_signal(signal.SIGINT)
        self.assertEqual(program.wait(), 130)
        self.assertIn("url=report.html", self.watched("The fit ended"))
        self.assertTrue((self.folder / "run/report.html").exists())
        self.assertFalse((self.folder / "run/watch.html.partial").exists())

    def test_has_no_page_of_a_fit_that_cannot_begin(self):
        self.write("faulty.yaml", "vehicle: none.urdf\n")
        self.run_program("fit", "faulty.yaml", "-o", "run", "--watch", code=3)
        self.assertFalse((self.folder / "run").exists())


if __name__ == "__main__":
    unittest.main()
