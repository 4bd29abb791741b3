"""`fourpost info` and `fourpost params` as a user meets them."""
import json
import math
import random
import statistics
import unittest

from program import SOURCE, ProgramTest


def table(rows, separator=",", decimal=".", end="\n"):
    lines = [separator.join(str(field).replace(".", decimal) if not isinstance(field, str) else field for field in row)
             for row in rows]
    return end.join(lines) + end


def samples(count=500, clip=2.0):
    """A sine of 2 mm at 500 Hz, cut at `clip`, and a constant. No two samples of it are alike."""
    return [(k / 500, max(-clip, min(clip, 2 * math.sin(2 * math.pi * 5.0317 * k / 500))), 7) for k in range(count)]


class Info(ProgramTest):
    def info(self, name, text, code=0):
        self.write(name, text)
        return json.loads(self.run_program("info", name, "--json", code=code).stdout)["files"][0]

    def test_of_a_recording(self):
        told = self.info("r.csv", table([("time", "x", "off"), ("s", "mm", "V"), *samples()]))
        self.assertEqual(told["kind"], "time_history")
        self.assertAlmostEqual(told["time"]["rate_Hz"], 500)
        self.assertEqual(told["time"]["gaps"], [])
        self.assertEqual(told["refusals"], [])
        x, off = told["channels"]
        values = [value for _, value, _ in samples()]
        self.assertAlmostEqual(x["rms"], statistics.pstdev(values), 9)
        self.assertEqual((x["minimum"], x["maximum"]), (min(values), max(values)))
        self.assertEqual((x["unit_known"], x["clipped_top"], x["remarks"]), (True, 0, []))
        self.assertEqual(off["remarks"], ["unknown unit 'V'", "constant"])

    def test_refuses_a_column_of_text(self):
        """Marks between thousands make a whole column text, which is told a few times and not for every row."""
        rows = "".join(f"{k / 100};1.00{k % 7},5\n" for k in range(500)).replace(".0;", ";")
        told = self.info("r.csv", "time;F\ns;N\n" + rows)
        self.assertEqual(told["channels"][0]["remarks"], ["no numbers"])
        self.assertIn("column 'F' has '1.000,5' here", told["refusals"][0])
        self.assertLess(len(told["refusals"]), 50)
        self.assertEqual(self.info("r.csv", table([("time", "F"), ("s", "N"), *((k / 100, "") for k in range(50))]))
                         ["refusals"], [])

    def test_keeps_control_characters_from_the_terminal(self):
        """ESC turns colours on, or worse; \\x9b is the same in one character."""
        text = table([("time", "x\x1b[31m\u009b1m\x07"), ("s", "mm"), *((k, k * k % 17) for k in range(50))])
        self.write("r.csv", text)
        self.write("s.csv", text.replace("s,mm", "s\x1b[0m,mm") + "1\x1b,2,3\n")
        self.assertIn("x?[31m??1m?", self.run_program("info", "r.csv").stdout)
        for name, code in (("r.csv", 0), ("s.csv", 3)):
            told = self.run_program("info", name, code=code)
            for character in "\x1b\x07\u009b":
                self.assertNotIn(character, told.stdout + told.stderr)

    def test_is_the_same_in_every_dialect(self):
        head = [("time", "x", "off"), ("s", "mm", "N")]
        plain = self.info("r.csv", table(head + samples()))
        for name, text in {
            "german.csv": "\ufeff" + table(head + samples(), ";", ",", "\r\n"),
            "tabs.txt": table(head + samples(), "\t", ","),
            "behind.csv": table([("time [s]", "x [mm]", "off [N]"), *samples()], ";", ","),
        }.items():
            with self.subTest(name):
                told = self.info(name, text)
                self.assertEqual({**told, "file": ""} | {"time": None}, {**plain, "file": ""} | {"time": None})
                self.assertEqual(told["time"]["rate_Hz"], plain["time"]["rate_Hz"])

    def test_tells_clipping_gaps_missing_numbers_and_levels(self):
        rows = [list(row) for row in samples(clip=1.5)]
        rows[100][2] = "nan"
        del rows[200:220]
        told = self.info("r.csv", table([("time", "x", "off"), ("s", "mm", "N"), *rows]))
        (gap,) = told["time"]["gaps"]
        self.assertEqual((gap["line"], gap["from_s"], gap["to_s"]), (203, 0.398, 0.44))
        self.assertEqual(told["channels"][0]["clipped_top"], sum(value == 1.5 for _, value, _ in rows))
        missing, hole = told["refusals"]
        self.assertIn("line 103: column 'off' has 'nan' here", missing)
        self.assertIn("line 203: time goes from 0.398 s to 0.44 s", hole)
        text = self.run_program("info", "r.csv").stdout
        self.assertIn("a fit refuses this recording:", text)
        self.assertIn("gap: from 0.398 to 0.44 s, line 203", text)
        self.assertIn("samples at 1.5", text)
        self.assertIn("1 missing, first in line 103", text)
        coarse = [(t, round(x), 0) for t, x, _ in samples()]
        told = self.info("c.csv", table([("time", "x", "off"), ("s", "mm", "N"), *coarse]))
        self.assertEqual(told["channels"][0]["level"], 1)
        self.assertIn("coarse resolution: levels of", told["channels"][0]["remarks"][0])

    def test_tells_noise_at_rest_and_jitter_of_a_recording_with_gaps(self):
        draw = random.Random(1)
        rows = [(k / 500 + draw.gauss(0, 1e-4), (5 * math.sin(2 * math.pi * 2 * k / 500) if k > 3000 else 0) +
                 draw.gauss(0, 0.01)) for k in range(10000)]
        del rows[7000:7200]
        self.write("r.csv", table([("time", "x"), ("s", "mm"), *rows]))
        told = json.loads(self.run_program("info", "r.csv", "--json").stdout)["files"][0]
        self.assertEqual(len(told["time"]["gaps"]), 1)
        # Steps differ by the root of two of a twentieth.
        self.assertAlmostEqual(told["time"]["jitter_share"], 0.0707, delta=0.003)
        self.assertLess(told["rest_s"][1], 6.01)
        self.assertAlmostEqual(told["channels"][0]["noise"]["sd"], 0.01, delta=0.001)
        # Before the rest there may be a gap: times are those of the record.
        late = [(t + (30 if t > 2 else 0), x) for t, x in rows if t < 13]
        self.write("r.csv", table([("time", "x"), ("s", "mm"), *late]))
        told = json.loads(self.run_program("info", "r.csv", "--json").stdout)["files"][0]
        self.assertGreater(told["rest_s"][0], 31.9)
        self.assertLess(told["rest_s"][1], 36.01)

    def test_calls_json_of_others_no_result(self):
        self.write("config.json", '{"rig": 1}')
        errors = self.run_program("check", "config.json", code=3).stderr
        self.assert_finding(errors, "file-of-other-kind", "config.json")
        self.assertIn("this is a JSON file", errors)

    def test_tells_why_a_fit_refuses_a_bench_recording(self):
        def bench(names, units, sign):
            rows = [(t, x, sign * 300 * math.cos(2 * math.pi * 5.0317 * t)) for t, x, _ in samples()]
            return table([names, units, *rows])

        self.assertEqual(self.info("good.csv", bench(("time", "x", "F"), ("s", "mm", "N"), 1))["refusals"], [])
        (refusal,) = self.info("bad.csv", bench(("time", "x", "F"), ("s", "mm", "N"), -1))["refusals"]
        self.assertIn("as a recording of a damper bench: ", refusal)
        self.assertIn("sign", refusal)
        # Rows 198 to 227 are missing, and the times go on.
        rows = bench(("time", "x", "F"), ("s", "mm", "N"), 1).splitlines()
        kept = rows[2:200] + rows[230:]
        closed = [f"{k / 500},{row.split(',', 1)[1]}" for k, row in enumerate(kept)]
        (jump,) = self.info("closed.csv", "\n".join(rows[:2] + closed) + "\n")["refusals"]
        self.assertIn("displacement jumps by ", jump)
        # The order of the columns does not count.
        swapped = [(t, -300 * math.cos(2 * math.pi * 5.0317 * t), x) for t, x, _ in samples()]
        told = self.info("swapped.csv", table([("time", "F", "x"), ("s", "N", "mm"), *swapped]))
        self.assertEqual(told["refusals"], [refusal])
        # Two forces are no bench's.
        self.assertEqual(self.info("forces.csv", bench(("time", "x", "F"), ("s", "N", "N"), -1))["refusals"], [])

    def test_tells_that_times_and_units_are_missing(self):
        self.write("r.csv", table([("a", "b"), *[(math.sin(k), k * k) for k in range(40)]]))
        text = self.run_program("info", "r.csv").stdout
        self.assertIn("name it in the study, time: {channel: NAME, unit: s}", text)
        self.assertEqual(text.count("no unit"), 2)

    def test_guesses_times_that_stand_there_twice(self):
        rows = [(k / 100, math.sin(k), k / 100) for k in range(100)]
        told = self.info("r.csv", table([("Tout", "b", "tout"), *rows]))
        self.assertEqual((told["time"]["column"], told["time"]["guessed"]), ("Tout", True))
        told = self.info("r.csv", table([("Tout", "b", "count"), *((t, b, k) for k, (t, b, _) in enumerate(rows))]))
        self.assertIsNone(told["time"])

    def test_of_other_layouts(self):
        text = self.run_program("info", SOURCE / "studies/landrover110/pitch_frf.csv",
                                SOURCE / "studies/landrover110/static.csv").stdout
        self.assertIn("stepped sine, 64 frequencies from 0.5", text)
        self.assertIn("a_axle_FL", text)
        self.assertIn("static_load_FL", text)

    def test_of_a_study_audits_the_rig(self):
        study = SOURCE / "studies/landrover110/model2.yaml"
        text = self.run_program("info", study).stdout
        self.assertIn("audit of the rig", text)
        self.assertIn("a_tow_point", text)
        self.assertNotIn("[rig-", text)
        audit = json.loads(self.run_program("info", study, "--json").stdout)["files"][0]["audit"]
        self.assertEqual(audit["suspicions"], [])
        self.assertLess(audit["misfit"], 1)

    def test_of_a_study_of_histories_names_a_late_channel(self):
        """By 3 ms at 200 Hz, which is less than a sample."""
        model = SOURCE / "urdf/quarter_car.urdf"
        self.run_program("simulate", model, "--random", "4mm", "--seed", "1", "--duration", "30s", "--rate", "1000Hz",
                         "--engine", "reduced", "-o", "fine.csv")
        names, units, *rows = [line.split(",") for line in (self.folder / "fine.csv").read_text().split()]
        draw = random.Random(1)
        strut = names.index("s_strut")
        sd = {column: 0.01 * statistics.pstdev(float(row[column]) for row in rows) for column in range(1, len(names))}
        study = f"vehicle: {model}\nhistories:\n  - {{file: r.csv, posts: {{post: {names[1]}}}}}\n" + (
            "channels: {a_sprung: a_sprung, a_unsprung: a_unsprung, s_strut: s_strut}\nfree: [k]\n")
        self.write("study.yaml", study)
        for late in (0, 3, -3):
            recorded = []
            for k in range(10, len(rows) - 10, 5):
                row = [f"{float(rows[k][c]) + draw.gauss(0, sd[c]):.9g}" for c in range(1, len(names))]
                row[strut - 1] = f"{float(rows[k - late][strut]) + draw.gauss(0, sd[strut]):.9g}"
                recorded.append([f"{k / 1000:.4f}", *row])
            self.write("r.csv", table([names, units, *recorded]))
            told = json.loads(self.run_program("info", "study.yaml", "--json").stdout)["files"][0]
            if late == 0:
                self.assertEqual(told["audit"]["suspicions"], [])
                continue
            # Three sensors of two motions: any of them may be late.
            (found,) = told["audit"]["suspicions"]
            explained = {one["of"]: one for one in (found, *found["rivals"])}
            self.assertEqual({one["kind"] for one in explained.values()}, {"delay"})
            # Three of its standard deviations, and what a good rig may be off by.
            self.assertAlmostEqual(explained["s_strut"]["size"], 1e-3 * late, delta=0.5e-3)
            (warning,) = [one["text"] for one in told["warnings"] if one["id"] == "rig-delay"]
            self.assertRegex(warning, "'s_strut' comes [23][.0-9]* ms " + ("late" if late > 0 else "early"))
            self.assertRegex(warning, "delay: -?[23][.0-9]* ms")

    def test_of_a_study_of_histories_says_which_condition_of_an_audit_it_lacks(self):
        model = SOURCE / "urdf/quarter_car.urdf"
        self.run_program("simulate", model, "--random", "4mm", "--seed", "1", "--duration", "6s", "--engine", "reduced",
                         "-o", "r.csv")
        post = (self.folder / "r.csv").read_text().split(",", 2)[1]
        self.write("study.yaml", f"vehicle: {model}\nhistories:\n  - {{name: short, file: r.csv, posts: {{post: {post}}}}}\n"
                                 "channels: {a_sprung: a_sprung, a_unsprung: a_unsprung}\nfree: [k]\n")
        self.assertRegex(self.run_program("info", "study.yaml").stdout,
                         r"no audit of the rig: it needs eight seconds .*'short' has [56][.0-9]* s without a gap")

    def test_names_channels_that_a_logger_held(self):
        rows = [list(row) for row in samples(1000)]
        for row in rows[600:640]:
            row[1] = rows[599][1]
        shown = self.info("r.csv", table([("time", "x", "y"), ("s", "mm", "mm"), *((t, x, math.cos(31 * t)) for t, x, _ in rows)]))
        x, y = shown["channels"]
        self.assertEqual((x["held"], y["held"]), (40, 0))
        self.assertEqual(x["remarks"], ["held by the logger: 40 samples, first in line 603"])
        self.assertEqual(y["remarks"], [])

    def test_tells_rest_before_a_gap_and_between_gaps(self):
        draw = random.Random(2)
        def moving(t):
            return 5 * math.sin(2 * math.pi * 2 * t)
        # Four seconds of rest, then a gap and a longer stretch of motion; rest between two gaps of motion.
        for rest, gaps in ((0, [4]), (20, [20, 24])):
            rows = []
            for k in range(30 * 200):
                t = k / 200
                late = sum(3 for gap in gaps if t >= gap)
                rows.append((f"{t + late:.3f}", (0 if rest <= t < rest + 4 else moving(t)) + draw.gauss(0, 0.01)))
            shown = self.info("r.csv", table([("time", "x"), ("s", "mm"), *rows]))
            self.assertEqual(len(shown["time"]["gaps"]), len(gaps))
            begin = rest + 3 * (rest > 0)
            # Rest is known to a quarter of a second, and a quarter ends at the gap.
            self.assertGreaterEqual(shown["rest_s"][0], begin - 0.01)
            self.assertGreater(shown["rest_s"][1], begin + 3)
            self.assertLess(shown["rest_s"][1], begin + 4.01)
            self.assertAlmostEqual(shown["channels"][0]["noise"]["sd"], 0.01, delta=0.001)

    def test_names_a_force_that_drifts_and_no_motion_that_rises(self):
        draw = random.Random(3)
        def record(force, post):
            rows = []
            for k in range(60 * 100):
                t = k / 100
                z = 5 * math.sin(2 * math.pi * 1.7 * t) + 2 * math.sin(2 * math.pi * 4.1 * t)
                rows.append((f"{t:.2f}", f"{z + post * t / 60:.6g}", f"{0.5 * z + draw.gauss(0, 0.01):.6g}",
                             f"{100 * z + draw.gauss(0, 1) + force * t / 60:.6g}"))
            return [one["remarks"] for one in self.info("r.csv", table([("time", "z_post", "s_strut", "F_tyre"), ("s", "mm", "mm", "N"), *rows]))["channels"]]

        self.assertEqual(record(0, 0), [[], [], []])
        self.assertEqual(record(0, 2), [[], [], []])
        post, strut, (force,) = record(28, 0)
        self.assertEqual((post, strut), ([], []))
        self.assertRegex(force, r"drifts by 2[78][.0-9]* over 60.0 s beside its motion, `trend: remove`")

    def test_says_what_to_write_for_a_unit(self):
        shown = self.info("r.csv", table([("time", "x", "F", "G", "v"), ("seconds", "inches", "lbs", "KN", "mph"),
                                         *((k / 100, *(math.sin(k * f) for f in (1, 2, 3, 4))) for k in range(50))]))
        self.assertEqual([one["remarks"] for one in shown["channels"]],
                         [[], ["unknown unit 'lbs': pounds are a mass or a force, write 'lbm' or 'lbf'"],
                          ["unknown unit 'KN', did you mean 'kN'?"], []])

    def test_says_what_else_fits_other_files(self):
        self.run_program("init", "car")
        for name, finding in (("car/vehicle.urdf", "vehicle-for-recording"), ("car", "folder-for-recording"), ("response.svg", "file-of-other-kind")):
            outcome = self.run_program("info", name, "car/stepped_sine.csv", code=3)
            self.assertIn("stepped sine", outcome.stdout)
            self.assertTrue(outcome.stderr.startswith(f"{name}: error: "), outcome.stderr)
            self.assertTrue(outcome.stderr.endswith(f" [{finding}]\n"), outcome.stderr)
            self.assertEqual(outcome.stderr.count("\n"), 1, outcome.stderr)

    def test_of_a_recording_of_rpc(self):
        """By content: its name says CSV."""
        name = self.folder / "run.csv"
        name.write_bytes((SOURCE / "tests/data/recordings/test1.rsp").read_bytes())
        told = json.loads(self.run_program("info", name, "--json").stdout)["files"][0]
        self.assertEqual((told["kind"], told["format"], told["refusals"]), ("time_history", "RPC III", []))
        self.assertAlmostEqual(told["time"]["rate_Hz"], 250)
        self.assertEqual([channel["unit"] for channel in told["channels"]], ["N", "m/s^2", "N", "N", "mm"])
        self.assertAlmostEqual(told["channels"][0]["rate_Hz"], 250)
        # What another program wrote into the header of maximum and minimum, within its counts.
        self.assertAlmostEqual(told["channels"][0]["maximum"], 241.96741, delta=0.02)
        self.assertAlmostEqual(told["channels"][0]["minimum"], -220.72052, delta=0.02)
        self.assertIn("RPC III: nCode File Creation", self.run_program("info", name).stdout)

    def test_shows_the_rate_and_group_of_each_channel(self):
        rows = [f"{k / 500},{k % 7},{k / 100},{k % 5}" for k in range(100)] + [f"{k / 500},{k % 7},," for k in range(100, 500)]
        self.write("rates.csv", "\n".join(["Time,F,Time,z", "s,N,s,mm"] + rows) + "\n")
        outcome = self.run_program("info", "rates.csv")
        self.assert_finding(outcome.stderr, "channels-interpolated", "rates.csv:")
        self.assertRegex(outcome.stdout, r"F +N +500 Hz")
        self.assertRegex(outcome.stdout, r"z +mm +100 Hz")

    def test_says_what_a_damaged_recording_lacks(self):
        whole = (SOURCE / "tests/data/recordings/test1.rsp").read_bytes()
        (self.folder / "cut.rsp").write_bytes(whole[:20000])
        self.write("data.txt", '{"time": [0, 1]}')
        outcome = self.run_program("info", "cut.rsp", "data.txt", code=3)
        self.assert_finding(outcome.stderr, "recording-cut-short", "cut.rsp:")
        self.assertIn("byte 9216", outcome.stderr)
        self.assert_finding(outcome.stderr, "csv-json", "data.txt:")

    def test_shows_what_can_be_read_and_tells_the_rest(self):
        self.write("empty.csv", "")
        self.write("ragged.csv", "time,x\ns,m\n0,1\n1\n")
        self.write("utf16.csv", "time,x\n".encode("utf-16"))
        outcome = self.run_program("info", "empty.csv", "ragged.csv", "utf16.csv", "none.csv", "x.mat",
                                   SOURCE / "studies/damper/sine_1Hz_5mm.csv", code=3)
        self.assertIn("displacement", outcome.stdout)
        for place, finding in (("empty.csv:", "csv-empty"), ("ragged.csv:4:", "csv-row-length"),
                               ("utf16.csv:", "csv-utf-16"), ("none.csv:", "file-not-there"), ("x.mat:", "file-not-there")):
            self.assert_finding(outcome.stderr, finding, place)


class Params(ProgramTest):
    def test_tells_values_bounds_and_uses(self):
        file = SOURCE / "urdf/quarter_car.urdf"
        parameters = {p["name"]: p for p in json.loads(self.run_program("params", file, "--json").stdout)["parameters"]}
        self.assertEqual(list(parameters), ["m_sprung", "m_unsprung", "k", "kt", "c_bump", "c_rebound"])
        k = parameters["k"]
        self.assertEqual((k["value"], k["unit"], k["file_unit"], k["lower"], k["upper"]), (15e3, "N/m", "kN/m", 5e3, 4e4))
        self.assertEqual(k["used_by"][0]["what"], "stiffness of <linear> of fp:spring 'spring'")
        line = file.read_text().splitlines()[k["used_by"][0]["line"] - 1]
        self.assertIn('stiffness="$k"', line)
        self.assertEqual(parameters["m_sprung"]["used_by"][0]["what"], "link[sprung]/mass")
        self.assertIn("5.000 .. 40.00", self.run_program("params", file).stdout)


if __name__ == "__main__":
    unittest.main()
