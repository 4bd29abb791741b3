"""`fourpost choose` as a user meets it: a small car, its folder, its faults."""
import csv
import json
import unittest

import jsonschema

from program import SOURCE, FittedStarter

SCHEMA = json.loads((SOURCE / "identify/command_line/schema/choose.json").read_text())
SETTINGS = """knobs:
  spring: {sets: k, range: {from: 12 kN/m, to: 28 kN/m, step: 4 kN/m}}
  damper: {sets: {c_bump: bump, c_rebound: rebound}, table: clicks.csv, now: 3}
roads:
  - {class: B, speed: 80 km/h}
  - {class: C, speed: 40 km/h}
draws: 40
duration: 10 s
"""
BENCHED_SETTINGS = SETTINGS.replace("table: clicks.csv", "bench: bench")
BENCH = """<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1"><link name="tube"/>
<link name="rod"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
<limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
PARAMETERS
<fp:damper name="damper" parent="tube" child="rod"><bilinear bump="$bump" rebound="$rebound"/></fp:damper>
</robot>"""
CLICKS = "click,bump,rebound\n,N*s/m,N*s/m\n1,500,700\n3,900,1500\n6,1400,3000\n"


class Choose(FittedStarter):
    def setUp(self):
        super().setUp()
        self.write("clicks.csv", CLICKS)
        self.write("settings.yaml", SETTINGS)

    def choose(self, *words, code=0):
        outcome = self.run_program("choose", "run", "--settings", "settings.yaml", "--json", *words, code=code)
        document = json.loads(outcome.stdout)
        jsonschema.Draft202012Validator(SCHEMA).validate(document)
        return document, outcome.stderr

    def rows(self, name):
        with (self.folder / name).open() as file:
            return list(csv.DictReader(file))

    def test_writes_what_it_prints(self):
        document, _ = self.choose("-o", "choice", "--threads", "1")
        self.assertEqual(json.loads((self.folder / "choice/result.json").read_text()), document)
        self.assertEqual(document["lattice"], 15)
        # Five springs by three clicks, and the fitted spring at the present click.
        self.assertEqual(document["rated"], 16)
        self.assertEqual(document["present"]["setting"], {"spring": "as fitted", "damper": "3"})
        names = {file.name for file in (self.folder / "choice").iterdir()}
        self.assertEqual(names, {"choose.html", "settings.csv", "metrics.csv", "test_next.csv", "settings.svg", "front.svg",
                                 "spectra.svg", "result.json"})
        settings = self.rows("choice/settings.csv")[1:]
        self.assertEqual(len(settings), 16)
        self.assertAlmostEqual(sum(float(row["best_probability"]) for row in settings), 1, places=9)
        best = next(row for row in settings if {"spring": row["spring"], "damper": row["damper"]} == document["best"]["setting"])
        self.assertAlmostEqual(float(best["change"]), 100 * document["best"]["change"]["mean"], places=9)
        self.assertEqual(min(float(row["change"]) for row in settings), float(best["change"]))
        # Both engines, two objectives and both together.
        self.assertEqual({check["engine"] for check in document["engines"]}, {"histories", "full"})
        for check in document["engines"]:
            self.assertAlmostEqual(check["by_spectra"], check["by_engine"], delta=0.02)
        page = (self.folder / "choice/choose.html").read_text()
        for word in ("Map of settings", "Two objectives", "What was asked for"):
            self.assertIn(word, page)

    def test_does_not_depend_on_threads(self):
        self.choose("--no-checks", "-o", "one", "--threads", "1")
        self.choose("--no-checks", "-o", "two", "--threads", "2")
        for name in ("result.json", "settings.csv", "test_next.csv"):
            self.assertEqual((self.folder / "one" / name).read_text(), (self.folder / "two" / name).read_text())

    def write_bench(self, sd):
        """The folder of a bench fit of three clicks, rates of which are known to `sd`, of which noise is a tenth."""
        rates = {"": (900, 1500), "_at_3": (1200, 2000), "_at_6": (1400, 2600)}
        names = {side + click: pair[i] for click, pair in rates.items() for i, side in enumerate(("bump", "rebound"))}
        (self.folder / "bench").mkdir(exist_ok=True)
        self.write("bench/vehicle.urdf", BENCH.replace("PARAMETERS", "".join(
            f'<fp:parameter name="{name}" value="{value} N*s/m" lower="100 N*s/m" upper="9000 N*s/m" precision="1 N*s/m" '
            'source="fit"/>' for name, value in names.items())))
        self.write("bench/study.yaml", "vehicle: vehicle.urdf\ncontrol: {bump: per setting, rebound: per setting}\nbench:\n"
                   "  recordings: [{file: 1.csv, control: 1}, {file: 3.csv, control: 3}, {file: 6.csv, control: 6}]\n")
        triangle = lambda size: [[size**2 if i == j else 0 for j in range(i + 1)] for i in range(len(names))]
        parameters = [{"name": name, "value": value, "unit": "N*s/m", "lower": 100, "upper": 9000}
                      for name, value in names.items()]
        self.write("bench/result.json", json.dumps({
            "parameters": parameters, "cost": 1, "identifiability": {"sd_inflation": 1}, "starts": {"runs": []},
            "intervals": {"confidence": "80 to 90 %", "moved_by_post_noise": [], "covariance": {
                "parameters": list(names), "noise": triangle(0.1 * sd), "total": triangle(sd)}}}))

    def test_doubt_of_benched_laws_lowers_the_probability_of_the_best(self):
        """The car is certain, so that the laws of the clicks are all that is in doubt."""
        self.write("settings.yaml", BENCHED_SETTINGS)
        best = []
        for sd in (0.001, 0.3):
            self.write_bench(sd)
            outcome = self.run_program("choose", "car/vehicle.urdf", "--settings", "settings.yaml", "--no-checks", "--json")
            document = json.loads(outcome.stdout)
            jsonschema.Draft202012Validator(SCHEMA).validate(document)
            self.assert_finding(outcome.stderr, "choice-bench-doubt-only", "car/vehicle.urdf")
            self.assertEqual(document["doubt_contains"], {
                "car": None, "benches": [{"run": "bench", "confidence": "80 to 90 %", "knobs": ["damper"]}],
                "exact_knobs": ["spring"], "compared_by_histories": 0, "model_error_on_roads": False})
            best.append(document["best"])
        self.assertGreater(best[0]["best_probability"], 0.95)
        self.assertLess(best[1]["best_probability"], 0.8)
        self.assertGreater(best[1]["regret"], best[0]["regret"])

    def test_says_what_the_doubt_contains(self):
        self.write_bench(0.1)
        self.write("settings.yaml", BENCHED_SETTINGS)
        self.choose("--no-checks", "-o", "one", "--threads", "1")
        self.choose("--no-checks", "-o", "two", "--threads", "2")
        for name in ("result.json", "settings.csv", "test_next.csv"):
            self.assertEqual((self.folder / "one" / name).read_text(), (self.folder / "two" / name).read_text())
        tested = [(row["spring"], row["damper"]) for row in self.rows("one/test_next.csv")]
        self.assertEqual(len(set(tested)), len(tested))
        words = ("P(best) and regret include the uncertainty of the car's parameters and the laws of damper from the "
                 "bench fit 'bench' (80 to 90 %)", "the numbers of spring")
        text = self.run_program("choose", "run", "--settings", "settings.yaml", "--no-checks").stdout
        page = (self.folder / "one/choose.html").read_text().replace("&#39;", "'")
        for word in words:
            self.assertIn(word, text)
            self.assertIn(word, page)
        # The laws' doubt adds to that of the car, whose draws stay as they were.
        self.write("bench/result.json", "{}")
        document, errors = self.choose("--no-checks")
        self.assert_finding(errors, "bench-without-doubt", "settings.yaml:3")
        self.assertEqual(document["doubt_contains"]["exact_knobs"], ["spring", "damper"])

    def test_chooses_for_a_vehicle_file_without_doubt(self):
        outcome = self.run_program("choose", "car/vehicle.urdf", "--settings", "settings.yaml", "--no-checks")
        self.assert_finding(outcome.stderr, "choice-without-doubt", "car/vehicle.urdf")
        self.assertNotIn("P(best)", outcome.stdout)

    def test_says_which_limit_nobody_meets(self):
        self.write("settings.yaml", SETTINGS + "limits: {damper.bump: {most: 1 mm}}\n")
        document, errors = self.choose("--no-checks", "-o", "choice", code=1)
        self.assertIsNone(document["best"])
        self.assertIn("limit-unattainable", {warning["id"] for warning in document["warnings"]})
        self.assert_finding(errors, "limit-unattainable", "settings.yaml:9")
        self.assertFalse((self.folder / "choice/front.svg").exists())

    def test_refuses_what_it_cannot_use(self):
        self.write("settings.yaml", SETTINGS.replace("sets: k,", "sets: kk,").replace("now: 3", "now: 4"))
        errors = self.run_program("choose", "run", "--settings", "settings.yaml", code=3).stderr
        self.assert_finding(errors, "knob-parameter", "settings.yaml:2")
        self.assert_finding(errors, "knob-now", "settings.yaml:3")
        self.write("settings.yaml", SETTINGS)
        errors = self.run_program("choose", "run", "--settings", "settings.yaml", "-o", "run", code=5).stderr
        self.assertIn("[", errors)
        self.run_program("choose", "nowhere", "--settings", "settings.yaml", code=3)
        self.run_program("choose", "run", code=2)

    def test_warns_of_roads_that_the_fit_has_not_seen(self):
        self.write("settings.yaml", SETTINGS.replace("class: C", "class: E") + "band: [0.5 Hz, 60 Hz]\n")
        _, errors = self.choose("--no-checks")
        self.assert_finding(errors, "road-beyond-speeds", "settings.yaml")
        self.assert_finding(errors, "road-beyond-band", "settings.yaml")

    def test_roads_without_an_answer_are_named(self):
        """Where the tyre is in the air nearly always, statistical linearisation does not converge."""
        self.write("rough.yaml", "knobs: {spring: {sets: k, values: [12 kN/m, 15 kN/m]}}\n"
                                 "roads: [{class: H, speed: 160 km/h}]\n")
        answer = self.run_program("choose", SOURCE / "urdf/quarter_car.urdf", "--settings", "rough.yaml", code=3)
        self.assert_finding(answer.stderr, "present-without-ride", "rough.yaml")



if __name__ == "__main__":
    unittest.main()
