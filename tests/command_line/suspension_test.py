"""A vehicle from hard points, as an engineer makes one: template, points of one's own, check, kinematics, settle."""
import csv
import json
import unittest
import xml.dom.minidom

from program import SOURCE, ProgramTest

KINDS = ["double_wishbone", "macpherson", "four_link_panhard", "three_link_panhard", "four_link", "trailing_arm",
         "semi_trailing_arm", "multilink", "a_frame", "leaf_spring", "twist_beam"]


class Suspension(ProgramTest):
    def rows(self, file="car/points.csv"):
        lines = [line for line in (self.folder / file).read_text().splitlines() if not line.startswith("#")]
        return list(csv.DictReader(lines))

    def test_goes_from_the_template_to_a_car(self):
        output = self.run_program("init", "car", "--suspension", "front=macpherson,rear=twist_beam").stdout
        self.assertIn("fourpost init car --suspension front=macpherson,rear=twist_beam --points car/points.csv", output)
        self.assertEqual(self.run_program("check", "car/vehicle.urdf").stderr, "")
        before = json.loads(self.run_program("kinematics", "car/vehicle.urdf", "--json").stdout)
        # The rack 20 mm lower: another bump steer.
        points = (self.folder / "car/points.csv").read_text()
        row = next(line for line in points.splitlines() if line.startswith("front,tie_inner"))
        cells = row.split(",")
        cells[4] = str(float(cells[4]) - 20)
        self.write("car/points.csv", points.replace(row, ",".join(cells)))
        again = ("init", "car", "--suspension", "front=macpherson,rear=twist_beam", "--points", "car/points.csv")
        self.assertIn("[vehicle-is-there]", self.run_program(*again, code=5).stderr)
        self.run_program(*again, "--replace")
        after = json.loads(self.run_program("kinematics", "car/vehicle.urdf", "--json").stdout)
        toe = [axles["axles"][0]["travels"][0]["positions"][0]["wheels"][0]["toe_rad"] for axles in (before, after)]
        self.assertGreater(abs(toe[0] - toe[1]), 1e-3)
        rest = json.loads(self.run_program("settle", "car/vehicle.urdf", "--json").stdout)
        self.assertTrue(rest["is_at_rest_as_drawn"])

    def test_spares_points_that_are_there(self):
        self.run_program("init", "car", "--suspension", "front=a_frame,rear=a_frame")
        self.write("car/points.csv", "mine")
        output = self.run_program("init", "car", "--suspension", "front=a_frame,rear=a_frame", "--replace", code=5).stderr
        self.assertIn("[points-are-there]", output)
        self.assertEqual((self.folder / "car/points.csv").read_text(), "mine")

    def test_lists_all_faults_and_writes_nothing(self):
        self.write("points.csv", "axle,point,x [mm],y [mm],z [mm]\nfront,contact,0,750,zero\nrear,contct,0,750,0\n"
                                 "front,tie_inner,100,-380,260\n")
        output = self.run_program("init", "car", "--suspension", "front=double_wishbone,rear=trailing_arm", "--points",
                                "points.csv", code=3).stderr
        self.assert_finding(output, "points-number", "points.csv:2: ")
        self.assert_finding(output, "point-unknown", "points.csv:3: ")
        self.assert_finding(output, "point-side", "points.csv:4: ")
        self.assert_finding(output, "point-missing", "points.csv: ")
        self.assertFalse((self.folder / "car").exists())

    def test_takes_a_file_of_any_name(self):
        self.run_program("init", "car", "--suspension", "front=a_frame,rear=a_frame")
        points = (self.folder / "car/points.csv").read_text()
        self.write("a--b <&>.csv", points)
        self.run_program("init", "x<&>--y", "--suspension", "front=a_frame,rear=a_frame", "--points", "a--b <&>.csv")
        self.assertEqual(self.run_program("check", "x<&>--y/vehicle.urdf").stderr, "")
        self.assertEqual((self.folder / "x<&>--y/points.csv").read_text(), points)
        # expat refuses what XML forbids, as "--" in a comment.
        head = xml.dom.minidom.parse(str(self.folder / "x<&>--y/vehicle.urdf")).firstChild
        self.assertIn("Points: a- -b <&>.csv.", head.data)

    def test_stands_on_its_loads(self):
        self.run_program("init", "car", "--suspension", "front=double_wishbone,rear=multilink", "--load",
                         "front=900kg,rear=700kg")
        car = json.loads(self.run_program("check", "car/vehicle.urdf", "--json").stdout)
        loads = [tyre["load_N"] / 9.80665 for tyre in car["corners"]]
        # Mass to 0.1 kg, centre to 0.1 mm.
        for load, expected in zip(sorted(loads), [350, 350, 450, 450]):
            self.assertAlmostEqual(load, expected, delta=0.1)
        for text, finding in (("front=900kg", "axle-load-missing"), ("front=900kg,front=700kg", "axle-load-twice"),
                              ("front=900", "option-quantity"), ("middle=1kg,front=900kg", "axle-load-malformed")):
            run = self.run_program("init", "other", "--suspension", "front=double_wishbone,rear=multilink", "--load", text,
                                   code=2)
            self.assert_finding(run.stderr, finding)

    def test_names_what_a_leaf_spring_has(self):
        self.run_program("init", "van", "--suspension", "front=McPherson,rear=leafspring", "--load", "front=820kg,rear=700kg")
        text = (self.folder / "van/vehicle.urdf").read_text()
        self.assertIn('<fp:spring name="rear_leaf_left"', text)
        self.assertNotIn("rear_coil", text)
        self.assertIn('<fp:parameter name="f_rear_leaf" value="0 N" lower="0 N" upper="1000 N"', text)
        self.assertEqual(self.run_program("check", "van/vehicle.urdf").stderr, "")
        unknown = self.run_program("init", "car", "--suspension", "front=McFerson,rear=leefspring", code=2).stderr
        self.assertIn("likewise 'leefspring' (did you mean 'leaf_spring'?)", unknown)

    def test_every_kind_and_point_is_documented(self):
        text = (SOURCE / "docs/suspensions.md").read_text()
        for kind in KINDS:
            self.run_program("init", kind, "--suspension", f"front={kind},rear={kind}")
            xml.dom.minidom.parse(str(self.folder / kind / "vehicle.urdf"))
            self.assertIn(f"| `{kind}` |", text)
            for row in self.rows(f"{kind}/points.csv"):
                self.assertIn(f"`{row['point']}`", text, kind)


if __name__ == "__main__":
    unittest.main()
