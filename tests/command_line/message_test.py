"""What is wrong with inputs is told with what to do; nothing that was there is lost."""
import json
import resource
import shutil
import subprocess
import unittest

from program import FOURPOST, SOURCE, FittedStarter, ProgramTest


def paths(value, path=()):
    """Of everything in a JSON document; of a list its first entry."""
    entries = value.items() if isinstance(value, dict) else list(enumerate(value))[:1] if isinstance(value, list) else ()
    for key, entry in entries:
        yield (*path, key)
        yield from paths(entry, (*path, key))


def at(document, path):
    for key in path:
        document = document[key]
    return document


class Report(FittedStarter):
    def setUp(self):
        super().setUp()
        self.result = (self.folder / "run/result.json").read_text()

    def test_takes_results_of_another_version(self):
        """Each entry in turn is missing or of another kind: what is left is reported, or the reason is told."""
        for number, path in enumerate(paths(json.loads(self.result))):
            # One of six for each entry: all of them would take minutes.
            other = ("gone", None, "text", 7, [], {})[number % 6]
            document = json.loads(self.result)
            parent = at(document, path[:-1])
            if other == "gone":
                del parent[path[-1]]
            else:
                parent[path[-1]] = other
            self.write("run/result.json", json.dumps(document))
            outcome = subprocess.run([FOURPOST, "report", "run"], cwd=self.folder, capture_output=True, text=True)
            self.assertIn(outcome.returncode, (0, 3), f"{path}: {other}: {outcome.stderr}")

    def test_tells_an_empty_run_and_one_that_was_killed(self):
        (self.folder / "empty").mkdir()
        for folder, finding in (("empty", "run-empty"), ("car", "run-not-fitted")):
            text = self.run_program("report", folder, code=3).stderr
            self.assertTrue(text.startswith(f"{folder}: error: "), text)
            self.assertTrue(text.endswith(f" [{finding}]\n"), text)
            self.assertNotIn("archive", text)
        self.assertIn("`fourpost fit car/study.yaml -o run`", text)
        (self.folder / "run/result.json").unlink()
        self.assertIn("[run-unfinished]", self.run_program("report", "run", code=3).stderr)
        (self.folder / "run/archive.sqlite").unlink()
        self.assertIn("[run-without-result]", self.run_program("report", "run", code=3).stderr)
        self.write("run/result.json", "")
        self.assertIn("[result-not-json]", self.run_program("report", "run", code=3).stderr)

    def test_names_the_file_that_is_damaged_and_its_remedy(self):
        self.run_program("fit", "car/study.yaml", "-o", "other")
        whole = (self.folder / "run/response.csv").read_text()
        self.write("run/response.csv", whole[:len(whole) // 2])
        for words in (("run",), ("run", "other", "-o", "both.html")):
            self.assertRegex(self.run_program("report", *words, code=3).stderr,
                             r"^run/response.csv: error: .*\[run-file-damaged\]\n"
                             r"run/response.csv:\d+: error: the row has \d+ fields?, the header \d+")

    def test_compares_no_run_with_itself(self):
        for command in (["report", "run", "run/", "-o", "both.html"], ["rank", "run", "run"]):
            self.assertIn("[run-named-twice]", self.run_program(*command, code=3).stderr)
        self.assertFalse((self.folder / "both.html").exists())

    def test_predicts_nothing_for_a_run_without_its_result(self):
        def refused():
            return self.run_program("predict", "run", "--recording", "car/stepped_sine.csv", code=3).stderr

        for damage, fault in (("", "[result-not-json]"), ("{}", "[result-not-of-fit]")):
            self.write("run/result.json", damage)
            self.assertIn(fault, refused())
        (self.folder / "run/result.json").unlink()
        self.assertRegex(refused(), r"^run: error: .*\[run-unfinished\]")

    def test_keeps_the_old_one_when_the_disk_is_full(self):
        before = (self.folder / "run/report.html").read_bytes()
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000))
        outcome = self.run_program("report", "run", code=5, preexec_fn=limit)
        self.assertIn("[disk-full]", outcome.stderr)
        self.assertEqual((self.folder / "run/report.html").read_bytes(), before)
        self.assertEqual([file.name for file in (self.folder / "run").glob("*.partial")], [])

    def test_thins_out_a_giant_recording_and_says_so(self):
        self.run_program("fit", SOURCE / "studies/single_wheel_station/model1.yaml", "-o", "big", "--no-suggest")
        head, units, *rows = (self.folder / "big/history.csv").read_text().splitlines()
        times = head.split(",").index("time")
        step = float(rows[1].split(",")[times]) - float(rows[0].split(",")[times])
        many = []
        for k in range(200000):
            fields = rows[k % len(rows)].split(",")
            fields[times] = f"{k * step:.6f}"
            many.append(",".join(fields))
        self.write("big/history.csv", "\n".join([head, units, *many]) + "\n")
        self.run_program("report", "big")
        page = (self.folder / "big/report.html").read_text()
        self.assertLess(len(page), 4e6)
        self.assertIn('"rows":200000', page)


