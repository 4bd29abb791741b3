"""Fits that are killed, starved and started twice: no evaluation is lost, and in the end the result is the same."""
import difflib
import itertools
import json
import os
import random
import resource
import shutil
import signal
import stat
import subprocess
import time
import unittest

from program import FOURPOST, SOURCE, Archive, ProgramTest, drop_swept_sine

VEHICLE = "urdf/landrover110_linkage.urdf"
# Somebody whom permissions hold off, which they do not do with root.
UNPRIVILEGED = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}


def limit_files(blocks):
    """Of 512 bytes."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512 * blocks, 512 * blocks))


def permit(path, write):
    everybody = stat.S_IWUSR | stat.S_IWGRP | stat.S_IWOTH
    mode = path.stat().st_mode
    path.chmod(mode | everybody if write else mode & ~everybody)


class ResumeTest(ProgramTest):
    """Of a study whose uninterrupted fit is in the folder `whole`."""
    study = "studies/landrover110/model2.yaml"
    # A fit of some tenths of a second.
    changes = {"band: [0.5 Hz, 12 Hz]": "band: [1.5 Hz, 4 Hz]", "  evaluations: 100\n": "  evaluations: 200\n",
               "  starts: 4": "  starts: 2"}

    @classmethod
    def setUpClass(cls):
        cls.make_kept()
        for part in ("urdf", "meshes", os.path.dirname(cls.study)):
            shutil.copytree(SOURCE / part, cls.kept / part)
        if "landrover110" in cls.study:
            drop_swept_sine(cls.kept / cls.study)
        maker = cls()
        maker.folder = cls.kept
        for old, new in cls.changes.items():
            maker.replace_in(cls.study, old, new)
        cls.answer = cls.run_kept(*cls.words_of_fit("whole")).stdout

    def setUp(self):
        super().setUp()
        shutil.copytree(self.kept, self.folder, dirs_exist_ok=True)

    @classmethod
    def words_of_fit(cls, folder):
        return "fit", "--no-suggest", cls.study, "--threads", "2", "-o", folder

    def fit(self, folder, *words, code=0, **more):
        return self.run_program(*self.words_of_fit(folder), *words, code=code, **more)

    def resume(self, folder, code=0):
        return self.fit(folder, "--resume", code=code)

    def start_fit(self, folder, *words, evaluations):
        """Returns when its archive has so many, or when it has ended."""
        program = self.start_program(*self.words_of_fit(folder), *words)
        while program.poll() is None and self.evaluations_at_work(folder) < evaluations:
            time.sleep(0.001)
        return program

    def path_of_archive(self, folder):
        return self.folder / folder / "archive.sqlite"

    def archive(self, folder):
        return Archive(self.path_of_archive(folder))

    def evaluations_at_work(self, folder):
        return Archive.evaluations_at_work(self.path_of_archive(folder))

    def read(self, name):
        return (self.folder / name).read_text()

    def result(self, folder):
        return json.loads(self.read(f"{folder}/result.json"))

    def change(self, old, new):
        self.replace_in(self.study, old, new)

    def assert_same_files(self, folder, expected="whole"):
        for file in ("result.json", "vehicle.urdf", "response.csv", "response.svg"):
            texts = [self.read(f"{name}/{file}").splitlines() for name in (expected, folder)]
            # The first of them: all are too long to print.
            lines = list(itertools.islice(difflib.unified_diff(*texts, expected, folder, lineterm="", n=1), 30))
            self.assertEqual(lines, [], file)

    def assert_same_results(self, folder, expected="whole"):
        self.assert_same_files(folder, expected)
        self.assertTrue(self.archive(folder).content == self.archive(expected).content, folder)

    def assert_no_evaluation_twice(self, folder):
        archive = self.archive(folder)
        self.assertEqual(archive.paid, archive.evaluations, folder)
        self.assertEqual(self.result(folder)["evaluations"]["paid"], archive.evaluations, folder)


class ResumeOfAKilledFit(ResumeTest):
    # A quarter car: little but evaluations.
    study = "studies/starter/study.yaml"
    changes = {"  evaluations: 100\n": "  evaluations: 800\n  generations: 1000\n"}

    def test_after_fifty_kills_gives_the_result_of_an_uninterrupted_fit(self):
        self.assert_no_evaluation_twice("whole")
        total = self.archive("whole").evaluations
        numbers = random.Random(7)
        kills = kills_at_work = logs_left = evaluations_at_kills = run = 0
        while kills < 50:
            # Of five kills a run, some of which come too late.
            self.assertLess(run, 100)
            folder = f"run{run}"
            for _ in range(5):
                begin = min(self.evaluations_at_work(folder), total - 1)
                program = self.start_fit(folder, "--resume", evaluations=numbers.randint(begin, total - 1))
                program.kill()
                _, errors = program.communicate()
                # Or it was done before.
                self.assertIn(program.returncode, (-signal.SIGKILL, 0), errors)
                if program.returncode == 0:
                    break
                kills += 1
                stored = self.evaluations_at_work(folder)
                evaluations_at_kills += stored
                # With all evaluations in it the archive is closed, and the results are written.
                if stored == total:
                    continue
                kills_at_work += 1
                log = self.folder / f"{folder}/archive.sqlite-wal"
                logs_left += log.exists() and log.stat().st_size > 0
            self.resume(folder)
            self.assert_same_results(folder)
            self.assert_no_evaluation_twice(folder)
            run += 1
        # They were killed at work: neither before the first evaluation nor after the last, on the whole.
        self.assertGreater(evaluations_at_kills, kills * total // 20)
        self.assertLess(evaluations_at_kills, kills * total * 19 // 20)
        # And most of them left a log, which the next start took in. How many of them come before the results are
        # written depends on the machine.
        self.assertGreater(kills_at_work, kills // 5)
        self.assertGreater(logs_left, kills_at_work // 2)


class Resume(ResumeTest):
    def test_goes_on_after_ctrl_c(self):
        # So many evaluations that Ctrl-C comes before the last, on any machine.
        budget, endless = "  evaluations: 200\n", "  evaluations: 100000000\n  generations: 1000000\n"
        self.change(budget, endless)
        program = self.start_fit("run", evaluations=10)
        program.send_signal(signal.SIGINT)
        _, errors = program.communicate()
        self.assertEqual(program.returncode, 130, errors)
        self.change(endless, budget)
        self.assertRegex(self.resume("run").stderr, "[1-9][0-9]* of [0-9]+ evaluations come from run/archive.sqlite")
        self.assert_same_files("run")
        archive = self.archive("run")
        self.assertEqual(archive.paid, archive.evaluations)

    def test_reuses_evaluations_of_a_smaller_budget(self):
        before = self.archive("whole").evaluations
        self.change("  evaluations: 200\n", "  evaluations: 240\n")
        self.assertIn("evaluations come from", self.resume("whole").stderr)
        archive = self.archive("whole")
        self.assertGreater(archive.evaluations, before)
        self.assertEqual(archive.paid, archive.evaluations)

    def test_reuses_evaluations_for_another_loss(self):
        self.change("refine: {loss: huber}\n", "")
        self.fit("run")
        before = self.result("run")
        self.assertEqual(before["refine"]["loss"], "none")
        self.assertNotIn("scale", before["refine"])
        self.change("search:\n", "refine: {loss: huber, scale: 1}\nsearch:\n")
        robust = self.resume("run")
        self.assertIn(" by huber beyond 1 sd for ", robust.stdout)
        # Those of the search at least.
        self.assertRegex(robust.stderr, "[2-9][0-9][0-9] of [0-9]+ evaluations come from")
        after = self.result("run")
        self.assertEqual(after["refine"]["loss"], "huber")
        self.assertEqual(after["refine"]["scale"], 1)
        self.assertGreater(after["refine"]["step"], 0)
        self.assertLess(after["cost"], before["cost"])

    def test_names_what_changed_and_leaves_the_archive(self):
        stored = self.archive("whole").content

        def assert_refused(change):
            errors = self.resume("whole", code=3).stderr
            self.assertIn("cannot resume", errors)
            self.assertIn(f"another state of: {change}: undo the change", errors)
            self.assertTrue(self.archive("whole").content == stored)

        self.change("[1.5 Hz, 4 Hz]", "[1.5 Hz, 3 Hz]")
        assert_refused("the recordings, their channels, the static loads, the band or the window")
        self.change("[1.5 Hz, 3 Hz]", "[1.5 Hz, 4 Hz]")
        self.change("  mean: 0.3 mm", "  mean: 0.4 mm")
        assert_refused("the free parameters, the model error or the deadline")
        # Still so when asked again.
        assert_refused("the free parameters, the model error or the deadline")
        self.change("  mean: 0.4 mm", "  mean: 0.3 mm")
        self.replace_in(VEHICLE, 'lower="1450 kg"', 'lower="1451 kg"')
        assert_refused("the vehicle")

        # Without the option it is fitted anew, beside what was there.
        self.fit("whole")
        both = self.archive("whole")
        self.assertTrue(both.content != stored)
        self.replace_in(VEHICLE, 'lower="1451 kg"', 'lower="1450 kg"')
        self.resume("whole")
        self.assertEqual(self.archive("whole").evaluations, both.evaluations)

    def test_without_an_archive_starts_from_the_beginning(self):
        self.assertIn("there is no run/archive.sqlite to resume from: starting from the beginning",
                      self.resume("run").stderr)
        self.assertNotIn("from the beginning", self.resume("run").stderr)


class Fit(ResumeTest):
    def can_run_unprivileged(self):
        self.folder.chmod(0o755)
        try:
            return subprocess.run([FOURPOST, "--version"], cwd=self.folder, capture_output=True,
                                  **UNPRIVILEGED).returncode == 0
        except OSError:
            return False

    def assert_is_resumed(self, folder, least):
        """From at least so many evaluations, without a result so far."""
        self.assertFalse((self.folder / folder / "result.json").exists())
        kept = self.archive(folder).evaluations
        self.assertGreaterEqual(kept, least)
        self.assertIn(f"{kept} of " if kept > 0 else "results: ", self.resume(folder).stderr)
        self.assert_same_results(folder)
        self.assert_no_evaluation_twice(folder)

    def test_needs_its_study_and_recordings_at_the_start_only(self):
        study = self.folder / self.study
        text = study.read_text()
        program = self.start_fit("run", evaluations=10)
        study.unlink()
        (study.parent / "pitch_frf.csv").unlink()
        shutil.copyfile(study.parent / "static.csv", study.parent / "bounce_frf.csv")
        _, errors = program.communicate()
        self.assertEqual(program.returncode, 0, errors)
        self.assertEqual(self.read("run/study.yaml"), text)
        files = self.result("run")["fitted_files"]
        self.assertEqual(files, self.result("whole")["fitted_files"])
        self.assertEqual(len(files), 2)

    def test_that_is_finished_evaluates_nothing_again(self):
        """With or without the option."""
        result = self.read("whole/result.json")
        for options in (("--resume",), ()):
            with self.subTest(options):
                again = self.fit("whole", *options)
                self.assertEqual(again.stdout, self.answer)
                self.assertEqual(self.read("whole/result.json"), result)
                count = self.archive("whole").evaluations
                self.assertIn(f"{count} of {count} evaluations come from", again.stderr)
        self.assert_no_evaluation_twice("whole")

    def test_shares_its_archive_with_another_one_at_the_same_time(self):
        paid = self.result("whole")["evaluations"]["paid"]
        rounds = overlapping = 0
        while rounds < 20 and overlapping < 3:
            rounds += 1
            shutil.rmtree(self.folder / "both", ignore_errors=True)
            programs = [self.start_program(*self.words_of_fit("both")) for _ in range(2)]
            (one, one_errors), (two, two_errors) = (program.communicate() for program in programs)
            self.assertEqual([program.returncode for program in programs], [0, 0], one_errors + two_errors)
            self.assertEqual(one, two)
            self.assert_same_results("both")
            # Else one came after the other.
            overlapping += f"{paid} of {paid} evaluations come from" not in one_errors + two_errors
        self.assertGreater(overlapping, 0)

    def test_counts_and_names_evaluations_beyond_the_deadline(self):
        self.change("  evaluations: 200\n", "  evaluations: 200\n  deadline: 0.001 ms\n")
        for _ in range(2):
            self.assertIn("fit all_failed: every evaluation failed: 201 timed out (took longer than ",
                          self.fit("run", code=4).stderr)
            self.assertFalse((self.folder / "run/result.json").exists())
            # Those of the search, and the look at what the data can tell.
            self.assertEqual(self.archive("run").evaluations, 201)

    def test_keeps_what_is_in_a_file_that_may_not_grow(self):
        # The largest one at the first transfer of the log into the file.
        for blocks in (1, 200, 2000, 6000):
            with self.subTest(blocks=blocks):
                folder = f"run{blocks}"
                self.assertIn("archive.sqlite: ", self.fit(folder, code=5, preexec_fn=limit_files(blocks)).stderr)
                self.assert_is_resumed(folder, least=1 if blocks >= 200 else 0)

    def test_keeps_what_is_on_a_full_disk(self):
        for size in (2000, 100000, 1000000):
            with self.subTest(size=size):
                folder = f"run{size}"
                variables = {"FULL_DISK_BYTES": str(size), "LD_PRELOAD": os.environ["FOURPOST_FULL_DISK"],
                             # Else a sanitizer wants to be preloaded first.
                             "ASAN_OPTIONS": "verify_asan_link_order=0"}
                self.assert_finding(self.fit(folder, code=5, env=os.environ | variables).stderr, "archive-disk-full")
                self.assert_is_resumed(folder, least=1 if size >= 100000 else 0)

    def test_keeps_what_is_in_a_folder_that_is_read_only(self):
        if not self.can_run_unprivileged():
            self.skipTest("permissions hold nobody off here")
        run = self.folder / "whole"
        stored = self.archive("whole").content
        result = self.read("whole/result.json")
        permit(run, write=False)
        for options in ((), ("--resume",), ("--seed", "9")):
            with self.subTest(options):
                self.assert_finding(self.fit("whole", *options, code=5, **UNPRIVILEGED).stderr, "folder-not-writable",
                                    "whole: error: ")
        # The archive alone.
        permit(run, write=True)
        permit(run / "archive.sqlite", write=False)
        self.assertIn("whole/archive.sqlite: ", self.fit("whole", "--seed", "9", code=5, **UNPRIVILEGED).stderr)
        permit(run / "archive.sqlite", write=True)
        self.assertTrue(self.archive("whole").content == stored)
        self.assertEqual(self.read("whole/result.json"), result)


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes", os.path.dirname(ResumeTest.study))
        for old, new in ResumeTest.changes.items():
            self.replace_in(ResumeTest.study, old, new)

    def test_shares_an_archive_between_methods_but_not_their_counts(self):
        words = ("compare", ResumeTest.study, "--methods", "dvhde,thesis,gb,bfgs", "--runs", "2", "--threads", "2",
                 "--json")
        without = self.run_program(*words).stdout
        shared = (*words, "--archive", "shared.sqlite")
        self.assertEqual(self.run_program(*shared).stdout, without)
        archive = Archive(self.folder / "shared.sqlite")
        self.assertGreater(archive.evaluations, 300)
        # However many runs asked at once.
        self.assertEqual(archive.paid, archive.evaluations)
        self.assertEqual(self.run_program(*shared).stdout, without)
        self.assertTrue(Archive(self.folder / "shared.sqlite").content == archive.content)


if __name__ == "__main__":
    unittest.main()
