"""Tyres whose rate changes with their load, as a user meets them: check, responses, a fit, and its vehicle."""
import json
import math
import random
import re
import sys
import unittest

from program import FOURPOST, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "tests/validation"))
import suggest  # noqa: E402

G = 9.80665
PARAMETER = ('<fp:parameter name="q_tyre" value="{}" lower="0 1/m" upper="30 1/m" precision="0.01 1/m" '
             'source="test"/>\n  <fp:frame name="strut_top"')
TABLE = ('<table scale="$s_tyre"><point deflection="2 mm" force="0 N"/><point deflection="10 mm" force="1.5 kN"/>'
         '<point deflection="20 mm" force="3.9 kN"/></table></fp:tyre>')


def progressive(text, progression="6 1/m"):
    text = text.replace('<fp:frame name="strut_top"', PARAMETER.format(progression), 1)
    return text.replace('stiffness="$kt"', 'stiffness="$kt" progression="$q_tyre"')


def measured(text):
    text = re.sub(r'<fp:parameter name="kt".*?/>', '<fp:parameter name="s_tyre" value="1" lower="0.5" upper="2" '
                  'precision="0.001" source="test"/>', text, flags=re.DOTALL)
    return text.replace(' stiffness="$kt"/>', ">" + TABLE)


class Tyre(ProgramTest):
    def write_car(self, change, name="car.urdf"):
        self.write(name, change(suggest.vehicle_text("quarter_car")))

    def checked(self, *words):
        return json.loads(self.run_program("check", *words, "--json").stdout)

    def test_stands_on_its_curve(self):
        """The rate at rest is sqrt(k^2 + 4 k q F), and rises with the mass."""
        self.write_car(progressive)
        rates = []
        for mass in (200, 280):
            check = self.checked("car.urdf", "--set", f"m_sprung={mass}kg", "--set", "q_tyre=6/m")
            load = (mass + 22) * G
            rates.append(check["corners"][0]["tyre_rate_N_per_m"])
            self.assertAlmostEqual(rates[-1], math.sqrt(230e3 ** 2 + 4 * 230e3 ** 2 * 6 * load / 230e3), delta=1)
        self.assertGreater(rates[1], rates[0])

    def test_warns_of_a_table_that_ends_below_the_load(self):
        self.write_car(measured)
        self.assertEqual(self.checked("car.urdf")["findings"], [])
        self.write_car(lambda text: measured(text).replace("3.9 kN", "2.1 kN"))
        self.assertEqual([finding["id"] for finding in self.checked("car.urdf")["findings"]], ["tyre-table-end"])

    def test_names_what_is_wrong_with_a_curve(self):
        self.write_car(lambda text: measured(text).replace("<table", '<table file="none.csv"'))
        output = self.run_program("check", "car.urdf", code=3).stderr
        self.assert_finding(output, "file-and-points", "car.urdf:")
        self.write_car(lambda text: measured(text).replace('name="tyre"', 'name="tyre" stiffness="200 kN/m"'))
        output = self.run_program("check", "car.urdf", code=3).stderr
        self.assert_finding(output, "tyre-rate-twice", "car.urdf:")
        self.write_car(lambda text: measured(text).replace('force="3.9 kN"', 'force="1.2 kN"'))
        output = self.run_program("check", "car.urdf", code=3).stderr
        self.assert_finding(output, "tyre-point-order", "car.urdf:")

    def test_answers_alike_in_all_engines(self):
        """Where the wheel hops off its post, against the time integration."""
        for change in (progressive, measured):
            self.write_car(change)
            gains = []
            for engine in ("reduced", "full", "time"):
                self.run_program("response", "car.urdf", "--frequencies", "12Hz:13Hz:2", "--amplitude", "12mm",
                                 "--velocity", "2m/s", "--acceleration", "90m/s^2", "--engine", engine, "-o", engine)
                response = (self.folder / engine / "response.csv").read_text()
                rows = [row.split(",") for row in response.splitlines() if not row.startswith("#")]
                at = {name: rows[0].index(name) for name in ("channel", "gain", "mean")}
                row = next(row for row in rows[1:] if row[at["channel"]] == "F_tyre")
                gains.append((float(row[at["gain"]]), float(row[at["mean"]])))
            for gain, mean in gains[1:]:
                # 0.02 dB, and of the mean a hundredth of the dynamic force.
                self.assertAlmostEqual(gain / gains[0][0], 1, delta=0.0025)
                self.assertAlmostEqual(mean, gains[0][1], delta=0.01 * gains[0][0] * 0.012)

    def test_settles_writes_and_exports_its_curve(self):
        self.write_car(measured)
        self.run_program("settle", "car.urdf")
        exported = json.loads(self.run_program("export", "car.urdf", "--json").stdout)
        curve = exported["tyres"][0]["curve"]
        self.assertEqual([point["deflection"] for point in curve["table"]], [0.002, 0.01, 0.02])
        self.assertEqual(curve["table"][1]["force"], {"parameter": "s_tyre", "factor": 1500})
        resolved = self.run_program("check", "car.urdf", "--resolved").stdout
        self.write("resolved.urdf", resolved)
        self.assertEqual(self.checked("resolved.urdf")["modes"], self.checked("car.urdf")["modes"])

    def test_twin_finds_both_coefficients(self):
        """Stepped sines in which the wheel leaves the post, with 1 % noise, from another start."""
        hopping = ["--amplitude", "40mm", "--velocity", "1.2m/s", "--acceleration", "90m/s^2"]
        folder = self.folder
        held = {"q_tyre": "6/m", "kt": "180kN/m"}
        channels = suggest.record(FOURPOST, folder, progressive(suggest.vehicle_text("quarter_car")), "quarter_car",
                                  random.Random(1), hopping, held, 0)
        self.write_car(lambda text: progressive(text, "1 1/m"))
        self.write("study.yaml", "vehicle: car.urdf\nrecordings:\n  - {file: heave.csv, posts: heave}\nchannels:\n" +
                   "".join(f"  {name}: {name}\n" for name in channels) + "band: [0.5 Hz, 18 Hz]\n"
                   "model_error: {gain_dB: 0.02, phase: 0.1 deg, floor: 0.001, mean: 0.02 mm, second_harmonic: 0.005 mm}\n"
                   "search: {seed: 1, evaluations: 60, starts: 1}\n")
        self.run_program("fit", "study.yaml", "-o", "run", "--threads", "1", "--accept-implausible")
        fitted = {p["name"]: p for p in json.loads((folder / "run/result.json").read_text())["parameters"]}
        for name, truth in (("q_tyre", 6), ("kt", 180e3)):
            self.assertLess(fitted[name]["sd"], 0.2 * truth)
            self.assertAlmostEqual(fitted[name]["value"], truth, delta=4 * fitted[name]["sd"])
        self.assertRegex((folder / "run/vehicle.urdf").read_text(), r'name="q_tyre" value="[4-8]')


if __name__ == "__main__":
    unittest.main()
