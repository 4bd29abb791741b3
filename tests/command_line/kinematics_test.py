"""Kinematics and compliance as a user sees them: tables, files, and what is said of vehicles without travel."""
import csv
import json
import re
import unittest
import xml.etree.ElementTree

from program import SOURCE, ProgramTest

ROADSTER = SOURCE / "urdf/independent_roadster.urdf"


class Kinematics(ProgramTest):
    def test_writes_tables_and_pictures(self):
        text = self.run_program("kinematics", ROADSTER, "--travel", "-40mm:30mm", "--step", "5mm", "-o", "kc").stdout
        self.assertIn("axle 'front'", text)
        self.assertIn("rigid linkage: no compliance", text)
        rows = list(csv.DictReader((self.folder / "kc/wheels.csv").read_text().splitlines()))
        heave = [row for row in rows if (row["axle"], row["travel"], row["wheel"]) == ("front", "heave", "front_left")]
        self.assertEqual([round(float(row["travel_mm"]), 9) for row in heave], [5 * k for k in range(-8, 7)])
        answer = json.loads((self.folder / "kc/result.json").read_text())
        travel = answer["axles"][0]["travels"][0]
        self.assertEqual(travel["reached_m"], [-0.04, 0.03])
        track = travel["positions"][-1]["track_m"]
        self.assertAlmostEqual(float(heave[-1]["track_mm"]), 1000 * track, places=9)
        for name in ("axle_1.svg", "axle_2.svg"):
            xml.etree.ElementTree.parse(self.folder / "kc" / name)
        page = (self.folder / "kc/report.html").read_text()
        self.assertTrue(page.startswith("<!doctype html>"))
        # What is printed stands on the page as well.
        self.assertIn("foot outward in bump", page)
        for name in ("Track", "roll centre height"):
            value = re.search(f"{name} ([0-9.]+) mm", text, re.IGNORECASE)[1]
            self.assertIn(f"{name} {value}", page.replace("\u00a0", " "))
        self.assertIn("roll camber to the body, left wheel", text)
        self.assertEqual((self.folder / "kc/compliance.csv").read_text().count("\n"), 1)

    def test_marks_rows_beyond_stops(self):
        self.run_program("kinematics", ROADSTER, "-o", "kc")
        axle = json.loads((self.folder / "kc/result.json").read_text())["axles"][0]
        heave = axle["travels"][0]
        # By themselves travels end where the last stop begins.
        self.assertEqual(heave["asked_m"][1], axle["stops_m"][1])
        self.assertNotIn("*", self.run_program("kinematics", ROADSTER).stdout.split("roll, mm")[0])
        text = self.run_program("kinematics", ROADSTER, "--travel", "-40mm:150mm").stdout
        self.assertIn(f"* a wheel is beyond its last stop, which begins at", text)
        self.assertIn("150.0 *", text)

    def test_of_bushes(self):
        text = self.run_program("kinematics", SOURCE / "urdf/landrover110.urdf", "--travel", "10mm", "-o", "kc").stdout
        self.assertIn("aligning", text)
        rows = list(csv.DictReader((self.folder / "kc/compliance.csv").read_text().splitlines()))
        self.assertEqual(len(rows), 2 * 4 * 2 * 2)
        self.assertEqual({row["per"] for row in rows}, {"1 kN", "100 N*m"})

    def test_shows_the_loads_of_both_sides_where_they_differ(self):
        self.assertNotIn("front_right load, N", self.heave(ROADSTER))
        self.copy("meshes")
        text = ROADSTER.read_text().replace("../meshes", "meshes").replace('xyz="-1.180 0 0.460"', 'xyz="-1.180 0.06 0.460"')
        self.write("driver.urdf", text)
        head = self.heave("driver.urdf")
        self.assertIn("front_left load, N", head)
        self.assertIn("front_right load, N", head)
        self.assertNotIn("front_right camber", head)

    def heave(self, vehicle):
        """Head of the first table of heave."""
        lines = self.run_program("kinematics", vehicle, "--travel", "10mm").stdout.splitlines()
        return next(line for line in lines if line.startswith("heave, mm"))

    def test_reports_a_dead_centre(self):
        run = self.run_program("kinematics", ROADSTER, "--travel", "400mm", "--step", "100mm")
        self.assert_finding(run.stderr, "travel-not-reached")

    def test_goes_on_where_a_stop_is_met(self):
        """The stop on the damper's line turns a softly held axle: the path has a kink there, and goes on."""
        self.run_program("init", "van", "--suspension", "front=macpherson,rear=leaf_spring")
        run = self.run_program("kinematics", "van/vehicle.urdf", "--set", "kr_rear_windup=1.6kN*m/rad", "--travel",
                               "-90mm:80mm", "--json")
        for axle in json.loads(run.stdout)["axles"]:
            for travel in axle["travels"]:
                self.assertEqual(travel["reached_m"], travel["asked_m"], (axle["name"], travel["name"]))

    def test_refuses_what_has_no_travel(self):
        text = ROADSTER.read_text()
        rod = '<fp:rod name="lock_left" parent="FE_left" child="FC_arm_left"/>'
        locked = text.replace("</robot>", rod + "</robot>")
        self.assert_finding(self.run_program("kinematics", self.write("locked.urdf", locked), code=3).stderr,
                            "loops-rigid")
        damper = SOURCE / "studies/damper/model1.urdf"
        self.assert_finding(self.run_program("kinematics", damper, code=3).stderr, "no-wheels")
        for travel, step, finding in (("20", "10mm", "option-quantity"), ("10mm:20mm", "10mm", "option-travel"),
                                      ("20mm:-20mm", "10mm", "option-travel"),
                                      ("20mm", "0.001mm", "option-travel-steps"), ("20mm", "-1mm", "option-not-positive")):
            with self.subTest(travel=travel, step=step):
                run = self.run_program("kinematics", ROADSTER, f"--travel={travel}", f"--step={step}", code=2)
                self.assert_finding(run.stderr, finding)


if __name__ == "__main__":
    unittest.main()
