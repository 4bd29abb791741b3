"""What `fourpost suggest` names first is what was planted; its files can be fitted; a fit grows by it."""
import csv
import json
import math
import random
import re
import signal
import statistics
import subprocess
import sys
import unittest

import jsonschema

from program import FOURPOST, SOURCE, ProgramTest, add_noise

sys.path.insert(0, str(SOURCE / "tests/validation"))
import random_stations  # noqa: E402
import suggest  # noqa: E402

SCHEMA = json.loads((SOURCE / "identify/command_line/schema/suggest.json").read_text())
CAR = "quarter_car"
FRICTION = ("friction", CAR, suggest.friction("damper", 40), None, "friction", {"damper"}, [])
CLEAN = ("none", CAR, lambda text: text, None, "", set(), [])


class Suggest(ProgramTest):
    def record(self, case):
        suggest.four_post(FOURPOST, self.folder, case, random.Random(1))

    def fit(self, study, folder, *more, code=0):
        self.run_program("fit", study, "-o", folder, "--threads", "1", "--accept-implausible", *more, code=code)

    def missing(self):
        return json.loads((self.folder / "run/result.json").read_text())["missing"]

    def suggested(self, *more):
        text = self.run_program("suggest", "run", "--study", "study.yaml", "--json", *more).stdout
        document = json.loads(text)
        jsonschema.Draft202012Validator(SCHEMA).validate(document)
        return document

    def test_names_planted_friction(self):
        self.record(FRICTION)
        self.fit("study.yaml", "run")
        before = self.suggested("--apply", "1", "-o", "with_friction")
        first = before["suggestions"][0]
        # The fit has named it as well.
        self.assertEqual(self.missing()["suggestions"][0], first)
        self.assertIn("What is missing", (self.folder / "run/report.html").read_text())
        self.assertEqual((first["mechanism"], first["elements"]), ("friction", ["damper"]))
        # A few steps of Gauss and Newton from a model without it do not reach the optimum.
        self.assertAlmostEqual(first["parameters"][0]["value"], 40, delta=15)
        self.fit("with_friction/study.yaml", "run")
        after = json.loads((self.folder / "run/result.json").read_text())
        friction = next(p for p in after["parameters"] if p["name"].startswith("friction"))
        # 0.5 % of noise leave the friction to some per cent.
        self.assertAlmostEqual(friction["value"], 40, delta=2)
        self.assertLess(after["misfit"], 0.2 * before["misfit"])

    def test_intervals_reach_to_the_car_with_what_is_missing(self):
        number = 1  # friction of a guide and of the spring's ends, which Model 2 of the station lacks
        made = random_stations.drawn(random.Random(number))
        random_stations.record(FOURPOST, self.folder, made, random.Random(number))
        self.fit(random_stations.study("model2", self.folder), "run")
        result = json.loads((self.folder / "run/result.json").read_text())
        together = " ".join(result["missing"]["together"]["additions"])
        self.assertIn("elastic friction", together)
        self.assertIn("guide 'body_travel'", together)
        truth = random_stations.truth(made, "model2")
        limits = set()
        for one in result["parameters"]:
            low, high = one["interval_95"]
            self.assertTrue(low <= truth[one["name"]] <= high, one)
            limits.add(one["limited_by"])
        self.assertIn("missing: elastic friction (hysteresis) beside spring 'spring'", limits)
        # Draws reach to the same side: their means are half-way, by their own chance.
        self.run_program("draws", "run", "-n", "400", "-o", "draws.csv")
        with open(self.folder / "draws.csv", newline="") as file:
            names, _, *rows = csv.reader(file)
        covariance = result["intervals"]["covariance"]
        values = {one["name"]: one["value"] for one in result["parameters"]}
        for name, moved in zip(covariance["parameters"], covariance["moved_by_missing"]):
            logs = [math.log(float(row[names.index(name)]) / values[name]) for row in rows]
            spread = 5 * statistics.stdev(logs) / math.sqrt(len(logs))
            self.assertAlmostEqual(statistics.mean(logs), moved / 2, delta=spread, msg=name)
        # Closer to the truth than the values are: by less than half of their errors.
        moves = {move["name"]: 1 + move["percent"] / 100 for move in result["missing"]["together"]["moves"]}
        for one in result["parameters"]:
            error = abs(one["value"] / truth[one["name"]] - 1)
            if error > 0.05:
                self.assertLess(abs(one["value"] * moves[one["name"]] / truth[one["name"]] - 1), error / 2, one)

    def test_is_silent_of_a_twin(self):
        self.record(CLEAN)
        self.fit("study.yaml", "run")
        self.assertIsNone(self.missing())
        self.assertEqual(self.suggested()["suggestions"], [])
        self.assertGreater(len(self.suggested("--all")["suggestions"]), 10)
        # Each addition without an answer has its reason.
        every = self.suggested("--all")
        self.assertEqual(len(every["failures"]), every["failed"])
        for one in every["failures"]:
            self.assertTrue(one["reason"], one)
        # Nor is there one of that number.
        answer = self.run_program("suggest", "run", "--study", "study.yaml", "--apply", "9999", "-o", "new", code=2)
        self.assert_finding(answer.stderr, "suggestion-unknown")

    def test_takes_no_noise_of_posts_for_physics(self):
        """An exact model, 1 % of noise on every channel, on the posts as well."""
        self.run_program("simulate", SOURCE / "urdf/quarter_car.urdf", "--road", "C", "--speed", "50km/h", "--duration", "20s",
                         "--rate", "200Hz", "--engine", "reduced", "--seed", "7", "-o", "clean.csv")
        noise = add_noise(self.folder / "clean.csv", self.folder / "recording.csv", 0.01, seed=3)
        self.write("study.yaml", "\n".join([
            f"vehicle: {SOURCE / 'urdf/quarter_car.urdf'}", "histories:", "  - file: recording.csv",
            "    posts: {post: post_post}",
            f"    channels: {{{', '.join(f'{name}: {name}' for name in noise if name != 'post_post')}}}",
            "model_error: {history: 1 %}", "search: {evaluations: 20, starts: 1}", ""]))
        self.fit("study.yaml", "run")
        result = json.loads((self.folder / "run/result.json").read_text())
        # Noise is known to some per cent.
        self.assertAlmostEqual(result["misfit"], 1, delta=0.15)
        self.assertGreater(result["post_noise_share"], 0.5)
        self.assertIsNone(result["missing"])
        self.assertNotIn("missing", " ".join(one["limited_by"] for one in result["parameters"]))
        answer = self.run_program("suggest", "run", "--study", "study.yaml")
        self.assert_finding(answer.stderr, "suggest-post-noise", "run/result.json")

    def test_holds_what_the_study_sets(self):
        """The file has another tyre than the study states."""
        self.record(FRICTION)
        self.replace_in("vehicle.urdf", 'value="230 kN/m"', 'value="190 kN/m"')
        study = (self.folder / "study.yaml").read_text() + "free: all but [kt]\n"
        self.write("study.yaml", study + "start: {kt: 230 kN/m}\n")
        self.fit("study.yaml", "run")
        first = self.suggested("--apply", "1", "-o", "with_friction")["suggestions"][0]
        self.assertEqual(first["mechanism"], "friction")
        self.assert_tyre_is_held("with_friction/vehicle.urdf")
        # By an option as well.
        self.write("study.yaml", study)
        self.fit("study.yaml", "grown", "--grow", "--set", "kt=230kN/m")
        # Of one force and no mass that is known, another tyre and another scale of the force are the same.
        self.assertEqual(self.kept()[:2], ["", "friction"])
        self.assertIn(self.kept()[2], ["free", "scale"])
        self.assert_tyre_is_held("grown/steps/1/fit/vehicle.urdf")

    def assert_tyre_is_held(self, vehicle):
        check = json.loads(self.run_program("check", vehicle, "--json").stdout)
        self.assertEqual([one["value"] for one in check["parameters"] if one["name"] == "kt"], [230e3])

    def test_friction_of_a_damper_on_a_bench_can_be_fitted(self):
        """It is a second damper beside the one that was recorded."""
        suggest.bench(self.folder, ("", "linear", 0), random.Random(1))
        self.fit("study.yaml", "run")
        every = self.suggested("--all")["suggestions"]
        number = next(one["number"] for one in every if one["mechanism"] == "friction")
        self.suggested("--all", "--apply", number, "-o", "with_friction")
        self.fit("with_friction/study.yaml", "run2")
        result = json.loads((self.folder / "run2/result.json").read_text())
        self.assertIn("friction_damper", [one["name"] for one in result["parameters"]])

    def grown(self, name):
        return json.loads((self.folder / "grown" / name).read_text())

    def kept(self):
        return [step["mechanism"] for step in self.grown("steps/growth.json")["steps"] if step["kept"]]

    def written(self):
        """When the result of each step was written."""
        return {path.parent.parent.name: path.stat().st_mtime_ns
                for path in (self.folder / "grown/steps").glob("*/fit/result.json")}

    def grow(self, *more):
        words = "fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow"
        return self.run_program(*words, *more)

    def test_fit_grows(self):
        self.record(FRICTION)
        printed = self.grow()
        self.assertEqual(self.kept(), ["", "friction"])
        self.assertEqual(self.grown("steps/growth.json")["end"], "the stated errors explain the residuals")
        result = self.grown("result.json")
        self.assertIn("friction_damper", [p["name"] for p in result["parameters"]])
        self.assertEqual(result["growth"]["added"], ["dry friction beside damper 'damper'"])
        self.assertIs(result["growth"]["interrupted"], False)
        self.assertRegex(printed.stderr, r"(?m)^step 0 of at most 12: the study as it stands$")
        self.assertRegex(printed.stderr, r"(?m)^step 1 of at most 12, addition 1 of \d: dry friction beside damper 'damper'$")
        # Once more: nothing is fitted, and the answer is the same.
        written = self.written()
        again = self.grow()
        self.assertEqual(again.stdout, printed.stdout)
        self.assertEqual(self.written(), written)
        self.assertIn("growth had ended: the stated errors explain the residuals", again.stderr)
        self.assertNotIn("step 1 of", again.stderr)
        # Interrupted or in time, it replaces nothing by less.
        text = (self.folder / "grown/result.json").read_text()
        words = "fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow"
        program = self.start_program(*words)
        next(line for line in program.stderr if line.startswith("the last step"))
        program.send_signal(signal.SIGINT)
        program.communicate()
        self.assertEqual((self.folder / "grown/result.json").read_text(), text)
        # Of another study it begins anew.
        self.replace_in("study.yaml", "seed: 1", "seed: 2")
        first = next(line for line in self.start_program(*words).stderr if line.startswith(("step", "growth")))
        self.assertEqual(first, "step 0 of at most 12: the study as it stands\n")

    def test_growth_begins_anew_with_other_validation_data(self):
        """They decide which steps are kept."""
        self.record(FRICTION)
        name = re.search(r"file: (\S+)", (self.folder / "study.yaml").read_text()).group(1).rstrip(",}")
        self.write("kept.csv", (self.folder / name).read_text())
        self.replace_in("study.yaml", "recordings:\n",
                        "recordings:\n  - {name: kept, file: kept.csv, posts: heave, use: validation}\n")
        self.grow()
        words = "fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow"
        self.write("kept.csv", (self.folder / name).read_text() + "\n")
        first = next(line for line in self.start_program(*words).stderr if line.startswith(("step", "growth")))
        self.assertEqual(first, "step 0 of at most 12: the study as it stands\n")

    def test_growth_tries_no_refused_addition_again(self):
        self.record(FRICTION)
        self.grow()
        file = self.folder / "grown/steps/growth.json"
        path = json.loads(file.read_text())
        # As if BIC had spoken against it.
        step = path["steps"][1]
        step |= {"kept": False, "criterion_change": 4.5, "reason": "the criterion does not fall"}
        candidate = {key: step[key] for key in ("added", "mechanism", "elements", "variant", "amount", "count", "choices",
                                                "parameters", "takes_back", "folder")} | {"effective_residuals": 50.0}
        path |= {"over": False, "end": None,
                 "round": {"residuals": 100, "tried": 30, "first": 1, "candidates": [candidate]}}
        file.write_text(json.dumps(path))
        written = self.written()
        printed = self.grow().stderr
        self.assertIn("growth goes on after step 0", printed)
        self.assertNotIn("step 1 of", printed)
        self.assertEqual(self.written(), written)
        path = self.grown("steps/growth.json")
        self.assertEqual([step["kept"] for step in path["steps"]], [True, False])
        self.assertEqual(path["end"], "no suggested addition improved the fit")

    def test_growth_that_is_interrupted_goes_on_after_its_last_step(self):
        self.record(FRICTION)
        command = [FOURPOST, "fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow"]
        program = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for line in program.stderr:
            if line.startswith("step 1 of"):
                program.send_signal(signal.SIGINT)
                break
        output, errors = program.communicate()
        self.assertEqual(program.returncode, 130)
        self.assertIn("those of the last step that was kept", errors)
        self.assertEqual(errors.splitlines()[-1], "growth was interrupted after step 0; the same command goes on there")
        self.assertIn("Growth was interrupted after step 0", output)
        self.assert_finding(output, "growth-interrupted")
        result = self.grown("result.json")
        self.assertEqual(result["termination"], "converged")
        self.assertIs(result["growth"]["interrupted"], True)
        self.assertIn("growth-interrupted", [one["id"] for one in result["conclusions"]])
        self.assertTrue(all(one["interval_95"] for one in result["parameters"]))
        report = (self.folder / "grown/report.html").read_text()
        self.assertIn("Growth was interrupted after step 0", report)
        self.assertNotIn('<b class="word">Good', report)
        # Neither the first fit nor the look for additions is made again.
        before = self.written()["0"]
        printed = self.grow().stderr
        self.assertEqual(self.written()["0"], before)
        self.assertIn("growth goes on after step 0", printed)
        self.assertNotIn("step 1 of at most 12, suggest", printed)
        self.assertEqual(self.kept(), ["", "friction"])
        self.assertIs(self.grown("result.json")["growth"]["interrupted"], False)
        self.assertNotIn("Growth was interrupted", (self.folder / "grown/report.html").read_text())

    def grown_step(self, mechanism, before, study, folder):
        """Adds the first suggestion of a mechanism to a step by hand, and fits it; as steps/growth.json has it."""
        said = json.loads(self.run_program("suggest", f"grown/{before}/fit", "--study", study, "--all", "--json").stdout)
        one = next(one for one in said["suggestions"] if one["mechanism"] == mechanism)
        self.run_program("suggest", f"grown/{before}/fit", "--study", study, "--all", "--apply", one["number"],
                         "-o", f"grown/{folder}")
        # 1: of a model that is too simple.
        self.assertIn(self.fit_with_any_end(f"grown/{folder}/study.yaml", f"grown/{folder}/fit"), (0, 1))
        result = self.grown(f"{folder}/fit/result.json")
        names = [parameter["name"] for parameter in one["parameters"]]
        return {"added": one["text"], "mechanism": mechanism, "elements": one["elements"], "variant": 0,
                "amount": 1 / one["parameters"][0]["value"] if mechanism == "mount" else one["parameters"][0]["value"],
                "count": len(names), "choices": 1, "parameters": names, "takes_back": "", "folder": folder,
                "cost": result["cost"], "misfit": result["misfit"], "criterion_change": -50.0, "validation_percent": None,
                "effective_residuals": said["effective_residuals"], "residuals": said["residuals"], "tried": said["tried"],
                "at_bound": [], "kept": True, "reason": ""}

    def fit_with_any_end(self, study, folder):
        words = "fit", study, "-o", folder, "--threads", "1", "--no-suggest", "--accept-implausible", "--accept-unidentified"
        return subprocess.run([FOURPOST, *words], cwd=self.folder, capture_output=True).returncode

    def with_a_mount_before_friction(self):
        """A growth to go on with: first a mount, of which there is none, then the friction that there is."""
        self.record(FRICTION)
        self.grow()
        path = self.grown("steps/growth.json")
        mount = self.grown_step("mount", "steps/0", "study.yaml", "steps/5")
        friction = self.grown_step("friction", "steps/5", "grown/steps/5/study.yaml", "steps/6")
        path |= {"steps": [path["steps"][0], mount, friction], "round": None, "over": False}
        (self.folder / "grown/steps/growth.json").write_text(json.dumps(path))

    def test_growth_takes_back_what_has_become_worthless(self):
        self.with_a_mount_before_friction()
        printed = self.grow()
        self.assertIn("taking back elastic mount in line with damper 'damper'", printed.stderr)
        self.assertRegex(printed.stdout, r"elastic mount in line with damper 'damper' .*taken back in step 3")
        path = self.grown("steps/growth.json")
        self.assertEqual(path["added"], ["dry friction beside damper 'damper'"])
        self.assertEqual(path["taken_back"], ["elastic mount in line with damper 'damper'"])
        self.assertEqual(path["steps"][-1]["takes_back"], "steps/5")
        # No later step lies in its folder.
        self.assertEqual(path["steps"][-1]["folder"], "steps/3_without_1")
        self.assertTrue((self.folder / "grown/steps/3_without_1/study.yaml").exists())
        # No worse than with it, by BIC.
        self.assertLess(path["steps"][-1]["criterion_change"], 0)
        result = self.grown("result.json")
        self.assertEqual(result["growth"]["taken_back"], path["taken_back"])
        self.assertEqual(result["growth"]["steps"][1]["taken_back_by"], 3)
        names = [one["name"] for one in result["parameters"]]
        self.assertIn("friction_damper", names)
        self.assertNotIn("k_mount_damper", names)
        self.assertNotIn("<series", (self.folder / "grown/vehicle.urdf").read_text())
        friction = next(one["value"] for one in result["parameters"] if one["name"] == "friction_damper")
        # As where the friction came first: 0.5 % of noise leave it to some per cent.
        self.assertAlmostEqual(friction, 40, delta=2)
        self.assertIn("taken back in step 3", (self.folder / "grown/report.html").read_text())
        # Nothing is fitted or taken back again.
        written = self.written()
        again = self.grow()
        self.assertEqual(again.stdout, printed.stdout)
        self.assertNotIn("taking back", again.stderr)
        self.assertEqual(self.written(), written)

    def test_growth_that_is_stopped_while_it_takes_back_goes_on_there(self):
        self.with_a_mount_before_friction()
        errors = self.stopped_at("step 3, 1 of 1: taking back")
        self.assertIn("not done: what can be taken back", errors)
        growth = self.grown("result.json")["growth"]
        self.assertEqual((growth["interrupted"], growth["not_done"]), (True, "what can be taken back"))
        self.assertEqual(growth["added"][0], "elastic mount in line with damper 'damper'")
        self.assertIn("taking back", self.grow().stderr)
        self.assertEqual(self.grown("result.json")["growth"]["added"], ["dry friction beside damper 'damper'"])

    def stopped_at(self, line):
        words = "fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow"
        program = self.start_program(*words)
        errors = next(text for text in program.stderr if text.startswith(line))
        program.send_signal(signal.SIGINT)
        errors += program.communicate()[1]
        self.assertEqual(program.returncode, 130)
        return errors

    def test_growth_that_was_killed_goes_on_after_its_last_step(self):
        self.record(FRICTION)
        words = "fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow"
        program = self.start_program(*words)
        next(text for text in program.stderr if text.startswith("step 1 of at most 12, addition"))
        program.kill()
        program.communicate()
        self.assertIn("growth goes on after step 0", self.grow().stderr)
        self.assertEqual(self.kept(), ["", "friction"])

    def test_growth_that_is_stopped_in_its_last_fit_ends_with_the_last_step(self):
        self.record(FRICTION)
        errors = self.stopped_at("the last step that was kept is fitted once more")
        self.assertIn("not done: the last fit with a search", errors)
        result = self.grown("result.json")
        step = self.grown("steps/1/fit/result.json")
        self.assertEqual(result["parameters"], step["parameters"])
        self.assertEqual(result["growth"]["not_done"], "the last fit with a search")
        self.assertIn("growth-interrupted", [one["id"] for one in result["conclusions"]])
        for name in ("vehicle.urdf", "response.csv", "parameters.csv"):
            self.assertEqual((self.folder / "grown" / name).read_text(), (self.folder / "grown/steps/1/fit" / name).read_text())
        self.assertIn("Not done: the last fit with a search", (self.folder / "grown/report.html").read_text())
        # The same command makes it.
        self.grow()
        self.assertIs(self.grown("result.json")["growth"]["interrupted"], False)


if __name__ == "__main__":
    unittest.main()
