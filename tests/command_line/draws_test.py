"""`fourpost draws` of the car that `fourpost init` writes, and the bands that a fit and a prediction have from it."""
import csv
import json
import math
import statistics
import unittest

from program import FittedStarter


def log_deviation(draws, parameter):
    """Of draws about their mean, in logarithms."""
    return statistics.pstdev(math.log(row[parameter]) for row in draws)


class Draws(FittedStarter):
    def draw(self, *options):
        return json.loads(self.run_program("draws", "run", "--json", *options).stdout)

    def parameters(self):
        return json.loads((self.folder / "run/result.json").read_text())["parameters"]

    def test_spread_as_the_run_states(self):
        """The run wrote `sd` and the covariance of what is drawn."""
        wide = self.draw("-n", "2000")
        self.assertEqual(wide["method"], "normal")
        self.assertEqual(wide["evaluations"], 0)
        noise = self.draw("-n", "500", "--noise-only", "--study", "car/study.yaml")
        self.assertEqual(noise["method"], "weighted")
        self.assertGreater(noise["effective"], 300)
        self.assertGreaterEqual(noise["evaluations"], 500)
        parameters = self.parameters()
        self.assertEqual(len(wide["draws"][0]), len(parameters))
        compared = 0
        for j, parameter in enumerate(parameters):
            if parameter["state"] != "determined" or not parameter["lower"] > 0:
                continue
            compared += 1
            sd = parameter["sd"] / parameter["value"]
            self.assertAlmostEqual(log_deviation(wide["draws"], j), sd, delta=0.1 * sd, msg=parameter["name"])
            of_noise = parameter["sd_parts"]["noise"] / parameter["value"]
            self.assertAlmostEqual(log_deviation(noise["draws"], j), of_noise, delta=0.2 * of_noise, msg=parameter["name"])
        self.assertGreater(compared, 0)

    def test_are_the_same_for_any_number_of_threads(self):
        words = ("draws", "run", "--noise-only", "--study", "car/study.yaml", "-n", "40", "--seed")
        one = self.run_program(*words, "7", "--threads", "1").stdout
        self.assertEqual(self.run_program(*words, "7", "--threads", "2").stdout, one)
        self.assertNotEqual(self.run_program(*words, "8").stdout, one)

    def test_are_a_table_with_names_and_units(self):
        answer = self.run_program("draws", "run", "-n", "3", "-o", "draws.csv").stdout
        self.assertTrue(answer.startswith("parameter"), answer)
        with open(self.folder / "draws.csv", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(len(rows), 5)
        first = self.parameters()[0]
        self.assertEqual(rows[0][0], first["name"])
        self.assertEqual(rows[1][0], first["unit"])

    def test_a_prediction_warns_where_it_leaves_the_fit(self):
        """12 mm were fitted: a prediction of the same motion leaves nothing, one of 20 mm all but the frequencies."""
        recording = (self.folder / "car/stepped_sine.csv").read_text()
        self.assertIn(",0.012,", recording)
        self.write("larger.csv", recording.replace(",0.012,", ",0.020,"))
        inside = json.loads(self.run_program("predict", "run", "--recording", "car/stepped_sine.csv", "--json").stdout)
        for warning in inside["warnings"]:
            self.assertNotIn("-not-covered", warning["id"])
        band = inside["band_95"]
        self.assertGreater(band["points"], 200)
        self.assertLess(band["outside"], 0.1 * band["points"])
        beyond = self.run_program("predict", "run", "--recording", "larger.csv", "--json")
        ids = [warning["id"] for warning in json.loads(beyond.stdout)["warnings"]]
        for what in ("amplitudes", "speeds", "travels", "loads"):
            self.assertIn(f"{what}-not-covered", ids)
        self.assertNotIn("frequencies-not-covered", ids)
        self.assertIn("20.0 mm (fit", beyond.stderr)

    def test_a_fit_has_bands_in_its_table_and_its_page(self):
        """A page draws the bands that response.csv holds."""
        table = (self.folder / "run/response.csv").read_text()
        self.assertIn("gain_half_95_parameters,gain_half_95_measured", table)
        self.assertIn('"gain_bands":[', (self.folder / "run/report.html").read_text())

    def test_are_refused_without_what_they_need(self):
        study = ("--study", "car/study.yaml", "--noise-only")
        self.assert_finding(self.run_program("draws", "run", "--noise-only", code=2).stderr, "draws-without-study")
        self.assertIn("--output", self.run_program("draws", "run", *study, "-n", "2", "-o", "draws.txt", code=2).stderr)
        # Ten times the first gain.
        self.write("car/other.csv", (self.folder / "car/stepped_sine.csv").read_text())
        self.replace_in("car/other.csv", ",1.18668,", ",11.8668,")
        self.replace_in("car/study.yaml", "file: stepped_sine.csv", "file: other.csv")
        self.assert_finding(self.run_program("draws", "run", *study, code=3).stderr, "draws-other-cost")
        self.replace_in("run/result.json", '"covariance"', '"formerly"')
        self.assert_finding(self.run_program("draws", "run", code=3).stderr, "run-without-covariance")


if __name__ == "__main__":
    unittest.main()
