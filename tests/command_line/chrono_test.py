"""A vehicle of a Project Chrono model: init --chrono, check, settle, kinematics, response."""
import json
import shutil
import unittest
import xml.dom.minidom

from program import SOURCE, ProgramTest

MODEL = ["--chrono", "chrono/vehicle.json", "--tyre", "chrono/car/tyre.json"]


class Chrono(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(SOURCE / "tests/data/chrono", self.folder / "chrono")

    def test_writes_a_car_at_rest(self):
        output = self.run_program("init", "car", *MODEL)
        self.assertIn("car/vehicle.urdf", output.stdout)
        self.assertIn("[chrono-guide]", output.stderr)
        self.assertEqual(self.run_program("check", "car/vehicle.urdf").stderr, "")
        self.assertTrue(json.loads(self.run_program("settle", "car/vehicle.urdf", "--json").stdout)["is_at_rest_as_drawn"])
        axles = json.loads(self.run_program("check", "car/vehicle.urdf", "--json").stdout)["axles"]
        # By hand, see tests/vehicles/chrono.
        self.assertAlmostEqual(axles[0]["ride_frequency_Hz"], 1.5294, 3)
        self.run_program("kinematics", "car/vehicle.urdf")
        self.run_program("response", "car/vehicle.urdf")

    def test_takes_files_of_any_name(self):
        vehicle = self.folder / "chrono/vehicle.json"
        name = "wish--bones <&'>.json"
        (self.folder / "chrono/car/wishbones.json").rename(self.folder / "chrono/car" / name)
        vehicle.write_text(vehicle.read_text().replace("wishbones.json", name))
        vehicle.rename(self.folder / "chrono/a--b <&>.json")
        self.run_program("init", "car", "--chrono", "chrono/a--b <&>.json", "--tyre", "chrono/car/tyre.json")
        document = xml.dom.minidom.parse(str(self.folder / "car/vehicle.urdf"))
        self.assertIn("From a- -b <&>.json of Project Chrono", document.firstChild.data)
        sources = [each.getAttribute("source") for each in document.getElementsByTagName("fp:parameter")]
        self.assertTrue(any(f"Chrono, {name}: " in source for source in sources), sources)
        self.assertEqual(self.run_program("check", "car/vehicle.urdf").stderr, "")

    def test_spares_a_vehicle_that_is_there(self):
        self.run_program("init", "car", *MODEL)
        self.assertIn("[vehicle-is-there]", self.run_program("init", "car", *MODEL, code=5).stderr)
        files = json.loads(self.run_program("init", "car", *MODEL, "--replace", "--json").stdout)["files"]
        self.assertEqual(files, ["vehicle.urdf"])

    def test_lists_all_faults_and_writes_nothing(self):
        for file, old, new in [("wishbones", '"Mass": 12', '"Mass": -12'), ("leaf", "[0, 0.5, 0.35]", "[0, 0.5]")]:
            path = self.folder / f"chrono/car/{file}.json"
            path.write_text(path.read_text().replace(old, new))
        output = self.run_program("init", "car", *MODEL, code=3).stderr
        self.assert_finding(output, "chrono-mass", f"{self.folder.resolve()}/chrono/car/wishbones.json:9: ")
        self.assert_finding(output, "chrono-value", f"{self.folder.resolve()}/chrono/car/leaf.json:8: ")
        self.assertFalse((self.folder / "car").exists())


if __name__ == "__main__":
    unittest.main()
