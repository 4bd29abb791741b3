"""A rig's folder becomes a study: channels of other names, units and signs; and the keys that keep studies short."""
import csv
import json
import math
import re
import shutil
import unittest

from program import SOURCE, ProgramTest, dwells

RATE = 200
# Sensor of the vehicle, and what a rig calls it, in which unit and with which sign.
NAMES = {"post_post": ("Actuator pos", "mm", 1e3), "a_body": ("Chassis Acc", "g", 1 / 9.80665),
         "a_wheel": ("Hub Acc", "g", -1 / 9.80665), "s_strut": ("Damper Pot", "mm", 1e3),
         "F_tyre": ("Load cell", "kN", 1e-3)}


def renamed(text):
    """The columns of a rig: other names and units, a blank column, lines above the names."""
    rows = list(csv.reader(text.splitlines()))
    columns = [["Time"] + ["s"] + [row[0] for row in rows[2:]]]
    for column in range(1, len(rows[0])):
        name, unit, factor = NAMES[rows[0][column]]
        columns.append([name, unit] + [f"{factor * float(row[column]):.8g}" for row in rows[2:]])
    return "Rig 4;2026\n" + "\n".join(";".join(row) for row in zip(*columns)) + "\n"


class Draft(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("meshes")
        text = (SOURCE / "studies/starter/vehicle.urdf").read_text()
        self.sensors = [part.split('"')[1] for part in text.split("<fp:sensor name=")[1:]]
        self.write("car.urdf", text)
        rows = "".join(f"{k / RATE:.4f},{z:.9g}\n" for k, z in enumerate(dwells([1, 2, 3, 5, 8, 12], RATE)))
        self.write("heights.csv", "time,post\ns,m\n" + rows)
        self.simulate("dwells.csv")

    def simulate(self, name, *options):
        self.run_program("simulate", "car.urdf", "--recording", "heights.csv", "--rate", f"{RATE}Hz", "--noise", "0.1%",
                         "--engine", "reduced", *options, "-o", name)

    def test_a_misspelt_post_is_an_error_although_other_files_are_used(self):
        shutil.copy(SOURCE / "urdf/landrover110_linkage.urdf", self.folder / "rover.urdf")
        for post in ("post_rear", "psot_rear", "z_axle"):
            rows = (self.folder / "heights.csv").read_text().splitlines()[2:]
            self.write(f"{post}.csv", f"time,post_front,{post},s_strut_front\ns,m,m,m\n" + "".join(
                f"{row},{row.split(',')[1]},{row.split(',')[1]}\n" for row in rows))
        words = ("init", "study", "--from", "post_rear.csv")
        refused = self.run_program(*words, "psot_rear.csv", "--vehicle", "rover.urdf", code=3).stderr
        self.assert_finding(refused, "not-drafted")
        self.assertIn("'psot_rear' is nearly 'post_rear'", refused)
        self.assertIn("not used: z_axle.csv", self.run_program(*words, "z_axle.csv", "--vehicle", "rover.urdf").stdout)

    def test_of_a_rigs_folder_fits_in_two_commands(self):
        (self.folder / "rig").mkdir()
        self.write("rig/run1.csv", renamed((self.folder / "dwells.csv").read_text()))
        self.write("rig/notes.txt", "springs of the red car\n")
        outcome = self.run_program("init", "study", "--from", "rig", "--vehicle", "car.urdf", "--json")
        answer = json.loads(outcome.stdout)
        used = {entry["file"]: entry["use"] for entry in answer["recordings"]}
        self.assertEqual(used, {"rig/run1.csv": "recordings", "rig/notes.txt": None})
        channels = {match["name"]: match["channel"] for entry in answer["recordings"] for match in entry["matches"]}
        for sensor in self.sensors:
            if sensor not in NAMES:
                continue
            name, _, factor = NAMES[sensor]
            self.assertEqual(channels[sensor], name if factor > 0 else f"{{channel: {name}, sign: -1}}")
        text = (self.folder / "study/study.yaml").read_text()
        self.assertIn("# not used: notes.txt", text)
        self.run_program("fit", "study/study.yaml", "-o", "run", code=0)
        # The car is the one that was simulated.
        result = json.loads((self.folder / "run/result.json").read_text())
        self.assertLess(result["misfit"], 1)
        for parameter in result["parameters"]:
            self.assertLess(abs(parameter["value"] / parameter["start"] - 1), 0.05, parameter["name"])

    def test_needs_no_lines_for_channels_that_are_named_as_sensors(self):
        self.run_program("init", "study", "--from", "dwells.csv", "--vehicle", "car.urdf")
        text = (self.folder / "study/study.yaml").read_text()
        self.assertNotIn("channels:", text)
        # Four seconds are too short for a dwell at 1 Hz.
        short = re.findall("look at: dwells.csv: the dwell at 1.0* Hz from 2", text)
        self.assertEqual(text.count("look at"), len(short), text)
        self.assertIn("file: ../dwells.csv\n    posts: heave", text)
        answer = json.loads(self.run_program("response", "study/study.yaml", "--engine", "reduced", "--json").stdout)
        self.assertEqual({channel["name"] for channel in answer["channels"]}, set(self.sensors))

    def test_says_of_each_channel_what_its_match_is_worth(self):
        """Posts and pots of a half car by single letters, one channel that is none of its sensors', one without a unit."""
        self.write("half.urdf", (SOURCE / "urdf/landrover110_model1.urdf").read_text())
        rows = "".join(f"{k / RATE:.4f},{z:.9g},{0.5 * z:.9g}\n" for k, z in enumerate(dwells([1, 2, 4], RATE)))
        self.write("two.csv", "time,front,rear\ns,m,m\n" + rows)
        self.run_program("simulate", "half.urdf", "--recording", "two.csv", "--rate", f"{RATE}Hz", "--noise", "0.1%",
                         "--engine", "reduced", "-o", "clean.csv")
        table = list(csv.reader((self.folder / "clean.csv").read_text().splitlines()))
        names = {"time": "time", "post_front": "post_f", "post_rear": "post_r", "s_strut_front": "pot_F",
                 "s_strut_rear": "pot_R", "a_body_front": "Karo_z_V", "a_body_rear": "Karo_z_H"}
        columns = [[names[name], *column] for name, *column in zip(*table) if name in names]
        columns += [["oil", "degC"] + ["80.5"] * (len(table) - 2), ["spare", ""] + ["0.25"] * (len(table) - 2),
                    ["pot_X", "m"] + [f"{1e-3 * (k % 7):.4g}" for k in range(len(table) - 2)]]
        self.write("rig.csv", "\n".join(",".join(row) for row in zip(*columns)) + "\n")
        outcome = self.run_program("init", "study", "--from", "rig.csv", "--vehicle", "half.urdf", "--json")
        channels = {c["name"]: c for c in json.loads(outcome.stdout)["recordings"][0]["channels"]}
        for channel, of in (("post_f", "post 'front'"), ("post_r", "post 'rear'"), ("pot_F", "s_strut_front"),
                            ("pot_R", "s_strut_rear"), ("Karo_z_V", "a_body_front"), ("Karo_z_H", "a_body_rear")):
            self.assertEqual((channels[channel]["of"], channels[channel]["state"]), (of, "sure"), channels[channel])
        self.assertEqual({name: channels[name]["state"] for name in ("oil", "spare", "pot_X")},
                         {"oil": "unmatched", "spare": "unmatched", "pot_X": "unmatched"})
        self.assertIn("has no unit", channels["spare"]["why"])
        self.assertIn("s_strut_front, s_strut_rear", channels["pot_X"]["why"])
        text = (self.folder / "study/study.yaml").read_text()
        self.assertIn("#   pot_R = s_strut_rear: sure\n", text)
        self.assertIn("without a channel: a_cross_member (an acceleration)", text)
        self.assertIn("post_channels: {front: post_f, rear: post_r}\n", text)
        self.write("rig2.csv", (self.folder / "rig.csv").read_text())
        self.run_program("init", "both", "--from", "rig.csv", "rig2.csv", "--vehicle", "half.urdf")
        self.assertIn("# rig2.csv, channel by channel: as rig.csv\n", (self.folder / "both/study.yaml").read_text())

    def test_says_how_posts_are_named(self):
        self.write("lost.csv", renamed((self.folder / "dwells.csv").read_text()).replace("Actuator pos", "xyz"))
        outcome = self.run_program("init", "study", "--from", "lost.csv", "--vehicle", "car.urdf", code=3)
        self.assertIn("no channel found for post 'post': call its displacement post_post", outcome.stderr)
        self.assertIn("displacements here: xyz, Damper Pot", outcome.stderr)

    def test_asks_for_nothing_twice(self):
        self.run_program("init", "study", "--from", "dwells.csv", "--vehicle", "car.urdf")
        before = (self.folder / "study/study.yaml").read_text()
        outcome = self.run_program("init", "study", "--from", "dwells.csv", "--vehicle", "car.urdf", code=5)
        self.assert_finding(outcome.stderr, "draft-is-there", "study/study.yaml")
        self.assertEqual(before, (self.folder / "study/study.yaml").read_text())

    def test_refuses_what_nothing_can_be_made_of(self):
        (self.folder / "empty").mkdir()
        self.assert_finding(self.run_program("init", "study", "--from", "empty", "--vehicle", "car.urdf", code=3).stderr,
                            "nothing-to-draft-from")
        self.write("text.csv", "springs of the red car\n")
        self.assert_finding(self.run_program("init", "study", "--from", "text.csv", "--vehicle", "car.urdf", code=3).stderr,
                            "not-drafted")
        self.assertFalse((self.folder / "study").exists())
        self.run_program("init", "study", "--from", "dwells.csv", code=2)

    def test_takes_a_sweep_as_a_history(self):
        self.run_program("simulate", "car.urdf", "--sweep", "0.5Hz:20Hz", "--duration", "30s", "--rate", "200Hz", "-o",
                         "sweep.csv")
        self.run_program("init", "study", "--from", "sweep.csv", "--vehicle", "car.urdf")
        text = (self.folder / "study/study.yaml").read_text()
        self.assertIn("histories:\n  - file: ../sweep.csv\n", text)
        self.run_program("response", "study/study.yaml")
        self.run_program("init", "both", "--from", "sweep.csv", "dwells.csv", "--vehicle", "car.urdf")
        self.assertIn("use: validation", (self.folder / "both/study.yaml").read_text())


    def sweep_with_gaps(self, gaps):
        """A sweep with a strut of the wrong sign and samples of a_wheel that are missing: pairs of first and count."""
        self.run_program("simulate", "car.urdf", "--sweep", "0.5Hz:20Hz", "--duration", "30s", "--rate", f"{RATE}Hz",
                         "--engine", "reduced", "-o", "clean.csv")
        rows = list(csv.reader((self.folder / "clean.csv").read_text().splitlines()))
        strut, wheel = rows[0].index("s_strut"), rows[0].index("a_wheel")
        for row in rows[2:]:
            row[strut] = f"{-float(row[strut]):.9g}"
        for first, count in gaps:
            for row in rows[2 + first:2 + first + count]:
                row[wheel] = ""
        self.write("sweep.csv", "\n".join(",".join(row) for row in rows) + "\n")
        printed = self.run_program("init", "study", "--from", "sweep.csv", "--vehicle", "car.urdf", "--json").stdout
        text = (self.folder / "study/study.yaml").read_text()
        shutil.rmtree(self.folder / "study")
        return text, {c["name"]: c for c in json.loads(printed)["recordings"][0]["channels"]}

    def test_counts_gaps_and_not_their_samples(self):
        text, _ = self.sweep_with_gaps([(1000, 6)])
        self.assertIn("  # 1 gap, the longest 35 ms\n", text)

    def test_compares_motion_beside_a_gap_that_is_too_long_to_bridge(self):
        # 16 steps of 5 ms; the longest stretch comes before it.
        text, channels = self.sweep_with_gaps([(4000, 15)])
        self.assertNotIn("bridge: ", text)
        self.assertIn("# look at: sweep.csv: motion was compared from 0 to 20.00 s, the longest stretch without a gap above "
                      "50 ms\n", text.replace("19.99", "20.00").replace("20.0 s", "20.00 s"))
        self.assertEqual(channels["s_strut"]["state"], "look at")
        self.assertIn("its sign is turned", channels["s_strut"]["why"])

    def test_says_which_channels_were_not_checked_by_motion(self):
        # Too little between gaps for any response.
        _, channels = self.sweep_with_gaps([(first, 15) for first in range(20, 6000, 20)])
        self.assertEqual(channels["s_strut"]["state"], "sure")
        self.assertRegex(channels["s_strut"]["why"], "^by name, not checked by motion: .")

    def sweep_of_two_recorders(self, lost, jitter_s, drift):
        """A sweep after two seconds of rest: one recorder loses samples, jitters and drifts, the other has the strut."""
        heights = [0.0] * (2 * RATE)
        for k in range(20 * RATE):
            t = k / RATE
            heights.append(min(1, t) * 8e-3 / (1 + t / 5) * math.sin(2 * math.pi * (0.5 * t + 0.3 * t * t)))
        self.write("heights.csv", "time,post\ns,m\n" + "".join(f"{k / RATE:.4f},{z:.9g}\n" for k, z in enumerate(heights)))
        self.simulate("sweep.csv")
        rows = list(csv.reader((self.folder / "sweep.csv").read_text().splitlines()))
        column = {name: [float(row[k]) for row in rows[2:]] for k, name in enumerate(rows[0])}
        jitter = [jitter_s * math.sin(1.7 * k * k) for k in range(len(rows) - 2)]
        lines = ["Zeit;Actuator pos;Chassis Acc;Hub Acc;Load cell", "s;mm;g;g;kN"]
        for k in range(len(rows) - 2):
            if k not in lost:
                lines.append(f"{k / RATE + jitter[k]:.6f};{1e3 * column['post_post'][k] + 12:.6g};"
                             f"{column['a_body'][k] / 9.80665 + drift * k / RATE:.8g};"
                             f"{-column['a_wheel'][k] / 9.80665 + 0.02:.8g};{1e-3 * column['F_tyre'][k]:.8g}")
        (self.folder / "rig").mkdir(exist_ok=True)
        self.write("rig/main.csv", "\n".join(lines) + "\n")
        self.write("rig/pots.csv", "time,Damper Pot\ns,mm\n" + "".join(
            f"{k / RATE:.4f},{1e3 * s - 4:.7g}\n" for k, s in enumerate(column["s_strut"])))

    def test_writes_what_a_recording_needs_so_that_it_fits_without_edits(self):
        both = ("    time: Zeit\n", "    with: [../rig/pots.csv]  # recorded over the same time",
                "not used: pots.csv: recorded beside main.csv")
        for lost, jitter_s, drift, lines in (
                ((900, 901, 1700), 0, 0.05, ("    bridge: ", "# 2 gaps, the longest ",
                                             "a_body: {channel: Chassis Acc, trend: remove}")),
                ((), 0.0001, 0, ("    resample: ", " Hz  # steps differ by ",
                                 "    noise:  # standard deviations at rest", "\n      a_body: "))):
            with self.subTest(jitter_s=jitter_s):
                name = f"{len(lost)}"
                self.sweep_of_two_recorders(lost, jitter_s, drift)
                self.run_program("init", name, "--from", "rig", "--vehicle", "car.urdf")
                text = (self.folder / name / "study.yaml").read_text()
                for line in both + lines:
                    self.assertIn(line, text)
                self.run_program("fit", f"{name}/study.yaml", "-o", f"run{name}", "--no-suggest")
                for parameter in json.loads((self.folder / f"run{name}/result.json").read_text())["parameters"]:
                    # The car is the one that was simulated, with noise of 0.1 %.
                    self.assertLess(abs(parameter["value"] / parameter["start"] - 1), 0.05, parameter["name"])

    def test_takes_what_is_let_go_and_what_is_driven(self):
        release = "t,s_strut,a_body\ns,mm,m/s^2\n" + "".join(
            f"{k / RATE:.4f},{50 * math.exp(-2 * k / RATE) * math.cos(8 * k / RATE):.5f},"
            f"{-2 * math.exp(-2 * k / RATE) * math.cos(8 * k / RATE + 0.3):.5f}\n" for k in range(4 * RATE))
        self.write("drop.csv", release)
        self.run_program("init", "drop", "--from", "drop.csv", "--vehicle", "car.urdf")
        self.assertIn("    release: estimated  # look at", (self.folder / "drop/study.yaml").read_text())
        text = (self.folder / "car.urdf").read_text()
        ends = text.split("<fp:damper ")[1].split(">")[0].split("parent=")[1].rstrip("/")
        self.write("active.urdf", text.replace("<fp:post", f'<fp:actuator name="actuator" parent={ends}/>\n  <fp:post', 1))
        self.write("active.csv", "t,Actuator Force,a_body\ns,lbf,g\n" + "".join(
            f"{k / RATE:.4f},{60 * math.sin(0.02 * k):.5f},{0.1 * math.sin(0.02 * k + 0.2):.5f}\n" for k in range(4 * RATE)))
        self.run_program("init", "active", "--from", "active.csv", "--vehicle", "active.urdf")
        self.assertIn("    actuators: {actuator: Actuator Force}  # look at", (self.folder / "active/study.yaml").read_text())

    def test_finds_when_a_vehicle_is_let_go_and_which_post_is_which(self):
        """Two drops of one recording, held until 1.5 s and, lifted from 6 to 7 s, until 9 s; and a post by an option."""
        def height(t):
            after = t - (9 if t >= 6 else 1.5)
            held = 30 * min(1, t - 6) if t >= 6 else 50
            return held if after < 0 else held * math.exp(-5 * after) * math.cos(8 * after)

        noise = [1e-3 * (k * 7919 % 13 - 6) for k in range(13)]
        self.write("drops.csv", "t,s_strut,a_body\ns,mm,m/s^2\n" + "".join(
            f"{k / RATE:.4f},{height(k / RATE) + noise[k % 13]:.5f},"
            f"{(0 if k < 300 or 1000 <= k < 1800 else -0.09 * height(k / RATE)) + noise[k * 3 % 13]:.5f}\n"
            for k in range(14 * RATE)))
        self.run_program("init", "drops", "--from", "drops.csv", "--vehicle", "car.urdf")
        text = (self.folder / "drops/study.yaml").read_text()
        for line in ("name: drops_1", "name: drops_2", "start: 1.5 s", "start: 9 s", "{s_strut: 50 mm}", "{s_strut: 30 mm}"):
            self.assertIn(line, text)
        self.assertEqual(text.count("release: at rest"), 2)
        self.assertNotIn("trend", text)
        self.assertNotIn("drifts", self.run_program("info", "drops.csv").stdout)
        self.write("lost.csv", renamed((self.folder / "dwells.csv").read_text()).replace("Actuator pos", "xyz"))
        words = ("init", "lost", "--from", "lost.csv", "--vehicle", "car.urdf", "--post")
        self.assert_finding(self.run_program(*words, "xyz=FL", code=2).stderr, "sine-post-unknown")
        self.assert_finding(self.run_program(*words, "xya=post", code=2).stderr, "response-post-missing")
        self.assert_finding(self.run_program(*words, "xyz", code=2).stderr, "post-channel-malformed")
        self.run_program(*words, "xyz=post")
        self.assertIn("post_channels: {post: xyz}\n", (self.folder / "lost/study.yaml").read_text())

    def test_takes_a_damper_from_its_bench(self):
        damper = SOURCE / "studies/damper"
        rows = (damper / "sine_5Hz_3mm.csv").read_text().splitlines()
        names = rows[0].replace("displacement", "Stroke").replace("force", "Rod load")
        self.write("bench.csv", "\n".join([names] + rows[1:]) + "\n")
        self.run_program("init", "study", "--from", "bench.csv", "--vehicle", damper / "model2.urdf")
        text = (self.folder / "study/study.yaml").read_text()
        self.assertIn("bench:\n  displacement: Stroke\n  force: Rod load\n  recordings:\n    - ../bench.csv\n", text)
        self.run_program("response", "study/study.yaml")

    def test_takes_files_of_a_bench_as_they_are(self):
        """No units, a hole, and a second file whose columns are called otherwise."""
        damper = SOURCE / "studies/damper"
        rows = (damper / "sine_5Hz_3mm.csv").read_text().splitlines()
        bare = [f"{1e3 * float(t):.0f},{rest}" for t, rest in (row.split(",", 1) for row in rows[2:])]
        # Rows are lost, and fields.
        bare = bare[:98] + bare[106:150] + [row.rsplit(",", 1)[0] + "," for row in bare[150:154]] + bare[154:]
        self.write("bare.csv", "\n".join(["t,dist,forc"] + bare) + "\n")
        self.write("other.csv", "\n".join([rows[0].replace("force", "F rod")] + rows[1:]) + "\n")
        files = ("--from", "bare.csv", "other.csv", "--vehicle", damper / "model2.urdf")
        self.assertIn("without a unit: dist, forc, which --unit states, as --unit dist=mm",
                      self.run_program("init", "none", "--from", "bare.csv", "--vehicle", damper / "model2.urdf",
                                       code=3).stderr)
        units = [part for unit in ("t=ms", "dist=m", "forc=N") for part in ("--unit", unit)]
        self.assertIn("response-unit-of-none", self.run_program("init", "none", *files, "--unit", "forse=N", code=2).stderr)
        self.assertFalse((self.folder / "none").exists())
        self.run_program("init", "study", *files, *units)
        text = (self.folder / "study/study.yaml").read_text()
        self.assertIn("bench:\n  displacement: {channel: dist, unit: m}\n  force: {channel: forc, unit: N}\n"
                      "  recordings:\n    - file: ../bare.csv\n", text)
        self.assertIn("      time: {channel: t, unit: ms}\n      bridge: 19 ms  # 2 gaps, the longest 18 ms\n"
                      "    - file: ../other.csv\n      displacement: displacement\n      force: F rod\n", text)
        self.run_program("response", "study/study.yaml")
        # What the study says of a file holds for its prediction, and a new file with the same columns is read alike.
        self.run_program("fit", "study/study.yaml", "-o", "run", "--no-suggest")
        (self.folder / "new.csv").write_text((self.folder / "other.csv").read_text())
        for file, preparation in (("bare.csv", "bridged"), ("new.csv", "")):
            predicted = json.loads(self.run_program("predict", "run", "--recording", file, "--json").stdout)
            self.assertIn(preparation, str(predicted["integration"][0].get("preparation", "")))


class ShortStudies(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_program("init", "car")
        self.study = (self.folder / "car/study.yaml").read_text()

    def fit(self, lines, *options, code=0):
        self.write("car/changed.yaml", self.study + lines)
        outcome = self.run_program("fit", "car/changed.yaml", "-o", "run", "--json", *options, code=code)
        return outcome if code else {p["name"]: p for p in json.loads(outcome.stdout)["parameters"]}

    def test_free_all_but_some(self):
        self.study = "\n".join(line for line in self.study.splitlines() if not line.startswith("free:")) + "\n"
        all_of_them = set(self.fit(""))
        some = sorted(all_of_them)[0]
        self.assertEqual(set(self.fit(f"free: all but [{some}]\n")), all_of_them - {some})
        self.assert_finding(self.fit("free: all but [nonsense]\n", code=3).stderr, "free-unknown")
        self.assert_finding(self.fit("free: most\n", code=3).stderr, "free-not-names")

    def test_start_values_of_study_and_option(self):
        self.study = "\n".join(line for line in self.study.splitlines() if not line.startswith("free:")) + "\n"
        parameters = json.loads(self.run_program("params", "car/vehicle.urdf", "--json").stdout)["parameters"]
        stiff = next(p for p in parameters if p["name"] == "k")
        start = 0.9 * stiff["value"] + 0.1 * stiff["lower"]
        found = self.fit(f"start: {{k: {start} N/m}}\n")
        self.assertAlmostEqual(found["k"]["start"], start, 6)
        # Held at it, the fitted vehicle has it too.
        self.fit("free: all but [k]\n", "--set", f"k={start}N/m")
        held = json.loads(self.run_program("params", "run/vehicle.urdf", "--json").stdout)["parameters"]
        self.assertAlmostEqual(next(p for p in held if p["name"] == "k")["value"], start, 6)
        fault = self.fit("start: {k: 3 kg}\n", code=3).stderr
        self.assert_finding(fault, "setting-unit", "car/changed.yaml:")
        self.assert_finding(self.fit("start: 3\n", code=3).stderr, "start-not-mapped")

    def test_check_with_other_values(self):
        check = lambda *options: json.loads(self.run_program("check", "car/vehicle.urdf", "--json", *options).stdout)
        self.assertNotEqual(check()["modes"], check("--set", "k=30kN/m")["modes"])
        self.assert_finding(self.run_program("check", "car/vehicle.urdf", "--set", "nonsense=3", code=2).stderr,
                            "option-parameter")


class Preparation(ProgramTest):
    """A history that was spoilt in a known way is read as before."""

    def setUp(self):
        super().setUp()
        self.copy("meshes")
        self.write("car.urdf", (SOURCE / "studies/starter/vehicle.urdf").read_text())
        self.run_program("simulate", "car.urdf", "--sweep", "1Hz:8Hz", "--duration", "20s", "--rate", "400Hz",
                         "--engine", "reduced", "-o", "good.csv")
        rows = list(csv.reader((self.folder / "good.csv").read_text().splitlines()))
        self.names, self.units = rows[0], rows[1]
        self.rows = [[float(field) for field in row] for row in rows[2:]]
        self.post = self.names.index("post_post")

    def save(self, name, rows, names=None, units=None):
        lines = [names or self.names, units or self.units]
        lines += [["" if value is None else f"{value:.12g}" for value in row] for row in rows]
        self.write(name, "\n".join(",".join(line) for line in lines) + "\n")

    def errors(self, keys, code=0):
        """NMSE of each channel of a vehicle that is the simulated one."""
        self.write("study.yaml", f"vehicle: car.urdf\nhistories:\n  - {{{keys}}}\n")
        outcome = self.run_program("response", "study.yaml", "--engine", "reduced", "--json", code=code)
        if code:
            return outcome.stderr
        return {channel["name"]: channel["nmse_percent"] for channel in json.loads(outcome.stdout)["channels"]}

    def assert_as_good(self, keys, limit=0.01):
        for name, error in self.errors(keys).items():
            self.assertLess(error, limit, name)

    def test_of_nothing_changes_nothing(self):
        # Simulation at its own error, 0.1 % rms.
        self.assert_as_good("file: good.csv")

    def test_bridges_gaps_and_evens_times(self):
        spoilt = [list(row) for k, row in enumerate(self.rows) if not 3000 <= k < 3006]
        for k, row in enumerate(spoilt):
            row[0] += 2e-4 * math.sin(k)
        # The channels go with the times they were sampled at.
        column = self.names.index("a_body") if "a_body" in self.names else 2
        spoilt[1000][column] = None
        self.save("spoilt.csv", spoilt)
        faults = self.errors("file: spoilt.csv", code=3)
        self.assert_finding(faults, "time-step-uneven")
        self.assert_finding(faults, "sample-missing")
        # Jitter of 0.2 ms that is not in the samples is 0.01 of a period at 8 Hz, 0.25 % of their squares at the most.
        self.assert_as_good("file: spoilt.csv, resample: 400 Hz, bridge: 20 ms", 0.3)
        self.assert_finding(self.errors("file: spoilt.csv, resample: 400 Hz, bridge: 10 ms", code=3), "gap-not-bridged")
        self.assert_finding(self.errors("file: good.csv, resample: 100 Hz", code=3), "resampled-below")

    def test_integrates_a_post_that_was_recorded_as_velocity(self):
        heights = [row[self.post] for row in self.rows]
        speed = [0.0] + [400 * (b - a) / 2 for a, b in zip(heights, heights[2:])] + [0.0]
        self.save("speed.csv", [[*row, v + 0.01] for row, v in zip(self.rows, speed)], self.names + ["v"], self.units + ["m/s"])
        self.assert_finding(self.errors("file: speed.csv, posts: {post: v}", code=3), "unit-of-other-dimension")
        # Central differences are off by (w h)^2 / 6 = 0.26 % at 8 Hz; the high-pass leaves 1/17 of a sine of twice its
        # frequency, 0.004 at four times.
        self.assert_as_good("file: speed.csv, posts: {post: {channel: v, integrate: 0.1 Hz}}", 0.1)
        self.assert_finding(self.errors("file: good.csv, posts: {post: {channel: post_post, integrate: 0.1 Hz}}", code=3),
                            "nothing-to-integrate")

    def test_joins_files_of_one_clock(self):
        some = self.names[:3]
        self.save("one.csv", [row[:3] for row in self.rows], some, self.units[:3])
        # Another recorder: half its rate, begun later, its clock 12 ms ahead.
        self.save("two.csv", [[row[0] + 0.012, *row[3:]] for row in self.rows[101::2]],
                  ["time"] + self.names[3:], ["s"] + self.units[3:])
        joined = "file: one.csv, with: [{file: two.csv, delay: 12 ms}]"
        self.assertEqual(set(self.errors(joined)), set(self.errors("file: good.csv")))
        self.assert_as_good(joined, 0.05)
        self.assertGreater(max(self.errors("file: one.csv, with: [two.csv]").values()), 0.5)

    def test_finds_that_another_recorder_is_3_ms_ahead(self):
        self.save("one.csv", [row[:3] for row in self.rows], self.names[:3], self.units[:3])
        self.save("two.csv", [[row[0] + 0.003, *row[3:]] for row in self.rows[::2]],
                  ["time"] + self.names[3:], ["s"] + self.units[3:])
        late = self.errors("file: one.csv, with: [two.csv]")
        stated = self.errors("file: one.csv, with: [{file: two.csv, delay: 3 ms}]")
        self.assertLess(max(stated.values()), 0.05)
        self.assertGreater(max(late.values()), 20 * max(stated.values()))
        # The table of errors has the delay at which each channel would agree best.
        self.write("study.yaml", "vehicle: car.urdf\nfree: [k]\nhistories:\n  - {file: one.csv, with: [two.csv]}\n")
        outcome = self.run_program("fit", "study.yaml", "-o", "run", "--no-suggest", "--json")
        for channel in json.loads(outcome.stdout)["channels"]:
            # k takes over a part of it.
            self.assertAlmostEqual(channel["delay_s"], 0.003 if channel["name"] in self.names[3:] else 0, delta=0.001)

    def test_says_in_the_result_what_was_done(self):
        self.write("study.yaml", "vehicle: car.urdf\nfree: [k]\nhistories:\n  - {file: good.csv, start: 2 s, "
                   "end: 18 s, resample: 400 Hz, channels: {s_strut: {channel: s_strut, trend: remove, delay: 1 ms}}}\n")
        self.run_program("fit", "study.yaml", "-o", "run", "--no-suggest")
        done = json.loads((self.folder / "run/result.json").read_text())["histories"][0]["preparation"]
        self.assertEqual(done, ["resampled to 400 Hz", "s_strut: trend taken away", "s_strut: delay of 1 ms taken back",
                                "cut to 2 .. 18 s"])

    def test_names_all_clipped_channels_at_once(self):
        clipped = [list(row) for row in self.rows]
        for column in range(2, len(self.names)):
            most = 0.7 * max(row[column] for row in clipped)
            for row in clipped:
                row[column] = min(row[column], most)
        self.save("clipped.csv", clipped)
        self.write("study.yaml", "vehicle: car.urdf\nhistories:\n  - {file: clipped.csv}\n  - {file: good.csv}\n")
        printed = self.run_program("response", "study.yaml", "--engine", "reduced").stderr
        lines = [line for line in printed.splitlines() if line.endswith("[samples-saturated]")]
        self.assertEqual(len(lines), 1, printed)
        for name in self.names[2:]:
            self.assertIn(f"'{name}'", lines[0])

    def test_takes_offset_and_trend_away(self):
        drifting = [list(row) for row in self.rows]
        strut = self.names.index("s_strut")
        for row in drifting:
            row[strut] += 0.003 + 0.0005 * row[0]
        self.save("drifting.csv", drifting)
        before = self.errors("file: drifting.csv")["s_strut"]
        keys = "file: drifting.csv, channels: {{s_strut: {{channel: s_strut, {}}}, others: by name}}"
        after = self.errors(keys.format("trend: remove"))["s_strut"]
        # The sweep has a slope of its own, of some thousandths of its size.
        self.assertLess(after, 0.02 * before)
        self.assertLess(self.errors(keys.format("high_pass: 0.1 Hz"))["s_strut"], 0.05 * before)
        self.assertAlmostEqual(self.errors(keys.format("offset: 3 mm"))["s_strut"], before, 6)
        self.assert_finding(self.errors(keys.format("offset: 3 N"), code=3), "offset-dimension")
        self.assert_finding(self.errors(keys.format("trend: keep"), code=3), "channel-trend")


if __name__ == "__main__":
    unittest.main()
