"""From nothing to a fitted car, and the same with data as measurement systems write them."""
import csv
import json
import struct
import unittest

from program import SOURCE, ProgramTest

TRUTH = {"m_body": 335, "m_wheel": 46, "k": 24e3, "kt": 230e3, "c_bump": 1100, "c_rebound": 2300}


def mat4(columns):
    """A MAT file of version 4 of columns of numbers and of texts, which are rows of characters filled up by blanks."""
    file = b""
    for name, values in columns.items():
        is_text = isinstance(values[0], str)
        width = max(map(len, values)) if is_text else 1
        numbers = [float(ord(value.ljust(width)[i])) for i in range(width) for value in values] if is_text else values
        file += struct.pack("<5i", 1 if is_text else 0, len(values), width, 0, len(name) + 1) + name.encode() + b"\0"
        file += struct.pack(f"<{len(numbers)}d", *numbers)
    return file


class Starter(ProgramTest):
    def test_fits_and_finds_the_truth(self):
        told = self.run_program("init", "car").stdout
        self.assertIn("fourpost fit car/study.yaml -o run", told)
        self.run_program("check", "car/vehicle.urdf")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        result = json.loads((self.folder / "run/result.json").read_text())
        self.assertEqual(result["termination"], "converged")
        for parameter in result["parameters"]:
            # Of six estimates one is beyond three deviations in a study of sixty.
            self.assertLess(abs(parameter["value"] - TRUTH[parameter["name"]]), 3 * parameter["sd"], parameter)
        self.assertTrue((self.folder / "run/report.html").exists())

    def test_is_that_of_the_tree(self):
        self.run_program("init", "car")
        for file in ("vehicle.urdf", "study.yaml", "stepped_sine.csv"):
            self.assertEqual((self.folder / "car" / file).read_text(), (SOURCE / "studies/starter" / file).read_text())

    def test_spares_what_is_there(self):
        self.write("file", "mine")
        self.assertIn("[starter-folder-is-file]", self.run_program("init", "file", code=5).stderr)
        (self.folder / "full").mkdir()
        self.write("full/study.yaml", "mine")
        self.assertIn("[starter-folder-not-empty]", self.run_program("init", "full", code=5).stderr)
        self.assertEqual((self.folder / "full/study.yaml").read_text(), "mine")
        (self.folder / "empty").mkdir()
        self.run_program("init", "empty")

    def test_fits_the_same_from_a_german_table(self):
        """Semicolons and decimal commas, a channel of the wrong sign, scale and time."""
        self.run_program("init", "car")
        rows = (self.folder / "car/stepped_sine.csv").read_text().splitlines()
        self.run_program("fit", "car/study.yaml", "-o", "run")
        changed = [rows[0].replace(",", ";")]
        for row in rows[1:]:
            fields = row.split(",")
            if fields[2] == "s_strut":
                frequency = float(fields[0])
                fields[3] = repr(float(fields[3]) / 2)
                fields[5] = repr(float(fields[5]) / 2)
                fields[4] = repr(float(fields[4]) + 180 - 360 * frequency * 0.002)
                fields[7] = repr(-float(fields[7]) / 2)
            changed.append(";".join(fields).replace(".", ","))
        self.write("car/stepped_sine.csv", b"\xef\xbb\xbf" + "\r\n".join(changed).encode() + b"\r\n")
        study = (self.folder / "car/study.yaml").read_text()
        self.write("car/study.yaml", study.replace(
            "s_strut: s_strut ", "s_strut: {channel: s_strut, sign: -1, scale: 2, delay: 2 ms} "))
        self.run_program("fit", "car/study.yaml", "-o", "other")
        values = [[p["value"] for p in json.loads((self.folder / run / "result.json").read_text())["parameters"]]
                  for run in ("run", "other")]
        for one, other in zip(*values):
            # Rounding of 1e-16 on the way to another stop of the refinement.
            self.assertLess(abs(one - other), 1e-4 * abs(one))

    def test_fits_the_same_from_a_mat_file(self):
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        rows = list(csv.DictReader((self.folder / "car/stepped_sine.csv").read_text().splitlines()))
        columns = {name: [row[name] for row in rows] for name in rows[0]}
        self.write("car/stepped_sine.mat", mat4({
            name: texts if name in ("channel", "unit") else [float(text or "nan") for text in texts]
            for name, texts in columns.items()}))
        text = self.run_program("info", "car/stepped_sine.csv").stdout
        self.assertEqual(self.run_program("info", "car/stepped_sine.mat").stdout, text.replace(".csv", ".mat"))
        study = (self.folder / "car/study.yaml").read_text()
        self.write("car/study.yaml", study.replace("file: stepped_sine.csv", "file: stepped_sine.mat"))
        self.run_program("fit", "car/study.yaml", "-o", "other")
        one, other = (json.loads((self.folder / run / "result.json").read_text()) for run in ("run", "other"))
        self.assertEqual(one["parameters"], other["parameters"])
        self.run_program("predict", "other", "--recording", "car/stepped_sine.mat")


if __name__ == "__main__":
    unittest.main()
