"""The tutorial's commands run one after the other, and print what it shows."""
import json
import os
import pathlib
import re
import subprocess
import unittest

from program import FOURPOST, SOURCE, ProgramTest


class Findings(ProgramTest):
    def test_are_those_of_the_program(self):
        shown = self.run_program("help", "findings").stdout
        self.assertTrue((SOURCE / "docs/findings.md").read_text() == shown,
                        "docs/findings.md is old; renew it: build/release/fourpost help findings > docs/findings.md")


class Tutorial(ProgramTest):
    def test_runs_as_it_stands(self):
        text = (SOURCE / "docs/tutorial.md").read_text()
        programs = self.folder / "bin"
        programs.mkdir()
        (programs / "fourpost").symlink_to(pathlib.Path(FOURPOST).resolve())
        environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"}
        printed = ""
        fences = re.findall(r"^```(\w*) ?(\S*)\n(.*?)^```", text, re.S | re.M)
        self.assertGreater(sum(language == "sh" for language, _, _ in fences), 7)
        for language, file, block in fences:
            if file:
                self.write(file, block)
            if language != "sh":
                continue
            outcome = subprocess.run(["sh", "-e", "-c", block], cwd=self.folder, env=environment, capture_output=True,
                                     text=True)
            self.assertEqual(outcome.returncode, 0, block + outcome.stderr)
            printed += outcome.stdout
        # Last digits may differ with another compiler.
        table, prediction = (block for language, _, block in fences if language == "")
        names = [line.split()[0] for line in table.splitlines() if re.match(r"\w+ +[\d.]+ +[\d.]+ +[\d.]+ ", line)]
        self.assertEqual(len(names), 6)
        for name in names:
            shown = re.search(rf"^{name} +[\d.]+ +([\d.]+)", table, re.M).group(1)
            got = re.search(rf"^{name} +[\d.]+ +([\d.]+) +[\d.]+ +[\d.]+ +[\d.]+ ", printed, re.M).group(1)
            self.assertAlmostEqual(float(got) / float(shown), 1, 3, name)
        self.assertIn(prediction.splitlines()[0] + "\n", printed)
        # The square of a small error, which last digits change more.
        shown, got = (float(re.search(r"^random +a_body +([\d.]+)", part, re.M).group(1))
                      for part in (prediction, printed))
        self.assertAlmostEqual(got / shown, 1, 1)
        self.check_truth("run_over_time")

    def check_truth(self, run):
        """Found again, within a few times the recordings' noise of 0.1 %."""
        truth = {"m_body": 335, "m_wheel": 46, "k": 24e3, "kt": 230e3, "c_bump": 1100, "c_rebound": 2300}
        result = json.loads((self.folder / run / "result.json").read_text())
        self.assertEqual(result["termination"], "converged")
        for parameter in result["parameters"]:
            self.assertLess(abs(parameter["value"] / truth[parameter["name"]] - 1), 0.005, parameter)


class Reference(ProgramTest):
    def test_tells_every_key_of_a_result(self):
        schema = json.loads((SOURCE / "identify/command_line/schema/fit.json").read_text())
        part = (SOURCE / "docs/reference.md").read_text().split("fit.json](")[1].split("\n\n")[1]
        told = {key for row in part.splitlines() for key in re.findall("`(\\w+)`", row.split("|")[1])}
        self.assertEqual(set(schema["properties"]) - told, set())
        self.assertEqual(told - set(schema["properties"]), set())


class Readme(ProgramTest):
    def test_shows_what_the_first_command_prints(self):
        part = (SOURCE / "README.md").read_text().split("### Response of a vehicle file")[1]
        commands, shown = re.findall(r"```(?:sh)?\n(.*?)```", part, re.S)[:2]
        words = commands.splitlines()[0].split("#")[0].split()
        self.assertEqual(words[0], "$fourpost")
        self.copy("urdf", "meshes")
        printed = self.run_program(*words[1:]).stdout
        self.assertEqual(printed[:len(shown) - 4] + "...\n", shown)


if __name__ == "__main__":
    unittest.main()
