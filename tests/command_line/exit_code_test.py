"""Exit codes that a user meets seldom: 5, 71 and 130."""
import resource
import signal
import subprocess
import time
import unittest

from program import FOURPOST, ProgramTest


def limit(kind, size):
    return lambda: resource.setrlimit(kind, (size, size))


class ExitCode(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("init", "car")

    def change_study(self, **search):
        study = self.folder / "car/study.yaml"
        text = study.read_text()
        settings = "".join(f"  {key}: {value}\n" for key, value in search.items())
        study.write_text(text[:text.index("search:")] + "search:\n" + settings)

    def test_is_5_of_a_fit_on_a_full_disk_that_keeps_old_results(self):
        # Of few evaluations, so that their archive takes less room than the report, and the next one adds none.
        self.change_study(evaluations=1, starts=1)
        self.run_program("fit", "car/study.yaml", "-o", "run")
        run = self.folder / "run"
        before = {file.name: file.read_bytes() for file in run.iterdir()}
        size = len(before["report.html"]) - 1
        self.assertLess(len(before["archive.sqlite"]), size)
        self.write("run/parameters.csv", "old")
        outcome = self.run_program("fit", "car/study.yaml", "-o", "run", code=5,
                                   preexec_fn=limit(resource.RLIMIT_FSIZE, size))
        self.assertIn("report.html", outcome.stderr)
        self.assertEqual((run / "parameters.csv").read_text(), "old")
        self.assertEqual({file.name for file in run.iterdir()}, set(before))

    def test_is_71_without_memory(self):
        self.change_study(evaluations=100000, population=100000)
        # What the program takes to begin with, and far less than that generation.
        size = 10_000_000
        while subprocess.run([FOURPOST, "--version"], capture_output=True,
                             preexec_fn=limit(resource.RLIMIT_AS, size)).returncode != 0:
            size += 10_000_000
            if size > 1_000_000_000:
                self.skipTest("this program reserves terabytes of addresses, as with the address sanitizer")
        outcome = self.run_program("fit", "car/study.yaml", "-o", "run", code=71,
                                   preexec_fn=limit(resource.RLIMIT_AS, size + 20_000_000))
        self.assertIn("[out-of-memory]", outcome.stderr)

    def test_is_130_at_once_of_a_second_interrupt(self):
        """Of a fit that begins with a generation of minutes, which it does not cut short."""
        self.change_study(evaluations=10000000, population=100000)
        program = subprocess.Popen([FOURPOST, "fit", "car/study.yaml", "-o", "run"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        with program.stderr as pipe:
            self.assertTrue(any(line.startswith("search: ") for line in pipe))
            program.send_signal(signal.SIGINT)
            self.assertTrue(any("another Ctrl-C in two seconds or later ends at once" in line for line in pipe))
            time.sleep(2.1)
            self.assertIsNone(program.poll())
            program.send_signal(signal.SIGINT)
            # As shells tell it, 128 + 2.
            self.assertEqual(program.wait(), -signal.SIGINT)
        self.assertFalse((self.folder / "run/result.json").exists())


if __name__ == "__main__":
    unittest.main()
