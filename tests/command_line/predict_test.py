"""`fourpost fit` of time histories, and `fourpost predict` of these and of stepped sines."""
import csv
import json
import math
import shutil
import unittest

from program import SOURCE, ProgramTest

STATION = "urdf/single_wheel_station.urdf"
SENSORS = ("z_sprung", "z_unsprung", "a_sprung", "a_unsprung", "F_tyre")
# A station that is not as its file says.
OTHER = ("--set", "m_sprung=190kg", "--set", "c_bump=800N*s/m")
STUDY = """vehicle: urdf/single_wheel_station.urdf
histories:
  - file: sweep.csv
    posts: {ground: z_ground}
    channels: {z_sprung: z_sprung, z_unsprung: z_unsprung, a_sprung: a_sprung, F_tyre: F_tyre}
    filter: {order: 4, cutoff: 30 Hz}
free: [m_sprung, c_bump, c_rebound]
search: {evaluations: 10, starts: 1}
"""
GRAVITY = 9.80665
LANDROVER = SOURCE / "studies/landrover110"
BOUNCE, PITCH, ROLL = (LANDROVER / f"{name}_frf.csv" for name in ("bounce", "pitch", "roll"))


class StationTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.make_kept()
        for part in ("urdf", "meshes"):
            shutil.copytree(SOURCE / part, cls.kept / part)
        (cls.kept / "study.yaml").write_text(STUDY)

    def setUp(self):
        super().setUp()
        shutil.copytree(self.kept, self.folder, dirs_exist_ok=True)

    def recorded(self, *options, amplitude="10mm", velocity="0.15m/s"):
        """Columns of the station on a sweep from 1 to 20 Hz in 6 s, recorded at 500 Hz through a filter."""
        self.run_program("simulate", STATION, "--sweep", "1Hz:20Hz", "--duration", "6s", "--amplitude", amplitude,
                         "--velocity", velocity, "--acceleration", "1000m/s^2", "--rate", "500Hz", "--filter", "30Hz",
                         "--order", "4", "--engine", "reduced", "--error", "0.01%", "-o", "clean.csv", *options)
        rows = list(csv.reader((self.folder / "clean.csv").read_text().splitlines()))
        self.assertEqual(rows[0], ["time", "post_ground", *SENSORS])
        return dict(zip(("time", "z_ground", *SENSORS), ([float(x) for x in column] for column in zip(*rows[2:]))))

    def write_recording(self, name, columns):
        """With offsets, which are not in the study."""
        lines = [",".join(columns), "s,m,m,m,m/s^2,m/s^2,N"]
        for time, post, *readings in zip(*columns.values()):
            lines.append(",".join(f"{x:.9g}" for x in (time, post - 0.012, *(reading + 0.1 for reading in readings))))
        self.write(name, "\n".join(lines) + "\n")

    def read(self, name):
        return (self.folder / name).read_text()

    def result(self):
        return json.loads(self.read("run/result.json"))


