"""A fit that grows by what it suggests: its steps, and how it goes on after it was ended."""
import json
import random
import re
import shutil
import signal
import subprocess
import sys
import unittest

from program import FOURPOST, SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "tests/validation"))
import suggest  # noqa: E402

FRICTION = ("friction", "quarter_car", suggest.friction("damper", 40), None, "friction", {"damper"}, [])
GROW = ("fit", "study.yaml", "-o", "grown", "--threads", "1", "--accept-implausible", "--grow")
FIRST_ADDITION = "step 1 of at most 12, addition"


class Growth(ProgramTest):
    """Of a car with friction, whose growth is in the folder `grown`."""
    mounted = None

    @classmethod
    def setUpClass(cls):
        cls.make_kept()
        suggest.four_post(FOURPOST, cls.kept, FRICTION, random.Random(1))
        cls.printed = cls.run_kept(*GROW)

    def setUp(self):
        super().setUp()
        shutil.copytree(self.kept, self.folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("mounted"))

    def grown(self, name):
        return json.loads((self.folder / "grown" / name).read_text())

    def mechanisms(self):
        return [step["mechanism"] for step in self.grown("steps/growth.json")["steps"] if step["kept"]]

    def start_anew(self):
        shutil.rmtree(self.folder / "grown")
        return self.start_program(*GROW)

    def killed_after_first_step(self):
        program = self.start_anew()
        next(line for line in program.stderr if line.startswith(FIRST_ADDITION))
        program.kill()
        program.communicate()

    def written(self):
        """When the result of each step was written."""
        return {path.parent.parent.name: path.stat().st_mtime_ns
                for path in (self.folder / "grown/steps").glob("*/fit/result.json")}

    def grow(self, *more):
        return self.run_program(*GROW, *more)

    def test_fit_grows(self):
        printed = self.printed
        self.assertEqual(self.mechanisms(), ["", "friction"])
        self.assertEqual(self.grown("steps/growth.json")["end"], "the stated errors explain the residuals")
        result = self.grown("result.json")
        self.assertIn("friction_damper", [p["name"] for p in result["parameters"]])
        # Those of the user's study, not of the step before.
        starts = {p["name"]: p["start"] for p in result["parameters"]}
        own = {p["name"]: p["start"] for p in self.grown("steps/0/fit/result.json")["parameters"]}
        self.assertEqual({name: starts[name] for name in own}, own)
        self.assertIn("validation rms error, %", printed.stdout)
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
        program = self.start_program(*GROW)
        next(line for line in program.stderr if line.startswith("the last step"))
        program.send_signal(signal.SIGINT)
        program.communicate()
        self.assertEqual((self.folder / "grown/result.json").read_text(), text)
        # Of another study it begins anew.
        self.replace_in("study.yaml", "seed: 1", "seed: 2")
        first = next(line for line in self.start_program(*GROW).stderr if line.startswith(("step", "growth")))
        self.assertEqual(first, "step 0 of at most 12: the study as it stands\n")

    def test_growth_begins_anew_with_other_validation_data(self):
        """They decide which steps are kept."""
        name = re.search(r"file: (\S+)", (self.folder / "study.yaml").read_text()).group(1).rstrip(",}")
        self.write("kept.csv", (self.folder / name).read_text())
        self.replace_in("study.yaml", "recordings:\n",
                        "recordings:\n  - {name: kept, file: kept.csv, posts: heave, use: validation}\n")
        self.killed_after_first_step()
        self.write("kept.csv", (self.folder / name).read_text() + "\n")
        first = next(line for line in self.start_program(*GROW).stderr if line.startswith(("step", "growth")))
        self.assertEqual(first, "step 0 of at most 12: the study as it stands\n")

    def test_growth_tries_no_refused_addition_again(self):
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
        program = self.start_anew()
        next(line for line in program.stderr if line.startswith(FIRST_ADDITION))
        program.send_signal(signal.SIGINT)
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
        self.assertEqual(self.mechanisms(), ["", "friction"])
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
        # The file's values begin near the optimum: a search finds no other.
        text = (self.folder / study).read_text()
        self.write(study, text.replace("evaluations: 40", "evaluations: 1"))
        words = "fit", study, "-o", folder, "--threads", "1", "--no-suggest", "--accept-implausible", "--accept-unidentified"
        return subprocess.run([FOURPOST, *words], cwd=self.folder, capture_output=True).returncode

    def with_a_mount_before_friction(self):
        """A growth to go on with: first a mount, of which there is none, then the friction that there is."""
        if self.mounted:
            shutil.rmtree(self.folder / "grown")
            shutil.copytree(self.mounted, self.folder / "grown")
            return
        path = self.grown("steps/growth.json")
        mount = self.grown_step("mount", "steps/0", "study.yaml", "steps/5")
        friction = self.grown_step("friction", "steps/5", "grown/steps/5/study.yaml", "steps/6")
        path |= {"steps": [path["steps"][0], mount, friction], "round": None, "over": False}
        (self.folder / "grown/steps/growth.json").write_text(json.dumps(path))
        type(self).mounted = shutil.copytree(self.folder / "grown", self.kept / "mounted")

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
        program = self.start_program(*GROW)
        errors = next(text for text in program.stderr if text.startswith(line))
        program.send_signal(signal.SIGINT)
        errors += program.communicate()[1]
        self.assertEqual(program.returncode, 130)
        return errors

    def test_growth_that_was_killed_goes_on_after_its_last_step(self):
        self.killed_after_first_step()
        self.assertIn("growth goes on after step 0", self.grow().stderr)
        self.assertEqual(self.mechanisms(), ["", "friction"])

    def test_growth_that_is_stopped_in_its_last_fit_ends_with_the_last_step(self):
        shutil.rmtree(self.folder / "grown")
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

    def test_growth_holds_what_an_option_sets(self):
        """The file has another tyre."""
        self.replace_in("vehicle.urdf", 'value="230 kN/m"', 'value="190 kN/m"')
        with (self.folder / "study.yaml").open("a") as file:
            file.write("free: all but [kt]\n")
        self.grow("--set", "kt=230kN/m")
        # Of one force and no mass that is known, another tyre and another scale of the force are the same.
        self.assertEqual(self.mechanisms()[:2], ["", "friction"])
        self.assertIn(self.mechanisms()[2], ["free", "scale"])
        check = json.loads(self.run_program("check", "grown/steps/1/fit/vehicle.urdf", "--json").stdout)
        self.assertEqual([one["value"] for one in check["parameters"] if one["name"] == "kt"], [230e3])


if __name__ == "__main__":
    unittest.main()
