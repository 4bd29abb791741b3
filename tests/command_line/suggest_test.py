"""What `fourpost suggest` names first is what was planted; its files can be fitted."""
import csv
import json
import math
import random
import statistics
import sys
import unittest

import jsonschema

from program import FOURPOST, SOURCE, ProgramTest, add_noise

sys.path.insert(0, str(SOURCE / "tests/validation"))
import random_stations  # noqa: E402
import suggest  # noqa: E402

SCHEMA = json.loads((SOURCE / "identify/command_line/schema/suggest.json").read_text())
CAR = "quarter_car"
FRICTION = ("friction", CAR, suggest.friction("damper", 40), None, "friction", {"damper"}, [])
CLEAN = ("none", CAR, lambda text: text, None, "", set(), [])


class Suggest(ProgramTest):
    def record(self, case):
        suggest.four_post(FOURPOST, self.folder, case, random.Random(1))

    def fit(self, study, folder, *more, code=0):
        self.run_program("fit", study, "-o", folder, "--threads", "1", "--accept-implausible", *more, code=code)

    def missing(self):
        return json.loads((self.folder / "run/result.json").read_text())["missing"]

    def suggested(self, *more):
        text = self.run_program("suggest", "run", "--study", "study.yaml", "--json", *more).stdout
        document = json.loads(text)
        jsonschema.Draft202012Validator(SCHEMA).validate(document)
        return document

    def test_names_planted_friction(self):
        self.record(FRICTION)
        self.fit("study.yaml", "run")
        before = self.suggested("--apply", "1", "-o", "with_friction")
        first = before["suggestions"][0]
        # The fit has named it as well.
        self.assertEqual(self.missing()["suggestions"][0], first)
        self.assertIn("What is missing", (self.folder / "run/report.html").read_text())
        self.assertEqual((first["mechanism"], first["elements"]), ("friction", ["damper"]))
        # A few steps of Gauss and Newton from a model without it do not reach the optimum.
        self.assertAlmostEqual(first["parameters"][0]["value"], 40, delta=15)
        self.fit("with_friction/study.yaml", "run")
        after = json.loads((self.folder / "run/result.json").read_text())
        friction = next(p for p in after["parameters"] if p["name"].startswith("friction"))
        # 0.5 % of noise leave the friction to some per cent.
        self.assertAlmostEqual(friction["value"], 40, delta=2)
        self.assertLess(after["misfit"], 0.2 * before["misfit"])

    def test_intervals_reach_to_the_car_with_what_is_missing(self):
        number = 1  # friction of a guide and of the spring's ends, which Model 2 of the station lacks
        made = random_stations.drawn(random.Random(number))
        random_stations.record(FOURPOST, self.folder, made, random.Random(number))
        self.fit(random_stations.study("model2", self.folder), "run")
        result = json.loads((self.folder / "run/result.json").read_text())
        together = " ".join(result["missing"]["together"]["additions"])
        self.assertIn("elastic friction", together)
        self.assertIn("guide 'body_travel'", together)
        truth = random_stations.truth(made, "model2")
        limits = set()
        for one in result["parameters"]:
            low, high = one["interval_95"]
            self.assertTrue(low <= truth[one["name"]] <= high, one)
            limits.add(one["limited_by"])
        self.assertIn("missing: elastic friction (hysteresis) beside spring 'spring'", limits)
        # Draws reach to the same side: their means are half-way, by their own chance.
        self.run_program("draws", "run", "-n", "400", "-o", "draws.csv")
        with open(self.folder / "draws.csv", newline="") as file:
            names, _, *rows = csv.reader(file)
        covariance = result["intervals"]["covariance"]
        values = {one["name"]: one["value"] for one in result["parameters"]}
        for name, moved in zip(covariance["parameters"], covariance["moved_by_missing"]):
            logs = [math.log(float(row[names.index(name)]) / values[name]) for row in rows]
            spread = 5 * statistics.stdev(logs) / math.sqrt(len(logs))
            self.assertAlmostEqual(statistics.mean(logs), moved / 2, delta=spread, msg=name)
        # Closer to the truth than the values are: by less than half of their errors.
        moves = {move["name"]: 1 + move["percent"] / 100 for move in result["missing"]["together"]["moves"]}
        for one in result["parameters"]:
            error = abs(one["value"] / truth[one["name"]] - 1)
            if error > 0.05:
                self.assertLess(abs(one["value"] * moves[one["name"]] / truth[one["name"]] - 1), error / 2, one)

    def test_is_silent_of_a_twin(self):
        self.record(CLEAN)
        self.fit("study.yaml", "run")
        self.assertIsNone(self.missing())
        self.assertEqual(self.suggested()["suggestions"], [])
        self.assertGreater(len(self.suggested("--all")["suggestions"]), 10)
        # Each addition without an answer has its reason.
        every = self.suggested("--all")
        self.assertEqual(len(every["failures"]), every["failed"])
        for one in every["failures"]:
            self.assertTrue(one["reason"], one)
        # Nor is there one of that number.
        answer = self.run_program("suggest", "run", "--study", "study.yaml", "--apply", "9999", "-o", "new", code=2)
        self.assert_finding(answer.stderr, "suggestion-unknown")

    def test_takes_no_noise_of_posts_for_physics(self):
        """An exact model, 1 % of noise on every channel, on the posts as well."""
        self.run_program("simulate", SOURCE / "urdf/quarter_car.urdf", "--road", "C", "--speed", "50km/h", "--duration", "20s",
                         "--rate", "200Hz", "--engine", "reduced", "--seed", "7", "-o", "clean.csv")
        noise = add_noise(self.folder / "clean.csv", self.folder / "recording.csv", 0.01, seed=3)
        self.write("study.yaml", "\n".join([
            f"vehicle: {SOURCE / 'urdf/quarter_car.urdf'}", "histories:", "  - file: recording.csv",
            "    posts: {post: post_post}",
            f"    channels: {{{', '.join(f'{name}: {name}' for name in noise if name != 'post_post')}}}",
            "model_error: {history: 1 %}", "search: {evaluations: 20, starts: 1}", ""]))
        self.fit("study.yaml", "run")
        result = json.loads((self.folder / "run/result.json").read_text())
        # Noise is known to some per cent.
        self.assertAlmostEqual(result["misfit"], 1, delta=0.15)
        self.assertGreater(result["post_noise_share"], 0.5)
        self.assertIsNone(result["missing"])
        self.assertNotIn("missing", " ".join(one["limited_by"] for one in result["parameters"]))
        answer = self.run_program("suggest", "run", "--study", "study.yaml")
        self.assert_finding(answer.stderr, "suggest-post-noise", "run/result.json")
        # Neither is it misfit of channels, nor motion: the road has nothing above 30 Hz, the noise goes up to 100.
        for channel in result["channels"]:
            self.assertLess(channel["misfit"], 1.3, channel["name"])
        posts = next(one for one in result["covered"] if one["quantity"] == "frequency")
        self.assertLess(posts["upper"], 35)
        self.predict_parts({channel["name"]: channel["nmse_percent"] for channel in result["channels"]})

    def predict_parts(self, errors):
        """Of the noisy recording three seconds in its middle, and all but what a logger held: no worse than the fit by much."""
        lines = (self.folder / "recording.csv").read_text().splitlines()
        self.write("middle.csv", "\n".join(lines[:2] + lines[2002:2602]) + "\n")
        held = lines[:2002] + [f"{lines[k].split(',')[0]},{lines[2001].split(',', 1)[1]}" for k in range(2002, 2042)] + lines[2042:]
        self.write("held.csv", "\n".join(held) + "\n")
        points = {}
        for name in ("recording", "middle", "held"):
            answer = self.run_program("predict", "run", "--recording", f"{name}.csv", "--json")
            predicted = json.loads(answer.stdout)
            for channel in predicted["channels"]:
                self.assertLess(channel["nmse_percent"], 2 * errors[channel["name"]], channel)
            counts = predicted["band_95"]["channels"]
            points[name] = counts[0]["points"]
            if name == "held":
                self.assert_finding(answer.stderr, "channel-held", "held.csv")
                self.assert_finding(answer.stderr, "input-unknown", "run/study.yaml")
                self.assertLess(points["held"], 0.99 * points["recording"])
            self.assertLess(sum(one["outside"] for one in counts), 0.1 * sum(one["points"] for one in counts), name)

    def test_looks_for_delays_of_histories_and_states_the_misfit_of_the_fit(self):
        """With a channel that comes 12 ms late, other channels listed in braces, and noise on the posts as well."""
        self.run_program("simulate", SOURCE / "urdf/quarter_car.urdf", "--road", "C", "--speed", "50km/h", "--duration", "6s",
                         "--rate", "200Hz", "--engine", "reduced", "--seed", "7", "-o", "clean.csv")
        noise = add_noise(self.folder / "clean.csv", self.folder / "recording.csv", 0.01, seed=3)
        channels = {name: f"{{channel: {name}}}" for name in noise if name != "post_post"}
        late = next(name for name in channels if name.startswith("a_"))
        channels[late] = f"{{channel: {late}, delay: -12 ms}}"
        self.write("study.yaml", "\n".join([
            f"vehicle: {SOURCE / 'urdf/quarter_car.urdf'}", "histories:", "  - file: recording.csv",
            "    posts: {post: post_post}",
            f"    channels: {{{', '.join(f'{name}: {source}' for name, source in channels.items())}}}",
            "model_error: {history: 1 %}", "search: {evaluations: 20, starts: 1}", ""]))
        self.run_program("fit", "study.yaml", "-o", "run", "--threads", "1", "--accept-implausible")
        every = self.suggested("--all")
        self.assertEqual([one["text"] for one in every["failures"] if one["text"].startswith("delay")], [])
        first = every["suggestions"][0]
        self.assertEqual((first["mechanism"], first["elements"]), ("delay", [f"'{late}'"]))
        # To a sample's fifth: the channel is interpolated between samples of 5 ms.
        self.assertAlmostEqual(first["correction"], 0.012, delta=0.001)
        result = json.loads((self.folder / "run/result.json").read_text())
        self.assertEqual(every["misfit"], result["misfit"])

    def test_holds_what_the_study_sets(self):
        """The file has another tyre than the study states."""
        self.record(FRICTION)
        self.replace_in("vehicle.urdf", 'value="230 kN/m"', 'value="190 kN/m"')
        study = (self.folder / "study.yaml").read_text() + "free: all but [kt]\n"
        self.write("study.yaml", study + "start: {kt: 230 kN/m}\n")
        self.fit("study.yaml", "run")
        first = self.suggested("--apply", "1", "-o", "with_friction")["suggestions"][0]
        self.assertEqual(first["mechanism"], "friction")
        check = json.loads(self.run_program("check", "with_friction/vehicle.urdf", "--json").stdout)
        self.assertEqual([one["value"] for one in check["parameters"] if one["name"] == "kt"], [230e3])

    def test_friction_of_a_damper_on_a_bench_can_be_fitted(self):
        """It is a second damper beside the one that was recorded. This one has none, so its speed is not determined: code 1."""
        suggest.bench(self.folder, ("", "linear", 0), random.Random(1))
        self.fit("study.yaml", "run")
        every = self.suggested("--all")["suggestions"]
        number = next(one["number"] for one in every if one["mechanism"] == "friction")
        self.suggested("--all", "--apply", number, "-o", "with_friction")
        self.fit("with_friction/study.yaml", "run2", code=1)
        result = json.loads((self.folder / "run2/result.json").read_text())
        found = {one["name"]: one for one in result["parameters"]}
        self.assertLess(found["friction_damper"]["value"], 1)
        self.assertIn("v_friction_damper", found)


if __name__ == "__main__":
    unittest.main()
