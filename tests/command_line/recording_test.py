"""A study of recordings in the formats of measurement systems answers as one of CSV."""
import cmath
import csv
import json
import math
import struct
import unittest

from program import SOURCE, ProgramTest

DAMPER = SOURCE / "studies/damper"


def columns(file):
    """Names, units and columns of a CSV of numbers."""
    rows = list(csv.reader(file.read_text().splitlines()))
    return rows[0], rows[1], [[float(field) for field in column] for column in zip(*rows[2:])]


def universal(names, units, values, step):
    """Data sets 58b of double precision, which hold the numbers of a CSV bit for bit."""
    sets = b""
    for name, unit, numbers in zip(names, units, values):
        data = struct.pack(f"<{len(numbers)}d", *numbers)
        # Ten columns do not hold a longer name, the label of the axis does.
        entity = name if len(name) <= 10 else "NONE"
        axis = f"    0    0    0 {'NONE':20} "
        sets += (f"    -1\n{'58b':>6}{1:6}{2:6}{11:12}{len(data):12}{0:6}{0:6}{0:12}{0:12}\n{name}\nNONE\nNONE\nNONE\nNONE\n"
                 f"{1:5}{1:10}{1:5}{0:10} {entity:10}{0:10}{0:4} {'NONE':10}{0:10}{0:4}\n"
                 f"{4:10}{len(numbers):10}{1:10}{0:13.5E}{step:13.5E}{0:13.5E}\n{17:10}{axis}{'s':20}\n"
                 f"{0:10}    0    0    0 {name:20} {unit:20}\n{0:10}{axis}{'NONE':20}\n{0:10}{axis}{'NONE':20}\n").encode() + data + b"\n    -1\n"
    return sets


