"""The program's usage: help, refusals, `fourpost response` and `fourpost compare`, and signals."""
import json
import signal
import time
import unittest

from program import Archive, ProgramTest, drop_swept_sine

VEHICLE = "urdf/landrover110_linkage.urdf"
STUDY = "studies/landrover110/model2.yaml"
BOUNCE = "studies/landrover110/bounce_frf.csv"
GEAR_TRAIN = "studies/test_problems/gear_train.yaml"


class UsageTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes", "studies/landrover110")

    def assert_refused(self, message):
        """A fit must fail for its input, with this message, and leave nothing behind."""
        outcome = self.run_program("fit", "--no-suggest", STUDY, "-o", "result", code=3)
        self.assertIn(message, outcome.stderr)
        self.assertEqual(outcome.stdout, "")
        self.assertFalse((self.folder / "result").exists())

    def respond(self, *words):
        return json.loads(self.run_program("response", STUDY, "--json", *words).stdout)


class Usage(UsageTest):
    def test_has_help_and_a_version(self):
        self.assertIn("check", self.run_program("--help").stdout)
        self.assertIn("0.2.0", self.run_program("--version").stdout)

    def test_refuses_words_it_does_not_know(self):
        for words in ("", "fitt", "fit", "check", f"fit {STUDY}", f"fit {STUDY} -o r --threads many",
                      f"fit {STUDY} -o r --seed -1", f"fit {STUDY} -o r --seed 010", "response a.yaml --engine ful",
                      "check a.urdf --jsn", "check a.urdf --json --resolved"):
            with self.subTest(words):
                self.run_program(*words.split(), code=2)

    def test_refuses_a_missing_study(self):
        self.run_program("response", "nowhere.yaml", code=3)


class Refusal(UsageTest):
    def test_of_parameters_that_begin_outside_their_range(self):
        """By options or `start`; all of them at once."""
        words = ("fit", "--no-suggest", STUDY, "-o", "result", "--set", "m_sprung=9000kg", "--set", "k_front=1N/m")
        faults = self.run_program(*words, code=3).stderr
        for name in ("m_sprung", "k_front"):
            self.assertIn(f"error: parameter '{name}' is to be fitted, but begins outside its range: begin within it, or "
                          "widen it in the vehicle file [free-outside-range]", faults)

    def test_names_the_broken_thing(self):
        """One thing broken in the shipped data."""
        for file, right, wrong, message in (
                (VEHICLE, '<fp:tyre name="front_tyre"', '<fp:tire name="front_tyre"', "unknown tag"),
                (VEHICLE, 'stiffness="2*$k_front"', 'stifness="2*$k_front"', "did you mean 'stiffness'?"),
                (VEHICLE, 'value="1725 kg"', 'value="1725"',
                 "landrover110_linkage.urdf:88: error: value=\"1725\" of fp:parameter 'm_sprung' has no unit"),
                (VEHICLE, 'name="front_centre" link="front_axle"', 'name="front_centre" link="frontaxle"',
                 "did you mean 'front_axle'?"),
                (VEHICLE, "</robot>", '<fp:frame name="far" link="ground" xyz="0 0.5 0"/><fp:ball name="b" parent="far" '
                                      'child="front_centre"/>\n</robot>', "the loop cannot be closed"),
                (VEHICLE, '<mass value="1725"/>', '<mass value="-1725"/>', "must not be negative"),
                (STUDY, "\n  a_cg: a_cg", "\n  a_cg: a_gc", "has no channel 'a_gc', did you mean 'a_cg'?"),
                (BOUNCE, "a_body_FL,1.01946", "a_body_FL,nan", "bounce_frf.csv:2: error: "),
                (STUDY, "[0.5 Hz, 12 Hz]", "[0.1 Hz, 0.2 Hz]", "the band holds no frequency of recording 'bounce'"),
                (STUDY, "\nsearch:", "\nsaerch:", "did you mean 'search'?"),
                (STUDY, "\nsearch:", "\nband: [1 Hz, 2 Hz]\nsearch:", "[key-twice]")):
            with self.subTest(wrong):
                whole = (self.folder / file).read_bytes()
                self.replace_in(file, right, wrong)
                try:
                    self.assert_refused(message)
                finally:
                    self.write(file, whole)

    def test_names_the_faults_of_all_files_at_once(self):
        self.replace_in(VEHICLE, 'value="1725 kg"', 'value="1725"')
        self.replace_in(BOUNCE, "a_body_FL,1.01946", "a_body_FL,nan")
        self.assert_refused("bounce_frf.csv:2: error: ")
        self.assert_refused("landrover110_linkage.urdf:")

    def test_names_the_study_s_line_for_a_file_that_is_not_there(self):
        self.replace_in(STUDY, "landrover110_linkage.urdf", "landrover.urdf")
        self.assert_refused("model2.yaml:3: error: file urdf/landrover.urdf does not exist")

    def test_of_a_test_problem_sends_to_compare(self):
        self.copy("studies/test_problems")
        outcome = self.run_program("fit", GEAR_TRAIN, "-o", "result", code=3)
        self.assertIn("this is a test problem for `fourpost compare`", outcome.stderr)


