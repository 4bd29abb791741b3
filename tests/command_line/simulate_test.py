"""`fourpost simulate`: histories and their summary, replayed recordings, refusals and warnings."""
import csv
import json
import math
import signal
import time
import unittest

from program import SOURCE, ProgramTest

CAR = "urdf/quarter_car.urdf"
LINKAGE = "urdf/landrover110_linkage.urdf"
MODEL3 = "urdf/landrover110_model3.urdf"


class SimulateTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes")

    def simulate(self, *words, code=0):
        """Each of `words` may hold several of the command line's."""
        return self.run_program("simulate", *" ".join(words).split(), code=code)

    def simulated(self, *words):
        return json.loads(self.simulate(*words, "--json").stdout)

    def errors(self, *words, code=0):
        return self.simulate(*words, code=code).stderr

    def assert_refused(self, vehicle, options, message, code=2):
        """2: options; 3: files that cannot be used; 5: output."""
        with self.subTest(options):
            outcome = self.simulate(vehicle, options, code=code)
            self.assertIn(message, outcome.stderr)
            self.assertEqual(outcome.stdout, "")

    def read(self, name):
        return (self.folder / name).read_text()

    def columns(self, text):
        """Units by their names, and the numbers by them."""
        names, units, *rows = csv.reader(text.splitlines())
        numbers = [[float(value) for value in column] for column in zip(*rows, strict=True)]
        return dict(zip(names, units, strict=True)), dict(zip(names, numbers, strict=True))