class Outputs(FittedStarter):
    """No command writes over another one's results, nor over what a user has."""

    def content(self):
        return {file: file.read_bytes() for file in self.folder.rglob("*") if file.is_file()}

    def test_folders_are_of_one_command_s_results(self):
        commands = {"fit": ("fit", "car/study.yaml"), "modes": ("modes", "car/vehicle.urdf"),
                    "kinematics": ("kinematics", "car/vehicle.urdf"),
                    "response": ("response", "car/vehicle.urdf", "--engine", "reduced"),
                    "predict": ("predict", "run", "--recording", "car/stepped_sine.csv")}
        folders = {"fit": "run", "modes": "modes", "kinematics": "kinematics", "response": "response",
                   "predict": "predicted"}
        for kind, command in commands.items():
            self.run_program(*command, "-o", folders[kind])
        # Over results of its own a command writes, be they of a study.
        self.run_program("response", "car/study.yaml", "-o", "response")
        for command in commands.values():
            self.run_program(*command, "-o", folders[command[0]])
        before = self.content()
        for command in commands.values():
            for kind, folder in folders.items():
                if kind == command[0] or (command[0] == "predict" and folder == "run"):
                    continue
                with self.subTest(f"{command[0]} over {kind}"):
                    text = self.run_program(*command, "-o", folder, code=5).stderr
                    self.assert_finding(text, "folder-of-other-result", f"{folder}:")
                    self.assertIn(f"`fourpost {kind}`", text)
        self.write("modes/result.json", "[1]")
        self.assert_finding(self.run_program(*commands["modes"], "-o", "modes", code=5).stderr,
                            "folder-of-foreign-result", "modes:")
        self.write("modes/result.json", before[self.folder / "modes/result.json"])
        self.assertEqual(self.content(), before)

    def test_a_fit_goes_over_its_own_damaged_result(self):
        self.write("run/result.json", "{")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        self.run_program("report", "run")

    def test_files_end_as_what_they_hold(self):
        self.run_program("init", "other")
        before = self.content()
        simulate = ("simulate", "car/vehicle.urdf", "--step", "5mm")
        compare = ("compare", "car/study.yaml", "--runs", "1", "--evaluations", "10")
        for command, file, like in ((compare, "car/stepped_sine.csv", "car/stepped_sine.html"),
                                    (compare, "run/result.json", "run/result.html"),
                                    (("report", "run"), "car/study.yaml", "car/study.html"),
                                    (simulate, "run/result.json", "run/result.csv")):
            with self.subTest(f"{command[0]} {file}"):
                text = self.run_program(*command, "-o", file, code=2).stderr
                self.assertIn(f"--output: error: '{file}': ", text)
                self.assertIn(f"'{like}' [output-ending]", text)
        for command, file in ((compare, "car/study.yaml"), (("report", "run"), "run/result.json"),
                              (simulate, "car/vehicle.urdf")):
            with self.subTest(f"{command[0]} {file}"):
                self.assertIn("[output-is-input]", self.run_program(*command, "-o", file, code=5).stderr)
        self.assertEqual(self.content(), before)


