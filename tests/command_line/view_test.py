"""fourpost view: a page of a vehicle that was never fitted. What it shows is tested in tests/report."""
import json
import re
import unittest

from program import SOURCE, ProgramTest

CAR = SOURCE / "urdf/quarter_car.urdf"


class View(ProgramTest):
    def json_of(self, *words):
        return json.loads(self.run_program(*words, "--json").stdout)

    def page(self, *words):
        file = self.run_program("view", *words).stdout.strip()
        text = (self.folder / file).read_text()
        return file, json.loads(re.search(r'id="data">(.*?)</script>', text, re.S).group(1))

    def test_is_named_after_its_vehicle_and_holds_its_response(self):
        file, data = self.page(CAR, "--frequencies", "1Hz:10Hz:5", "--mode", "heave")
        self.assertEqual(file, "quarter_car.html")
        response = self.json_of("response", CAR, "--frequencies", "1Hz:10Hz:5", "--engine", "reduced")
        channels = {channel["name"]: channel for channel in response["modes"][0]["channels"]}
        self.assertEqual({channel["name"] for channel in data["responses"]}, set(channels))
        for channel in data["responses"]:
            for shown, gain in zip(channel["gain_modelled"], channels[channel["name"]]["gain"]):
                # Six digits of the page.
                self.assertLess(abs(shown / gain - 1), 1e-5)

    def test_begins_at_the_values_of_the_options(self):
        _, data = self.page(CAR, "--set", "k=25kN/m", "--frequencies", "1Hz:4Hz:4", "-o", "car.html")
        values = {parameter["name"]: parameter["value"] for parameter in data["live"]["parameters"]}
        self.assertEqual(values["k"], 25)
        # What the page saves is that car.
        saved = self.write("saved.urdf", data["live"]["file"])
        params = self.json_of("params", saved)["parameters"]
        self.assertEqual({one["name"]: one["value"] for one in params}["k"], 25e3)

    def test_refuses_what_is_no_page_and_what_it_reads(self):
        self.assertIn("a page", self.run_program("view", CAR, "-o", "car.csv", code=2).stderr)
        self.run_program("view", CAR, "--mode", "swim", code=2)
        self.run_program("view", "nowhere.urdf", code=3)


if __name__ == "__main__":
    unittest.main()