class Simulate(SimulateTest):
    def test_writes_posts_and_channels_with_units(self):
        history = self.simulate(CAR, "--sine 2Hz --amplitude 5mm --duration 4s --rate 200Hz").stdout
        units, columns = self.columns(history)
        names = list(units)
        self.assertEqual(names[0], "time")
        self.assertEqual(units["time"], "s")
        post = names[1]
        self.assertTrue(post.startswith("post_"), post)
        self.assertEqual(units[post], "m")
        self.assertGreater(len(names), 3)
        self.assertEqual(len(columns["time"]), 801)
        self.assertEqual(columns["time"][200], 1)
        self.assertAlmostEqual(max(columns[post]), 0.005, delta=1e-5)

    def test_prints_a_summary_and_the_channels_asked_for(self):
        summary = self.simulated("--channels a_cg,s_strut_rear", LINKAGE,
                                 "--step 20mm --engine reduced -o history.csv --chart history.svg")
        self.assertEqual(summary["engine"], "reduced")
        self.assertEqual(summary["samples"], 2501)
        self.assertLessEqual(summary["integration"]["change_by_last_halving"], 1e-3)
        self.assertEqual(summary["integration"]["error_asked"], 1e-3)
        self.assertEqual(summary["motion"], "step of 20.0 mm in heave")
        channels = summary["channels"]
        self.assertEqual(len(channels), 4)
        self.assertEqual(channels[0]["name"], "post_front")
        self.assertEqual(channels[0]["peak"], 0.02)
        self.assertEqual(channels[2]["name"], "a_cg")
        self.assertEqual(channels[3]["unit"], "m")
        self.assertIn("s_strut_rear [mm]", self.read("history.svg"))
        units, _ = self.columns(self.read("history.csv"))
        self.assertEqual(list(units), ["time", "post_front", "post_rear", "a_cg", "s_strut_rear"])

    def test_answers_alike_by_both_engines(self):
        words = (LINKAGE, "--sine 1.5Hz --amplitude 4mm --duration 3s --channels a_cg,F_tyre_front --engine")
        reduced = self.simulated(*words, "condensed")
        self.assertEqual(reduced["engine"], "reduced")
        full = self.simulated(*words, "full")
        self.assertEqual(full["engine"], "full")
        self.assertLessEqual(full["integration"]["change_by_last_halving"], 1e-3)
        for one, other in zip(reduced["channels"][2:4], full["channels"][2:4], strict=True):
            # The engines' promise, 0.075 dB.
            self.assertAlmostEqual(one["rms"] / other["rms"], 1, delta=0.009)

    def test_chooses_the_engine_by_what_is_visible(self):
        """By default linear kinematics are checked: they suffice for half a millimetre, but not for 50 mm."""
        words = (LINKAGE, "--sine 1.5Hz --velocity 1m/s --acceleration 2g --duration 3s -o a.csv --amplitude")
        self.assertIn("below the visible limit (0.6 %): reduced model used", self.simulate(*words, "0.5mm").stdout)
        self.assertIn("above the visible limit (0.6 %): full geometry used", self.simulate(*words, "50mm").stdout)
        answer = self.simulated(*words, "50mm")
        self.assertEqual(answer["engine"], "full")
        self.assertGreater(answer["linear_kinematics_error"]["value"], 0.006)
        self.assertLessEqual(answer["integration"]["change_by_last_halving"], 1e-3)

    def test_replays_what_it_wrote(self):
        road = "--road B --speed 72km/h --duration 6s -o a.csv --rate"
        self.simulate(MODEL3, road, "1kHz", code=2)
        self.simulate(MODEL3, road, "1000Hz")
        self.simulate(MODEL3, "--recording a.csv --rate 1000Hz -o b.csv")
        first, second = (self.columns(self.read(name))[1]["a_body_FL"] for name in ("a.csv", "b.csv"))
        self.assertEqual(len(first), len(second))
        # Both integrations' 0.1 %, and a spline through every other of its samples.
        self.assertLess(math.dist(first, second) / math.hypot(*first), 3e-3)

    def test_draws_roads_and_noise_by_the_seed(self):
        for motion in ("--random 3mm", "--road B --speed 20m/s", "--sine 2Hz --amplitude 3mm --noise 2%"):
            with self.subTest(motion):
                words = (CAR, motion, "--duration 4s --filter 30Hz --order 4 --seed")
                one = self.simulate(*words, "1").stdout
                # The texts are too long to print.
                self.assertTrue(self.simulate(*words, "1").stdout == one)
                self.assertTrue(self.simulate(*words, "2").stdout != one)

    def test_takes_shares_of_posts_and_other_values_of_parameters(self):
        words = (MODEL3, "--sine 2Hz --duration 3s")
        plain = self.simulated(*words)["channels"]
        answer = self.simulated(*words, "--mode FL=1,RR=-0.5 --set k_FL=50kN/m")
        self.assertEqual(answer["parameters"]["k_FL"], 50e3)
        channels = answer["channels"]
        peak = channels[0]["peak"]
        self.assertEqual(peak, plain[0]["peak"])
        self.assertEqual(channels[1]["peak"], 0)
        self.assertAlmostEqual(channels[3]["peak"], 0.5 * peak, delta=1e-12 * peak)  # rounding

    def test_moves_the_posts_within_the_usual_limits(self):
        """0.15 m/s at 2 Hz: the default of `response` as well."""
        sine = self.simulated(CAR, "--sine 2Hz --duration 4s")
        # Of 500 samples a second.
        self.assertAlmostEqual(sine["channels"][0]["peak"], 0.15 / (4 * math.pi), delta=1e-4 * 0.012)
        fast = self.simulated(CAR, "--sine 10Hz --acceleration 0.5g --duration 4s --rate 2000Hz")
        self.assertAlmostEqual(fast["channels"][0]["peak"], 0.5 * 9.80665 / (20 * math.pi)**2, delta=1e-5)

    def test_writes_a_folder_where_the_name_has_no_ending(self):
        options = "--sine 2Hz --amplitude 5mm --duration 2s --rate 200Hz"
        outcome = self.simulate(CAR, options, "-o run --chart chart.svg")
        self.assertEqual(outcome.stderr, "results: run; open run/report.html\n")
        self.simulate(CAR, options, "-o history.csv")
        self.assertEqual(self.read("run/history.csv"), self.read("history.csv"))
        self.assertEqual(self.read("run/history.svg"), self.read("chart.svg"))
        self.assertEqual(json.loads(self.read("run/result.json"))["samples"], 401)
        self.assertTrue(self.read("run/report.html").startswith("<!doctype html>"))
        self.simulate(CAR, options, "-o run")
        # Results of other commands stay, and so do inputs.
        self.run_program("modes", CAR, "-o", "modes")
        self.assertIn("modes", self.errors(CAR, options, "-o modes", code=5))
        self.assertIn("simulate", self.run_program("modes", CAR, "-o", "run", code=5).stderr)
        self.errors(CAR, options, "-o urdf", code=5)

    def test_page_says_what_moves(self):
        self.simulate(CAR, "--sine 2Hz --amplitude 5mm --duration 2s --engine full", "-o run")
        page = self.read("run/report.html")
        self.assertIn("Drawn by the reduced model; the numbers and charts of this page are of the full geometry.", page)
        self.assertIn("<span>1 post</span>", page)
        self.simulate(CAR, "--sweep 1Hz:30Hz --amplitude 20mm --acceleration 5m/s^2 --duration 1000s --rate 100Hz",
                      "--engine reduced -o run")
        page = self.read("run/report.html")
        self.assertRegex(page, r"Drawn by the reduced model\. The first [0-9.]+ s of 1000 s are drawn\.")
        facts = page[page.index('<p class="facts">'):page.index("</p>", page.index('<p class="facts">'))]
        self.assertIn("m/s\u00b2", facts)

    def test_keeps_to_the_stroke_of_the_file(self):
        self.replace_in(CAR, 'under="tyre"', 'under="tyre" stroke="20 mm"')
        self.assertIn("fp:post 'post' reaches 10 mm up and down, but this motion needs 12 mm",
                      self.errors(CAR, "--sine 1Hz --amplitude 12mm", code=3))
        self.simulate(CAR, "--sine 1Hz --amplitude 8mm")

    def test_keeps_what_an_interrupted_history_has(self):
        program = self.start_program("simulate", LINKAGE, "--sine", "1Hz", "--duration", "2000s", "--engine", "full",
                                     "-o", "history.csv", "--json")
        # Some hundred samples at least, and by far not all.
        time.sleep(2)
        program.send_signal(signal.SIGINT)
        output, errors = program.communicate()
        self.assertEqual(program.returncode, 130, errors)
        self.assertIn("[history-interrupted]", errors)
        summary = json.loads(output)
        self.assertIs(summary["interrupted"], True)
        _, columns = self.columns(self.read("history.csv"))
        samples = len(columns["time"])
        self.assertEqual(samples, summary["samples"])
        self.assertGreater(samples, 100)
        self.assertLess(samples, 1000000)