class Misspelt(ProgramTest):
    def test_files_are_guessed(self):
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        self.write("car/run.mat", "")
        for words, near in ((("info", "car/steped_sine.csv"), "car/stepped_sine.csv"),
                            (("info", "car/rum.mat"), "car/run.mat"),
                            (("check", "car/vehicel.urdf"), "car/vehicle.urdf"),
                            (("fit", "car/studdy.yaml", "-o", "other"), "car/study.yaml"),
                            (("predict", "run", "--recording", "car/steppedsine.csv"), "car/stepped_sine.csv"),
                            (("report", "runn"), "run"), (("report", "runn/"), "run")):
            with self.subTest(words):
                text = self.run_program(*words, code=3).stderr
                self.assertIn(f", did you mean '{near}'?", text)
                self.assert_finding(text, "run-not-there" if words[0] == "report" else "file-not-there")
        study = self.folder / "car/study.yaml"
        study.write_text(study.read_text().replace("stepped_sine.csv", "steped_sine.csv"))
        self.assertRegex(self.run_program("fit", "car/study.yaml", "-o", "other", code=3).stderr,
                         r"steped_sine.csv does not exist, did you mean '\S*car/stepped_sine.csv'\?")
        # None is near.
        self.assertNotIn("did you mean", self.run_program("info", "car/landrover.csv", code=3).stderr)

    def test_a_wrong_value_stands_behind_its_option(self):
        for words, place in ((("fit", "study.yaml", "-o", "run", "--threads", "5000"), "--threads: error: "),
                             (("compare", "study.yaml", "--runs", "none"), "--runs: error: ")):
            with self.subTest(words):
                self.assert_finding(self.run_program(*words, code=2).stderr, "usage", place)

    def test_parameters_are_told(self):
        self.run_program("init", "car")
        vehicle = self.folder / "car/vehicle.urdf"
        vehicle.write_text(vehicle.read_text().replace('"$k"', '"$kq"'))
        self.assertIn("refers to an unknown parameter 'kq'; there are m_body, m_wheel, k, kt, c_bump, c_rebound",
                      self.run_program("check", "car/vehicle.urdf", code=3).stderr)


class FullDisk(ProgramTest):
    def test_init_leaves_nothing(self):
        """There is room for the vehicle and not for the recording, or for nothing."""
        (self.folder / "empty").mkdir()
        for room in (0, 4000):
            limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))
            for folder in ("empty", "some/new", "new/"):
                with self.subTest(f"{folder}, {room} bytes"):
                    text = self.run_program("init", folder, code=5, preexec_fn=limit).stderr
                    self.assertIn(": free some space, or name another folder [disk-full]", text)
                    self.assertEqual(list(self.folder.rglob("*")), [self.folder / "empty"])
        self.run_program("init", "empty")

    def test_is_told_before_any_work(self):
        self.run_program("init", "car")
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
        text = self.run_program("modes", "car/vehicle.urdf", "-o", "modes", code=5, preexec_fn=limit).stderr
        self.assert_finding(text, "disk-full", "modes:")


class RefusedFit(ProgramTest):
    """Of masses and rates without a force, which are known to a common factor only."""

    def setUp(self):
        super().setUp()
        self.run_program("init", "car")
        study = self.folder / "car/study.yaml"
        study.write_text(study.read_text().replace("  F_tyre: F_tyre", "  #"))

    def fit(self, *words, code=3):
        return self.run_program("fit", "car/study.yaml", *words, code=code).stderr

    def test_leaves_no_folder_that_was_not_there(self):
        text = self.fit("-o", "runs/first")
        self.assert_finding(text, "scale-unidentified")
        self.assertNotIn("[scale-not-measured]", text)
        self.assertFalse((self.folder / "runs").exists())
        (self.folder / "empty").mkdir()
        self.fit("-o", "empty")
        self.assertEqual(list((self.folder / "empty").iterdir()), [])
        self.assertIn("frees no parameter 'kx'; there are all, m_body, m_wheel, k, kt, c_bump, c_rebound",
                      self.fit("-o", "other", "--profile", "kx", code=2))
        self.assertFalse((self.folder / "other").exists())

    def test_keeps_what_an_earlier_one_paid_for(self):
        self.fit("-o", "run", "--accept-unidentified", code=0)
        before = {file.name for file in (self.folder / "run").iterdir()}
        self.fit("-o", "run")
        self.assertEqual({file.name for file in (self.folder / "run").iterdir()}, before)
        self.assertRegex(self.fit("-o", "run", "--accept-unidentified", code=0),
                         r"([0-9]+) of \1 evaluations come from run/archive.sqlite")


