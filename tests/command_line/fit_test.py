"""`fourpost fit` of the Land Rover's recordings: what it prints and writes, and the vehicle that comes of it."""
import csv
import json
import math
import shutil
import unittest

from program import SOURCE, ProgramTest, drop_swept_sine

VEHICLE = "urdf/landrover110_linkage.urdf"
MODEL1 = "studies/landrover110/model1.yaml"
JOINT = "studies/landrover110/model1_joint.yaml"
MODEL2 = "studies/landrover110/model2.yaml"
PARTS = ("urdf", "meshes", "studies/landrover110")


class FitTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy(*PARTS)

    def read(self, name):
        return (self.folder / name).read_text()

    def result(self):
        return json.loads(self.read("result/result.json"))

    def write_joint(self, text):
        """Four of its sweep's sixty seconds, two of its parameters: what is fitted and what is predicted stay the same."""
        for old, new in (("evaluations: 100", "evaluations: 5"), ("starts: 4", "starts: 1"),
                         ("    file: bounce_sweep.csv\n", "    file: bounce_sweep.csv\n    start: 20 s\n    end: 24 s\n")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.write(JOINT, text + "\nfree: [c_front_rebound, c_rear_rebound]\n")


class Validation(FitTest):
    def test_predicts_stepped_sines_that_are_kept_from_the_fit(self):
        study = self.folder / MODEL1
        drop_swept_sine(study)
        study.write_text(study.read_text().replace("    posts: pitch\n", "    posts: pitch\n    use: validation\n"))
        kept = self.run_program("fit", "--no-suggest", MODEL1, "-o", "result", "--seed", "3")
        result = self.result()
        self.assertEqual([one["name"] for one in result["recordings"]], ["bounce"])
        unseen = {one["name"]: one for one in result["validation"] if one["recording"] == "pitch"}
        self.assertEqual(set(unseen), {one["name"] for one in result["channels"]})
        self.assertIn("Not fitted:", kept.stdout)
        with (self.folder / "result/response.csv").open() as table:
            rows = list(csv.DictReader(table))
        self.assertEqual({row["in_band"] for row in rows if row["recording"] == "pitch"}, {"0"})
        self.assertIn("1", {row["in_band"] for row in rows if row["recording"] == "bounce"})
        # As `predict` has it of the same fit.
        other = study.parent / "pitch_frf.csv"
        predicted = json.loads(self.run_program("predict", "result", "--recording", other, "--mode", "pitch", "--json").stdout)
        for channel in predicted["channels"]:
            self.assertAlmostEqual(channel["nmse_percent"] / unseen[channel["name"]]["nmse_percent"], 1, places=2)
        # The fit has not seen it: without it all comes out alike.
        study.write_text(study.read_text().replace(
            "  - name: pitch\n    file: pitch_frf.csv\n    posts: pitch\n    use: validation\n", ""))
        self.run_program("fit", "--no-suggest", MODEL1, "-o", "alone", "--seed", "3")
        alone = json.loads(self.read("alone/result.json"))
        for key in ("cost", "residuals", "parameters", "channels"):
            self.assertEqual(alone[key], result[key])

    def test_fits_histories_and_predicts_all_stepped_sines(self):
        study = self.folder / JOINT
        text = study.read_text().replace("    posts: heave\n", "    posts: heave\n    use: validation\n")
        text = text.replace("    posts: pitch\n", "    posts: pitch\n    use: validation\n")
        self.write_joint(text)
        answer = self.run_program("fit", "--no-suggest", JOINT, "-o", "result")
        result = self.result()
        self.assertEqual(result["recordings"], [])
        self.assertEqual({one["recording"] for one in result["validation"]}, {"bounce", "pitch"})
        self.assertEqual({one["recording"] for one in result["channels"]}, {"bounce_sweep"})
        self.assertIn("not fitted", self.read("result/response.svg"))
        self.assertEqual(answer.stdout.count("Not fitted:"), 1)
        predicted = self.run_program("predict", "result", "--recording", study.parent / "pitch_frf.csv", "--mode", "pitch",
                                     "--json")
        self.assertGreater(len(json.loads(predicted.stdout)["channels"]), 0)

    def test_explains_tables_of_several_kinds_once(self):
        study = self.folder / JOINT
        text = study.read_text().replace("    posts: pitch\n", "    posts: pitch\n    use: validation\n")
        history = text[text.index("  - name: bounce_sweep"):text.index("# Load cells at rest")]
        kept = history.replace("name: bounce_sweep\n", "name: kept\n    use: validation\n")
        text = text.replace(history, history.rstrip() + "\n" + kept)
        self.write_joint(text)
        text = self.run_program("fit", "--no-suggest", JOINT, "-o", "result").stdout
        self.assertEqual(text.count("Not fitted:"), 1)
        explained = [line for line in text.split("\n") if line.startswith("Without physics: ")]
        self.assertEqual(len(explained), len(set(explained)))
        self.assertIn("Without physics, as explained above:", text)

    def test_needs_something_to_fit(self):
        study = self.folder / MODEL1
        text = study.read_text().replace("    posts: heave\n", "    posts: heave\n    use: validation\n")
        study.write_text(text.replace("    posts: pitch\n", "    posts: pitch\n    use: validation\n"))
        self.assert_finding(self.run_program("fit", MODEL1, "-o", "result", code=3).stderr, "sines-not-fitted")

    def test_leaves_out_what_it_cannot_predict(self):
        study = self.folder / MODEL1
        drop_swept_sine(study)
        study.write_text(study.read_text().replace("    file: pitch_frf.csv\n", "    file: none.csv\n    use: validation\n"))
        answer = self.run_program("fit", "--no-suggest", MODEL1, "-o", "result")
        self.assertIn("[validation-left-out]", answer.stderr)
        self.assertEqual([one["recording"] for one in self.result()["validation_left_out"]], ["pitch"])

class Fit(FitTest):
    """One fit serves the tests of what it writes."""

    @classmethod
    def setUpClass(cls):
        cls.make_kept()
        for part in PARTS:
            shutil.copytree(SOURCE / part, cls.kept / part)
        cls.answer = cls.run_kept("fit", "--no-suggest", MODEL2, "-o", "result", "--seed", "3", "--threads", "2").stdout

    def setUp(self):
        super().setUp()
        shutil.copytree(self.kept / "result", self.folder / "result")

    def test_prints_parameters_and_errors(self):
        for part in ("m_sprung", "rms dB", "\nrecording  rms dB  rms deg  NMSE, %\nbounce "):
            self.assertIn(part, self.answer)

    def test_writes_its_result(self):
        result = self.result()
        self.assertEqual(result["termination"], "converged")
        self.assertEqual(result["seed"], 3)
        self.assertEqual(len(result["recordings"]), 2)
        self.assertEqual(result["recordings"][1]["name"], "pitch")
        self.assertGreater(result["recordings"][1]["nmse_percent"], 0)
        self.assertGreater(result["cost"], 0)
        # The search's hundred, and refinements; most of these by a quarter of the frequencies.
        self.assertGreater(result["evaluations"]["paid"], 100)
        self.assertGreater(result["evaluations"]["coarse"], 100)
        self.assertEqual(result["evaluations"]["coarse"], sum(run["coarse_evaluations"] for run in result["starts"]["runs"]))
        self.assertEqual(result["evaluations"]["failed"], 0)
        # The objective is smooth enough for every refinement to find the one optimum.
        self.assertEqual(result["starts"]["agreeing"], result["starts"]["refined"])
        self.assertIs(result["starts"]["runs"][0]["agrees"], True)
        self.assertIn("reused", result["evaluations"])
        self.assertEqual(len(result["parameters"]), 12)
        for parameter in result["parameters"]:
            self.assertGreaterEqual(parameter["value"], parameter["lower"])
            self.assertLessEqual(parameter["value"], parameter["upper"])
            self.assertIsInstance(parameter["sd"], (int, float), parameter)
            self.assertIsInstance(parameter["at_bound"], bool)
        self.assertEqual(result["parameters"][0]["unit"], "kg")
        self.assertEqual(len(result["channels"]), 11)
        self.assertIn("simbody", result["versions"])

    def test_writes_the_response(self):
        # Two recordings of 64 frequencies, 11 channels, and the header.
        self.assertEqual(self.read("result/response.csv").count("\n"), 2 * 64 * 11 + 1)
        self.assertTrue(self.read("result/response.svg").startswith("<svg"))

    def test_writes_a_vehicle_that_check_accepts(self):
        check = self.run_program("check", "result/vehicle.urdf", "--json")
        self.assertEqual(check.stderr, "")
        values = {parameter["name"]: parameter["value"] for parameter in json.loads(check.stdout)["parameters"]}
        fitted = {parameter["name"]: parameter["value"] for parameter in self.result()["parameters"]}
        self.assertEqual({name: values[name] for name in fitted}, fitted)

    def test_replaces_an_earlier_result(self):
        drop_swept_sine(self.folder / MODEL2)
        self.run_program("fit", "--no-suggest", MODEL2, "-o", "result")
        # That of the study, where the earlier one was asked for.
        self.assertEqual(self.result()["seed"], 1)


class FitOnce(FitTest):
    def setUp(self):
        super().setUp()
        for model in (MODEL1, MODEL2):
            drop_swept_sine(self.folder / model)

    def test_names_parameters_far_from_their_priors(self):
        self.replace_in(VEHICLE, 'value="1725 kg"', 'value="1725 kg" prior_sd="10 kg"')
        fit = self.run_program("fit", "--no-suggest", MODEL2, "-o", "result", "--threads", "2")
        self.assertRegex(fit.stdout, "m_sprung .* kg .* [3-9]\\.[0-9] sd from prior\n")
        self.assertIn(" for 2551 residuals, of which priors ", fit.stdout)
        mass, *others = self.result()["parameters"]
        self.assertEqual(mass["prior"]["value"], 1725)
        self.assertEqual(mass["prior"]["sd"], 10)
        self.assertLess(mass["sd_parts"]["noise"], 10)
        self.assertLessEqual(mass["sd_parts"]["model"], 10.1)
        self.assertEqual(len(others), 11)
        for parameter in others:
            self.assertNotIn("prior", parameter)
        # The fitted value is no prior.
        self.assertNotIn("prior_sd", self.read("result/vehicle.urdf"))
        self.run_program("check", "result/vehicle.urdf")

    def test_is_the_same_for_one_and_two_threads(self):
        shutil.copy(SOURCE / MODEL2, self.folder / MODEL2)
        self.replace_in(MODEL2, "    file: bounce_sweep.csv\n", "    file: bounce_sweep.csv\n    end: 10 s\n")
        one = self.run_program("fit", MODEL2, "-o", "one", "--threads", "1", "--json").stdout
        two = self.run_program("fit", MODEL2, "-o", "two", "--threads", "2", "--json").stdout
        self.assertEqual(one, two)
        self.assertEqual(one, self.read("one/result.json"))
        for name in ("vehicle.urdf", "response.csv"):
            self.assertEqual(self.read(f"one/{name}"), self.read(f"two/{name}"))

    def test_prints_profiles_of_the_parameters_asked(self):
        fit = self.run_program("fit", "--no-suggest", MODEL1, "-o", "result", "--profile", "k_front,m_front")
        self.assertIn("95 % by profile", fit.stdout)
        result = self.result()
        self.assertEqual(len(result["profiles"]), 2)
        parameters = {parameter["name"]: parameter for parameter in result["parameters"]}
        for profile in result["profiles"]:
            parameter = parameters[profile["name"]]
            # A profile sees noise alone.
            value = parameter["value"]
            reach = 1.96 * parameter["sd_parts"]["noise"] / value
            width = value * (math.exp(reach) - math.exp(-reach))
            # The model bends a little: a tenth.
            for end, expected in zip(profile["interval_95"], (math.exp(-reach), math.exp(reach)), strict=True):
                self.assertAlmostEqual(end, value * expected, delta=0.1 * width, msg=profile["name"])
        self.assertIn("k_front, kN/m", self.read("result/profile.svg"))
        self.assertIn("95 % by profile", self.read("result/report.html"))

    def test_refuses_a_profile_of_an_unknown_parameter(self):
        unknown = self.run_program("fit", MODEL1, "-o", "other", "--profile", "k_frnt", code=2)
        self.assertIn("the study frees no parameter 'k_frnt', did you mean 'k_front'?", unknown.stderr)
        self.assertFalse((self.folder / "other").exists())

    def test_does_not_overwrite_what_is_not_its_own(self):
        (self.folder / "thesis").mkdir()
        self.write("thesis/chapter1.tex", "years of work")
        outcome = self.run_program("fit", "--no-suggest", MODEL2, "-o", "thesis", code=5)
        self.assertIn("thesis", outcome.stderr)
        self.assertEqual(self.read("thesis/chapter1.tex"), "years of work")

    def test_does_not_write_over_its_inputs(self):
        outcome = self.run_program("fit", MODEL2, "-o", "studies/landrover110", code=5)
        self.assertIn("holds the input model2.yaml", outcome.stderr)


if __name__ == "__main__":
    unittest.main()