class PredictHistory(StationTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        maker = cls()
        maker.folder = cls.kept
        maker.write_recording("sweep.csv", maker.recorded(*OTHER))
        maker.write_recording("other.csv", maker.recorded(*OTHER, amplitude="6mm"))
        cls.run_kept("fit", "study.yaml", "-o", "run", "--no-suggest")

    def predict(self, recording, *words, code=0):
        return self.run_program("predict", "run", "--recording", recording, *words, code=code)

    def predicted(self, recording, *words):
        return json.loads(self.predict(recording, "--json", *words).stdout)

    def fit(self, study=STUDY, code=0):
        shutil.rmtree(self.folder / "run")
        self.write("study.yaml", study)
        return self.run_program("fit", "study.yaml", "-o", "run", "--no-suggest", code=code)

    def refused(self, *words, code=3):
        outcome = self.run_program("predict", *words, code=code)
        self.assertEqual(outcome.stdout, "")
        return outcome.stderr

    def test_shows_what_a_fit_is_worth_on_a_recording_that_it_has_not_seen(self):
        fit = self.result()
        self.assertAlmostEqual(fit["parameters"][0]["value"], 190, delta=0.01)
        self.assertAlmostEqual(fit["parameters"][1]["value"], 800, delta=0.1)
        self.assertEqual(len(fit["channels"]), 4)
        self.assertEqual(fit["channels"][0]["recording"], "sweep")
        self.assertEqual(self.read("run/study.yaml"), STUDY)
        self.assertTrue(self.read("run/history.svg").startswith("<svg"))
        self.assertIn("z_sprung_measured,z_sprung_modelled", self.read("run/history.csv"))
        self.assertFalse((self.folder / "run/response.csv").exists())

        answer = self.predict("other.csv", "-o", "predicted", "--json")
        prediction = json.loads(answer.stdout)
        self.assertEqual(json.loads(self.read("predicted/result.json")), prediction)
        self.assertIs(prediction["was_fitted"], False)
        self.assertNotIn("[recording-was-fitted]", answer.stderr)
        self.assertEqual(len(prediction["channels"]), 4)
        for channel in prediction["channels"]:
            self.assertEqual(channel["recording"], "other")
            # The integration's error squared.
            self.assertLess(channel["nmse_percent"], 1e-2, channel["name"])
            self.assertGreater(channel["vaf_percent"], 99.99, channel["name"])
        # Whatever it is called.
        shutil.copy(self.folder / "sweep.csv", self.folder / "sweep_again.csv")
        seen = self.predict("sweep_again.csv", "--json")
        self.assertIs(json.loads(seen.stdout)["was_fitted"], True)
        self.assert_finding(seen.stderr, "recording-was-fitted")

    def test_warns_of_a_tyre_that_pulls(self):
        self.replace_in(STATION, 'stiffness="$kt"', 'stiffness="$kt" liftoff="false"')
        shutil.copy(self.folder / "sweep.csv", self.folder / "quiet.csv")
        self.write_recording("sweep.csv", self.recorded(velocity="1.5m/s"))
        warning = "fp:tyre 'tyre' pulls on the ground in [0-9]+ of [0-9]+ samples of 'sweep', down to -"
        self.assertRegex(self.fit().stderr, warning)
        self.assertRegex(json.dumps(self.result()["warnings"]), warning)
        answer = self.predict("sweep.csv", "--json")
        self.assertRegex(answer.stderr, warning)
        self.assertRegex(json.dumps(json.loads(answer.stdout)["warnings"]), warning)
        self.assertRegex(self.run_program("response", "study.yaml").stderr, warning)
        # A quiet one.
        shutil.copy(self.folder / "quiet.csv", self.folder / "sweep.csv")
        self.assertNotIn("pulls on the ground", self.predict("sweep.csv").stderr)

    def test_warns_of_a_channel_that_is_not_synchronised(self):
        """By 20 samples of 2 ms, on the station as its file has it."""
        columns = self.recorded()
        force = columns["F_tyre"]
        columns["F_tyre"] = force[:20] + force[:-20]
        self.write_recording("late.csv", columns)
        answer = self.predict("late.csv")
        self.assertRegex(answer.stderr, r"'F_tyre' of 'late' comes 4.*\[channel-late-of-")
        self.assertNotIn("'z_sprung' of 'late' comes", answer.stderr)
        # As a script finds it, and in the results.
        prediction = self.predicted("late.csv", "-o", "late_results")
        self.assertEqual(len(prediction["warnings"]), 1)
        warning = prediction["warnings"][0]["text"]
        self.assertIn("'F_tyre' of 'late' comes 4", warning)
        self.assertIn(warning[warning.index("'"):], answer.stderr)
        self.assertEqual(json.loads(self.read("late_results/result.json"))["warnings"], prediction["warnings"])
        self.assertEqual(self.predicted("other.csv")["warnings"], [])
        self.assertNotIn("[channel-late", self.predict("other.csv").stderr)

    def test_a_fit_compares_its_values_with_the_file_s(self):
        table = self.read("run/parameters.csv")
        self.assertTrue(table.startswith("parameter,unit,start,fitted,difference_percent,sd,lower_95,upper_95"), table)
        self.assertIn("\nm_sprung,kg,", table)

    def test_the_compromise_cost_has_no_deviations(self):
        answer = self.fit(STUDY + "cost: compromise\n").stdout
        self.assertIn("[compromise-without-deviations]", answer)
        self.assertNotIn("times what noise", answer)
        parameters = self.result()["parameters"]
        self.assertEqual(len(parameters), 3)
        for parameter in parameters:
            self.assertIsNone(parameter["sd"])
        self.assertNotIn("the data do not tell", self.read("run/report.html"))

    def test_refuses_errors_without_a_deviation(self):
        errors = self.fit(STUDY + "model_error: {history: 0 %}\n", code=3).stderr
        self.assertIn("study.yaml:3: error: 'z_sprung' of history 'sweep' has no 'noise' and no 'model_error', "
                      "so its residuals cannot be weighted", errors)

    def test_confirms_a_fit_by_the_multibody_system(self):
        answer = self.predicted("sweep.csv", "--engine", "full")
        self.assertEqual(answer["engine"], "full")
        self.assertLessEqual(answer["integration"]["change_by_last_halving"], 1e-3)
        self.assertEqual(len(answer["channels"]), 4)
        for channel in answer["channels"]:
            # Both fit to the integration's error squared.
            self.assertAlmostEqual(channel["reduced_nmse_percent"], channel["nmse_percent"], delta=2e-3)
        self.assertIn("of reduced model", self.predict("sweep.csv", "--engine", "full").stdout)

    def test_checks_linear_kinematics(self):
        """The station's wheel moves straight: there is nothing that linear kinematics leave out."""
        answer = self.predicted("sweep.csv")
        self.assertEqual(answer["engine"], "reduced")
        self.assertLess(answer["linear_kinematics_error"]["value"], 1e-5)
        self.assertNotIn("reduced_nmse_percent", answer["channels"][0])
        self.assertIn("below the visible limit (0.6 %): reduced model used", self.predict("sweep.csv").stdout)
        # By its older name too.
        reduced = self.predicted("sweep.csv", "--engine", "condensed")
        self.assertIsNone(reduced["linear_kinematics_error"])

    def test_takes_the_kalman_filter_s_noise_from_elsewhere(self):
        self.assertIn("name the recording it was fitted to by --noise-from",
                      self.refused("run", "--recording", "other.csv", "--kalman"))
        simulated = self.predicted("other.csv")["channels"]
        channels = self.predicted("other.csv", "--kalman", "--noise-from", "sweep.csv")["channels"]
        self.assertEqual(len(channels), 4)
        for channel, without in zip(channels, simulated):
            # The simulation is the same with the filter beside it.
            self.assertEqual(channel["nmse_percent"], without["nmse_percent"])
            self.assertIsInstance(channel["one_step_nmse_percent"], (int, float))
            self.assertIsInstance(channel["innovations_beyond"], (int, float))

    def test_a_fit_by_prediction_keeps_its_noise(self):
        filtered = "    filter: {order: 4, cutoff: 30 Hz}\n"
        self.assertIn(filtered, STUDY)
        self.fit(STUDY.replace(filtered, "    process: 0.5 m/s^2\n") + "cost: prediction\n")
        self.assertEqual(self.result()["kalman_noise"][0]["process_sd"][0], 0.5)
        self.predict("other.csv", "--kalman")

    def test_refuses_what_is_no_fit_or_no_recording(self):
        self.assertIn("[run-without-result]", self.refused("urdf", "--recording", "other.csv"))
        self.assertIn("none.csv", self.refused("run", "--recording", "none.csv"))
        self.assertIn("[file-of-other-kind]", self.refused("run", "--recording", "study.yaml"))
        self.assertIn("[usage]", self.refused("run", code=2))
        self.write("odd.csv", "x,z\n1,2\n")
        self.assertIn("[recording-of-other-kind]", self.refused("run", "--recording", "odd.csv"))
        self.assertIn("(time histories, with a column of times", self.refused("run", "--recording", BOUNCE))
        self.write("less.csv", "time,z_ground\ns,m\n0,0\n1,0\n2,0\n3,0\n")
        self.assertIn("[fitted-channels-missing]", self.refused("run", "--recording", "less.csv"))

    def test_says_that_a_recording_over_time_holds_its_motion_itself(self):
        answer = self.predict("other.csv", "--mode", "heave")
        self.assert_finding(answer.stderr, "mode-of-history")
        self.assertEqual(answer.stdout, self.predict("other.csv").stdout)

    def test_warns_of_a_channel_in_another_unit(self):
        text = self.read("other.csv")
        self.assertIn("m/s^2", text)
        # A thousandth of what it should be.
        self.write("other.csv", text.replace("m/s^2", "mm/s^2", 1))
        self.assertRegex(self.predict("other.csv").stderr,
                         r"'a_sprung' of 'other' and the model differ by a factor of 1.*\[channel-unit-")

    def test_a_fit_takes_static_loads_beside_histories(self):
        """Loads at rest beside recordings over time, and no frequency response."""
        self.write("static.csv", "quantity,unit,value,sd\nload,N,2040,20\n")
        self.assertIn("static load", self.fit(STUDY + "static_loads: {file: static.csv, tyres: {tyre: load}}\n").stdout)


def delayed(signal, samples):
    return [signal[0]] * samples + signal[:-samples]


class FaultyRecording(StationTest):
    """Fits of a recording with one fault; the station is as its file has it where a test does not change it."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        maker = cls()
        maker.folder = cls.kept
        cls.good = maker.recorded()

    def warnings_of(self, code=1, **faults):
        """All that a fit warns of, whose columns `faults` differ. Code 1: the model does not explain its data."""
        self.write_recording("sweep.csv", self.good | faults)
        return self.warnings(code)

    def warnings(self, code):
        """Id first; each is in the results once."""
        outcome = self.run_program("fit", "--no-suggest", "study.yaml", "-o", "run", code=code)
        page = self.read("run/report.html")
        warnings = []
        for item in self.result()["warnings"]:
            text, name = item["text"], f"[{item['id']}]"
            self.assertIn(f"{text[text.index(': ') + 2:]} {name}", outcome.stderr)
            # Up to the first sign that HTML writes otherwise.
            self.assertIn(text.split("'")[0], page)
            self.assertNotIn(f"{name} {text}", warnings)
            warnings.append(f"{name} {text}")
        self.assertNotIn("[channel-", outcome.stdout)
        return warnings

    def assert_one(self, warnings, start, *parts):
        """One of the warnings begins so and has these parts."""
        self.assertTrue(any(one.startswith(start) and all(part in one for part in parts) for one in warnings), warnings)

    def test_a_good_one_has_no_warning(self):
        self.assertEqual(self.warnings_of(code=0), [])

    def test_the_late_channel_alone_is_accused(self):
        """The fit meets the late channel half-way; the healthy ones are not accused."""
        warnings = self.warnings_of(F_tyre=delayed(self.good["F_tyre"], 10))
        self.assertEqual(len(warnings), 1, warnings)
        self.assert_one(warnings, "[channel-late-of-others] study.yaml:5: 'F_tyre' of 'sweep' comes 20",
                        "% with 'F_tyre: {channel: F_tyre, delay: 20")

    def test_a_late_height_is_named(self):
        """The fit hides it by its parameters; the second derivative does not."""
        warnings = self.warnings_of(code=0, z_sprung=delayed(self.good["z_sprung"], 10))
        self.assertEqual(len(warnings), 1, warnings)
        self.assert_one(warnings,
                        "[channel-late-of-point] study.yaml:5: 'z_sprung' of 'sweep' comes 20 ms later than 'a_sprung'",
                        "'z_sprung: {channel: z_sprung, delay: 20 ms}' in the study")

    def test_a_late_post_is_named(self):
        """The values of the file have not been adapted to it."""
        self.replace_in(STATION, 'value="1010 N*s/m"', 'value="900 N*s/m"')
        self.replace_in(STATION, 'value="15.01 kN/m"', 'value="16 kN/m"')
        warnings = self.warnings_of(z_ground=delayed(self.good["z_ground"], 10))
        self.assertEqual(len(warnings), 1, warnings)
        self.assert_one(warnings, "[posts-not-synchronised] study.yaml:4: ", " ms earlier", "channels of its 'posts'")
        # To what values of the file that are off by some per cent make of it.
        self.assertRegex(warnings[0], "add 'delay: (19|20|21)")

    def test_swapped_channels_are_named(self):
        self.replace_in("study.yaml", "z_sprung: z_sprung, z_unsprung: z_unsprung", "z_sprung: z_unsprung, z_unsprung: z_sprung")
        self.write_recording("sweep.csv", self.recorded(*OTHER))
        warnings = self.warnings(code=1)
        self.assertEqual(len(warnings), 2, warnings)
        for warning, name in zip(warnings, ("z_sprung", "z_unsprung")):
            self.assert_one([warning], "[history-channels-swapped", f": '{name}' of 'sweep'")

    def test_a_wrong_sign_is_named(self):
        self.assert_one(self.warnings_of(F_tyre=[-force for force in self.good["F_tyre"]]),
                        "[channel-inverted] study.yaml:5: 'F_tyre' of 'sweep' ",
                        "% with 'F_tyre: {channel: F_tyre, sign: -1}' in the study")

    def test_a_wrong_unit_is_named(self):
        self.assert_one(self.warnings_of(a_sprung=[a / GRAVITY for a in self.good["a_sprung"]]),
                        "[channel-unit-mistaken] study.yaml:5: 'a_sprung' of 'sweep' ", " in g instead of m/s^2",
                        "% with 'a_sprung: {channel: a_sprung, unit: g}' in the study")


def turned(text, channel):
    """A table with the phases of a channel half a turn off."""
    rows = list(csv.reader(text.splitlines()))
    name, phase = rows[0].index("channel"), rows[0].index("phase_deg")
    for row in rows[1:]:
        if row[name] == channel:
            row[phase] = f"{float(row[phase]) + 180:.6f}"
    return "".join(",".join(row) + "\n" for row in rows)


class PredictResponse(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """The fit of the planar car to bounce alone."""
        cls.make_kept()
        for part in ("urdf", "meshes", "studies/landrover110"):
            shutil.copytree(SOURCE / part, cls.kept / part)
        study = cls.kept / "studies/landrover110/model1.yaml"
        text, pitch = study.read_text(), "  - name: pitch\n    file: pitch_frf.csv\n    posts: pitch\n"
        if text.count(pitch) != 1:
            raise AssertionError("the study's pitch is written otherwise")
        study.write_text(text.replace(pitch, ""))
        cls.run_kept("fit", "--no-suggest", study, "-o", "run")

    def predict(self, recording, *words, code=0):
        return self.run_program("predict", self.kept / "run", "--recording", recording, *words, code=code)

    def bounce(self, *words, code=0):
        return self.predict(BOUNCE, "--mode", "heave", *words, code=code)

    def peak(self, channel, file):
        """Frequency of the largest modelled gain below the wheels' hop [Hz]."""
        with open(self.folder / file, newline="") as table:
            rows = [(float(row["gain_modelled"]), float(row["frequency_Hz"])) for row in csv.DictReader(table)
                    if row["channel"] == channel]
        return max(row for row in rows if row[1] <= 4)[1]

    def test_shows_what_a_fit_is_worth_on_a_pattern_that_it_has_not_seen(self):
        outcome = self.predict(PITCH, "--json", "-o", "prediction")
        self.assertIn("posts: pitch, which fits best", outcome.stderr)
        answer = json.loads(outcome.stdout)
        self.assertEqual(answer["posts"], "pitch")
        self.assertEqual(len(answer["channels"]), 11)
        for channel in answer["channels"]:
            self.assertIsInstance(channel["rms_dB"], (int, float))
            self.assertIsInstance(channel["rms_deg"], (int, float))
            self.assertAlmostEqual(channel["nmse_percent"] + channel["vaf_percent"], 100, delta=1e-9)
        self.assertTrue((self.folder / "prediction/response.svg").exists())
        # Stated, the pattern is not guessed.
        stated = self.predict(PITCH, "--mode", "pitch", "--json")
        self.assertEqual(stated.stdout, outcome.stdout)
        self.assertEqual(stated.stderr, "")

    def test_warns_of_a_wrong_pattern_and_of_a_wrong_sign(self):
        wrong = self.predict(PITCH, "--mode", "heave").stderr
        self.assertIn("'pitch_frf' move as heave (front 1, rear 1)", wrong)
        self.assertIn("[posts-move-otherwise]", wrong)
        self.assertIn("look like pitch (front 1, rear -1)", wrong)
        self.write("turned.csv", turned(PITCH.read_text(), "a_tow_point"))
        opposite = self.predict("turned.csv", "--mode", "pitch").stderr
        self.assertRegex(opposite, r"'a_tow_point' .*\[sign-opposite\]")
        self.assertNotIn("[posts-move-otherwise]", opposite)
        seen = self.bounce("--json")
        self.assert_finding(seen.stderr, "recording-was-fitted")
        self.assertIs(json.loads(seen.stdout)["was_fitted"], True)

    def test_leaves_out_what_was_not_measured(self):
        lines = PITCH.read_text().splitlines(keepends=True)
        kept = [line for line in lines if "a_body_FL" not in line]
        self.assertLess(len(kept), len(lines))
        self.write("less.csv", "".join(kept))
        outcome = self.predict("less.csv", "--mode", "pitch", "--json")
        self.assertRegex(outcome.stderr, r"less.csv: warning: .* a_body_front.*\[sensors-not-measured\]")
        self.assertEqual(len(json.loads(outcome.stdout)["channels"]), 10)
        self.write("none.csv", "frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n1,0.01,a_other,1,0\n")
        self.assertRegex(self.predict("none.csv", code=3).stderr, r"none.csv: error: .*\[fitted-channels-missing\]")

    def test_a_pattern_that_a_planar_car_cannot_make_is_not_guessed(self):
        self.assertIn("no pattern that the posts of landrover110_model1 can make", self.predict(ROLL, code=3).stderr)

    def test_takes_a_load(self):
        load = ("--add-mass", "250 kg", "--at")
        self.assertNotEqual(self.bounce(*load, "-2.5,0,0.9").stdout, self.bounce().stdout)
        # At the bounce frequency of the loaded car, sqrt(m / (m + 250 kg)) of the empty one's, its body moves more.
        empty = json.loads(self.bounce("--json", "-o", "empty").stdout)
        heavy = json.loads(self.bounce(*load, "-1.4,0,0.9", "--json", "-o", "heavy").stdout)
        self.assertEqual(len(empty["channels"]), len(heavy["channels"]))
        ratio = self.peak("a_cg", "heavy/response.csv") / self.peak("a_cg", "empty/response.csv")
        self.assertAlmostEqual(ratio, math.sqrt(1803 / 2053), delta=0.03)  # the grid's spacing

    def test_shows_what_the_load_does_to_the_posts(self):
        load = ("--add-mass", "250 kg", "--at")
        added = json.loads(self.bounce(*load, "-1397 mm, 0,90 cm", "--json").stdout)["added_load"]
        self.assertEqual(added["mass_kg"], 250)
        self.assertEqual(added["place_m"], [-1.397, 0, 0.9])
        self.assertEqual(added["body"], "chassis")
        self.assertEqual(len(added["static_loads"]), 2)
        for post in added["static_loads"]:
            # In the middle of the wheelbase, 2.794 m.
            self.assertAlmostEqual(post["with_N"] - post["without_N"], 125 * GRAVITY, delta=1e-6)  # rounding
        answer = self.bounce(*load, "-1.397,0,0.9")
        self.assertTrue(answer.stdout.startswith("added: 250 kg at -1.4, 0, 0.9 m (x, y, z) on 'chassis'\n"
                                                 "load at rest  without, N  with, N\nfront "), answer.stdout)
        self.assertNotIn("--at", answer.stderr)
        # Beside the plane of a car that has no sides.
        beside = self.bounce(*load, "-1.397,0.4,0.9").stderr
        for part in ("--at: warning: ", "landrover110_model1", " 0.4 m ", " 0 m: ", "[load-without-roll]"):
            self.assertIn(part, beside)

    def test_refuses_loads_that_cannot_be(self):
        def refused(mass, place):
            return self.bounce("--add-mass", mass, "--at", place, code=2).stderr
        self.assertIn("--add-mass: error: '250 N' is not a mass", refused("250 N", "-2.5,0"))
        for place in ("-2.5,0", "-2.5,0,0.9,1", "-2.5 kg,0,0.9", "-2.5,,0.9"):
            self.assertIn("[load-place-unreadable]", refused("250 kg", place))
        outside = refused("250 kg", "-1200,0,900")
        for part in ("[load-far-outside]", "--at: error: -1200, 0, 900 m ", " x from -3.62 to "):
            self.assertIn(part, outside)
        tips = refused("20 t", "1,0,0.9")
        for part in ("[load-tips-car]", ": rear -"):
            self.assertIn(part, tips)

    def test_names_a_result_that_is_no_recording_and_what_has_no_use(self):
        errors = self.predict(self.kept / "run/response.csv", code=3).stderr
        self.assertRegex(errors, r"response.csv:1: error: .*\[comparison-as-recording\]")
        self.assertEqual(errors.count("\n"), 1)
        self.assertIn("is a frequency response", self.predict(PITCH, "--kalman", code=2).stderr)


class Release(ProgramTest):
    """A linear quarter car that is let go, integrated by Runge and Kutta's rule, without noise."""

    def drop(self, name, held_m, start_s=0.0):
        mass, unsprung, k, kt, c = 200.0, 22.0, 15e3, 230e3, 1500.0

        def slopes(state):
            z, y, v, u = state
            force = k * (z - y) + c * (v - u)
            return v, u, -force / mass, (force - kt * y) / unsprung
        state, step, rows = (held_m, k * held_m / (k + kt), 0.0, 0.0), 5e-4, []
        rows += [f"{i * 2e-3:.4f},{held_m:.9g},0" for i in range(round(start_s / 2e-3))]
        for i in range(3000):
            if i % 4 == 0:
                rows.append(f"{start_s + i * step:.4f},{state[0]:.9g},{slopes(state)[2]:.9g}")
            parts = []
            for share in (0, 0.5, 0.5, 1):
                parts.append(slopes([s + share * step * (parts[-1][j] if parts else 0) for j, s in enumerate(state)]))
            state = [s + step / 6 * (a + 2 * b + 2 * d + e) for s, a, b, d, e in zip(state, *parts)]
        self.write(name, "time,z_sprung,a_sprung\ns,m,m/s^2\n" + "\n".join(rows) + "\n")

    def test_predicts_a_drop_from_another_height(self):
        self.drop("low.csv", 0.02)
        self.drop("high.csv", 0.03, start_s=0.4)
        self.write("study.yaml", f"vehicle: {SOURCE}/urdf/quarter_car.urdf\nfree: [c_bump, c_rebound]\nhistories:\n"
                   "  - file: low.csv\n    release: {z_sprung: 20 mm}\n"
                   "    channels: {z_sprung: z_sprung, a_sprung: a_sprung}\nsearch: {evaluations: 10, starts: 1}\n")
        self.run_program("fit", "study.yaml", "-o", "run")

        def nmse(*options):
            answer = self.run_program("predict", "run", "--recording", "high.csv", "--start", "0.4s", "--json", *options)
            return json.loads(answer.stdout)["channels"][0]["nmse_percent"], answer.stderr
        right, silent = nmse("--release", "z_sprung=30 mm")
        self.assertNotIn("[release-of-study]", silent)
        # The rounding of nine digits and the integration's error of 1e-3, squared.
        self.assertLess(right, 1e-3)
        self.assertLess(nmse("--release", "at rest")[0], 1e-3)
        # From 20 mm a linear car moves by two thirds: a ninth of the variance is missed.
        wrong, warnings = nmse()
        self.assertIn("[release-of-study]", warnings)
        self.assertAlmostEqual(wrong, 100 / 9, delta=0.5)

    def test_is_refused_where_nothing_is_let_go(self):
        self.drop("low.csv", 0.02)
        self.write("study.yaml", f"vehicle: {SOURCE}/urdf/quarter_car.urdf\nfree: [c_bump, c_rebound]\nhistories:\n"
                   "  - file: low.csv\n    release: at rest\n    channels: {z_sprung: z_sprung}\n"
                   "search: {evaluations: 5, starts: 1}\n")
        self.run_program("fit", "study.yaml", "-o", "run")
        words = ["predict", "run", "--recording", "low.csv"]
        self.assertIn("[release-option]", self.run_program(*words, "--release", "z_sprung=50", code=2).stderr)
        self.assertIn("[option-quantity]", self.run_program(*words, "--start", "3N", code=2).stderr)



if __name__ == "__main__":
    unittest.main()
