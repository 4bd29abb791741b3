"""`fourpost predict` of a whole car: warp, a road and a load.

In place of a fit's folder there is the car as its file has it, with its study; recordings are from `fourpost response`
and `fourpost simulate` of the same car.
"""
import csv
import json
import shutil
import unittest

from program import ProgramTest

GRAVITY = 9.80665
CAR = "urdf/landrover110_engine.urdf"


class PredictCar(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes", "studies/landrover110")
        (self.folder / "run").mkdir()
        shutil.copy(self.folder / CAR, self.folder / "run/vehicle.urdf")
        shutil.copy(self.folder / "studies/landrover110/full.yaml", self.folder / "run/study.yaml")
        # Of a fit that has seen no recording.
        self.write("run/result.json", '{"termination": "converged", "parameters": [], "fitted_files": []}')

    def record_sine(self, mode):
        """A stepped sine as a rig writes it: without pattern and engine."""
        self.run_program("response", CAR, "--engine", "full", "-o", "response", "--mode", mode,
                         "--frequencies", "0.6Hz:10Hz:6")
        with open(self.folder / "response/response.csv", newline="") as file:
            rows = [row[1:-1] for row in csv.reader(file)]
        with open(self.folder / "sine.csv", "w", newline="") as file:
            csv.writer(file).writerows(rows)

    def predict(self, *words):
        return json.loads(self.run_program("predict", "run", "--json", "--recording", *words).stdout)

    def test_predicts_warp_by_the_full_geometry(self):
        """In warp, channels of the car's middle are next to nodes, where linear kinematics are visibly off."""
        self.record_sine("warp")
        answer = self.predict("sine.csv", "--mode", "warp")
        self.assertEqual(len(answer["channels"]), 21)
        self.assertEqual(answer["engine"], "full")
        self.assertIs(answer["linear_kinematics_error"]["visible"], True)
        for channel in answer["channels"]:
            # Digits of the table.
            self.assertLess(channel["nmse_percent"], 1e-3, channel)
        self.assertEqual(self.predict("sine.csv")["posts"], "warp")
        reduced = self.predict("sine.csv", "--mode", "warp", "--engine", "reduced")
        self.assertEqual(reduced["engine"], "reduced")
        self.assertGreater(reduced["channels"][4]["nmse_percent"], 0.1, reduced["channels"][4])
        self.assertGreater(self.predict("sine.csv", "--mode", "heave")["channels"][0]["nmse_percent"], 10)

    def test_predicts_a_road_on_four_posts(self):
        for corner in ("FL", "FR", "RL", "RR"):
            self.replace_in("run/study.yaml", f"{corner}: z_post_{corner}", f"{corner}: post_{corner}")
        self.run_program("simulate", CAR, "--road", "B", "--speed", "60km/h", "--duration", "4s", "--filter", "30Hz",
                         "-o", "road.csv")
        answer = self.predict("road.csv")
        self.assertEqual(len(answer["channels"]), 21)
        for channel in answer["channels"]:
            # The posts as they went through the filter, undone up to 45 Hz.
            self.assertLess(channel["nmse_percent"], 0.5, channel)

    def test_carries_a_load_on_four_posts(self):
        self.record_sine("roll")
        load = self.predict("sine.csv", "--mode", "roll", "--add-mass", "200 kg", "--at", "-2,300 mm,1")["added_load"]
        self.assertEqual(load["body"], "chassis")
        self.assertEqual(len(load["static_loads"]), 4)
        more = {post["post"]: post["with_N"] - post["without_N"] for post in load["static_loads"]}
        self.assertAlmostEqual(sum(more.values()), 200 * GRAVITY, delta=1e-6)  # rounding
        left = sum(force for post, force in more.items() if post.endswith("L"))
        # By the lever over the track, 2 x 0.743 m.
        self.assertAlmostEqual(left / sum(more.values()), 0.5 + 0.3 / (2 * 0.743), delta=1e-9)


if __name__ == "__main__":
    unittest.main()
