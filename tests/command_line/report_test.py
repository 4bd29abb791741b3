"""`fourpost report`: pages of one run and of several compared, and what it says of runs that it cannot read."""
import json
import os
import resource
import shutil
import unittest

from program import SOURCE, ProgramTest


def limit_files():
    """No file beyond 100 blocks of 512 bytes: stands for a full disk."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (100 * 512, 100 * 512))


class ReportTest(ProgramTest):
    # Folders and studies of the fits that the tests of a class share.
    fits = {}
    options = ()

    @classmethod
    def setUpClass(cls):
        cls.make_kept()
        for part in ("urdf", "meshes", *{os.path.dirname(study) for study in cls.fits.values()}):
            shutil.copytree(SOURCE / part, cls.kept / part)
        cls.warnings = {folder: cls.run_kept("fit", *cls.options, study, "-o", folder).stderr
                        for folder, study in cls.fits.items()}

    def setUp(self):
        super().setUp()
        shutil.copytree(self.kept, self.folder, dirs_exist_ok=True)

    def report(self, *words, code=0):
        return self.run_program("report", *words, code=code)

    def read(self, name):
        return (self.folder / name).read_text()

    def assert_error(self, errors, place, finding):
        self.assert_finding(errors, finding, f"{place}: error: ")


class OfOneRun(ReportTest):
    fits = {"run": "studies/landrover110/model2.yaml"}
    options = ("--no-suggest",)

    def test_is_what_the_fit_wrote(self):
        page = self.read("run/report.html")
        for part in ("<h1>landrover110_linkage</h1>", "The fit converged.", "<code>c_front_bump</code>", "rear hop"):
            self.assertIn(part, page)
        answer = json.loads(self.report("run", "-o", "again.html", "--json").stdout)
        again = self.folder / "again.html"
        self.assertEqual(answer["bytes"], again.stat().st_size)
        # The fitted vehicle comes from its file here, in whose digits nothing is lost. The pages are too long to print.
        self.assertTrue(again.read_bytes() == (self.folder / "run/report.html").read_bytes())

    def test_goes_without_a_vehicle_that_is_gone(self):
        (self.folder / "run/vehicle.urdf").unlink()
        errors = self.report("run").stderr
        self.assertIn("vehicle.urdf", errors)
        self.assert_finding(errors, "vehicle-not-shown")
        self.assertNotIn('data-draw="viewer"', self.read("run/report.html"))

    def test_keeps_an_older_one_on_a_full_disk(self):
        before = self.read("run/report.html")
        errors = self.run_program("report", "run", code=5, preexec_fn=limit_files).stderr
        self.assertIn("[disk-full]", errors)
        self.assertTrue(self.read("run/report.html") == before)
        self.assertFalse((self.folder / "run/report.html.partial").exists())

    def test_does_not_overwrite_what_it_reads(self):
        self.report("run", "-o", "run/result.json", code=5)
        self.assertIn("termination", self.read("run/result.json"))


class OfRunsThatItCannotRead(ReportTest):
    def test_names_what_it_needs(self):
        (self.folder / "empty").mkdir()
        self.assert_error(self.report("empty", code=3).stderr, "empty", "run-empty")
        self.assert_finding(self.report("urdf/quarter_car.urdf", code=3).stderr, "run-not-there")
        self.run_program("modes", "urdf/quarter_car.urdf", "-o", "modes")
        self.assert_finding(self.report("modes", code=3).stderr, "result-not-of-fit")
        self.write("empty/result.json", "{")
        self.assert_finding(self.report("empty", code=3).stderr, "result-not-json")

    def test_names_what_a_comparison_needs(self):
        errors = self.report("one", "two", code=2).stderr
        self.assert_error(errors, "--output", "page-without-name")
        self.assertIn(" 2 ", errors)
        (self.folder / "one").mkdir()
        self.assert_error(self.report("one", "two", "-o", "models.html", code=3).stderr, "one", "run-empty")
        self.write("one/result.json", "{}")
        self.assert_error(self.report("one", "one", "-o", "models.html", code=3).stderr, "one/result.json",
                          "result-not-of-fit")
        self.assertFalse((self.folder / "models.html").exists())


class OfDampers(ReportTest):
    fits = {model: f"studies/damper/{model}.yaml" for model in ("model1", "model2")}

    def test_go_without_their_vehicle(self):
        """Between clamps nothing has to hold the rod, and there is nothing to see."""
        self.assertNotIn("equilibrium", self.warnings["model2"])
        page = self.read("model2/report.html")
        self.assertIn("Damper bench", page)
        for part in ("equilibrium", "The vehicle is not shown"):
            self.assertNotIn(part, page)

    def test_compare_runs(self):
        answer = json.loads(self.report("model1", "model2", "-o", "models.html", "--json").stdout)
        self.assertEqual(answer["bytes"], (self.folder / "models.html").stat().st_size)
        page = self.read("models.html")
        # What `fourpost rank` says of them.
        rank = json.loads(self.run_program("rank", "model1", "model2", "--json").stdout)
        for part in ("2 fits compared", f"Recommended: {rank['reason']}", 'data-draw="compared_bench"', "damper bench"):
            self.assertIn(part, page)

    def test_name_the_run_that_they_do_not_understand(self):
        good = json.loads(self.read("model1/result.json"))
        (self.folder / "bad").mkdir()

        def errors_with(change):
            self.write("bad/result.json", json.dumps(good | change))
            return self.report("model1", "bad", "-o", "models.html", code=3).stderr

        for change in ({"refine": 1}, {"static_loads": [1]}):
            with self.subTest(change):
                errors = errors_with(change)
                self.assert_error(errors, "bad/result.json", "result-not-understood")
                self.assertNotIn("model1/", errors)
        self.write("bad/bench.csv", "time_s\n0\n")
        errors = errors_with({"seed": 2})
        self.assert_error(errors, "bad/bench.csv:1", "fit-column-missing")
        self.assertIn("'recording': fit again [fit-column-missing]", errors)
        self.assertFalse((self.folder / "models.html").exists())


if __name__ == "__main__":
    unittest.main()
