"""Files and names that nobody means to give: no crash, no hang, no lost results, and the exit code of their kind."""
import json
import os
import resource
import subprocess
import unittest

from program import FOURPOST, ProgramTest

# Latin-1, as old shares have it: no UTF-8.
STREET = b"Stra\xdfe"


def user_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


class Hostile(ProgramTest):
    def refused(self, *words, code=3, says):
        # None of them takes a second; without an end none must hang the test.
        outcome = subprocess.run([FOURPOST, *words], cwd=self.folder, capture_output=True, timeout=60)
        text = outcome.stderr.decode(errors="replace")
        self.assertEqual(outcome.returncode, code, text)
        self.assertIn(says, text)
        return text

    def json_of(self, *words):
        outcome = subprocess.run([FOURPOST, *words], cwd=self.folder, capture_output=True, timeout=600)
        self.assertIn(outcome.returncode, (0, 1), outcome.stderr)
        return json.loads(outcome.stdout.decode())

    def test_names_that_are_no_utf8_lose_no_results(self):
        self.run_program("init", "car")
        folder = os.fsencode(self.folder)
        os.rename(folder + b"/car/study.yaml", folder + b"/car/" + STREET + b".yaml")
        os.rename(folder + b"/car", folder + b"/" + STREET)
        result = self.json_of("fit", STREET + b"/" + STREET + b".yaml", "-o", STREET + b"run", "--json")
        self.assertIn("Stra\ufffde", json.dumps(result, ensure_ascii=False))
        files = set(os.listdir(folder + b"/" + STREET + b"run"))
        self.assertLessEqual({b"result.json", b"vehicle.urdf", b"report.html"}, files)
        for name in files - {b"archive.sqlite"}:
            with open(folder + b"/" + STREET + b"run/" + name, "rb") as file:
                file.read().decode()
        self.json_of("check", STREET + b"run/vehicle.urdf", "--json")
        self.json_of("report", STREET + b"run", "--json")
        recording = STREET + b"/" + STREET + b".csv"
        os.link(folder + b"/" + STREET + b"/stepped_sine.csv", folder + b"/" + recording)
        self.json_of("info", recording, "--json")
        self.json_of("predict", STREET + b"run", "--recording", recording, "--mode", "heave", "--json", "-o",
                     STREET + b"predicted")
        self.json_of("response", STREET + b"/" + STREET + b".yaml", "--json")
        self.json_of("params", STREET + b"/vehicle.urdf", "--json")

    def test_what_is_no_file_is_refused_at_once(self):
        self.run_program("init", "car")
        os.mkfifo(self.folder / "pipe")
        for words in (["info"], ["check"], ["params"], ["fit", "-o", "run"], ["response"], ["modes"],
                      ["simulate", "--sine", "2Hz"]):
            for path, kind in (("pipe", "pipe"), ("/dev/zero", "device")):
                self.refused(words[0], path, *words[1:], says=f"{kind}, not a file")
        os.mkfifo(self.folder / "pipe.mat")
        self.refused("info", "pipe.mat", says="pipe, not a file")
        text = (self.folder / "car/vehicle.urdf").read_text()
        os.mkfifo(self.folder / "car/pipe.stl")
        self.write("car/pipe.urdf", text.replace("<inertial>", '<visual><geometry><mesh filename="pipe.stl"/>'
                                                 "</geometry></visual><inertial>", 1))
        self.refused("check", "car/pipe.urdf", says="pipe, not a file")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        (self.folder / "run/archive.sqlite").unlink()
        os.mkfifo(self.folder / "run/archive.sqlite")
        self.refused("fit", "car/study.yaml", "-o", "run", code=5, says="archive-not-a-file")
        (self.folder / "run/result.json").unlink()
        os.mkfifo(self.folder / "run/result.json")
        self.refused("report", "run", says="pipe, not a file")

    def test_a_name_that_cannot_be_written_is_5(self):
        self.run_program("init", "car")
        os.symlink("loop", self.folder / "loop")
        os.symlink("loop.csv", self.folder / "loop.csv")
        for name, why in (("x" * 300, "File name too long"), ("loop", "Too many levels of symbolic links")):
            with self.subTest(name[:5]):
                self.refused("fit", "car/study.yaml", "-o", name, code=5, says=why)
                self.refused("init", name, code=5, says=why)
                self.refused("simulate", "car/vehicle.urdf", "--sine", "2Hz", "--duration", "1s", "-o", name + ".csv",
                             code=5, says="[output-")

    def test_a_name_that_cannot_be_read_is_3(self):
        self.run_program("init", "car")
        text = (self.folder / "car/vehicle.urdf").read_text()
        self.write("car/long.urdf", text.replace("<inertial>", f'<visual><geometry><mesh filename="{"m" * 5000}.stl"/>'
                                                 "</geometry></visual><inertial>", 1))
        self.refused("check", "car/long.urdf", says="File name too long")
        study = (self.folder / "car/study.yaml").read_text()
        self.write("car/long.yaml", study.replace("vehicle.urdf", "v" * 5000))
        self.refused("fit", "car/long.yaml", "-o", "run", says="File name too long")

    def test_a_result_of_100_MB_is_refused(self):
        self.run_program("init", "car")
        self.run_program("fit", "car/study.yaml", "-o", "run")
        for content in ('{"termination": 1, "parameters": [' + "0," * 50_000_000 + "0]}", "[" * 10_000_000):
            self.write("run/result.json", content)
            before = user_seconds()
            for words in (["report", "run"], ["rank", "run", "run"], ["predict", "run", "--recording",
                                                                     "car/stepped_sine.csv"]):
                self.refused(*words, says="result.json")
            self.assertLess(user_seconds() - before, 20)

    def test_many_columns_take_time_in_proportion(self):
        def seconds(columns):
            self.write("wide.csv", ",".join(["time"] + [f"c{i}" for i in range(columns)]) + "\n" +
                       "\n".join(",".join([str(row)] + ["1"] * columns) for row in range(5)) + "\n")
            before = user_seconds()
            self.run_program("info", "wide.csv")
            self.write("wide.csv", ",".join(["frequency_Hz", "channel"] + [f"c{i}" for i in range(columns)]) + "\n" +
                       ",".join(["1", "a"] + ["1"] * columns) + "\n")
            self.run_program("info", "wide.csv", code=3)
            return user_seconds() - before

        # Linear would be 4, quadratic 16; 0.1 s for what the program takes at all.
        self.assertLess(seconds(80_000), 8 * (seconds(20_000) + 0.1))

    def test_a_name_of_megabytes_is_shortened(self):
        name = "n" * 5_000_000
        self.write("car.urdf", f'<robot name="r" xmlns:fp="urn:fourpost:vehicle:1"><link name="a"/>'
                               f'<joint name="j" type="fixed"><parent link="{name}"/><child link="a"/></joint></robot>')
        self.assertLess(len(self.refused("check", "car.urdf", says="nnn")), 20_000)
        self.write("names.csv", f"time,{name},{name}\n1,2,3\n")
        self.assertLess(len(self.refused("info", "names.csv", says="nnn")), 20_000)
        self.write("wide.csv", f"time,{name}\ns,m\n" + "".join(f"{i},1\n" for i in range(9)))
        self.assertLess(len(self.run_program("info", "wide.csv").stdout), 20_000)
        self.write("study.yaml", f"vehicle: {'n' * 500_000}\nband: {'n' * 400_000}\n")
        self.assertLess(len(self.refused("fit", "study.yaml", "-o", "run", says="band")), 20_000)

    def test_help_that_nobody_gets_is_5(self):
        for words in (["--help"], ["--version"], ["fit", "--help"]):
            with open("/dev/full", "w") as full:
                code = subprocess.run([FOURPOST, *words], stdout=full, stderr=subprocess.DEVNULL).returncode
            self.assertEqual(code, 5, words)
            code = subprocess.run([FOURPOST, *words], preexec_fn=lambda: os.close(1),
                                  stderr=subprocess.DEVNULL).returncode
            self.assertEqual(code, 5, words)


if __name__ == "__main__":
    unittest.main()
