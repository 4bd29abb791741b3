"""What `fourpost fit` says of the force that its vehicle lacks is what was planted in the vehicle that was recorded."""
import csv
import json
import random
import sys
import unittest

from program import FOURPOST, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "tests/validation"))
import suggest  # noqa: E402


class MissingForce(ProgramTest):
    def fit(self, vehicle, planted, seed=1):
        case = ("planted", vehicle, planted, None, "", set(), [])
        suggest.four_post(FOURPOST, self.folder, case, random.Random(seed))
        self.run_program("fit", "study.yaml", "-o", "run", "--threads", "1", "--accept-implausible")
        return json.loads((self.folder / "run/result.json").read_text())["missing_force"]

    def first(self, missing, mechanism, element, amount):
        """Amounts are in the scale of the fit, which what is missing moves by up to a tenth."""
        one = missing["explanations"][0]
        self.assertEqual((one["mechanism"], one["elements"]), (mechanism, [element]))
        self.assertAlmostEqual(one["amount"], amount, delta=4 * one["sd"] + 0.1 * amount)
        return one

    def test_names_friction(self):
        missing = self.fit("landrover110_model1", suggest.friction("front_damper", 150))
        self.assertTrue(missing["lines_are_unique"])
        self.first(missing, "friction", "front_damper", 150)
        page = (self.folder / "run/report.html").read_text()
        for text in ("What force is missing", "dry friction along damper", "Audit of the rig"):
            self.assertIn(text, page)
        self.assertIn("<svg", (self.folder / "run/missing_force.svg").read_text())

    def test_names_damping_of_a_tyre(self):
        self.first(self.fit("landrover110_model1", suggest.tyres(["front_tyre"], 900)), "damping", "front_tyre", 900)

    def test_names_a_part_on_mounts(self):
        one = self.first(self.fit("landrover110_model1", suggest.power_unit(1.4, 250, 8.5)), "part_on_mounts", "chassis",
                         250)
        self.assertAlmostEqual(one["frequency_Hz"], 8.5, delta=0.1)

    def test_is_silent_of_a_twin(self):
        for seed in (1, 2, 3):
            self.assertEqual(self.fit("quarter_car", lambda text: text, seed)["explanations"], [])

    def test_table_is_within_noise_of_a_twin(self):
        self.fit("quarter_car", lambda text: text)
        with open(self.folder / "run/missing_force.csv", encoding="utf-8") as file:
            ratios = [float(row["force"]) / float(row["force_sd"]) for row in csv.DictReader(file)]
        mean_square = sum(ratio ** 2 for ratio in ratios) / len(ratios) / 2
        # Of some 64 independent squares, less what the fit took: three standard deviations.
        self.assertGreater(mean_square, 0.5)
        self.assertLess(mean_square, 1.4)


if __name__ == "__main__":
    unittest.main()
