"""Curves from files: a fit of a damper's measured curve, whose vehicle stands alone afterwards."""
import json
import re
import shutil
import unittest

from program import ProgramTest

CURVE = "speed [m/s],force [N]\n-1,-1500\n-0.1,-150\n0.1,150\n1,1500\n"


class Curve(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("init", "car")
        text = (self.folder / "car/vehicle.urdf").read_text()
        text = re.sub(r'<fp:parameter name="c_(bump|rebound)".*?/>', "", text, flags=re.DOTALL)
        text = text.replace('<bilinear bump="$c_bump" rebound="$c_rebound"/>', '<table file="shock.csv" scale="$s"/>')
        scale = '<fp:parameter name="s" value="1" lower="0.2" upper="4" precision="0.001" source="bench"/>'
        self.write("car/vehicle.urdf", text.replace("<fp:damper", scale + "\n  <fp:damper"))
        self.write("car/shock.csv", CURVE)
        study = (self.folder / "car/study.yaml").read_text()
        self.write("car/study.yaml", study.replace("c_bump, c_rebound]", "s]"))

    def test_is_fitted_and_written_out(self):
        self.run_program("fit", "car/study.yaml", "-o", "run")
        fitted = (self.folder / "run/vehicle.urdf").read_text()
        self.assertNotIn("shock.csv", fitted)
        self.assertIn('<point speed="-1 m/s" force="-1500 N"/>', fitted)
        self.assertIn('scale="$s"', fitted)
        before = json.loads(self.run_program("check", "run/vehicle.urdf", "--json").stdout)
        # The folder stands alone, wherever it goes.
        shutil.rmtree(self.folder / "car")
        shutil.move(self.folder / "run", self.folder / "elsewhere")
        after = json.loads(self.run_program("check", "elsewhere/vehicle.urdf", "--json").stdout)
        self.assertEqual(before["modes"], after["modes"])
        self.run_program("export", "elsewhere")

    def test_is_an_input_of_the_study(self):
        inputs = json.loads(self.run_program("info", "car/study.yaml", "--json").stdout)["files"][0]["inputs"]
        self.assertTrue(any(name.endswith("shock.csv") for name in inputs), inputs)

    def test_reports_its_faults_in_its_own_lines(self):
        self.write("car/shock.csv", CURVE.replace("0.1,150\n", "0.1,-150\n").replace("-1,-1500", "-1,much"))
        output = self.run_program("check", "car/vehicle.urdf", code=3).stderr
        self.assert_finding(output, "curve-number", "car/shock.csv:2: ")
        self.write("car/shock.csv", CURVE.replace("1,1500\n", "1,140\n"))
        output = self.run_program("check", "car/vehicle.urdf", code=3).stderr
        self.assert_finding(output, "curve-order", "car/shock.csv:5: ")


if __name__ == "__main__":
    unittest.main()
