"""The wheel station over time: the studies of studies/single_wheel_station against the table that its README shows."""
import csv
import json
import re
import unittest

from program import SOURCE, ProgramTest

CHANNELS = ("z_sprung", "z_unsprung", "a_sprung", "a_unsprung", "F_tyre")


def stored():
    """Errors of results/errors.csv by study and recording, of the condensed model."""
    text = (SOURCE / "studies/single_wheel_station/results/errors.csv").read_text()
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    return {(row["study"], row["recording"]): row for row in rows if row["engine"] == "condensed"}


class Station(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("studies/single_wheel_station", "urdf", "meshes")

    def errors(self, model, *changes):
        """Of the sweep that is fitted and of the one that is not, as results/errors.py finds them, by a shorter search."""
        study = self.folder / f"studies/single_wheel_station/{model}.yaml"
        text, count = re.subn(r"evaluations: 60\n  starts: 1\n", "evaluations: 5\n  starts: 1\n", study.read_text())
        self.assertEqual(count, 1)
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        study.write_text(text)
        self.run_program("fit", study, "-o", model, "--no-suggest")
        told = {}
        for recording in ("sweep_12mm", "sweep_7mm"):
            answer = self.run_program("predict", model, "--recording", study.parent / f"{recording}.csv", "--engine", "reduced",
                                      "--json").stdout
            told[recording] = {channel["name"]: channel["nmse_percent"] for channel in json.loads(answer)["channels"]}
        return told

    def test_errors_are_those_of_the_table(self):
        """To half a unit of the table's third digit, and a half per cent for where refinements end."""
        table = stored()
        for model in ("model1", "model2", "model3"):
            for recording, errors in self.errors(model).items():
                for channel in CHANNELS:
                    printed = float(table[model, recording][channel])
                    self.assertLess(abs(errors[channel] / printed - 1), 0.01, (model, recording, channel, errors[channel]))

    def test_friction_is_what_the_thesis_s_models_lack(self):
        """Model 4, fitted to the first eight seconds, leaves a tenth of Model 3's errors; the load cell's is mostly noise."""
        table = stored()
        for recording, errors in self.errors("model4", ("sweep_12mm.csv", "sweep_12mm.csv\n    end: 8 s")).items():
            for channel in CHANNELS[:-1]:
                without = float(table["model3", recording][channel])
                self.assertLess(errors[channel], 0.1 * without, (recording, channel))

    def test_response_tells_what_the_vehicle_as_it_stands_misses(self):
        study = self.folder / "studies/single_wheel_station/model1.yaml"
        answer = self.run_program("response", study).stdout
        self.assertEqual(len(re.findall("^sweep_12mm ", answer, flags=re.M)), len(CHANNELS), answer)
        self.run_program("response", study, "-o", "run")
        self.assertTrue((self.folder / "run/result.json").exists())
        self.assertIn("sweep_12mm,", (self.folder / "run/history.csv").read_text())


if __name__ == "__main__":
    unittest.main()
