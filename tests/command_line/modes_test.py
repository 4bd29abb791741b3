"""`fourpost modes`: poles and shapes, how they follow a parameter, and what it says against its options."""
import json
import unittest

from program import ProgramTest

QUARTER_CAR = "urdf/quarter_car.urdf"
LANDROVER = "urdf/landrover110_linkage.urdf"


class Modes(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes")

    def modes(self, *words, code=0):
        return self.run_program("modes", *words, code=code)

    def read(self, name):
        return (self.folder / name).read_text()

    def test_prints_poles_and_shapes(self):
        outcome = self.modes(QUARTER_CAR)
        self.assertEqual(outcome.stderr, "")
        # Poles of thesis section 4.2.
        for part in ("heave", "1.365", "0.401", "wheel hop", "16.44", "0.333", "0.210", "1.34", "0.0174", "0.134",
                     "sprung z 1", "unsprung z 1"):
            self.assertIn(part, outcome.stdout)
        result = json.loads(self.modes(QUARTER_CAR, "--json").stdout)
        self.assertEqual(len(result["modes"]), 2)
        self.assertEqual(len(result["state_space"]["A"]), 4)
        self.assertEqual(result["state_space"]["inputs"][0], "post")
        hop = result["modes"][1]
        self.assertEqual(hop["kind"], "oscillating")
        self.assertGreater(hop["poles_per_s"][0][1], 90)
        self.assertLess(hop["damped_frequency_Hz"], hop["frequency_Hz"])
        self.assertEqual(hop["shape"][0]["body"], "unsprung")
        self.assertAlmostEqual(hop["shape"][0]["translation_m"][2][0], 1, delta=1e-12)  # rounding

    def test_follows_poles_and_draws_them(self):
        text = self.modes(QUARTER_CAR, "--vary", "k", "--vary", "c_bump=200N*s/m:4000N*s/m:7", "-o", "result").stdout
        self.assertIn("Hz at 5.000 kN/m", text)
        self.assertEqual(self.read("result/poles.csv").count("\n"), 2 * 25 + 2 * 7 + 1)
        for picture in ("bode_k.svg", "bode_c_bump.svg", "impulse.svg"):
            self.assertTrue(self.read(f"result/{picture}").startswith("<svg"), picture)
        self.assertTrue(self.read("result/impulse.csv").startswith("time,"))
        self.assertTrue(self.read("result/report.html").startswith("<!doctype html>"))
        for picture in ("poles_k.svg", "poles_c_bump.svg"):
            self.assertIn(">wheel hop<", self.read(f"result/{picture}"), picture)
        stiffness, damping = json.loads(self.read("result/result.json"))["pole_paths"]
        self.assertEqual(stiffness["parameter"], "k")
        self.assertEqual(len(damping["values"]), 7)
        self.assertEqual(len(damping["paths"][0]["poles_per_s"]), 7)

    def test_names_all_faulty_options_at_once(self):
        errors = self.modes(QUARTER_CAR, "--vary", "m_unsprun", "--vary", "k=1kN/m", "--set", "m_sprun=2kg", "--set",
                            "kt=5", "-o", "result", code=2).stderr
        for part in ("--vary: error: the vehicle has no parameter 'm_unsprun', did you mean 'm_unsprung'?",
                     "[range-malformed]", "did you mean 'm_sprung'?", "[setting-unit]"):
            self.assertIn(part, errors)
        self.assertFalse((self.folder / "result").exists())

    def test_warns_of_a_mode_that_grows(self):
        tyre = '<fp:tyre name="front_tyre" link="front_axle" xyz="0.870 0 '
        self.replace_in(LANDROVER, f'{tyre}-0.075"', f'{tyre}-15"')
        outcome = self.modes(LANDROVER)
        self.assertIn("[unstable-in-design-pose]", outcome.stderr)
        self.assertIn("diverging", outcome.stdout)

    def test_of_every_shipped_vehicle_fit_a_terminal(self):
        vehicles = sorted((self.folder / "urdf").glob("*.urdf"))
        self.assertTrue(vehicles)
        for vehicle in vehicles:
            with self.subTest(vehicle.name):
                outcome = self.modes(vehicle)
                self.assertEqual(outcome.stderr, "")
                for line in outcome.stdout.split("\n"):
                    self.assertLessEqual(len(line.encode()), 110, line)


if __name__ == "__main__":
    unittest.main()
