"""Time histories made into frequency responses, by the command and by a study."""
import json
import math
import shutil
import unittest

from program import SOURCE, ProgramTest, dwells

RATE = 200
STUDY = """vehicle: car.urdf
recordings:
  - {{{recording}}}
channels: {{a_body: a_body, s_strut: s_strut}}
band: [1 Hz, 10 Hz]
"""


class Frf(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("meshes")
        text = (SOURCE / "studies/starter/vehicle.urdf").read_text()
        self.write("car.urdf", text)
        rows = "".join(f"{k / RATE:.4f},{z:.9g}\n" for k, z in enumerate(dwells([2, 3, 5, 8], RATE)))
        self.write("heights.csv", "time,post\ns,m\n" + rows)
        self.run_program("simulate", "car.urdf", "--recording", "heights.csv", "--rate", f"{RATE}Hz", "--noise", "0.1%",
                         "--engine", "reduced", "-o", "dwells.csv")

    def respond(self, recording):
        self.write("study.yaml", STUDY.format(recording=recording))
        return json.loads(self.run_program("response", "study.yaml", "--engine", "reduced", "--json").stdout)

    def test_is_what_a_study_makes_of_the_same_file(self):
        self.run_program("frf", "dwells.csv", "-o", "frf")
        files = {file.name for file in (self.folder / "frf").iterdir()}
        self.assertEqual(files, {"heave.csv", "heave.uff", "heave.svg", "recordings.yaml", "frf.json"})
        table = self.respond("file: frf/heave.csv, posts: heave")
        history = self.respond("file: dwells.csv, posts: heave")
        for one, other in zip(table["channels"], history["channels"], strict=True):
            # A table has ten digits.
            self.assertAlmostEqual(one["rms_dB"], other["rms_dB"], 7)
            # The vehicle is the one that was simulated: noise of 0.1 % and what is left of the run-in.
            self.assertLess(other["rms_dB"], 0.05, other)
            self.assertLess(other["rms_deg"], 0.3, other)

    def test_is_a_universal_file_too(self):
        self.run_program("frf", "dwells.csv", "-o", "frf")
        table = self.respond("file: frf/heave.csv, posts: heave")
        functions = self.respond("file: frf/heave.uff, posts: heave, amplitude: 2 mm")
        for one, other in zip(table["channels"], functions["channels"], strict=True):
            # It has no deviations to weight by, and one amplitude for all; this car's springs are linear.
            self.assertAlmostEqual(one["rms_dB"], other["rms_dB"], 2)

    def test_is_predicted_by_a_vehicle_that_was_fitted_to_such(self):
        self.write("study.yaml", STUDY.format(recording="file: dwells.csv, posts: heave") + "free: [k]\n")
        self.run_program("fit", "study.yaml", "-o", "run")
        self.run_program("simulate", "car.urdf", "--recording", "heights.csv", "--rate", f"{RATE}Hz", "--noise", "0.1%",
                         "--seed", "2", "--engine", "reduced", "-o", "again.csv")
        outcome = self.run_program("predict", "run", "--recording", "again.csv", "--json")
        self.assertEqual(json.loads(outcome.stdout)["posts"], "post=1")
        for channel in json.loads(outcome.stdout)["channels"]:
            # The vehicle is the one that was simulated.
            self.assertLess(channel["nmse_percent"], 0.1)
        self.assertNotIn("recording-was-fitted", outcome.stderr)

    def test_predicts_whatever_the_column_of_times_is_called(self):
        """As in the recordings of the fit, or as usual."""
        names, *rest = (self.folder / "dwells.csv").read_text().split("\n")
        self.assertIn("time", names.split(","))
        self.write("zeit.csv", "\n".join([",".join("Zeit" if name == "time" else name for name in names.split(",")), *rest]))
        self.write("study.yaml", STUDY.format(recording="file: zeit.csv, posts: heave, time: Zeit") + "free: [k]\n")
        self.run_program("fit", "study.yaml", "-o", "run")
        for recording in ("zeit.csv", "dwells.csv"):
            outcome = self.run_program("predict", "run", "--recording", recording, "--json")
            for channel in json.loads(outcome.stdout)["channels"]:
                self.assertLess(channel["nmse_percent"], 0.1)
        self.write("other.csv", (self.folder / "zeit.csv").read_text().replace("Zeit", "Uhr"))
        output = self.run_program("predict", "run", "--recording", "other.csv", code=3).stderr
        self.assertIn("one of times, named as in the recordings of the fit", output)

    def test_has_the_ends_of_a_band_although_frequencies_are_measured(self):
        measured = json.loads(self.run_program("frf", "dwells.csv", "--json").stdout)["responses"][0]["frequency_Hz"]
        self.assertNotEqual((measured[0], measured[-1]), (2, 8))
        self.write("study.yaml", STUDY.format(recording="file: dwells.csv, posts: heave").replace("[1 Hz, 10 Hz]", "[2 Hz, 8 Hz]"))
        answer = json.loads(self.run_program("response", "study.yaml", "--engine", "reduced", "--json").stdout)
        self.assertEqual(len(answer["recordings"][0]["frequency_Hz"]), 4)

    def test_says_what_was_perhaps_forgotten(self):
        rows = (self.folder / "dwells.csv").read_text().splitlines()
        height = rows[0].split(",").index("post_post")
        more = ["left,oil", "m,foo"] + [row.split(",")[height] + ",1.5" for row in rows[2:]]
        self.write("more.csv", "\n".join(f"{row},{added}" for row, added in zip(rows, more)) + "\n")
        warnings = self.run_program("frf", "more.csv", "--post", "post_post=FL").stderr
        self.assert_finding(warnings, "response-like-post")
        self.assert_finding(warnings, "response-unit-unknown")
        self.assertIn("'oil' (foo)", warnings)
        warnings = self.run_program("frf", "dwells.csv").stderr
        self.assertNotIn("response-", warnings)

    def test_of_random_motion_has_h1_h2_and_hv(self):
        self.run_program("simulate", "car.urdf", "--random", "4mm", "--duration", "100s", "--noise", "5%", "-o", "random.csv")
        channel = json.loads(self.run_program("frf", "random.csv", "--json").stdout)["responses"][0]["channels"][0]
        for h1, h2, hv, coherence in zip(channel["gain"], channel["gain_h2"], channel["gain_hv"], channel["coherence"]):
            # H1 = Sxy/Sxx, H2 = Syy/Syx, so that coherence is their ratio.
            self.assertAlmostEqual(h1 / h2, coherence, 12)
            self.assertAlmostEqual(hv * hv, h1 * h2, 9 * (h1 * h2 < 1) or 6)
            self.assertLess(coherence, 1)

    def test_bounce_is_heave(self):
        heave = self.respond("file: dwells.csv, posts: heave")
        self.assertEqual(self.respond("file: dwells.csv, posts: bounce"), heave)
        one, other = (self.run_program("response", "car.urdf", "--mode", mode).stdout.replace("bounce", "heave")
                      for mode in ("heave", "bounce"))
        self.assertEqual(one, other)

    def test_of_a_study_names_what_contradicts_it(self):
        for recording, finding in (("file: dwells.csv, posts: {post: 0.5, x: 1}", "sine-post-unknown"),
                                   ("file: dwells.csv, posts: heave, repeats: 3", "sine-repeats-counted"),
                                   ("file: dwells.csv, posts: heave, post_channels: {post: nothing}",
                                    "response-post-missing"),
                                   ("file: dwells.csv, posts: heave, post_channels: 3", "sine-post-channels"),
                                   ("file: dwells.csv, posts: heave, post_channels: {FL: post_post, FR: s_strut}",
                                    "sine-posts-unmapped")):
            with self.subTest(recording):
                self.write("study.yaml", STUDY.format(recording=recording))
                self.assert_finding(self.run_program("response", "study.yaml", code=3).stderr, finding)

    def test_of_a_study_prepares_channels_as_histories_do(self):
        rows = [row.split(",") for row in (self.folder / "dwells.csv").read_text().splitlines()]
        column = {name: [float(row[k]) for row in rows[2:]] for k, name in enumerate(rows[0])}
        times = [k / RATE for k in range(len(rows) - 2)]
        # The post is recorded 4 samples late, in mm without a unit, with an offset; the acceleration drifts; the strut
        # is in another file, whose clock is 0.12 s ahead.
        late = [column["post_post"][max(0, k - 4)] for k in range(len(times))]
        self.write("main.csv", "T,stroke,acc\ns,,g\n" + "".join(
            f"{t:.4f},{1e3 * z + 7:.8g},{a / 9.80665 + 0.3 + 0.02 * t:.9g}\n"
            for t, z, a in zip(times, late, column["a_body"])))
        self.write("beside.csv", "time,pot\ns,mm\n" + "".join(
            f"{t + 0.12:.4f},{1e3 * s:.8g}\n" for t, s in zip(times, column["s_strut"])))
        recording = ("file: main.csv, posts: heave, time: T, start: 1 s, end: 17.9 s, with: [{file: beside.csv, delay: 120 ms}], "
                     "post_channels: {post: {channel: stroke, unit: mm, offset: 7 mm, delay: 20 ms}}")
        study = STUDY.format(recording=recording).replace(
            "{a_body: a_body, s_strut: s_strut}", "{a_body: {channel: acc, trend: remove, high_pass: 0.3 Hz}, s_strut: pot}")
        self.write("study.yaml", study)
        answer = json.loads(self.run_program("response", "study.yaml", "--engine", "reduced", "--json").stdout)
        for channel in answer["channels"]:
            # As of the file itself; a delay is taken back by a spline, which loses little at 25 samples a period.
            self.assertLess(channel["rms_dB"], 0.05, channel)
            self.assertLess(channel["rms_deg"], 0.3, channel)
        for wrong, finding in ((study.replace("end: 17.9 s", "end: 0.5 s"), "sine-window-empty"),
                               (study.replace("start: 1 s, end: 17.9 s", "start: 90 s"), "response-window-empty"),
                               (study.replace("with: [{file: beside.csv, delay: 120 ms}]", "with: 3"), "history-with")):
            self.write("study.yaml", wrong)
            self.assert_finding(self.run_program("response", "study.yaml", code=3).stderr, finding)
        self.run_program("frf", "dwells.csv", "-o", "frf")
        table = STUDY.format(recording="file: frf/heave.csv, posts: heave")
        for wrong, finding in ((table.replace("posts: heave", "posts: heave, start: 1 s"), "sine-keys-of-history"),
                               (table.replace("a_body: a_body", "a_body: {channel: a_body, trend: remove}"),
                                "sine-channel-of-history")):
            self.write("study.yaml", wrong)
            self.assert_finding(self.run_program("response", "study.yaml", code=3).stderr, finding)

    def test_of_a_study_in_another_unit_is_an_error_with_the_line_to_write(self):
        text = (self.folder / "dwells.csv").read_text()
        names, units, *rows = [row.split(",") for row in text.splitlines()]

        def scaled(channel):
            """The file with one channel in mm, called m."""
            k = names.index(channel)
            return "\n".join(",".join(row) for row in [names, units] + [
                row[:k] + [f"{1e3 * float(row[k]):.9g}"] + row[k + 1:] for row in rows]) + "\n"

        recording = STUDY.format(recording="file: wrong.csv, posts: heave, post_channels: {post: post_post}") + "free: [k]\n"
        history = "vehicle: car.urdf\nhistories:\n  - file: wrong.csv\nchannels: {a_body: a_body, s_strut: s_strut}\nfree: [k]\n"
        for channel, study, finding, line in (
                ("post_post", recording, "rig-amplitude", "post_channels: {post: {channel: post_post, unit: mm}}"),
                ("s_strut", recording, "sine-thousandfold", "s_strut: {channel: s_strut, unit: mm}"),
                ("post_post", history, "posts-unit-mistaken", "posts: {post: {channel: post_post, unit: mm}}"),
                ("s_strut", history, "channel-thousandfold", "s_strut: {channel: s_strut, unit: mm}")):
            with self.subTest(finding):
                self.write("wrong.csv", scaled(channel))
                self.write("study.yaml", study)
                refused = self.run_program("fit", "study.yaml", "-o", "run", code=3).stderr
                self.assert_finding(refused, finding)
                self.assertIn(f"write '{line}'", refused)
                # One cause, one error beside the sentence that ends the fit.
                self.assertEqual(refused.count(": error: "), 2, refused)
                key = line.split(":")[0]
                corrected = study.replace("    post_channels: {post: post_post}", "")
                corrected = corrected.replace("post_channels: {post: post_post}", line) if key == "post_channels" else (
                    corrected.replace("s_strut: s_strut", line) if key == "s_strut" else
                    corrected.replace("wrong.csv\n", f"wrong.csv\n    {line}\n"))
                self.write("study.yaml", corrected)
                self.run_program("fit", "study.yaml", "-o", "good", "--no-suggest")
        self.write("study.yaml", history)
        for text in (history, recording):
            # The channel alone, and beside one that its error makes quiet.
            self.write("study.yaml", text)
            accepted = self.run_program("fit", "study.yaml", "-o", "run", "--accept-implausible", "--no-suggest", "--json",
                                        code=1)
            self.assertIn("-thousandfold]", accepted.stderr)
            result = json.loads(accepted.stdout)
            self.assertFalse(result["verdict"]["explains_data"])
            self.assertIn("-thousandfold", result["verdict"]["accepted"][0]["id"])
            self.assertIn("implausible-accepted", [entry["id"] for entry in result["conclusions"]])
            self.assertIn("Implausible values were accepted", (self.folder / "run/report.html").read_text())

    def split(self, ahead_s):
        """The recording of two devices: the second, at half the rate, has the strut and a clock that is ahead."""
        names, units, *rows = [row.split(",") for row in (self.folder / "dwells.csv").read_text().splitlines()]
        strut = names.index("s_strut")
        keep = [k for k in range(len(names)) if k != strut]
        self.write("main.csv", "\n".join(",".join(row[k] for k in keep) for row in [names, units, *rows]) + "\n")
        self.write("pots.csv", "time,s_strut\ns,m\n" + "".join(
            f"{float(row[0]) + ahead_s:.6f},{row[strut]}\n" for row in rows[::2]))

    def test_joins_devices_whose_clocks_differ(self):
        self.split(0.003)
        study = STUDY.format(recording="file: main.csv, posts: heave, with: [{file: pots.csv{DELAY}}]")
        errors = {}
        for delay in ("", ", delay: 3 ms"):
            self.write("study.yaml", study.replace("{file: pots.csv{DELAY}", "{file: pots.csv" + delay))
            answer = json.loads(self.run_program("response", "study.yaml", "--engine", "reduced", "--json").stdout)
            errors[delay] = {channel["name"]: channel["rms_deg"] for channel in answer["channels"]}["s_strut"]
        # 3 ms are 8.6 degrees at 8 Hz; beside it noise of 0.1 %.
        self.assertGreater(errors[""], 3)
        self.assertLess(errors[", delay: 3 ms"], 0.3)
        # By the command.
        phases = {}
        for other in ("pots.csv", "pots.csv=3ms"):
            frf = json.loads(self.run_program("frf", "main.csv", "--with", other, "--json").stdout)
            response = frf["responses"][0]
            phases[other] = {c["name"]: c for c in response["channels"]}["s_strut"]["phase_deg"]
            self.assertEqual(frf["preparation"], ["with pots.csv" + (", 3 ms ahead" if "=" in other else "")])
        for frequency, late, right in zip(response["frequency_Hz"], *phases.values()):
            self.assertAlmostEqual((right - late + 180) % 360 - 180, 360 * frequency * 0.003, delta=0.3)
        self.assert_finding(self.run_program("frf", "main.csv", "--with", "pots.csv=3mm", code=2).stderr, "option-quantity")

    def test_file_beside_may_have_an_equals_sign_in_its_name(self):
        self.split(0.003)
        for name in ("run=2.csv", "rate=200Hz.csv"):
            shutil.copy(self.folder / "pots.csv", self.folder / name)
            for other, done in ((name, f"with {name}"), (f"{name}=3ms", f"with {name}, 3 ms ahead")):
                with self.subTest(other):
                    frf = json.loads(self.run_program("frf", "main.csv", "--with", other, "--json").stdout)
                    self.assertEqual(frf["preparation"], [done])

    def test_names_motions_that_are_no_dwell(self):
        frf = json.loads(self.run_program("frf", "dwells.csv", "--json").stdout)
        self.assertEqual(frf["missed"], [])
        heights = dwells([2, 3], RATE)
        # Six seconds at 0.25 Hz, 1.5 cycles, then two dwells.
        slow = [0.02 * math.sin(2 * math.pi * 0.25 * k / RATE) for k in range(6 * RATE)]
        rows = "".join(f"{k / RATE:.4f},{z:.9g}\n" for k, z in enumerate(heights[:2 * RATE] + slow + heights[2 * RATE:]))
        self.write("heights.csv", "time,post\ns,m\n" + rows)
        self.run_program("simulate", "car.urdf", "--recording", "heights.csv", "--rate", f"{RATE}Hz", "--engine", "reduced",
                         "-o", "slow.csv")
        frf = json.loads(self.run_program("frf", "slow.csv", "--json").stdout)
        self.assertEqual(len(frf["missed"]), 1, frf["missed"])
        self.assertRegex(frf["missed"][0], r"no dwell was found from 2\.\d* to [78]\.\d* s")
        self.run_program("init", "study", "--from", "slow.csv", "--vehicle", "car.urdf")
        self.assertIn("# look at: slow.csv: no dwell was found", (self.folder / "study/study.yaml").read_text())

    def test_takes_stated_frequencies_of_dwells(self):
        # Steps of 1 % over eight cycles look like a sweep.
        stated = [2 + 0.02 * k for k in range(10)]
        rows = "".join(f"{k / RATE:.4f},{z:.9g}\n" for k, z in enumerate(dwells(stated, RATE)))
        self.write("heights.csv", "time,post\ns,m\n" + rows)
        self.run_program("simulate", "car.urdf", "--recording", "heights.csv", "--rate", f"{RATE}Hz", "--noise", "0.1%",
                         "--engine", "reduced", "-o", "close.csv")
        words = ["frf", "close.csv", "--kind", "stepped", "--json"]
        frf = json.loads(self.run_program(*words, "--frequencies", "2Hz:2.18Hz:0.02Hz").stdout)
        found = frf["responses"][0]["frequency_Hz"]
        self.assertEqual([round(frequency, 2) for frequency in found], [round(frequency, 2) for frequency in stated])
        # A frequency of eight cycles with noise of 0.1 % is good to a fraction of the step.
        for frequency, true in zip(found, stated, strict=True):
            self.assertAlmostEqual(frequency, true, delta=0.002)

    def test_audit_finds_a_device_on_another_clock(self):
        for ahead_s, is_found in ((0.003, True), (0, False)):
            self.split(ahead_s)
            self.write("study.yaml", """vehicle: car.urdf
recordings:
  - {file: main.csv, posts: heave, with: [pots.csv]}
band: [1 Hz, 10 Hz]
""")
            found = self.run_program("info", "study.yaml").stdout
            self.assertEqual("'s_strut' comes 3" in found, is_found, found)
            # With the line to write.
            self.assertEqual("write 's_strut: {channel: s_strut, delay: 3" in found, is_found, found)

    def test_says_what_was_done_to_the_recording(self):
        self.split(0.003)
        self.write("study.yaml", """vehicle: car.urdf
recordings:
  - file: main.csv
    posts: heave
    with: [{file: pots.csv, delay: 3 ms}]
    resample: 200 Hz
    end: 17 s
channels:
  a_body: {channel: a_body, trend: remove}
  s_strut: {channel: s_strut, offset: 1 mm, delay: 0.1 ms}
band: [1 Hz, 10 Hz]
free: [k]
""")
        self.run_program("fit", "study.yaml", "-o", "run", "--no-suggest")
        done = json.loads((self.folder / "run/result.json").read_text())["recordings"][0]["preparation"]
        for part in ("resampled to 200 Hz", "with pots.csv, 3 ms ahead", "a_body: trend taken away",
                     "s_strut: offset taken away", "s_strut: delay of 0.1 ms taken back", "responses of a stepped sine"):
            self.assertIn(part, done)
        self.assertTrue(any(part.startswith("cut to 0 .. ") for part in done), done)
        self.assertIn("a_body: trend taken away", (self.folder / "run/report.html").read_text())

    def rows(self):
        """Names, units and rows of the recording."""
        names, units, *rows = [row.split(",") for row in (self.folder / "dwells.csv").read_text().splitlines()]
        return names, units, rows

    def write_rows(self, file, *rows):
        self.write(file, "\n".join(",".join(row) for row in rows) + "\n")

    def assert_same_responses(self, one, other):
        self.assertEqual([c["name"] for c in one["channels"]], [c["name"] for c in other["channels"]])
        for mine, its in zip(one["channels"], other["channels"]):
            self.assertEqual(mine["unit"], its["unit"])
            for a, b in zip(mine["gain"], its["gain"], strict=True):
                # Numbers times 1000 in rounding.
                self.assertAlmostEqual(a / b, 1, 6)

    def test_takes_units_that_the_file_does_not_have(self):
        names, units, rows = self.rows()
        whole = json.loads(self.run_program("frf", "dwells.csv", "--json").stdout)["responses"][0]
        self.write_rows("bare.csv", names, *rows)
        refused = self.run_program("frf", "bare.csv", code=3).stderr
        self.assert_finding(refused, "response-posts-without-unit")
        self.assertIn("--unit 'post_post=mm'", refused)
        self.assertIn("post_channels: {post: {channel: post_post, unit: mm}}", refused)
        # By name, and by patterns, of which the last one counts.
        words = ["--unit", "*=m", "--unit", "a_*=m/s^2", "--unit", "F_*=N", "--unit", "time=s"]
        self.assert_same_responses(json.loads(self.run_program("frf", "bare.csv", *words, "--json").stdout)["responses"][0],
                                   whole)
        alone = self.run_program("frf", "bare.csv", "--unit", "post_post=m", "--unit", "s_strut=m", code=3).stderr
        self.assertIn("'time'", alone)
        self.assertIn("--unit", alone)
        unknown = self.run_program("frf", "bare.csv", "--unit", "psot_post=m", code=3).stderr
        self.assert_finding(unknown, "response-unit-of-none")
        self.assertIn("did you mean 'post_post'?", unknown)
        self.assert_finding(self.run_program("frf", "bare.csv", "--unit", "post_post=furlong", code=2).stderr,
                            "channel-unit-malformed")
        stated = self.run_program("frf", "bare.csv", "--post", "post_post=FL", "--unit", "time=s", code=3).stderr
        self.assert_finding(stated, "response-post-unit")
        self.assertIn("'post_post' of post 'FL' has no unit", stated)

    def test_takes_a_table_without_names(self):
        names, units, rows = self.rows()
        whole = json.loads(self.run_program("frf", "dwells.csv", "--json").stdout)["responses"][0]
        self.write_rows("bare.csv", *rows)
        refused = self.run_program("frf", "bare.csv", code=3).stderr
        self.assert_finding(refused, "csv-without-names")
        words = []
        for k, (name, unit) in enumerate(zip(names, units)):
            words += ["--unit", f"column{k + 1}={unit}"]
            if name == "post_post":
                words += ["--post", f"column{k + 1}=post"]
        bare = json.loads(self.run_program("frf", "bare.csv", *words, "--json").stdout)["responses"][0]
        for channel in bare["channels"]:
            channel["name"] = names[int(channel["name"].removeprefix("column")) - 1]
        self.assert_same_responses(bare, whole)
        # By a study.
        column = {name: f"column{k + 1}" for k, name in enumerate(names)}
        study = STUDY.format(recording=f"file: bare.csv, posts: heave, time: {{channel: {column['time']}, unit: s}}, "
                                       f"post_channels: {{post: {{channel: {column['post_post']}, unit: m}}}}").replace(
            "{a_body: a_body, s_strut: s_strut}", f"{{a_body: {{channel: {column['a_body']}, unit: m/s^2}}, "
            f"s_strut: {{channel: {column['s_strut']}, unit: m}}}}")
        self.write("study.yaml", study)
        answer = json.loads(self.run_program("response", "study.yaml", "--engine", "reduced", "--json").stdout)
        for channel in answer["channels"]:
            # As of the file itself.
            self.assertLess(channel["rms_dB"], 0.05, channel)

    def test_responses_without_names_are_refused_once(self):
        self.run_program("frf", "dwells.csv", "-o", "frf")
        head, *rows = (self.folder / "frf/heave.csv").read_text().splitlines()
        self.write("bare.csv", "\n".join(rows) + "\n")
        self.write("study.yaml", STUDY.format(recording="file: bare.csv, posts: heave"))
        refused = self.run_program("response", "study.yaml", code=3).stderr
        self.assert_finding(refused, "csv-without-names")
        self.assertIn("frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg", refused)

    def test_a_file_without_rows_needs_rows(self):
        for text in ("time,post_FL\ns,m\n", "time,post_FL\n", "time [s],post_FL [m]\n"):
            self.write("empty.csv", text)
            for command in ("frf", "info"):
                refused = self.run_program(command, "empty.csv", code=3).stderr
                self.assert_finding(refused, "csv-no-rows")
                self.assertEqual(refused.count(": error: "), 1, refused)

    def test_posts_that_no_rig_moves_so_are_in_another_unit(self):
        names, units, rows = self.rows()
        post = names.index("post_post")
        for factor, unit, meant in ((1e3, "m", "mm"), (1, "mm", "m")):
            with self.subTest(unit):
                self.write_rows("wrong.csv", names, units[:post] + [unit] + units[post + 1:], *(
                    row[:post] + [f"{factor * float(row[post]):.9g}"] + row[post + 1:] for row in rows))
                refused = self.run_program("frf", "wrong.csv", code=3).stderr
                self.assert_finding(refused, "response-post-size")
                self.assertIn(f"state its unit: --unit 'post_post={meant}'", refused)
                self.run_program("frf", "wrong.csv", "--unit", f"post_post={meant}")

    def test_a_post_that_is_misspelt_is_an_error(self):
        names, units, rows = self.rows()
        post, strut = names.index("post_post"), names.index("s_strut")

        def record(*posts, sensor="s_FL"):
            self.write_rows("four.csv", ["time", *posts, sensor], ["s", *("m" for _ in posts), "m"],
                            *([row[0], *(row[post] for _ in posts), row[strut]] for row in rows))

        record("post_FL", "post_FR", "post_RL", "psot_RR")
        refused = self.run_program("frf", "four.csv", code=3).stderr
        self.assert_finding(refused, "response-post-misspelt")
        self.assertIn("'post_RR'", refused)
        self.assertIn("--post 'post_FL=FL'", refused)
        # As it says; and where posts are stated, the others are the user's choice.
        self.run_program("frf", "four.csv", *(word for channel, name in (
            ("post_FL", "FL"), ("post_FR", "FR"), ("post_RL", "RL"), ("psot_RR", "RR"))
            for word in ("--post", f"{channel}={name}")))
        self.assert_finding(self.run_program("frf", "four.csv", "--post", "post_FL=FL").stderr, "response-like-post")
        # Named like a post that is there, or like none.
        record("post_FL", "post_FR", "post_RL", "table")
        self.assertNotIn("misspelt", self.run_program("frf", "four.csv").stderr)
        # A sensor that is nearly called as a post and does not move as one.
        record("post_FL", "post_FR", "post_RL", sensor="pot_RR")
        self.assertNotIn("response-", self.run_program("frf", "four.csv").stderr)
        unknown = self.run_program("frf", "four.csv", "--post", "post_Fl=FL", code=3).stderr
        self.assert_finding(unknown, "response-post-missing")
        self.assertIn("did you mean 'post_FL'?", unknown)

    def test_a_post_that_the_vehicle_does_not_have_is_an_error_of_validation_too(self):
        good = STUDY.format(recording="file: dwells.csv, posts: heave")
        for wrong, finding in (
                ("  - {file: dwells.csv, name: other, posts: {psot: 1}, use: validation}\n", "sine-post-unknown"),
                ("  - {file: dwells.csv, name: other, posts: heave, post_channels: {post: psot_post}, use: validation}\n",
                 "response-post-missing"),
                ("histories:\n  - {file: dwells.csv, posts: {psot: post_post}, use: validation}\n", "history-post-unknown")):
            with self.subTest(finding):
                self.write("study.yaml", good.replace("channels:", wrong + "channels:", 1) + "free: [k]\n")
                refused = self.run_program("fit", "study.yaml", "-o", "run", code=3).stderr
                self.assert_finding(refused, finding)
                self.assertIn("post", refused)
        # A fault of the file itself leaves it out.
        self.write("study.yaml", good.replace("channels:", "  - {file: none.csv, posts: heave, use: validation}\nchannels:", 1) +
                   "free: [k]\n")
        self.assert_finding(self.run_program("fit", "study.yaml", "-o", "run", "--no-suggest").stderr, "validation-left-out")

    def test_shows_mean_offsets(self):
        shown = self.run_program("frf", "dwells.csv").stdout
        self.assertRegex(shown, r"mean offsets relative to rest[^\n]* heave.csv")
        channel = {c["name"]: c for c in json.loads(self.run_program("frf", "dwells.csv", "--json").stdout)
                   ["responses"][0]["channels"]}["s_strut"]
        surest = max(range(4), key=lambda k: abs(channel["mean"][k]) / channel["mean_sd"][k])
        row = next(line.split() for line in shown.split("mean offsets")[2].splitlines() if line.startswith("s_strut"))
        self.assertEqual(row[1], "mm")
        self.assertAlmostEqual(float(row[2]), 1e3 * channel["mean"][surest], delta=1e-3 * abs(1e3 * channel["mean"][surest]) + 1e-9)

    def test_refuses_what_it_cannot_use(self):
        self.assert_finding(self.run_program("frf", "dwells.csv", "--post", "FL", code=2).stderr, "post-channel-malformed")
        self.assert_finding(self.run_program("frf", "dwells.csv", "--kind", "steped", code=2).stderr, "value-unknown")
        self.assert_finding(self.run_program("frf", "car.urdf", code=3).stderr, "vehicle-for-recording")
        self.assert_finding(self.run_program("frf", "dwells.csv", "-o", ".", code=5).stderr, "folder-holds-input")


if __name__ == "__main__":
    unittest.main()