class Response(UsageTest):
    def test_has_the_misfit_of_the_vehicle_as_it_is(self):
        text = self.run_program("response", STUDY).stdout
        self.assertIn("a_axle_rear", text)
        self.assertIn("\npitch ", text)
        response = self.respond()
        self.assertEqual(len(response["recordings"]), 2)
        self.assertEqual(len(response["channels"]), 11)
        first = response["recordings"][0]
        self.assertEqual(len(first["channels"][0]["gain"]), len(first["frequency_Hz"]))

    def test_comes_from_the_engine_asked_for(self):
        self.replace_in(STUDY, "[0.5 Hz, 12 Hz]", "[4 Hz, 4.15 Hz]")
        drop_swept_sine(self.folder / STUDY)
        self.replace_in(STUDY, "  - name: pitch\n    file: pitch_frf.csv\n    posts: pitch\n", "")
        linearised = self.respond()["recordings"]
        answers = {}
        for engine in ("full", "time"):
            answers[engine] = self.respond("--engine", engine)["recordings"]
            self.assertNotEqual(answers[engine], linearised, engine)
            gain, expected = (answer[0]["channels"][0]["gain"][0] for answer in (answers[engine], linearised))
            self.assertAlmostEqual(gain / expected, 1, delta=0.006, msg=engine)  # 0.05 dB
        self.assertNotEqual(answers["full"], answers["time"])

    def test_comes_from_an_engine_by_its_former_name(self):
        self.run_program("init", "car")
        self.replace_in("car/study.yaml", "band: [0.5 Hz, 20 Hz]", "band: [3 Hz, 5 Hz]")
        former, time = (self.run_program("response", "car/study.yaml", "--json", "--engine", engine)
                        for engine in ("march", "time"))
        self.assert_finding(former.stderr, "engine-former")
        self.assertEqual(former.stdout, time.stdout)
        self.assertNotEqual(former.stdout, self.run_program("response", "car/study.yaml", "--json").stdout)

    def test_names_what_keeps_time_integration_from_settling(self):
        """With dampers of a three-hundredth, pitch swings for minutes."""
        drop_swept_sine(self.folder / STUDY)
        self.replace_in(STUDY, "[0.5 Hz, 12 Hz]", "[4 Hz, 4.15 Hz]")
        for axle in ("front", "rear"):
            name = f'name="c_{axle}'
            self.replace_in(VEHICLE, f'{name}_bump" value="1500 N*s/m" lower="500', f'{name}_bump" value="5 N*s/m" lower="1')
            self.replace_in(VEHICLE, f'{name}_rebound" value="3500 N*s/m" lower="1500',
                            f'{name}_rebound" value="5 N*s/m" lower="1')
        outcome = self.run_program("response", STUDY, "--engine", "time", code=4)
        for part in ("'bounce' has no periodic response at 4.00 Hz: heave at ", " within 60 s ", "give it damping",
                     "[response-unanswered]"):
            self.assertIn(part, outcome.stderr)

    def test_warns_once_of_a_sum_with_a_member_of_opposite_sign(self):
        """Turning all members round would not correct it."""
        drop_swept_sine(self.folder / STUDY)
        self.replace_in(STUDY, "{sum: [F_tyre_FL, F_tyre_FR]}", "{sum: [F_tyre_FL, {channel: F_tyre_FR, sign: -1}]}")
        warnings = self.run_program("response", STUDY).stderr
        self.assertTrue(warnings.startswith(f"{STUDY}:25: warning: 'F_tyre_FL' and 'F_tyre_FR' of 'F_tyre_front' move "
                                            "against each other"), warnings)
        self.assertEqual(warnings.count("warning:"), 1, warnings)


