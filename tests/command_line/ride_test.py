"""Ride on roads: what the command prints and writes, and what it refuses."""
import csv
import json
import re
import unittest

from program import SOURCE, ProgramTest

CAR = SOURCE / "urdf/landrover110_linkage.urdf"
ROAD = ("--road", "C", "--speed", "60km/h")


class Ride(ProgramTest):
    def metrics(self, *words):
        document = json.loads(self.run_program("ride", *words, "--json").stdout)
        return [{metric["name"]: metric["value"] for metric in ride["metrics"]} for ride in document["rides"]]

    def test_roads_and_speeds_are_all_combined(self):
        document = json.loads(self.run_program("ride", CAR, "--road", "B,C", "--speed", "40km/h,80km/h", "--json").stdout)
        self.assertEqual([ride["motion"] for ride in document["rides"]],
                         ["road B at 40 km/h", "road C at 40 km/h", "road B at 80 km/h", "road C at 80 km/h"])
        b, c = ({metric["name"]: metric["value"] for metric in ride["metrics"]} for ride in document["rides"][:2])
        # Road C is four times as rough: twice the heights, but for tyres that lift off.
        for name in ("a_cg.Wk", "front_tyre.load_rms", "rear_damper.travel", "body.heave"):
            self.assertAlmostEqual(c[name] / b[name], 2, delta=0.01, msg=name)

    def test_time_histories_are_near(self):
        outcome = self.run_program("ride", CAR, *ROAD, "--time", "--engine", "reduced")
        self.assertIn("difference, %", outcome.stdout)
        document = json.loads(self.run_program("ride", CAR, *ROAD, "--time", "--engine", "reduced", "--json").stdout)
        spectra, history = ({metric["name"]: metric["value"] for metric in ride["metrics"]} for ride in document["rides"])
        self.assertEqual([ride["way"] for ride in document["rides"]], ["spectra", "history"])
        # A minute of a road scatters by some percent.
        for name in ("a_cg.Wk", "front_tyre.load_rms", "rear_damper.speed"):
            self.assertAlmostEqual(spectra[name] / history[name], 1, delta=0.08, msg=name)
        self.assertIsNone(spectra["a_cg.mtvv"])
        self.assertGreater(history["a_cg.mtvv"], history["a_cg.Wk"])

    def test_other_motions_are_time_histories(self):
        for words in (("--step", "20mm", "--duration", "2s"), ("--sweep", "1Hz:10Hz", "--duration", "5s")):
            document = json.loads(self.run_program("ride", CAR, *words, "--engine", "reduced", "--json").stdout)
            self.assertEqual([ride["way"] for ride in document["rides"]], ["history"])
        self.run_program("simulate", CAR, "--random", "2mm", "--duration", "5s", "-o", "rig.csv", "--engine", "reduced")
        self.run_program("ride", CAR, "--recording", "rig.csv", "--engine", "reduced")

    def test_shocks_of_a_recording_are_named(self):
        # A bump in ten seconds of rest.
        self.run_program("simulate", CAR, "--step", "20mm", "--duration", "10s", "-o", "bump.csv", "--engine", "reduced")
        bump = ("ride", CAR, "--recording", "bump.csv", "--engine", "reduced")
        self.assert_finding(self.run_program(*bump).stderr, "ride-shocks")
        # A minute of a stationary road has none.
        road = self.run_program("ride", CAR, *ROAD, "--time", "--engine", "reduced")
        self.assertNotIn("[ride-shocks]", road.stderr)

    def test_points_and_weightings(self):
        seat = ("--point", "seat=chassis:0.1,0.3,0.8", "--weighting", "seat=Wb", "--weighting", "a_cg=Wd")
        metrics = self.metrics(CAR, *ROAD, *seat)[0]
        self.assertIn("seat.Wb", metrics)
        self.assertIn("a_cg.Wd", metrics)
        # Near the centre of mass the unweighted acceleration is nearly that of it.
        self.assertAlmostEqual(metrics["seat.rms"] / metrics["a_cg.rms"], 1, delta=0.05)

    def test_sickness_needs_a_lower_band(self):
        sick = ("--weighting", "a_cg=Wf")
        self.assert_finding(self.run_program("ride", CAR, *ROAD, *sick).stderr, "ride-band-above-sickness", "--band: ")
        lower = self.run_program("ride", CAR, *ROAD, *sick, "--band", "0.08Hz:30Hz").stderr
        self.assertNotIn("[ride-band-above-sickness]", lower)

    def test_a_setting_changes_it(self):
        hard = self.metrics(CAR, *ROAD, "--set", "c_front_bump=4000N*s/m", "--set", "c_front_rebound=8000N*s/m")[0]
        self.assertGreater(hard["a_cg.Wk"], self.metrics(CAR, *ROAD)[0]["a_cg.Wk"])

    def test_files_hold_what_is_printed(self):
        document = json.loads(self.run_program("ride", CAR, *ROAD, "-o", "ride", "--json").stdout)
        folder = self.folder / "ride"
        self.assertEqual({file.name for file in folder.iterdir()},
                         {"report.html", "metrics.csv", "spectra.csv", "ride.svg", "result.json"})
        self.assertEqual(json.loads((folder / "result.json").read_text()), document)
        with open(folder / "metrics.csv", newline="") as file:
            rows = {row["metric"]: row["value"] for row in csv.DictReader(file)}
        for metric in document["rides"][0]["metrics"]:
            expected = "" if metric["value"] is None else metric["value"]
            self.assertEqual(rows[metric["name"]] and float(rows[metric["name"]]), expected)
        # The density's integral by the trapezoidal rule is the mean square.
        with open(folder / "spectra.csv", newline="") as file:
            spectrum = [(float(row["frequency_Hz"]), float(row["density"])) for row in csv.DictReader(file)
                        if row["channel"] == "a_cg"]
        square = sum((f - e) * (a + b) / 2 for (e, a), (f, b) in zip(spectrum, spectrum[1:]))
        self.assertAlmostEqual(square ** 0.5 / float(rows["a_cg.rms"]), 1, delta=0.02)
        self.run_program("ride", CAR, *ROAD, "-o", "ride")
        self.assertIn("[folder-of-other-result]", self.run_program("modes", CAR, "-o", "ride", code=5).stderr)

    def test_a_page_has_numbers_spectra_and_sliders(self):
        outcome = self.run_program("ride", CAR, *ROAD, "-o", "ride")
        self.assertIn("open ride/report.html", outcome.stderr)
        text = (self.folder / "ride/report.html").read_text()
        self.assertTrue("Road C at 60 km/h</h2>" in text, "the heading")
        self.assertTrue("Power spectra, 4 nonlinear elements by statistical linearisation." in text, "the method")
        data = json.loads(re.search(r'id="data">(.*?)</script>', text, re.DOTALL).group(1))
        charts = data["curves"]["ride_1"]["charts"]
        points = ["a_body_front", "a_body_rear", "a_cross_member", "a_tow_point", "a_cg"]
        self.assertEqual([chart["title"] for chart in charts], [*points, "weighting Wk", "tyre loads"])
        self.assertEqual([line["label"] for line in charts[0]["lines"]], ["weighted", "unweighted"])
        ride = data["live"]["ride"]
        self.assertEqual((ride["road"], ride["band_Hz"]), ("C", [0.5, 30]))
        self.assertEqual(ride["points"], [{"name": name, "weighting": "Wk"} for name in points])
        self.assertAlmostEqual(ride["speed"], 60 / 3.6)

    def test_a_fit_rides_as_its_vehicle_does(self):
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        self.assertEqual(self.metrics("run", *ROAD), self.metrics("run/vehicle.urdf", *ROAD))
        self.run_program("ride", "run", *ROAD, "-o", "ride")
        self.assertTrue((self.folder / "ride/report.html").exists())

    def test_faults_are_named_at_once(self):
        text = self.run_program("ride", CAR, "--road", "C", "--speed", "0km/h", "--point", "seat=chasis:0,0,1", "--point",
                                "seat", "--weighting", "a_cgg=Wk", "--weighting", "a_cg=We", "--point",
                                "a_cg=chassis:0,0,0", code=2).stderr
        self.assert_finding(text, "option-not-positive", "--speed: ")
        self.assert_finding(text, "ride-point-link", "--point: ")
        self.assert_finding(text, "ride-point-malformed", "--point: ")
        self.assert_finding(text, "ride-point-twice", "--point: ")
        self.assert_finding(text, "ride-weighting-point", "--weighting: ")
        self.assert_finding(text, "ride-weighting-malformed", "--weighting: ")
        self.assertIn("[usage]", self.run_program("ride", CAR, "--road", "C", code=2).stderr)
        self.assertIn("[value-unknown]", self.run_program("ride", CAR, "--road", "X", "--speed", "9m/s", code=2).stderr)

    def test_vehicles_that_cannot_ride_are_refused(self):
        text = CAR.read_text()
        self.copy("meshes")
        posts = "\n".join(line for line in text.splitlines() if "<fp:post" not in line)
        self.write("posts.urdf", posts.replace("../meshes", "meshes"))
        self.assert_finding(self.run_program("ride", "posts.urdf", *ROAD, code=3).stderr, "vehicle-without-posts")

    def test_ranges_of_the_method_are_named(self):
        rough = self.run_program("ride", CAR, "--road", "F", "--speed", "60km/h").stderr
        self.assert_finding(rough, "ride-not-normal")
        self.assertNotIn("[road-beyond-iso]", rough)
        slow = self.run_program("ride", CAR, "--road", "B", "--speed", "20km/h").stderr
        self.assert_finding(slow, "road-beyond-iso", "--speed: ")
        self.assertNotIn("[ride-not-normal]", slow)
        self.assert_finding(self.run_program("ride", CAR, "--road", "B", "--speed", "60km/h", "--band", "0.5Hz:40Hz").stderr,
                            "bodies-bend", "--band: ")
        self.assertEqual(self.run_program("ride", CAR, "--road", "B", "--speed", "60km/h").stderr, "")


if __name__ == "__main__":
    unittest.main()
