"""`fourpost plan` as a user meets it: a car of the starter study, its fit, a rig, and its faults."""
import csv
import json
import math
import unittest

import jsonschema

from program import SOURCE, ProgramTest

SCHEMA = json.loads((SOURCE / "identify/command_line/schema/plan.json").read_text())
RIG = """time: 30 min
noise: {acceleration: 0.05 m/s^2, displacement: 0.1 mm, force: 20 N}
runs:
  - {mode: heave, band: [0.5 Hz, 5 Hz], frequencies: 15, amplitude: 8 mm}
  - {mode: heave, band: [5 Hz, 25 Hz], frequencies: 15, amplitude: 2 mm}
measurements:
  - {parameter: m_sprung, sd: 1 %, time: 5 min}
"""


class Plan(ProgramTest):
    def plan(self, *words, code=0):
        outcome = self.run_program("plan", *words, "--json", code=code)
        document = json.loads(outcome.stdout)
        jsonschema.Draft202012Validator(SCHEMA).validate(document)
        return document, outcome.stderr

    def test_plans_for_a_vehicle_without_more(self):
        document, errors = self.plan(SOURCE / "urdf/landrover110_model1.urdf", "--time", "40min")
        self.assertIn("plan-noise-assumed", errors)
        self.assertLessEqual(document["planned_time_s"], 2400)
        self.assertGreater(document["efficiency"], 0.7)
        self.assertLessEqual(document["efficiency"], 1)
        self.assertGreater(document["gain_over_even"], 1)
        for parameter in document["planned_parameters"]:
            self.assertLess(parameter["sd_with_plan"], parameter["sd_now"])
            self.assertLessEqual(parameter["sd_with_all"], parameter["sd_with_plan"])

    def test_is_next_to_the_best_where_repeats_improve(self):
        self.write("rig.yaml", "model_error: {gain_dB: 0.05, phase: 0.3 deg, mean: 0.05 mm, floor: 0}\n")
        document, _ = self.plan(SOURCE / "urdf/landrover110_model1.urdf", "--rig", "rig.yaml", "--time", "60min")
        self.assertGreater(document["efficiency"], 0.95)

    def test_writes_what_it_prints(self):
        self.write("rig.yaml", RIG)
        document, _ = self.plan(SOURCE / "urdf/quarter_car.urdf", "--rig", "rig.yaml", "-o", "plan")
        self.assertEqual(json.loads((self.folder / "plan/result.json").read_text()), document)
        with (self.folder / "plan/plan.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["run"] for row in rows], [run["name"] for run in document["planned_runs"]])
        chosen = [run for run in document["planned_runs"] if run["is_on_rig"] and run["repeats"] > 0]
        drives = sorted(file.name for file in (self.folder / "plan").glob("drive_*"))
        self.assertEqual(len(drives), 2 * len(chosen))
        drive = next(name for name in drives if name.endswith(".csv") and "0.5_Hz_5_Hz" in name)
        with (self.folder / "plan" / drive).open() as file:
            heights = [float(row["post_post"] if "post_post" in row else list(row.values())[1])
                       for row in list(csv.DictReader(file))[1:]]
        self.assertAlmostEqual(max(heights), 0.008, delta=0.0002)

    def test_recordings_of_its_drives_have_what_it_counts_on(self):
        self.write("rig.yaml", RIG)
        vehicle = SOURCE / "urdf/quarter_car.urdf"
        self.plan(vehicle, "--rig", "rig.yaml", "-o", "plan")
        drive = next((self.folder / "plan").glob("drive_*0.5_Hz_5_Hz.csv"))
        self.run_program("simulate", vehicle, "--recording", drive, "--engine", "reduced", "-o", "simulated.csv")
        self.run_program("frf", "simulated.csv", "-o", "frf")
        with (self.folder / "frf/heave.csv").open() as file:
            rows = list(csv.DictReader(file))
        frequencies = sorted({float(row["frequency_Hz"]) for row in rows})
        self.assertEqual(len(frequencies), 15)
        for row in rows:
            # The rig's file says 8 mm; more than 0.15 m/s or 6 m/s^2 no usual rig makes.
            w = 2 * math.pi * float(row["frequency_Hz"])
            asked = min(0.008, 0.15 / w, 6 / w**2)
            self.assertAlmostEqual(float(row["post_amplitude_m"]), asked, delta=1e-3 * asked)
        # A mean offset needs a rest to be relative to.
        struts = [row for row in rows if row["unit"] == "m"]
        self.assertTrue(struts)
        self.assertTrue(all(row["mean"] for row in struts))

    def test_drives_of_alike_names_are_files_of_their_own(self):
        self.write("rig.yaml", "time: 60 min\nrepeats: 1\nruns:\n" + "".join(
            f"  - {{mode: heave, band: [1 Hz, {4 + i} Hz], frequencies: 4, name: '{name}'}}\n"
            for i, name in enumerate(("高い", "低い", "a b", "A.b"))))
        document, _ = self.plan(SOURCE / "urdf/quarter_car.urdf", "--rig", "rig.yaml", "-o", "plan")
        chosen = [run for run in document["planned_runs"] if run["repeats"] > 0]
        self.assertEqual(len(chosen), 4)
        self.assertEqual(len(list((self.folder / "plan").glob("drive_*.csv"))), 4)

    def test_a_fit_is_what_is_known(self):
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "run", "--threads", "1")
        fitted = {one["name"]: one for one in json.loads((self.folder / "run/result.json").read_text())["parameters"]}
        document, errors = self.plan("run", "--time", "20min")
        # Its recordings have repeats, whose noise counts for the sensors that were read.
        with (self.folder / "run/response.csv").open() as file:
            read = {row["channel"] for row in csv.DictReader(file) if row["gain_sd"]}
        self.assertTrue(read)
        for channel in read:
            self.assertNotIn(f"'{channel}'", errors)
        for parameter in document["planned_parameters"]:
            stated = fitted[parameter["name"]]["sd"]
            # Of noise alone, of which the fit's own is a part.
            self.assertLessEqual(parameter["sd_now"], stated * (1 + 1e-6))
            self.assertLess(parameter["sd_with_plan"], parameter["sd_now"])

    def test_meets_what_is_wanted_or_says_that_it_cannot(self):
        self.write("rig.yaml", RIG + "want: {c_bump: 5 %}\n")
        document, _ = self.plan(SOURCE / "urdf/quarter_car.urdf", "--rig", "rig.yaml")
        wanted = next(one for one in document["planned_parameters"] if one["name"] == "c_bump")
        self.assertTrue(document["meets_wanted"])
        self.assertLessEqual(wanted["sd_with_plan"], wanted["wanted"])
        self.assertLess(document["planned_time_s"], 1800)
        self.write("rig.yaml", RIG + "want: {c_bump: 500 %}\n")
        document, _ = self.plan(SOURCE / "urdf/quarter_car.urdf", "--rig", "rig.yaml")
        self.assertEqual(document["planned_time_s"], 0)
        printed = self.run_program("plan", SOURCE / "urdf/quarter_car.urdf", "--rig", "rig.yaml").stdout
        self.assertIn("known already", printed)
        self.write("rig.yaml", RIG + "want: {c_bump: 0.001 %}\n")
        document, errors = self.plan(SOURCE / "urdf/quarter_car.urdf", "--rig", "rig.yaml", code=1)
        self.assertFalse(document["meets_wanted"])
        self.assertIn("plan-want-missed", errors)

    def test_faults(self):
        vehicle = SOURCE / "urdf/quarter_car.urdf"
        self.write("rig.yaml", "runs: []\n")
        self.assertIn("[rig-runs-none]", self.run_program("plan", vehicle, "--rig", "rig.yaml", code=3).stderr)
        self.assertIn("[plan-nothing-affordable]", self.run_program("plan", vehicle, "--time", "10s", code=3).stderr)
        self.run_program("plan", vehicle, "--time", "10 kg", code=2)
        self.run_program("plan", vehicle, "--rig", "nowhere.yaml", code=3)
        self.run_program("plan", "nowhere", code=3)

    def test_numbers_are_finite(self):
        document, _ = self.plan(SOURCE / "urdf/single_wheel_station.urdf", "--time", "30min")
        for parameter in document["planned_parameters"]:
            for key in ("sd_now", "sd_with_plan", "sd_shared_evenly", "sd_with_all"):
                self.assertTrue(math.isfinite(parameter[key]), (parameter["name"], key))


if __name__ == "__main__":
    unittest.main()
