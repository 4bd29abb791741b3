"""What `fourpost fit` says of recordings of four posts that cannot be right."""
import json
import re
import unittest

from program import ProgramTest, drop_swept_sine

MODEL1 = "studies/landrover110/model1.yaml"
STATIC = "studies/landrover110/static.csv"


class FitTest(ProgramTest):
    model = "model1"

    def setUp(self):
        super().setUp()
        self.copy("urdf", "meshes", "studies/landrover110")
        drop_swept_sine(self.folder / f"studies/landrover110/{self.model}.yaml")

    def fit(self, *words, code=0):
        study = f"studies/landrover110/{self.model}.yaml"
        return self.run_program("fit", "--no-suggest", study, "-o", "run", *words, code=code)


class Right(FitTest):
    def test_loads_are_not_spoken_of(self):
        warnings = self.fit().stderr
        for finding in ("[load-", "[loads-"):
            self.assertNotIn(finding, warnings)


class CrossWeight(FitTest):
    model = "model3"

    def test_of_a_right_car_is_named_once(self):
        """Its corners carry other loads than equal springs on both sides let them."""
        warnings = self.fit().stderr
        self.assertEqual(warnings.count("[static-loads-differ]"), 1)
        named = warnings[warnings.index("more than 3 standard deviations"):]
        self.assertRegex(named, r"'tyre_[FR][LR]' \d+ N (more|less) \([0-9.]+ sd\)")
        for part in ("cross weight", "scale of the cells", "centre of mass"):
            self.assertIn(part, named)


class Posts:
    """Holds the tests of each model, so that they do not run without one."""

    class Loads(FitTest):
        def fit_with(self, changes):
            """Each value of a load cell [N] replaced by another one."""
            for right, wrong in changes.items():
                self.replace_in(STATIC, right, wrong)
            # What loads and channels say against each other speaks against the fit.
            warnings = self.fit(code=1).stderr
            self.assertIn("[rig-", warnings)
            return warnings

        def test_of_wheelpans_are_within_the_range_that_is_printed(self):
            """They were weighed along: 25 kg each, 100 kg in all."""
            warnings = self.fit_with({"4971": "5216", "5092": "5337", "5493": "5738", "5497": "5742"})
            printed = re.search(r"add up to 2247 kg, .* between (\d+) and (\d+) kg in all "
                                r".*\[loads-heavier-than-motion\]", warnings)
            self.assertTrue(printed, warnings)
            self.assertLess(float(printed[1]), 100)
            self.assertGreater(float(printed[2]), 100)
            # A model that lacks friction has wrong masses as well, and Model 1 is known to.
            if self.model == "model1":
                self.assertIn("first add what the model lacks", warnings)
            result = json.loads((self.folder / "run/result.json").read_text())
            self.assertIn("loads-heavier-than-motion", json.dumps(result["warnings"]))

        def test_of_one_cell_that_is_off_are_named_by_their_tyre(self):
            """1000 N more front left, the corner of which the fit hides most."""
            warnings = self.fit_with({"4971": "5971"})
            self.assertNotIn("[loads-", warnings)
            for part in ("[load-far-off]", *self.far_off):
                self.assertIn(part, warnings)


class LoadsOfAxles(Posts.Loads):
    model = "model1"
    far_off = ("'front_tyre' fitted", "measured 11060 N")


class LoadsOfCorners(Posts.Loads):
    model = "model3"
    far_off = ("'tyre_FL' fitted", "measured 5971 N")


class WrongPosts(FitTest):
    def test_are_refused_unless_accepted(self):
        self.replace_in(MODEL1, "posts: pitch", "posts: heave")
        refused = self.fit(code=3).stderr
        for part in ("[posts-contradict-study]", "[posts-move-otherwise]", "--accept-implausible"):
            self.assertIn(part, refused)
        self.assertFalse((self.folder / "run").exists())
        forced = self.fit("--accept-implausible", "--json", code=1)
        self.assertIn("[posts-move-otherwise]", forced.stderr)
        self.assertIn("posts-move-otherwise", json.dumps(json.loads(forced.stdout)["warnings"]))


if __name__ == "__main__":
    unittest.main()