def rpc(names, units, values, step):
    """RPC III of floats."""
    frames = -(-len(values[0]) // 256)
    groups = -(-frames // 8)
    keys = {"FORMAT": "BINARY_IEEE_BIG_END", "NUM_HEADER_BLOCKS": 4, "NUM_PARAMS": 13, "FILE_TYPE": "TIME_HISTORY",
            "DATA_TYPE": "FLOATING_POINT", "DELTA_T": step, "PTS_PER_FRAME": 256, "PTS_PER_GROUP": 2048,
            "CHANNELS": len(names), "FRAMES": frames}
    for i, (name, unit) in enumerate(zip(names, units), 1):
        keys |= {f"DESC.CHAN_{i}": name, f"UNITS.CHAN_{i}": unit}
    file = b"".join(key.encode().ljust(32, b"\0") + str(value).encode().ljust(96, b"\0") for key, value in keys.items())
    file = file.ljust(2048, b"\0")
    for group in range(groups):
        for numbers in values:
            padded = numbers + [numbers[-1]] * (2048 * groups - len(numbers))
            file += struct.pack(">2048f", *padded[2048 * group:2048 * (group + 1)])
    return file


def frequency_responses(rows):
    """Data sets 58b of responses to the displacement of a post, at frequencies of their own, of a stepped sine's rows."""
    sets = b""
    for channel in sorted({row["channel"] for row in rows}):
        points = [row for row in rows if row["channel"] == channel]
        data = b""
        for row in points:
            frequency = float(row["frequency_Hz"])
            response = cmath.rect(float(row["gain"]), math.radians(float(row["phase_deg"])))
            # A stepped sine has accelerations relative to the post's.
            if row["unit"] == "m/s^2":
                response *= -(2 * math.pi * frequency) ** 2
            data += struct.pack("<3d", frequency, response.real, response.imag)
        axis = f"    0    0    0 {'NONE':20} "
        sets += (f"    -1\n{'58b':>6}{1:6}{2:6}{11:12}{len(data):12}{0:6}{0:6}{0:12}{0:12}\nNONE\nNONE\nNONE\nNONE\nNONE\n"
                 f"{4:5}{1:10}{1:5}{0:10} {channel:10}{0:10}{0:4} {'post':10}{1:10}{3:4}\n"
                 f"{6:10}{len(points):10}{0:10}{0:13.5E}{0:13.5E}{0:13.5E}\n{18:10}{axis}{'Hz':20}\n"
                 f"{0:10}{axis}{points[0]['unit']:20}\n{8:10}{axis}{'m':20}\n{0:10}{axis}{'NONE':20}\n").encode()
        sets += data + b"\n    -1\n"
    return sets


class Recordings(ProgramTest):
    def channels(self, name):
        told = json.loads(self.run_program("info", name, "--json").stdout)["files"][0]
        return [{key: channel[key] for key in ("name", "unit", "minimum", "maximum", "mean", "rms", "level")}
                for channel in told["channels"]]

    def test_universal_file_is_the_csv_bit_for_bit(self):
        names, units, values = columns(DAMPER / "sweep.csv")
        self.write("sweep.uff", universal(names[1:], units[1:], values[1:], 0.002))
        self.assertEqual(self.channels("sweep.uff"), self.channels(DAMPER / "sweep.csv"))

    def test_study_of_a_universal_file_answers_as_that_of_a_csv(self):
        names, units, values = columns(DAMPER / "sweep.csv")
        self.write("sweep.uff", universal(names[1:], units[1:], values[1:], 0.002))
        for part in ("model1.urdf", "sweep.csv"):
            self.write(part, (DAMPER / part).read_bytes())
        study = "vehicle: model1.urdf\nbench: {damper: damper, recordings: [sweep.csv]}\nsearch: {seed: 1, evaluations: 50}\n"
        self.write("csv.yaml", study)
        self.write("uff.yaml", study.replace("sweep.csv", "sweep.uff"))
        self.assertEqual(json.loads(self.run_program("response", "csv.yaml", "--json").stdout)["channels"],
                         json.loads(self.run_program("response", "uff.yaml", "--json").stdout)["channels"])

    def test_frequency_responses_of_a_universal_file_are_a_stepped_sine(self):
        self.run_program("init", "car")
        rows = list(csv.DictReader((self.folder / "car/stepped_sine.csv").read_text().splitlines()))
        fields = ("frequency_Hz", "channel", "gain", "phase_deg", "unit")
        self.write("car/plain.csv", "post_amplitude_m," + ",".join(fields) + "\n" +
                   "".join("0.005," + ",".join(row[field] for field in fields) + "\n" for row in rows))
        self.write("car/plain.uff", frequency_responses(rows))
        study = (self.folder / "car/study.yaml").read_text()
        self.write("car/csv.yaml", study.replace("file: stepped_sine.csv", "file: plain.csv"))
        self.write("car/uff.yaml", study.replace("file: stepped_sine.csv", "file: plain.uff\n    amplitude: 5 mm"))
        answers = [json.loads(self.run_program("response", f"car/{name}.yaml", "--json").stdout) for name in ("csv", "uff")]
        for one, other in zip(answers[0]["channels"], answers[1]["channels"]):
            self.assertEqual(one["name"], other["name"])
            # Responses went through real and imaginary parts and back.
            self.assertAlmostEqual(one["rms_dB"], other["rms_dB"], 9)
            self.assertAlmostEqual(one["rms_deg"], other["rms_deg"], 9)
        self.assertIn("post amplitude not stated", self.run_program("info", "car/plain.uff").stdout)
        self.write("car/none.yaml", study.replace("file: stepped_sine.csv", "file: plain.uff"))
        outcome = self.run_program("response", "car/none.yaml", code=3)
        self.assert_finding(outcome.stderr, "amplitude-missing", "car/plain.uff:")

    def test_simulated_history_is_written_in_formats_of_rigs(self):
        simulate = ("simulate", SOURCE / "urdf/quarter_car.urdf", "--sine", "2Hz", "--duration", "4s", "-o")
        for name in ("run.csv", "run.uff", "run.rsp", "run.drv"):
            self.run_program(*simulate, name)
        names, units, values = columns(self.folder / "run.csv")
        for name, digits in (("run.uff", 7), ("run.rsp", 6), ("run.drv", 3)):
            told = json.loads(self.run_program("info", name, "--json").stdout)["files"][0]
            for channel in told["channels"]:
                column = names.index(channel["name"])
                self.assertEqual(channel["unit"], units[column])
                # A CSV has eight digits, floats seven, 16 bits four; a sine's mean is small beside it.
                for key, value in (("maximum", max(values[column])), ("minimum", min(values[column]))):
                    self.assertLess(abs(channel[key] - value), 0.6 * 10**-digits * max(map(abs, values[column])), (name, channel, key))
            self.assertEqual([channel["name"] for channel in told["channels"]],
                             names[1:2] if name == "run.drv" else names[1:])
            self.assertAlmostEqual(told["time"]["rate_Hz"], 500)
        outcome = self.run_program(*simulate, "run.tdms", code=2)
        self.assert_finding(outcome.stderr, "output-ending")

    def test_drive_file_of_rpc_moves_the_posts(self):
        heights = [0.01 * (1 - abs(k - 256) / 256) for k in range(512)]
        self.write("drive.drv", rpc(["post"], ["m"], [heights], 0.005))
        rows = "".join(f"{0.005 * k!r},{struct.unpack('f', struct.pack('f', height))[0]!r}\n" for k, height in enumerate(heights))
        self.write("drive.csv", "time,post\ns,m\n" + rows)
        answers = [self.run_program("simulate", SOURCE / "urdf/quarter_car.urdf", "--recording", name).stdout
                   for name in ("drive.drv", "drive.csv")]
        self.assertGreater(len(answers[0].splitlines()), 500)
        self.assertEqual(*answers)


if __name__ == "__main__":
    unittest.main()
