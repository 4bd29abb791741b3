"""`fourpost check`: what it prints of a vehicle, and what it says against one."""
import json
import math
import subprocess
import unittest

from program import FOURPOST, ProgramTest

LANDROVER = "urdf/landrover110_linkage.urdf"
QUARTER_CAR = "urdf/quarter_car.urdf"
GRAVITY = 9.80665


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes")

    def check(self, vehicle, *words, code=0):
        return self.run_program("check", vehicle, *words, code=code)

    def checked(self, vehicle):
        return json.loads(self.check(vehicle, "--json").stdout)

    def test_takes_values_that_are_written_once(self):
        self.run_program("init", "car")
        once = (self.folder / "car/vehicle.urdf").read_text()
        tag = once[once.index('<fp:parameter name="m_body"'):]
        tag = tag[:tag.index("/>") + 2]
        bind = '>\n    <fp:bind to="link[body]/mass"/>\n  </fp:parameter>'
        bound = once.replace('<mass value="$m_body"/>', '<mass value="300"/>').replace(tag, tag[:-2] + bind)
        self.assertNotIn("link[body]/mass", once)
        expected = self.checked("car/vehicle.urdf")
        self.write("car/vehicle.urdf", bound)
        self.assertEqual(self.checked("car/vehicle.urdf"), expected)
        self.write("car/vehicle.urdf", once)
        parameters = json.loads(self.run_program("params", "car/vehicle.urdf", "--json").stdout)["parameters"]
        self.assertEqual([p["name"] for p in parameters][0], "m_body")
        self.run_program("fit", "car/study.yaml", "-o", "run", "--no-suggest")
        fitted = (self.folder / "run/vehicle.urdf").read_text()
        self.assertIn('<mass value="$m_body"/>', fitted)
        self.assertNotIn('name="m_body" value="300 kg"', fitted)
        self.check("run/vehicle.urdf")
        # Written twice and not alike.
        self.write("car/vehicle.urdf", bound.replace('name="m_body" value="300 kg"', 'name="m_body" value="310 kg"'))
        refused = self.check("car/vehicle.urdf", code=3).stderr
        self.assert_finding(refused, "bind-value")
        self.assertIn("300 kg in the tree, but factor times the value of fp:parameter 'm_body' is 310 kg", refused)
        self.assertIn('write "$m_body"', refused)

    def test_prints_the_modes_while_friction_sticks(self):
        car = (self.folder / QUARTER_CAR).read_text()
        law = '<bilinear bump="$c_bump" rebound="$c_rebound"/>'
        self.write("sticking.urdf", car.replace("../meshes", "meshes")
                   .replace(law, law + '<friction force="60 N" stiffness="200 N/mm"/>'))
        self.write("stiff.urdf", car.replace("../meshes", "meshes").replace('name="k" value="15 kN/m"', 'name="k" value="215 kN/m"')
                   .replace('upper="40 kN/m"', 'upper="400 kN/m"'))
        sticking, stiff = self.checked("sticking.urdf"), self.checked("stiff.urdf")
        self.assertEqual(sticking["modes"], self.checked(QUARTER_CAR)["modes"])
        self.assertEqual(self.checked(QUARTER_CAR)["stuck_modes"], [])
        self.assertEqual(len(sticking["stuck_modes"]), 2)
        for stuck, expected in zip(sticking["stuck_modes"], stiff["modes"]):
            self.assertAlmostEqual(stuck["frequency_Hz"], expected["frequency_Hz"], delta=1e-9)
        self.assertRegex(self.check("sticking.urdf").stdout,
                         r"(?m)^These are the modes while friction slides\. While it sticks: [a-z ]+ [0-9.]+ Hz, ")

    def test_prints_loads_and_modes(self):
        check = self.checked(QUARTER_CAR)
        self.assertEqual(check["dof"], 2)
        self.assertEqual(check["mobility"]["joint_coordinates"], 2)
        self.assertEqual(check["mass_kg"], 222)
        self.assertAlmostEqual(check["unsprung_mass_kg"], 22, delta=1e-6)
        corner = check["corners"][0]
        self.assertAlmostEqual(corner["load_N"], 222 * GRAVITY, delta=1e-9)
        self.assertAlmostEqual(corner["alone"]["wheel_rate_N_per_m"], 15e3, delta=1e-3)
        self.assertAlmostEqual(check["struts"][0]["motion_ratio_alone"], 1, delta=1e-9)
        self.assertAlmostEqual(check["modes"][0]["frequency_Hz"], 1.3647, delta=0.5e-4)  # specification 1.1
        self.assertAlmostEqual(check["modes"][1]["damping_ratio"], 0.333, delta=0.5e-3)
        self.assertEqual(check["modes"][1]["name"], "wheel hop")
        self.assertEqual(len(check["observability"]), 6)

    def test_prints_posts_sensors_and_priors(self):
        end = 'source="thesis section 4.2, quarter car example"/>\n  <fp:parameter name="kt"'
        self.replace_in(QUARTER_CAR, f'precision="0.01 kN/m"\n                {end}',
                        f'precision="0.01 kN/m" prior_sd="700 N/m"\n                {end}')
        text = self.check(QUARTER_CAR).stdout
        for part in ("post  under tyre", "sensor", "accelerometer", "a_sprung", "prior sd", " 0.7 "):
            self.assertIn(part, text)
        check = self.checked(QUARTER_CAR)
        self.assertEqual(check["findings"], [])
        self.assertEqual(check["posts"][0]["tyre"], "tyre")
        self.assertEqual(check["sensors"][0]["name"], "a_sprung")
        self.assertEqual(check["sensors"][0]["kind"], "accelerometer")
        self.assertEqual(check["sensors"][0]["link"], "sprung")
        self.assertEqual(check["parameters"][2]["prior_sd"], 700)
        self.assertEqual(check["parameters"][2]["precision"], 10)
        self.assertEqual(check["bushings"], [])

    def test_prints_what_is_known_of_ratios(self):
        self.replace_in(QUARTER_CAR, '<fp:parameter name="c_rebound"',
                        '<fp:parameter name="c_rebound" like="c_bump" like_sd="0.15"')
        text = self.check(QUARTER_CAR).stdout
        row = next(line for line in text.splitlines() if line.startswith("c_rebound "))
        self.assertIn("like sd", text)
        self.assertRegex(row, r" c_bump +0\.15 ")
        parameters = {parameter["name"]: parameter for parameter in self.checked(QUARTER_CAR)["parameters"]}
        self.assertEqual(parameters["c_rebound"]["like"], {"parameter": "c_bump", "sd": 0.15})
        self.assertNotIn("like", parameters["c_bump"])

    def test_has_bushings_as_the_file_gives_them(self):
        """The leading arm's, with a loss factor of 0.1 at 30 Hz."""
        arm = self.checked("urdf/landrover110.urdf")["bushings"][0]
        self.assertEqual(arm["name"], "arm_FL")
        self.assertEqual(arm["stiffness_N_per_m"], [10e6, 1.5e6, 250e3])
        self.assertEqual(arm["rotational_stiffness_Nm_per_rad"], [1000, 100, 1000])
        self.assertAlmostEqual(arm["damping_Ns_per_m"][0], 0.1 * 10e6 / (2 * math.pi * 30), delta=1e-9)  # rounding

    def test_names_what_the_linear_model_leaves_out(self):
        self.replace_in(QUARTER_CAR, "</robot>",
                        '<fp:parameter name="gap" value="60 mm" lower="50 mm" upper="70 mm" precision="1 mm" '
                        'source="test"/><fp:stop name="stop" parent="sprung" child="unsprung"><bump gap="$gap" '
                        'stiffness="100 kN/m"/></fp:stop></robot>')
        outcome = self.check(QUARTER_CAR)
        self.assertEqual(outcome.stderr, "")
        self.assertIn("not in the linear model", outcome.stdout)

    def test_prints_all_findings_of_one_pass_also_in_json(self):
        self.replace_in(QUARTER_CAR, 'value="230 kN/m" lower="100 kN/m"', 'value="230 N/m" lower="100 N/m"')
        self.replace_in(QUARTER_CAR, '<linear stiffness="$k"', '<linear stiffness="$k" preload="-9 N"')
        outcome = self.check(QUARTER_CAR, "--json", code=3)
        findings = json.loads(outcome.stdout)["findings"]
        self.assertEqual([finding["severity"] for finding in findings], ["warning", "error"])
        self.assertEqual(findings[0]["file"], QUARTER_CAR)
        self.assertGreater(findings[0]["line"], 0)
        self.assertIn("was 230 kN/m meant?", findings[0]["text"])
        for finding in findings:
            self.assertIn(finding["text"], outcome.stderr)

    def test_says_in_json_why_a_file_does_not_read(self):
        self.replace_in(QUARTER_CAR, '<mass value="22"/>', '<mass value="-22"/>')
        check = json.loads(self.check(QUARTER_CAR, "--json", code=3).stdout)
        self.assertNotIn("name", check)
        self.assertGreaterEqual(len(check["findings"]), 1)
        self.assertEqual(check["findings"][0]["severity"], "error")

    def test_prints_tables_that_fit_a_terminal(self):
        vehicles = sorted((self.folder / "urdf").glob("*.urdf"))
        self.assertTrue(vehicles)
        for vehicle in vehicles:
            with self.subTest(vehicle.name):
                text = self.check(vehicle).stdout
                for part in ("motion ", "degrees of freedom", "centre of mass", "ride rate", "motion ratio",
                             "damping ratio", "source", "most sensitive"):
                    self.assertIn(part, text)
                for line in text.split("\n"):
                    self.assertLessEqual(len(line.encode()), 110, line)
                    self.assertFalse(line.endswith(" "), line)

    def test_prints_a_resolved_file_of_the_same_vehicle(self):
        resolved = self.check(LANDROVER, "--resolved")
        self.assertIn('preload="equilibrium"', resolved.stdout)
        self.assertEqual(resolved.stderr, "")
        self.write("resolved.urdf", resolved.stdout)
        self.assertEqual(self.check("resolved.urdf", "--json").stdout, self.check(LANDROVER, "--json").stdout)

    def test_warns_of_weight_that_no_tyre_carries(self):
        self.replace_in(LANDROVER, "</robot>",
                        '<fp:frame name="hook" link="ground" xyz="-1.456 0 3"/><fp:spring name="crane" parent="hook" '
                        'child="chassis"><linear stiffness="1 N/m" preload="1 kN"/></fp:spring></robot>')
        self.assertIn("warning: the tyres carry ", self.check(LANDROVER).stderr)

    def test_warns_of_motions_that_nothing_holds(self):
        self.replace_in(QUARTER_CAR, "</robot>",
                        '<link name="disc"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" '
                        'iyz="0"/></inertial></link><joint name="spin" type="continuous"><parent link="unsprung"/>'
                        '<child link="disc"/><axis xyz="0 1 0"/></joint></robot>')
        outcome = self.check(QUARTER_CAR)
        self.assertIn("nothing resists pitch of link 'disc'", outcome.stderr)
        self.assertIn("wheel wind-up, free ", outcome.stdout)

    def test_warns_of_an_unstable_vehicle(self):
        """A tyre's point far below an arm that turns: its load swings with the arm."""
        tyre = '<fp:tyre name="front_tyre" link="front_axle" xyz="0.870 0 '
        self.replace_in(LANDROVER, f'{tyre}-0.075"', f'{tyre}-15"')
        outcome = self.check(LANDROVER, "--json")
        check = json.loads(outcome.stdout)
        self.assertIs(check["stable"], False)
        self.assert_finding(outcome.stderr, "vehicle-unstable")
        self.assertEqual(check["modes"][0]["kind"], "diverging")
        self.assertIs(self.checked(QUARTER_CAR)["stable"], True)

    def test_refuses_a_faulty_vehicle(self):
        self.replace_in(LANDROVER, 'value="1725 kg"', 'value="1725"')
        self.assertIn('write "1725 kg"', self.check(LANDROVER, "--json", code=3).stderr)
        self.assertEqual(self.check(LANDROVER, code=3).stdout, "")

    def test_refuses_a_missing_file(self):
        self.check("nowhere.urdf", code=3)

    def test_fails_where_stdout_is_full(self):
        with open("/dev/full", "w") as full:
            outcome = subprocess.run([FOURPOST, "check", QUARTER_CAR, "--json"], cwd=self.folder, stdout=full,
                                     stderr=subprocess.PIPE, text=True)
        self.assertEqual(outcome.returncode, 5, outcome.stderr)


if __name__ == "__main__":
    unittest.main()
