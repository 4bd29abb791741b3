"""What --json prints is what identify/command_line/schema says, and every command that takes it has a schema."""
import json
import unittest

import jsonschema

from program import SOURCE, ProgramTest

SCHEMAS = SOURCE / "identify/command_line/schema"


def schema(name):
    return json.loads((SCHEMAS / f"{name}.json").read_text())


class Schema(ProgramTest):
    def check(self, name, *words, code=0):
        document = json.loads(self.run_program(*words, "--json", code=code).stdout)
        self.validate(name, document)
        return document

    def validate(self, name, document):
        jsonschema.Draft202012Validator.check_schema(schema(name))
        faults = jsonschema.Draft202012Validator(schema(name)).iter_errors(document)
        self.assertEqual([f"{fault.json_path}: {fault.message}" for fault in faults], [])

    def test_of_a_vehicle(self):
        vehicles = [*SOURCE.glob("urdf/*.urdf"), *SOURCE.glob("studies/**/*.urdf")]
        self.assertGreater(len(vehicles), 20)
        for file in vehicles:
            with self.subTest(file.name):
                # A damper alone carries nothing at rest.
                self.check("check", "check", file, code=3 if file.name == "friction_knees.urdf" else 0)
                self.check("params", "params", file)
                if file.parent.name in ("urdf", "single_wheel_station"):
                    self.check("export", "export", file)
        file = SOURCE / "urdf/quarter_car.urdf"
        self.check("modes", "modes", file, "--vary", "k")
        for name in ("quarter_car", "landrover110"):
            self.check("settle", "settle", SOURCE / f"urdf/{name}.urdf")
            self.check("kinematics", "kinematics", SOURCE / f"urdf/{name}.urdf", "--travel", "20mm")
        self.check("response", "response", file, "--frequencies", "1Hz:4Hz:4")
        self.check("view", "view", file, "--frequencies", "1Hz:4Hz:4", "-o", "car.html")
        self.check("simulate", "simulate", file, "--step", "20mm", "--duration", "1s")
        self.check("simulate", "simulate", file, "--sine", "2Hz", "--duration", "1s", "--engine", "full")
        self.check("ride", "ride", file, "--road", "B", "--speed", "60km/h", "--time", "--duration", "10s")

    def test_of_a_time_history(self):
        file = SOURCE / "urdf/quarter_car.urdf"
        for words, kind in ((["--sweep", "0.5Hz:20Hz"], "sweep"), (["--random", "4mm"], "random"), (["--sine", "2Hz"], "stepped")):
            self.run_program("simulate", file, *words, "--rate", "200Hz", "--duration", "60s", "-o", f"{kind}.csv")
            self.assertEqual(self.check("frf", "frf", f"{kind}.csv", "-o", kind)["kind"], kind)

    def test_of_a_broken_vehicle(self):
        text = (SOURCE / "urdf/quarter_car.urdf").read_text()
        broken = self.write("broken.urdf", text.replace('value="200 kg"', 'value="200"'))
        findings = self.check("check", "check", broken, code=3)["findings"]
        # It stands without its meshes.
        self.assertEqual({finding["severity"] for finding in findings}, {"error", "warning"})

    def test_of_the_starter_study(self):
        self.check("init", "init", "car")
        self.check("info", "info", "car/stepped_sine.csv", SOURCE / "studies/landrover110/static.csv",
                   SOURCE / "studies/damper/sine_1Hz_5mm.csv")
        self.check("study_response", "response", "car/study.yaml", "-o", "response")
        self.validate("study_response", json.loads((self.folder / "response/result.json").read_text()))
        fit = self.check("fit", "fit", "car/study.yaml", "-o", "run")
        self.assertEqual(fit, json.loads((self.folder / "run/result.json").read_text()))
        self.check("report", "report", "run")
        self.check("predict", "predict", "run", "--recording", "car/stepped_sine.csv")
        self.check("draws", "draws", "run")
        self.check("draws", "draws", "run", "--noise-only", "--study", "car/study.yaml", "-o", "draws.csv")
        self.check("suggest", "suggest", "run", "--study", "car/study.yaml", "--all")
        load = ["--add-mass", "20 kg", "--at", "0,0,0.8"]
        self.check("predict", "predict", "run", "--recording", "car/stepped_sine.csv", *load)

    def test_of_bench_studies(self):
        misfits = self.check("study_response", "response", SOURCE / "studies/damper/model1.yaml")
        self.assertGreater(len(misfits["validation"]), 0)
        for model in ("model1", "model2"):
            self.check("fit", "fit", SOURCE / f"studies/damper/{model}.yaml", "-o", model)
        self.check("rank", "rank", "model1", "model2")
        sine = SOURCE / "studies/damper/sine_5Hz_6mm.csv"
        predicted = self.check("predict", "predict", "model2", "--recording", sine)
        fitted = json.loads((self.folder / "model2/result.json").read_text())
        kept = [channel for channel in fitted["validation"] if channel["recording"] == sine.stem]
        # The folder of a run has no recordings to fit a linear model to.
        self.assertEqual([set(channel.pop("yardstick")) >= {"order", "nmse_percent"} for channel in kept], [True])
        self.assertEqual(predicted["channels"], kept)

    def test_of_histories(self):
        self.copy("studies/single_wheel_station", "meshes")
        study = "studies/single_wheel_station/model1.yaml"
        # A quarter of the recording has the same keys.
        self.replace_in(study, "sweep_12mm.csv\n", "sweep_12mm.csv\n    end: 4 s\n")
        self.replace_in(study, "evaluations: 60", "evaluations: 5")
        misfits = self.check("study_response", "response", study)
        self.assertEqual({misfit["recording"] for misfit in misfits["channels"]}, {"sweep_12mm"})
        self.check("fit", "fit", study, "-o", "run")
        self.check("predict", "predict", "run", "--recording", SOURCE / "studies/single_wheel_station/sweep_7mm.csv")

    def test_of_a_comparison(self):
        self.check("compare", "compare", SOURCE / "studies/test_problems/oscillator.yaml", "--methods", "dvhde,gb",
                   "--runs", "2")

    def test_of_a_batch(self):
        self.run_program("init", "car")
        self.write("plan.yaml", "fits: [{study: car/study.yaml}]\n"
                                "predictions: [{of: study, recordings: car/stepped_sine.csv}]\n")
        self.check("batch", "batch", "plan.yaml", "--list")
        told = self.check("batch", "batch", "plan.yaml", "-o", "out")
        self.assertEqual(told["counts"]["done"], 2)
        self.assertEqual(self.check("batch", "batch", "plan.yaml", "-o", "out")["work"]["found"], 2)

    def test_sees_what_is_wrong(self):
        document = self.check("init", "init", "car")
        document["more"] = 1
        with self.assertRaises(AssertionError):
            self.validate("init", document)

    def test_is_there_for_every_command_with_json(self):
        page = self.run_program("man").stdout
        commands = {part.split("\n")[0] for part in page.split(".SS ")[1:] if "\\-\\-json" in part}
        names = {file.stem for file in SCHEMAS.glob("*.json")}
        self.assertEqual(names - {"study_response"}, commands)


if __name__ == "__main__":
    unittest.main()
