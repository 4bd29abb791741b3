"""Instruments that are known to a standard deviation: planted errors are found, and intervals hold the truth."""
import csv
import json
import random
import re
import unittest

from program import ProgramTest, add_noise

STATED = """calibration:
  gain: {accelerometers: 2 %, posts: 1 %, load_cells: 1 %}
  delay: {posts: 1 ms}
"""


class Calibration(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "truth")
        self.run_program("response", "truth/vehicle.urdf", "--mode", "heave", "-o", "response")
        with open(self.folder / "response/response.csv", newline="") as file:
            self.rows = list(csv.DictReader(file))
        parameters = json.loads((self.folder / "truth/result.json").read_text())["parameters"]
        self.truth = {parameter["name"]: parameter["value"] for parameter in parameters}

    def record(self, seed, gain=1.0, late=0.0, post_gain=1.0, post_late=0.0):
        """Of accelerometers and posts, with noise of 1 % and 0.6 degrees."""
        draw = random.Random(seed)
        lines = ["frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,unit"]
        for row in self.rows:
            is_acceleration = row["channel"].startswith("a")
            frequency = float(row["frequency_Hz"])
            read = float(row["gain"]) * post_gain * (gain if is_acceleration else 1)
            phase = float(row["phase_deg"]) + 360 * frequency * (post_late - (late if is_acceleration else 0))
            mean = float(row["mean"]) + draw.gauss(0, 1e-4) if row["channel"] == "s_strut" else ""
            lines.append(
                f"{frequency},{row['post_amplitude_m']},{row['channel']},{draw.gauss(read, 0.01 * read)},"
                f"{draw.gauss(phase, 0.6)},{0.01 * read},0.6,{mean},{row['unit']}"
            )
        self.write("car/stepped_sine.csv", "\n".join(lines) + "\n")

    def fit(self, stated, code=0):
        study = (self.folder / "car/study.yaml").read_text()
        self.write("car/stated.yaml", stated + study)
        self.run_program("fit", "car/stated.yaml", "-o", "run", "--no-suggest", "--accept-implausible", code=code)
        return json.loads((self.folder / "run/result.json").read_text())

    def test_finds_planted_errors(self):
        self.record(1, gain=1.03, post_late=2e-3)
        result = self.fit(STATED)
        found = {one["name"]: one for one in result["intervals"]["calibrations"]}
        for name, planted in (("gain of accelerometers", 0.03), ("delay of posts", 2e-3), ("gain of posts", 0)):
            one = found[name]
            self.assertLess(abs(one["estimate"] - planted), 3 * one["estimate_sd"], one)
        self.assertLess(found["delay of posts"]["estimate_sd"], 0.5e-3)
        # Nothing but the load cell gives masses and rates their scale.
        self.assertAlmostEqual(found["gain of load_cells"]["estimate_sd"], 0.01, delta=1e-4)
        self.assertIn("calibration: gain of load_cells", {one["limited_by"] for one in result["parameters"]})
        for parameter in result["parameters"]:
            lower, upper = parameter["interval_95"]
            self.assertTrue(lower < self.truth[parameter["name"]] < upper, parameter)

    def test_brings_parameters_nearer(self):
        self.record(2, gain=0.97, post_late=-1.5e-3)

        def errors(result):
            return [abs(one["value"] / self.truth[one["name"]] - 1) for one in result["parameters"]]

        self.assertLess(sum(errors(self.fit(STATED))), 0.6 * sum(errors(self.fit(""))))

    def test_says_nothing_of_parameters_that_are_all_at_bounds(self):
        self.record(5)
        vehicle = (self.folder / "car/vehicle.urdf").read_text()
        start = vehicle.index('<fp:parameter name="k"')
        stiff = re.sub('value="[^"]*"(.*?)lower="[^"]*"(.*?)upper="[^"]*"', r'value="9 kN/m"\1lower="8 kN/m"\2upper="10 kN/m"',
                       vehicle[start:], count=1, flags=re.S)
        self.write("car/vehicle.urdf", vehicle[:start] + stiff)
        study = self.folder / "car/study.yaml"
        study.write_text(re.sub("^free: .*$", "free: [k]", study.read_text(), flags=re.M))
        parameter, = self.fit(STATED, code=1)["parameters"]
        self.assertEqual((parameter["state"], parameter["value"]), ("at_bound", 10e3))

    def test_names_one_beyond_its_statement(self):
        self.record(3, post_late=5e-3)
        result = self.fit(STATED)
        self.assertIn("calibration-beyond", [one["id"] for one in result["conclusions"]])
        self.record(4)
        result = self.fit(STATED)
        self.assertNotIn("calibration-beyond", [one["id"] for one in result["conclusions"]])

    def test_does_not_take_noise_of_posts_for_gains(self):
        """That noise moves the fit beside the optimum on purpose; the data must not pull the gains back by it."""
        self.run_program("simulate", "truth/vehicle.urdf", "--random", "4mm", "--duration", "20s", "--rate", "200Hz",
                         "--engine", "reduced", "--seed", "3", "-o", "clean.csv")
        noise = add_noise(self.folder / "clean.csv", self.folder / "recording.csv", 0.005, seed=6)
        post = next(name for name in noise if name.startswith("post_"))
        sensors = [name for name in noise if name != post]
        self.write("study.yaml", "\n".join([
            "vehicle: truth/vehicle.urdf", "histories:", "  - file: recording.csv",
            f"    posts: {{{post[5:]}: {post}}}", f"    channels: {{{', '.join(f'{name}: {name}' for name in sensors)}}}",
            f"    noise: {{{', '.join(f'{name}: {noise[name]}' for name in sensors)}}}",
            "calibration: {gain: {accelerometers: 1 %, load_cells: 1 %}}",
            "search: {evaluations: 20, starts: 1}", ""]))
        self.run_program("fit", "study.yaml", "-o", "run", "--no-suggest", "--accept-implausible")
        result = json.loads((self.folder / "run/result.json").read_text())
        self.assertEqual(result["conclusions"], [])
        for one in result["intervals"]["calibrations"]:
            self.assertLess(abs(one["estimate"]), 3 * one["estimate_sd"], one)
        for one in result["parameters"]:
            self.assertAlmostEqual(one["value"] / self.truth[one["name"]], 1, delta=0.03, msg=one)

    def test_refuses_what_is_no_instrument(self):
        self.write("car/wrong.yaml", "calibration: {gain: {accelerometer: 1 %}}\n" +
                   (self.folder / "car/study.yaml").read_text())
        answer = self.run_program("fit", "car/wrong.yaml", "-o", "run", code=3)
        self.assert_finding(answer.stderr, "calibration-unknown")
        self.assertIn("accelerometers", answer.stderr)


if __name__ == "__main__":
    unittest.main()