class Refusal(SimulateTest):
    def test_of_usage_that_it_does_not_know(self):
        for options, message in (
                ("", "--sweep,--sine,--step,--random,--recording,--road"),
                ("--sine 2 --amplitude 5mm", "--sine: error: '2' is not a frequency: write a number with its unit"),
                ("--sine 2rad/s --amplitude 5mm", "'2rad/s' is not a frequency: write a number with its unit"),
                ("--sine 2Hz --amplitude 5N", "--amplitude: error: '5N' is not a length"),
                ("--sine 2Hz --amplitude=-5mm", "'-5mm' must be above zero"),
                ("--sweep 2Hz --amplitude 5mm", "'2Hz' is not a range of frequencies"),
                ("--sine 2Hz --amplitude 5mm --mode hevae", "did you mean 'heave'?"),
                ("--road I --speed 10m/s", "--road: error: 'I' "),
                ("--random 5mm --band 9Hz:3Hz", "from a lower frequency to a higher one"),
                ("--step 5mm --seed -1", "--seed"),
                ("--step 5mm --noise 1", "--noise: error: '1' is not a share: write it in percent"),
                ("--step 5mm --noise 500%", "'500%' must not be above 100%"),
                ("--step 5mm --chart x.png", "'x.svg' [output-ending]"),
                ("--step 5mm --duration 0.4s", "--duration: error: 0.4 s end before the step does"),
                ("--sine 2Hz --engine ful", "did you mean 'full'?"),
                ("--stepp 5mm", "did you mean '--step'?")):
            self.assert_refused(CAR, options, message)
        self.assert_refused(CAR, "--sine 2Hz --amplitude 5mm -o a.csv --chart a.csv", "name the same file", code=5)

    def test_names_all_faulty_options_at_once(self):
        outcome = self.simulate(CAR, "--mode heav --sine 5 --amplitude 5mn --channels a_spring --set m_sprun=1kg",
                                "--noise 1", code=2)
        for message in ("did you mean 'heave'?", "--sine: error: '5' is not a frequency", "'5mn' is not a length",
                        "did you mean 'a_sprung'?", "the vehicle has no parameter 'm_sprun', did you mean 'm_sprung'?",
                        "--noise: error: '1' is not a share"):
            self.assertIn(message, outcome.stderr)
        self.assertEqual(outcome.stdout, "")

    def test_of_what_the_vehicle_cannot_do(self):
        self.assert_refused(CAR, "--sine 2Hz --amplitude 5mm --mode roll", "the posts cannot make 'roll'")
        self.assert_refused(LINKAGE, "--sine 2Hz --amplitude 5mm --channels a_cgg",
                            "the vehicle has no sensor 'a_cgg', did you mean 'a_cg'?")
        self.assert_refused(LINKAGE, "--sine 1Hz --amplitude 80mm",
                            "fp:post 'front' reaches 75 mm up and down, but this motion needs 80 mm", code=3)
        self.simulate(LINKAGE, "--sine 1Hz --amplitude 80mm --stroke 200mm")
        for options, message in (
                ("--sweep 1Hz:40Hz --amplitude 1mm --rate 100Hz", "use 102.4 Hz or more [rate-too-low]"),
                ("--step 5mm --filter 300Hz", "[filter-too-high]"),
                ("--step 5mm --rate 1000000000Hz", "20000000 samples: lower --duration or --rate [history-too-long]"),
                ("--random 1mm --band 1Hz:1.01Hz --duration 0.1s", "[motion-impossible]")):
            self.assert_refused(CAR, options, message)

    def test_of_a_vehicle_without_equilibrium(self):
        self.assertIn("preload_not_balanced.urdf:",
                      self.errors(str(SOURCE / "tests/data/broken/preload_not_balanced.urdf"), "--step 5mm", code=3))

    def test_of_values_that_do_not_go_together(self):
        """A rod thicker than its piston, which the file's own is not."""
        text = (SOURCE / "tests/data/broken/hydraulic_rod_too_thick.urdf").read_text()
        self.write("corner.urdf", text)
        self.replace_in("corner.urdf", 'rod="4 cm"/>', 'rod="$rod"/>')
        self.replace_in("corner.urdf", '<fp:parameter name="k"',
                        '<fp:parameter name="rod" value="11 mm" source="estimate"/><fp:parameter name="k"')
        self.simulate("corner.urdf", "--step 1mm --duration 1s")
        self.assert_refused("corner.urdf", "--step 1mm --set rod=40mm", "[values-inconsistent]")
        for command in ("modes", "response"):
            errors = self.run_program(command, "corner.urdf", "--set", "rod=40mm", code=2).stderr
            self.assert_finding(errors, "values-inconsistent", "--set: error: ")

    def test_of_a_recording_that_it_cannot_use(self):
        self.write("posts.csv", "time,post\ns,kN\n0,1\n0.1,2\n0.2,\n0.3,1\n")
        for recording, message in (("posts.csv", "posts.csv:"), ("nowhere.csv", "nowhere.csv"),
                                   (CAR, "give a recording (.csv, .mat, ")):
            self.assert_refused(CAR, f"--recording {recording}", message, code=3)

    def test_of_output_over_its_inputs_or_into_nothing(self):
        self.assertIn("[output-is-input]", self.errors(CAR, "--step 5mm -o", CAR, code=5))
        for output in ("nowhere/history.csv", "."):
            self.simulate(CAR, "--step 5mm -o", output, code=5)


