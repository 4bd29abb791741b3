"""`fourpost response` of a vehicle file: tables and results, refusals, warnings, and frequencies without an answer."""
import json
import math
import signal
import unittest

from program import ProgramTest

CAR = "urdf/quarter_car.urdf"
LANDROVER = "urdf/landrover110_linkage.urdf"
STUDY = "studies/landrover110/model2.yaml"


class ResponseTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes")

    def respond(self, *words, code=0):
        """Each of `words` may hold several of the command line's."""
        return self.run_program("response", *" ".join(words).split(), code=code)

    def read(self, name):
        return (self.folder / name).read_text()

    def result(self, folder="result"):
        return json.loads(self.read(f"{folder}/result.json"))

    def assert_refused(self, *messages, words=CAR, code=3):
        """3: a file that cannot be used; 2: options."""
        outcome = self.respond(words, "-o result", code=code)
        for message in messages:
            self.assertIn(message, outcome.stderr)
        self.assertEqual(outcome.stdout, "")
        self.assertFalse((self.folder / "result").exists())


class OfAStudy(ResponseTest):
    def test_holds_recordings_kept_for_validation(self):
        self.copy("studies/landrover110")
        study = self.folder / "studies/landrover110/model1.yaml"
        study.write_text(study.read_text().replace("    posts: pitch\n", "    posts: pitch\n    use: validation\n"))
        text = self.respond(str(study), "--engine reduced -o result").stdout
        self.assertIn("Kept for validation:", text)
        result = self.result()
        self.assertEqual([one["name"] for one in result["recordings"]], ["bounce", "pitch"])
        # Beside those of the study's history.
        kept = [one["name"] for one in result["validation"] if one["recording"] == "pitch"]
        self.assertEqual(kept, [one["name"] for one in result["channels"]])
        self.assertIn("\npitch,", self.read("result/response.csv"))


class Response(ResponseTest):
    def test_is_a_table_and_a_folder(self):
        outcome = self.respond(CAR, "--frequencies 0.5Hz:20Hz:30 -o result")
        self.assertEqual(outcome.stderr, "results: result; open result/report.html\n")
        for part in ("heave: 30 frequencies from 0.5", "swept up, engine reduced\n",
                     "at most 12 mm, 0.15 m/s, 6 m/s^2\n", "linear kinematics are off by at most", "a_sprung",
                     "F_tyre"):
            self.assertIn(part, outcome.stdout)
        self.assertEqual(self.read("result/response.csv").count("\n"), 30 * 6 + 1)
        self.assertTrue(self.read("result/response.svg").startswith("<svg"))
        result = self.result()
        self.assertEqual(result["vehicle"], "quarter_car")
        heave = result["modes"][0]
        self.assertEqual(heave["posts"]["post"], 1)
        self.assertEqual(len(heave["channels"]), 6)
        self.assertIs(heave["linear_kinematics_error"]["visible"], False)

    def test_has_the_modes_channels_and_settings_asked_for(self):
        result = json.loads(self.respond(
            "urdf/landrover110_model3.urdf --mode roll --mode heave --channels a_cg,a_cg --frequencies 1Hz,2Hz",
            "--amplitude 3mm --set k_FL=50kN/m --direction down --engine reduced --json").stdout)
        roll, heave = result["modes"]
        self.assertEqual(roll["mode"], "roll")
        self.assertEqual(len(heave["channels"]), 1)
        self.assertEqual(heave["frequency_Hz"], [1, 2])
        self.assertEqual(heave["post_amplitude_m"], [0.003, 0.003])
        self.assertEqual(result["parameters"]["k_FL"], 50e3)
        self.assertEqual(result["direction"], "down")

    def test_shows_all_of_few_frequencies(self):
        few = self.respond(CAR, "--frequencies 1Hz,1.1Hz,1.2Hz,1.3Hz,1.4Hz,9Hz").stdout
        for column in (" 1.00 Hz", " 1.10 Hz", " 1.20 Hz", " 1.30 Hz", " 1.40 Hz", " 9.00 Hz"):
            self.assertIn(column, few)

    def test_spreads_its_columns_over_many_frequencies(self):
        many = self.respond(CAR, "--frequencies 2Hz:4Hz:50").stdout
        head = many[many.index("at Hz"):].split("\n")[0]
        self.assertIn(" 2.00 Hz", head)
        self.assertTrue(head.endswith(" 4.00 Hz"), head)
        self.assertEqual(head.count("H"), 9, head)

    def test_takes_accelerations_in_g(self):
        answer = json.loads(self.respond(CAR, "--frequencies 10Hz --acceleration 0.5g --json").stdout)
        amplitude = answer["modes"][0]["post_amplitude_m"][0]
        self.assertAlmostEqual(amplitude * (2 * math.pi * 10)**2, 0.5 * 9.80665, delta=1e-12)  # rounding

    def test_of_a_study_writes_a_folder_too(self):
        self.copy("studies/landrover110")
        self.respond(STUDY, "-o result")
        for file in ("response.csv", "response.svg", "report.html", "result.json"):
            self.assertTrue((self.folder / "result" / file).exists(), file)


