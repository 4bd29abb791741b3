"""`fourpost export` as a user meets it."""
import json
import unittest

from program import SOURCE, ProgramTest

QUARTER_CAR = SOURCE / "urdf/quarter_car.urdf"


class Export(ProgramTest):
    def export(self, *words):
        return json.loads(self.run_program("export", *words, "--json").stdout)

    def test_has_equations_that_other_programs_can_form(self):
        """A quarter car: the state matrix by hand from its masses, rates and damper."""
        car = self.export(QUARTER_CAR)
        self.assertEqual(car["coordinates"], 2)
        value = {parameter["name"]: parameter["value"] for parameter in car["parameters"]}

        def number(scalar):
            return scalar["factor"] * value[scalar["parameter"]] if isinstance(scalar, dict) else scalar

        n = range(2)
        mass = [[0.0] * 2 for _ in n]
        stiffness = [[0.0] * 2 for _ in n]
        for body in car["bodies"]:
            jacobian = body["com_jacobian"][0]
            for i in n:
                for j in n:
                    mass[i][j] += number(body["mass"]) * sum(row[i] * row[j] for row in jacobian)
        for held in car["held"]:
            direction = held["length"]["gradient"]
            for i in n:
                for j in n:
                    stiffness[i][j] += number(held["law"]["stiffness"]) * direction[i] * direction[j]
        # Lower left of [0 1; -M^-1 K -M^-1 C], with a mass matrix that may not be diagonal.
        a = car["state_space"]["A"]
        for i in n:
            for j in n:
                product = sum(mass[i][k] * a[2 + k][j] for k in n)
                self.assertAlmostEqual(product, -stiffness[i][j], delta=1e-9 * max(map(abs, stiffness[i])))

    def test_names_inputs_and_outputs_with_units(self):
        space = self.export(QUARTER_CAR)["state_space"]
        self.assertEqual(space["inputs"], ["post"])
        self.assertEqual(len(space["outputs"]), len(space["output_units"]))
        self.assertEqual(len(space["C"]), len(space["outputs"]))
        self.assertEqual(dict(zip(space["outputs"], space["output_units"]))["a_sprung"], "m/s^2")

    def test_takes_values_and_the_folder_of_a_fit(self):
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        value = {p["name"]: p["value"] for p in self.export("run")["parameters"]}
        fitted = {p["name"]: p["value"] for p in json.loads((self.folder / "run/result.json").read_text())["parameters"]}
        for name in fitted:
            self.assertAlmostEqual(value[name], fitted[name], delta=1e-6 * abs(fitted[name]))
        changed = self.export("run", "--set", "k=30N/mm")
        self.assertEqual({p["name"]: p["value"] for p in changed["parameters"]}["k"], 30000)

    def test_refuses_what_has_no_equations(self):
        self.run_program("export", SOURCE / "studies/damper/friction_knees.urdf", code=3)
        self.run_program("export", self.folder, code=3)
        self.run_program("export", QUARTER_CAR, "--set", "none=3kg", code=2)

    def test_writes_a_file(self):
        self.run_program("export", QUARTER_CAR, "-o", "car.json")
        self.assertEqual(json.loads((self.folder / "car.json").read_text()), self.export(QUARTER_CAR))


if __name__ == "__main__":
    unittest.main()