class Warnings(SimulateTest):
    def test_of_friction_that_never_slides(self):
        damper = '<bilinear bump="$c_bump" rebound="$c_rebound"/>'
        self.replace_in(CAR, damper, f'{damper}<friction force="5 kN"/>')
        for motion in ("--sine 2Hz --amplitude 1mm", "--road A --speed 5m/s --duration 4s", "--step 2mm"):
            with self.subTest(motion):
                outcome = self.simulate(CAR, motion, "--json")
                for part in ("'damper'", " 5000 N ", "[friction-holds]"):
                    self.assertIn(part, outcome.stderr)
                self.assertEqual(len(json.loads(outcome.stdout)["findings"]), 1)
        self.replace_in(CAR, 'force="5 kN"', 'force="50 N"')
        self.assertEqual(self.errors(CAR, "--sine 2Hz -o a.csv"), "")

    def test_of_a_tyre_that_pulls(self):
        """Only where the file asks for it; both engines."""
        road = (CAR, "--road D --speed 60km/h --duration 4s --json")
        engines = ("", "--engine full")
        for engine in engines:
            self.assertEqual(self.errors(*road, engine), "", engine)
        self.replace_in(CAR, 'stiffness="$kt"', 'stiffness="$kt" liftoff="false"')
        for engine in engines:
            with self.subTest(engine):
                outcome = self.simulate(*road, engine)
                self.assertRegex(outcome.stderr,
                                 "warning: fp:tyre 'tyre' pulls on the ground in [0-9]+ of 2001 samples of this "
                                 "motion, down to -[0-9.]+ N: remove liftoff=\"false\" or reduce the motion")
                self.assertEqual(len(json.loads(outcome.stdout)["findings"]), 1)
        self.assertEqual(self.errors(CAR, "--sine 2Hz --amplitude 1mm -o a.csv"), "")

    def test_above_the_range_of_the_model(self):
        self.assertIn("--sweep: warning: above 30 Hz", self.errors(CAR, "--sweep 1Hz:60Hz --duration 4s"))
        self.assertIn("--band: warning: above 30 Hz", self.errors(CAR, "--random 1mm --band 1Hz:60Hz --duration 4s"))
        self.assertEqual(self.errors(CAR, "--sweep 1Hz:30Hz --duration 4s"), "")

    def test_of_a_vehicle_that_falls_over(self):
        axle = 'link="front_axle" xyz="0.870 0 '
        self.replace_in(LINKAGE, f'{axle}-0.075" ', f'{axle}-15" ')
        self.assertIn("[unstable-in-design-pose]", self.errors(LINKAGE, "--step 1mm --duration 1s"))

    def test_of_a_recording_that_ends(self):
        self.simulate(CAR, "--step 5mm --duration 2s -o a.csv")
        errors = self.errors(CAR, "--recording a.csv --duration 3s")
        self.assert_finding(errors, "recording-ends", "--duration: warning: ")
        self.assertIn(" 2 s", errors)
        self.assertEqual(self.errors(CAR, "--recording a.csv --duration 2s"), "")


if __name__ == "__main__":
    unittest.main()