class Validation(ProgramTest):
    def test_a_fit_is_kept_whose_vehicle_cannot_go_through_it(self):
        self.copy("studies/single_wheel_station", "meshes")
        folder = self.folder / "studies/single_wheel_station"
        text = (folder / "model1.yaml").read_text()
        lines = text[text.index("  - file:"):text.index("    # What all")]
        # Posts that go to the moon.
        lines = lines.replace("sweep_12mm", "sweep_7mm").replace(
            "{ground: z_ground}", "{ground: {channel: z_ground, scale: 1e9}}\n    use: validation")
        self.assertIn("evaluations: 60", text)
        text = text.replace("evaluations: 60", "evaluations: 5")
        (folder / "study.yaml").write_text(text.replace("\nsearch:", lines + "\nsearch:"))
        outcome = self.run_program("fit", folder / "study.yaml", "-o", "run", "--no-suggest")
        result = json.loads((self.folder / "run/result.json").read_text())
        for kind in ("validation-left-out", "history-not-predicted"):
            self.assertRegex(outcome.stderr, f"'sweep_7mm.*\\[{kind}\\]")
        warnings = {one["id"]: one["text"] for one in result["warnings"]}
        self.assertIn("sweep_7mm", warnings["validation-left-out"])
        self.assertRegex(warnings["history-not-predicted"], "sweep_7mm.* t = 0.0[0-9]* s")
        self.assertEqual(result["termination"], "converged")
        self.assertNotIn("validation", result)
        self.assertEqual([one["recording"] for one in result["validation_left_out"]], ["sweep_7mm"])
        self.assertNotIn("Not fitted:", outcome.stdout)
        names = {file.name for file in (self.folder / "run").iterdir()}
        self.assertTrue({"history.csv", "motion.csv", "report.html"} < names)
        self.assertNotIn("validation.csv", names)


class Data(ProgramTest):
    """A recording of a damper as another system wrote it gives the same result, or a message that helps."""

    def fit(self, text, bench, code=0, name="r.csv"):
        shutil.copy(SOURCE / "studies/damper/model2.urdf", self.folder / "damper.urdf")
        self.write(name, text)
        self.write("study.yaml", f"vehicle: damper.urdf\nbench:\n  recordings: [{name}]\n  {bench}\n"
                                 "search: {evaluations: 20, starts: 1}\n")
        outcome = self.run_program("fit", "study.yaml", "-o", "run", code=code)
        if code:
            return outcome.stderr
        return [p["value"] for p in json.loads((self.folder / "run/result.json").read_text())["parameters"]]

    def test_is_fitted_from_every_dialect(self):
        plain = (SOURCE / "studies/damper/sine_1Hz_5mm.csv").read_text()
        expected = self.fit(plain, "damper: damper")
        head, units, *rows = plain.splitlines()
        fields = [row.split(",") for row in rows]
        german = "\r\n".join([head.replace(",", ";"), units.replace(",", ";"),
                              *(";".join(row).replace(".", ",") for row in fields)])
        behind = "\n".join(["Time (s)\tWeg [mm]\tKraft / kN",
                            *("\t".join((t, repr(1e3 * float(x)), repr(1e-3 * float(f)))) for t, x, f in fields)])
        turned = "\n".join(["clock,ch1,ch2", *(f"{t},{-float(x)!r},{0.5 * float(f)!r}" for t, x, f in fields)])
        for name, text, bench in (
                ("german", "\ufeff" + german, "damper: damper"),
                ("behind", behind, "displacement: Weg\n  force: Kraft"),
                ("turned", turned, "time: {channel: clock, unit: s}\n"
                                   "  displacement: {channel: ch1, unit: m, sign: -1}\n"
                                   "  force: {channel: ch2, unit: N, scale: 2}")):
            with self.subTest(name):
                for value, other in zip(expected, self.fit(text, bench)):
                    self.assertLess(abs(value - other), 1e-6 * abs(value))

    def test_is_told_what_it_lacks(self):
        rows = "".join(f"{k * 0.01:.2f};{k % 7};{k % 5}\n" for k in range(50))
        for text, bench, place, finding, words in (
                ("time;displacement;force\n" + rows, "damper: damper",
                 "r.csv:1:", "unit-missing", "force"),
                ("time;displacement;force\ns;V;N\n" + rows, "damper: damper",
                 "r.csv:2:", "unit-of-other-dimension", "the damper's extension"),
                ("time;displacment;force\ns;m;N\n" + rows, "damper: damper",
                 "r.csv", "channel-column-missing", "did you mean 'displacment'?"),
                ("time;displacement;force\ns;m;N\n" + rows.replace("0.07;0;2", "0.07;;2"), "damper: damper",
                 "r.csv:10:", "sample-missing", "displacement"),
                ("time;displacement;force\ns;m;N\n" + rows, "force: {channel: force, scale: 0}",
                 "study.yaml:4:", "channel-scale", "force")):
            with self.subTest(finding):
                message = self.fit(text, bench, code=3)
                self.assert_finding(message, finding, place)
                self.assertIn(words, message)


if __name__ == "__main__":
    unittest.main()
