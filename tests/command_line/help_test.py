"""Help, manual page and completion tell the same commands and options; what is misspelt is told."""
import functools
import os
import re
import shutil
import subprocess
import unittest

from program import FOURPOST, SOURCE, ProgramTest


@functools.cache
def help_of(*command):
    """As each test would ask for it once more."""
    return subprocess.run([FOURPOST, *command, "--help"], capture_output=True, text=True, check=True).stdout


class Help(ProgramTest):
    def commands(self):
        text = help_of()
        return re.findall(r"^  ([a-z]+)  ", text[text.index("Subcommands:"):], re.M)

    def options(self, command):
        return set(re.findall(r"(?<![\w-])--[a-z-]+", re.sub(r"Examples:.*", "", help_of(command), flags=re.S)))

    def test_has_examples_for_every_command(self):
        self.assertGreater(len(self.commands()), 13)
        for command in self.commands():
            text = help_of(command)
            self.assertRegex(text, f"Examples:\n  .*fourpost {command}", command)

    def test_has_examples_that_run(self):
        """In the starter's folder, of a fit of it; two models of a damper in place of `run/model1` and `run/model2`."""
        self.run_program("init", "new")
        for new, name in (("vehicle.urdf", "car.urdf"), ("vehicle.urdf", "vehicle.urdf"), ("study.yaml", "study.yaml"),
                          ("stepped_sine.csv", "stepped_sine.csv")):
            shutil.copy(self.folder / "new" / new, self.folder / name)
        self.write("settings.yaml", "knobs: {spring: {sets: k, values: [18 kN/m, 22 kN/m]}}\nduration: 5 s\ndraws: 20\n")
        self.write("plan.yaml", "fits: [{study: study.yaml, seeds: 1..2}]\n")
        (self.folder / "rig").mkdir()
        shutil.copy(self.folder / "stepped_sine.csv", self.folder / "rig")
        shutil.copytree(SOURCE / "tests/data/chrono", self.folder / "data")
        rover = SOURCE / "urdf/landrover110_model3.urdf"
        for model in ("model1", "model2"):
            self.run_program("fit", SOURCE / f"studies/damper/{model}.yaml", "-o", f"models/{model}", "--no-suggest")
        programs = self.folder / "bin"
        programs.mkdir()
        (programs / "fourpost").symlink_to(FOURPOST)
        environment = {**os.environ, "HOME": str(self.folder), "PATH": f"{programs}:{os.environ['PATH']}"}
        examples = {command: re.findall("^  (.+)", help_of(command).split("Examples:")[1], re.M)
                    for command in self.commands()}
        # What makes files that others take comes first.
        order = ["init", "simulate", "fit"]
        for command in order + [command for command in examples if command not in order]:
            for example in examples[command]:
                if "warp" in example:
                    continue  # Of a car on four posts, and a recording of it.
                line = example.replace("run/model", "models/model").replace(" | man -l -", "")
                line = re.sub(r"run[12]\.mat", "stepped_sine.csv", line)
                if command == "predict":
                    line = line.replace("sweep.csv", "stepped_sine.csv")  # of the kind that was fitted
                line = re.sub(r"data/\S+Vehicle\.json", "data/vehicle.json", line)
                line = re.sub(r"data/\S+Tire\.json", "data/car/tyre.json", line)
                if "roll" in line:
                    line = line.replace("car.urdf", str(rover))
                outcome = subprocess.run(["bash", "-e", "-c", line], cwd=self.folder, env=environment,
                                         capture_output=True, text=True)
                self.assertEqual(outcome.returncode, 0, line + outcome.stderr)
                if command == "response":
                    self.assertNotIn("the post reaches", outcome.stderr)

    def test_is_the_manual_page(self):
        page = self.run_program("man").stdout.replace("\\-", "-")
        parts = {part.split("\n")[0]: part for part in page.split(".SS ")[1:]}
        self.assertEqual(set(parts), set(self.commands()))
        for command in self.commands():
            for option in self.options(command):
                self.assertRegex(parts[command], rf"(?m)^\.B .*{option}(?![\w-])", command)
        for code in ("0", "1", "2", "3", "4", "5", "70", "71", "75", "130"):
            self.assertIn(f".TP\n.B {code}\n", page)

    def test_is_what_shells_complete(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.run_program("completion", shell).stdout
            for command in self.commands():
                self.assertIn(command, script)
                for option in self.options(command) - {"--help"}:
                    self.assertIn(option[2:] if shell == "fish" else option, script, f"{shell}: {command}")

    def complete(self, *words):
        script = self.run_program("completion", "bash").stdout
        line = " ".join(f"'{word}'" for word in words)
        outcome = subprocess.run(
            ["bash", "-c", f"{script}\nCOMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _fourpost; "
                           "printf '%s\\n' \"${COMPREPLY[@]}\""], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(outcome.stderr, "")
        return set(outcome.stdout.split())

    def test_bash_completes(self):
        self.assertEqual(self.complete("fourpost", "re"), {"response", "report"})
        self.assertEqual(self.complete("fourpost", "fit", "--s"), {"--seed", "--set"})
        self.assertEqual(self.complete("fourpost", "response", "--engine", "t"), {"time"})
        self.assertEqual(self.complete("fourpost", "simulate", "--engine", ""), {"auto", "reduced", "full"})
        self.assertEqual(self.complete("fourpost", "simulate", "--engine", "="), {"auto", "reduced", "full"})
        self.assertEqual(self.complete("fourpost", "simulate", "--engine", "=", "r"), {"reduced"})
        self.assertEqual(self.complete("fourpost", "compare", "study.yaml", "--methods", "d"), {"dvhde", "direct", "de"})
        self.assertEqual(self.complete("fourpost", "compare", "study.yaml", "--methods", "gb,dv"), {"gb,dvhde"})
        self.assertEqual(self.complete("fourpost", "completion", ""), {"bash", "zsh", "fish"})

    def typed(self, keys, shows):
        """What stands on the line of an interactive bash, or is asked by it, after these keys."""
        import pty
        import select
        import time
        self.write("completion.bash", self.run_program("completion", "bash").stdout)
        self.write("bashrc", "PS1='> '; bind 'set enable-bracketed-paste off'; . ./completion.bash; "
                             "fourpost() { printf 'got:'; printf '<%s>' \"$@\"; echo; }\n")
        leader, follower = pty.openpty()
        shell = subprocess.Popen(["bash", "--noprofile", "--rcfile", "bashrc", "-i"], cwd=self.folder, stdin=follower,
                                 stdout=follower, stderr=follower, start_new_session=True,
                                 env={"PATH": os.environ["PATH"], "TERM": "dumb", "HOME": str(self.folder),
                                      "INPUTRC": "/dev/null"})
        os.close(follower)
        text = ""
        os.write(leader, keys.encode())
        end = time.monotonic() + 60
        while shows not in text and time.monotonic() < end:
            if select.select([leader], [], [], 0.1)[0]:
                text += os.read(leader, 10000).decode()
        shell.kill()
        shell.wait()
        os.close(leader)
        return text

    def test_bash_completes_as_one_types(self):
        self.write("my study.yaml", "")
        (self.folder / "runs of may").mkdir()
        self.write("runs of may/first one.csv", "")
        for keys, got in (("fit my\t\n", "<fit><my study.yaml>"), ("fit \"my\t\n", "<fit><my study.yaml>"),
                          ("info ru\tfi\t\n", "<info><runs of may/first one.csv>"),
                          ("fit x -o ru\t\n", "<fit><x><-o><runs of may/>"),
                          ("fit --output=ru\t\n", "<fit><--output=runs of may/>"),
                          ("simulate --engine=r\t\n", "<simulate><--engine=reduced>"),
                          ("simulate --engine r\t\n", "<simulate><--engine><reduced>"),
                          ("simulate --amp\t\n", "<simulate><--amplitude>"),
                          ("compare my\t --methods gb,dv\t\n", "<compare><my study.yaml><--methods><gb,dvhde>")):
            with self.subTest(keys):
                self.assertIn("got:" + got, self.typed("fourpost " + keys, "got:" + got))

    def test_knows_what_was_meant(self):
        for words, meant in ((["fitt", "car/study.yaml", "more"], "fit"), (["--versoin"], "--version")):
            self.assertRegex(self.run_program(*words, code=2).stderr,
                             rf"^error: fourpost .*'{words[0]}'.*'{meant}'\? \[argument-misspelt\]\n$")
        self.assertRegex(self.run_program("xyzzy", code=2).stderr, r"'xyzzy'.*`fourpost --help` \[argument-unknown\]\n$")
        for command in self.commands():
            outcome = self.run_program(command, "a", "--jsno", code=2)
            if command not in ("completion", "man", "help"):
                self.assertRegex(outcome.stderr, r"'--jsno'.*'--json'\? \[argument-misspelt\]", command)
        for shell, words in (("bahs", "'bash'"), ("tcl", "bash, zsh, fish")):
            self.assertRegex(self.run_program("completion", shell, code=2).stderr,
                             rf"^SHELL: error: '{shell}' .*{words}.* \[value-unknown\]\n$")

    def on_terminal(self, *words, **environment):
        """What a terminal of 60 columns shows."""
        import fcntl
        import pty
        import struct
        import termios
        leader, follower = pty.openpty()
        fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 60, 0, 0))
        usual = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "NO_COLOR")}
        program = subprocess.Popen([FOURPOST, *words], stdout=follower, stderr=follower, cwd=self.folder,
                                   env={**usual, "TERM": "xterm", **environment})
        os.close(follower)
        text = b""
        try:
            while part := os.read(leader, 10000):
                text += part
        except OSError:  # The other end is closed.
            pass
        program.wait()
        os.close(leader)
        return text.decode().replace("\r\n", "\n")

    def test_colours_a_terminal_that_takes_them(self):
        self.assertTrue(self.on_terminal("fitt").startswith("\x1b[1;31merror:\x1b[0m fourpost "))
        for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
            self.assertNotIn("\x1b", self.on_terminal("fitt", **environment))
        self.assertNotIn("\x1b", self.run_program("fitt", code=2).stderr)

    def test_is_as_wide_as_the_terminal(self):
        self.run_program("init", "car")
        for words in (["--help"], ["fit", "--help"], ["help", "simulate"], ["check", "car/vehicle.urdf"],
                      ["info", "car/stepped_sine.csv"], ["rank", "--help"]):
            whole = self.run_program(*words).stdout
            self.assertGreater(max(map(len, whole.splitlines())), 60)
            for columns in (60, 80):
                lines = self.on_terminal(*words, COLUMNS=str(columns)).splitlines()
                wide = [line for line in lines if len(line) > columns and not line.startswith("  fourpost ")]
                self.assertEqual(wide, [], words)
            shown = self.on_terminal(*words).split()
            self.assertEqual(set(whole.split()), set(shown))
        self.assertEqual(max(map(len, self.on_terminal("fit", "--help").splitlines()[:9])),
                         max(map(len, self.on_terminal("fit", "--help", COLUMNS="60").splitlines()[:9])))

    def test_is_a_command_too(self):
        self.assertEqual(self.run_program("help").stdout, help_of())
        for command in self.commands():
            self.assertEqual(self.run_program("help", command).stdout, help_of(command))
        text = self.run_program("help", "output-is-input").stdout
        self.assertTrue(text.startswith("output-is-input, error\n"))
        self.assertIn("Remedy\n", text)
        self.assertEqual(text, self.run_program("help", "[output-is-input]").stdout)
        for topic, meant in (("fitt", "'fit'"), ("output-is-inputt", "'output-is-input'")):
            self.assertRegex(self.run_program("help", topic, code=2).stderr,
                             rf"^TOPIC: error: '{topic}' .*{meant}.* \[help-topic-unknown\]\n$")

    def test_is_found_of_every_finding(self):
        ids = re.findall(r"^\| `([a-z0-9-]+)` \| (?:error|warning) \| \S", self.run_program("help", "findings").stdout, re.M)
        self.assertGreater(len(ids), 50)
        self.assertEqual(ids, sorted(ids))
        for finding in ids[::7]:
            self.assertTrue(self.run_program("help", finding).stdout.startswith(finding + ", "))

    def test_of_a_finding_names_what_stands_in_its_places(self):
        self.assertIn("unknown key 'NAME' in ...\n", self.run_program("help", "key-unknown").stdout)
        self.assertIn("N % of the posts' motion in 'NAME' does", self.run_program("help", "response-posts-off").stdout)
        self.assertNotIn("......", self.run_program("help", "findings").stdout)

    def test_ends_with_5_when_stdout_is_full(self):
        for words in (["man"], ["completion", "zsh"], ["init", "car"]):
            with open("/dev/full", "w") as full:
                code = subprocess.run([FOURPOST, *words], cwd=self.folder, stdout=full, stderr=subprocess.PIPE).returncode
            self.assertEqual(code, 5, words)


if __name__ == "__main__":
    unittest.main()