class Refusal(ResponseTest):
    def test_names_all_faulty_options_at_once(self):
        self.assert_refused(
            "did you mean 'heave'?", "'5' is not a frequency", "'5mn' is not a length", "did you mean 'a_sprung'?",
            "the vehicle has no parameter 'm_sprun', did you mean 'm_sprung'?", code=2,
            words=f"{CAR} --mode heav --frequencies 5 --amplitude 5mn --channels a_spring --set m_sprun=1kg")

    def test_names_options_that_a_study_does_not_take(self):
        self.copy("studies/landrover110")
        self.assert_refused("--mode: error: ", "--amplitude: error: ", " model2.yaml ", "[option-of-vehicle]", code=2,
                            words=f"{STUDY} --mode roll --amplitude 3mm")

    def test_names_the_faults_of_the_file(self):
        self.replace_in(CAR, '<mass value="22"/>', '<mass value="-22"/>')
        self.assert_refused("must not be negative")
        self.assert_refused("nowhere.urdf", words="nowhere.urdf")

    def test_of_a_design_pose_that_nothing_holds(self):
        self.replace_in(CAR, '<linear stiffness="$k"', '<linear stiffness="$k" preload="-9 N"')
        self.assert_refused("preload")

    def test_names_the_mode_that_grows(self):
        tyre = '<fp:tyre name="front_tyre" link="front_axle" xyz="0.870 0 '
        self.replace_in(LANDROVER, f'{tyre}-0.075"', f'{tyre}-15"')
        self.assert_refused("[unstable]", words=LANDROVER)

    def test_of_more_than_the_stroke(self):
        post = '<fp:post name="post" under="tyre"'
        self.replace_in(CAR, f"{post}/>", f'{post} stroke="80 mm"/>')
        self.assert_refused("fp:post 'post' reaches 40 mm up and down, but heave at 0.5 Hz needs 50 mm",
                            words=f"{CAR} --amplitude 50mm")
        self.respond(CAR)

    def test_names_the_kind_of_a_file(self):
        self.copy("studies/landrover110")
        self.assert_refused("a vehicle file (.urdf) or a study (.yaml) [file-of-other-kind]", words="studies")
        self.assert_refused("[file-of-other-kind]", words="studies/landrover110/bounce_frf.csv")
        self.assertIn("[study-for-vehicle]", self.run_program("modes", STUDY, code=3).stderr)
        self.assertIn("[vehicle-for-study]", self.run_program("fit", CAR, "-o", "result", code=3).stderr)

    def test_of_a_folder_that_holds_its_input(self):
        self.assertRegex(self.respond(CAR, "-o urdf", code=5).stderr,
                         r"urdf: error: .* quarter_car.urdf.*\[folder-holds-input\]")

    def test_of_words_that_it_does_not_know(self):
        for options in ("--direction sideways", "--engine ful", "--frequencies", "--sweep up"):
            with self.subTest(options):
                self.respond(CAR, options, code=2)
        errors = self.respond(CAR, "--engine ful", code=2).stderr
        self.assert_finding(errors, "value-unknown", "--engine: error: ")
        self.assertIn("'full'", errors)
        errors = self.respond(CAR, "--amplitud 3mm", code=2).stderr
        self.assert_finding(errors, "argument-misspelt")
        self.assertIn("'--amplitude'", errors)
        errors = self.run_program("respons", code=2).stderr
        self.assert_finding(errors, "argument-misspelt")
        self.assertIn("'response'", errors)


