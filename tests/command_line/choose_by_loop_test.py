"""The loop of studies/choose_by_loop, shortened: three clicks on the bench, each third click of the others to choose from."""
import csv
import subprocess
import sys
import unittest

from program import FOURPOST, SOURCE, ProgramTest


class ChooseByLoop(ProgramTest):
    def test_chosen_clicks_are_the_best_within_one_percent(self):
        study = SOURCE / "studies/choose_by_loop/loop.py"
        # A car for which the first choice is in doubt, so that a test is worth its run.
        options = "--cars 6 --benched 4,10,16 --step 3 --tests 1 --draws 20 --road 10"
        outcome = self.run_python(study, FOURPOST, "loop", *options.split())
        command, *rows = outcome.splitlines()
        self.assertEqual(command, f"# loop.py PROGRAM FOLDER {options}")
        car, = csv.DictReader(rows)
        # Of what 400 runs would tell; the present clicks are worse by 4.2 %.
        self.assertGreater(float(car["present_regret"]), 3)
        self.assertLess(float(car["last_true_regret"]), 1)
        # Heave, pitch, the present clicks on a road, and one test.
        self.assertEqual(int(car["rig_runs"]), 4)
        self.assertEqual(len(car["tested"].split()), 1)
        self.assertTrue((self.folder / "loop/choice_2/choose.html").exists())
        with (self.folder / "loop/choices.csv").open() as file:
            self.assertEqual([row["clicks"] for row in csv.DictReader(file)], [car["first"], car["last"]])
        with (self.folder / "loop/force_speed.csv").open() as file:
            forces = list(csv.DictReader(file))
        self.assertEqual([int(row["click"]) for row in forces], list(range(4, 17)))
        # A harder click resists more, in both directions.
        for speed, sign in (("-0.3 m/s", -1), ("0.3 m/s", 1)):
            sizes = [sign * float(row[speed]) for row in forces]
            self.assertEqual(sizes, sorted(sizes))
        refused = self.python(study, FOURPOST, "loop", "--benched", "4,16")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("loop/bench was fitted to clicks 4,10,16, not to 4,16", refused.stderr)

    def run_python(self, *words):
        outcome = self.python(*words)
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        return outcome.stdout

    def python(self, *words):
        return subprocess.run([sys.executable, *map(str, words)], cwd=self.folder, capture_output=True, text=True)


if __name__ == "__main__":
    unittest.main()