class Signals(UsageTest):
    def setUp(self):
        super().setUp()
        drop_swept_sine(self.folder / STUDY)
        self.replace_in(STUDY, "  evaluations: 100\n", "  evaluations: 100000000\n  generations: 1000000\n")

    def start_search(self, *words, result):
        """A fit that is in its search, on any machine."""
        program = self.start_program("fit", *words, STUDY, "-o", result)
        archive = self.folder / result / "archive.sqlite"
        while program.poll() is None and Archive.evaluations_at_work(archive) < 25:
            time.sleep(0.001)
        return program

    def test_leave_the_best_so_far(self):
        program = self.start_search("--no-suggest", result="result")
        # Twice, as timeout(1) does with the process and its group.
        program.send_signal(signal.SIGINT)
        program.send_signal(signal.SIGINT)
        output, errors = program.communicate()
        self.assertEqual(program.returncode, 130, errors)
        for part in ("fit interrupted", "[ended-without-deviations]",
                     "stopped before any refinement ended\nsearch by dvhde stopped by the user: "):
            self.assertIn(part, output)
        result = json.loads((self.folder / "result/result.json").read_text())
        self.assertEqual(result["termination"], "interrupted")
        self.assertIsNone(result["identifiability"])
        self.assertGreater(result["residuals"], 1000)
        self.run_program("check", "result/vehicle.urdf")

    def test_are_named_where_they_end_the_program(self):
        for number, again in ((signal.SIGINT, "another Ctrl-C"), (signal.SIGTERM, "another such signal")):
            with self.subTest(number.name):
                program = self.start_search(result=f"result{int(number)}")
                program.send_signal(number)
                _, errors = program.communicate()
                self.assertEqual(program.returncode, 130, errors)
                self.assertEqual("Ctrl-C" in errors, number == signal.SIGINT, errors)
                self.assertIn(again, errors)


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("studies/test_problems")

    def compare(self, *words, code=0):
        return self.run_program("compare", *words, code=code)

    def test_counts_what_each_method_needs(self):
        words = ("studies/test_problems/oscillator.yaml", "--methods", "dvhde,gb,de_15", "--runs", "5", "--seed", "3", "--json")
        text = self.compare(*words).stdout
        methods = json.loads(text)["methods"]
        self.assertEqual(len(methods), 3)
        for method in methods:
            self.assertEqual(method["runs"], 5)
            self.assertEqual(method["successes"], 5, method["name"])
            self.assertEqual(method["evaluations_mean"], method["expected_evaluations"])
            self.assertLessEqual(method["cost_worst"], 1e-6)
        self.assertEqual(methods[2]["name"], "de_15")
        self.assertLess(methods[0]["evaluations_mean"], 50)
        for threads in (1, 4):
            self.assertEqual(self.compare(*words, "--threads", threads).stdout, text)

    def test_prints_a_table_with_intervals_and_all_settings(self):
        text = self.compare(GEAR_TRAIN, "--methods", "thesis_40,simplex", "--runs", "3").stdout
        for part in ("per success", "95 %", "thesis_40: ended by"):
            self.assertIn(part, text)
        self.assertRegex(text, "thesis_40: ended by .*algorithm de; with population 40 .*base random .*factor 0.8 "
                               ".*crossover 0.7")

    def test_measures_time_and_ends_runs_where_asked(self):
        words = (GEAR_TRAIN, "--methods", "de", "--runs", "2", "--evaluations", "60")
        method = json.loads(self.compare(*words, "--time", "--json").stdout)["methods"][0]
        self.assertGreater(method["seconds"]["mean"], 0)
        self.assertEqual(method["ends"]["evaluations used up"], 2)
        self.assertEqual(method["evaluations"]["mean"], 60)
        self.assertIn("seconds", self.compare(*words, "--time").stdout)
        self.compare(*words, "--near", "3", code=2)
        self.compare(*words, "--time", "--archive", "a.sqlite", code=2)

    def test_takes_the_study_of_a_vehicle(self):
        self.copy("urdf", "meshes", "studies/landrover110")
        answer = json.loads(self.compare(STUDY, "--methods", "gb,dvhde", "--runs", "1", "--json").stdout)
        # Without a target of its own, the best of all runs and 1 %.
        self.assertAlmostEqual(answer["target_cost"], 1.01 * 10535.5, delta=2)
        self.assertEqual(answer["methods"][0]["successes"], 1)

    def test_names_what_it_does_not_know(self):
        method = self.compare(GEAR_TRAIN, "--methods", "thesis_4", code=2)
        self.assertEqual(method.stderr,
                         "--methods: error: unknown method 'thesis_4', did you mean 'thesis_40'? [method-unknown]\n")
        self.assertEqual(method.stdout, "")
        self.assert_finding(self.compare(GEAR_TRAIN, "--methods", "de,de", code=2).stderr, "method-twice")
        self.replace_in(GEAR_TRAIN, "problem: gear_train", "problem: gear_trains")
        self.assertIn("gear_train.yaml:2: error: unknown problem 'gear_trains', did you mean 'gear_train'?",
                      self.compare(GEAR_TRAIN, code=3).stderr)


if __name__ == "__main__":
    unittest.main()