class Warnings(ResponseTest):
    def test_of_friction_that_never_slides(self):
        damper = '<bilinear bump="$c_bump" rebound="$c_rebound"/>'
        self.replace_in(CAR, damper, f'{damper}<friction force="5 kN"/>')
        errors = self.respond(CAR, "--frequencies 1Hz:10Hz:5 --amplitude 1mm").stderr
        for part in ("'damper'", " heave", " 5000 N ", "[friction-holds]"):
            self.assertIn(part, errors)

    def test_of_friction_that_sticks_throughout(self):
        damper = '<bilinear bump="$c_bump" rebound="$c_rebound"/>'
        self.replace_in(CAR, damper, f'{damper}<friction force="5 kN" stiffness="200 N/mm"/>')
        errors = self.respond(CAR, "--frequencies 1Hz:10Hz:5 --amplitude 1mm").stderr
        for part in ("'damper'", " heave", " 200 kN/m", " 5000 N ", "[friction-sticks]"):
            self.assertIn(part, errors)

    def test_of_a_tyre_that_pulls(self):
        sweep = f"{CAR} --frequencies 1Hz:16Hz:5 --amplitude 15mm --velocity 2m/s --acceleration 10g --engine reduced"
        self.assertNotIn("pulls on the ground", self.respond(sweep).stderr)
        self.replace_in(CAR, 'stiffness="$kt"', 'stiffness="$kt" liftoff="false"')
        self.assertRegex(self.respond(sweep).stderr,
                         "warning: fp:tyre 'tyre' pulls on the ground in [1-4] of 5 frequencies of heave, down to "
                         "-[0-9.]+ N: remove liftoff=\"false\" or reduce the motion")

    def test_above_the_range_of_the_model(self):
        self.assertIn("warning: above 30 Hz", self.respond(CAR, "--frequencies 1Hz:60Hz:5").stderr)


class Unanswered(ResponseTest):
    def test_frequencies_are_named(self):
        outcome = self.respond(CAR, "--frequencies 0.8Hz --engine time -o none",
                               "--set c_bump=1N*s/m --set c_rebound=1N*s/m", code=4)
        for part in ("outside its bounds", "heave: no answer at 1 of 1 ", "[frequencies-unanswered]"):
            self.assertIn(part, outcome.stderr)
        self.assertIn("no answer at 0.800 Hz: heave at 0.8 Hz, 12 mm has no periodic motion within 60 s", outcome.stdout)
        self.assertIn("no periodic motion within 60 s", self.result("none")["modes"][0]["unanswered"][0]["why"])
        self.assertNotIn("nan", self.read("none/response.svg"))

    def test_frequencies_among_others_end_with_1(self):
        errors = self.respond(CAR, "--frequencies 0.8Hz:30Hz:2 --engine time",
                              "--set c_bump=20N*s/m --set c_rebound=20N*s/m", code=1).stderr
        for part in ("heave: no answer at 1 of 2 ", "[frequencies-unanswered]"):
            self.assertIn(part, errors)

    def test_frequencies_of_an_interrupted_response_are_null(self):
        program = self.start_program("response", LANDROVER, "--engine", "time", "--mode", "heave", "--mode", "pitch",
                                     "--frequencies", "1Hz:3Hz:4000", "-o", "result")
        # Progress with a rate: at least one frequency is done.
        next((line for line in program.stderr if " per " in line), None)
        program.send_signal(signal.SIGINT)
        output, errors = program.communicate()
        self.assertEqual(program.returncode, 130, errors)
        self.assertIn("[response-interrupted]", errors)
        self.assertIn("[interrupted]\n", output)
        modes = self.result()["modes"]
        self.assertEqual(len(modes), 1)
        gain = modes[0]["channels"][0]["gain"]
        self.assertIsNotNone(gain[0])
        self.assertIsNone(gain[3999])


if __name__ == "__main__":
    unittest.main()
