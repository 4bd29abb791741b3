"""Hard points and bushes of a car fitted to a rig's tables, as a user does it."""
import csv
import json
import re
import unittest

from program import ProgramTest

PARAMETERS = """
  <fp:parameter name="dz_upper_ball" value="0 mm" lower="-10 mm" upper="10 mm" precision="0.01 mm" source="drawing"/>
  <fp:parameter name="dz_tie_outer" value="0 mm" lower="-10 mm" upper="10 mm" precision="0.01 mm" source="drawing"/>
</robot>"""
FREED = {"front_upper_ball_upper_arm_left": "dz_upper_ball", "front_upper_ball_knuckle_left": "dz_upper_ball",
         "front_tie_outer_knuckle_left": "dz_tie_outer"}
STUDY = """vehicle: car/vehicle.urdf
kinematics:
  - file: kin/wheels.csv
    axle: front
    noise: {camber: 0.02 deg, toe: 0.01 deg}
  - file: kin/compliance.csv
    axle: rear
    motion: lateral
    noise: {toe: 0.002 deg, centre_y: 0.02 mm}
    case: together
free: [dz_upper_ball, dz_tie_outer, k_rear_pivot]
search: {evaluations: 1, starts: 1}
"""


class KinematicsStudy(ProgramTest):
    def car(self):
        """A car with a shift of two points, and no posts, which a rig of this kind has not."""
        self.run_program("init", "car", "--suspension", "front=double_wishbone,rear=twist_beam")
        text = (self.folder / "car/vehicle.urdf").read_text()
        for frame, parameter in FREED.items():
            text, count = re.subn(f'(<fp:frame name="{frame}"[^>]*)/>', f'\\1 dz="${parameter}"/>', text)
            self.assertEqual(count, 1)
        text = re.sub(r"\n *<fp:post [^>]*/>", "", text)
        self.write("car/vehicle.urdf", text.replace("</robot>", PARAMETERS))

    def test_fits_points_and_bushes_to_the_files_of_kinematics(self):
        self.car()
        self.run_program("kinematics", "car/vehicle.urdf", "--set", "dz_upper_ball=3mm", "--set", "dz_tie_outer=-2mm",
                         "--set", "k_rear_pivot=3kN/mm", "--travel", "30mm", "--step", "30mm", "-o", "kin")
        self.write("study.yaml", STUDY)
        text = self.run_program("fit", "study.yaml", "-o", "run").stdout
        self.assertIn("rig table", text)
        result = json.loads((self.folder / "run/result.json").read_text())
        fitted = {one["name"]: one for one in result["parameters"]}
        # The tables hold the truth to all digits; a fit stops where a step no longer matters beside the noise.
        for name, truth in (("dz_upper_ball", 3e-3), ("dz_tie_outer", -2e-3), ("k_rear_pivot", 3e6)):
            self.assertAlmostEqual(fitted[name]["value"], truth, delta=1e-2 * fitted[name]["sd"])
            self.assertEqual(fitted[name]["state"], "determined")
        curves = result["kinematics"]
        # Camber and toe of two wheels in heave, roll and each wheel's travel; toe and y of two wheels.
        self.assertEqual(len(curves), 2 * 2 * 4 + 4)
        self.assertLess(max(curve["misfit"] for curve in curves), 0.01)
        self.assertEqual({curve["use"] for curve in curves}, {"fit"})
        rows = list(csv.DictReader((self.folder / "run/kinematics.csv").read_text().splitlines()))
        self.assertEqual(len(rows), sum(curve["points"] for curve in curves))
        page = (self.folder / "run/report.html").read_text()
        self.assertIn("Kinematics and compliance", page)
        # The fitted vehicle has the points: it stands alone.
        value, = re.findall('name="dz_upper_ball" value="(.*?) mm"', (self.folder / "run/vehicle.urdf").read_text())
        self.assertAlmostEqual(float(value), 1e3 * fitted["dz_upper_ball"]["value"], places=9)  # digits of a double
        self.predicts()

    def predicts(self):
        self.run_program("kinematics", "run/vehicle.urdf", "--travel", "30mm", "--step", "30mm", "-o", "more")
        answer = json.loads(self.run_program("predict", "run", "--recording", "more/wheels.csv", "--json").stdout)
        self.assertLess(max(curve["rms"] for curve in answer["kinematics"]), 1e-6)

    def test_looks_at_tables_and_studies(self):
        self.car()
        self.run_program("kinematics", "car/vehicle.urdf", "--travel", "20mm", "--step", "20mm", "-o", "kin")
        text = self.run_program("info", "kin/wheels.csv").stdout
        self.assertIn("kinematics and compliance", text)
        self.assertIn("heave", text)
        self.write("study.yaml", STUDY)
        self.run_program("info", "study.yaml")
        answer = json.loads(self.run_program("response", "study.yaml", "--json").stdout)
        self.assertLess(max(curve["rms"] for curve in answer["kinematics"]), 1e-6)

    def test_refuses_a_quantity_without_column(self):
        self.car()
        self.write("front.csv", "travel [mm],camber_left [deg]\n-20,0.6\n0,0\n20,-0.7\n")
        self.write("study.yaml", """vehicle: car/vehicle.urdf
kinematics:
  - file: front.csv
    axle: front
    motion: heave
    noise: {camber: 0.02 deg, toe: 0.01 deg}
free: [dz_upper_ball]
""")
        text = self.run_program("fit", "study.yaml", "-o", "run", code=3).stderr
        self.assertIn("study.yaml:3", text)
        self.assertIn("[kinematics-quantity-missing]", text)


if __name__ == "__main__":
    unittest.main()
