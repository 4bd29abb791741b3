"""The tutorial's commands run one after the other, and print what it shows."""
import os
import pathlib
import re
import subprocess
import unittest

from program import FOURPOST, SOURCE, ProgramTest


class Tutorial(ProgramTest):
    def test_runs_as_it_stands(self):
        text = (SOURCE / "docs/tutorial.md").read_text()
        programs = self.folder / "bin"
        programs.mkdir()
        (programs / "fourpost").symlink_to(pathlib.Path(FOURPOST).resolve())
        environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"}
        printed = ""
        fences = re.findall(r"^```(\w*)\n(.*?)^```", text, re.S | re.M)
        blocks = [block for language, block in fences if language == "sh"]
        self.assertGreater(len(blocks), 5)
        for block in blocks:
            outcome = subprocess.run(["sh", "-e", "-c", block], cwd=self.folder, env=environment, capture_output=True,
                                     text=True)
            self.assertEqual(outcome.returncode, 0, block + outcome.stderr)
            printed += outcome.stdout
        # Last digits may differ with another compiler.
        (table,) = (block for language, block in fences if language == "")
        names = [line.split()[0] for line in table.splitlines() if re.match(r"\w+ +[\d.]+ +[\d.]+ +[\d.]+ ", line)]
        self.assertEqual(len(names), 6)
        for name in names:
            shown = re.search(rf"^{name} +[\d.]+ +([\d.]+)", table, re.M).group(1)
            got = re.search(rf"^{name} +[\d.]+ +([\d.]+) +[\d.]+ +[\d.]+ +[\d.]+ ", printed, re.M).group(1)
            self.assertAlmostEqual(float(got) / float(shown), 1, 3, name)


if __name__ == "__main__":
    unittest.main()
