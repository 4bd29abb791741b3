"""Time histories made into frequency responses, by the command and by a study."""
import json
import math
import unittest

from program import SOURCE, ProgramTest

RATE = 200
STUDY = """vehicle: car.urdf
recordings:
  - {{{recording}}}
channels: {{a_body: a_body, s_strut: s_strut}}
band: [1 Hz, 10 Hz]
"""


def dwells(frequencies):
    """Two seconds of rest, then four seconds of each."""
    heights = [0.0] * (2 * RATE)
    phase = 0.0
    for frequency in frequencies:
        for _ in range(4 * RATE):
            phase += 2 * math.pi * frequency / RATE
            heights.append(5e-3 / frequency * math.sin(phase))
    return heights


class Frf(ProgramTest):
    def setUp(self):
        super().setUp()
        self.copy("meshes")
        text = (SOURCE / "studies/starter/vehicle.urdf").read_text()
        self.write("car.urdf", text)
        rows = "".join(f"{k / RATE:.4f},{z:.9g}\n" for k, z in enumerate(dwells([2, 3, 5, 8])))
        self.write("heights.csv", "time,post\ns,m\n" + rows)
        self.run_program("simulate", "car.urdf", "--recording", "heights.csv", "--rate", f"{RATE}Hz", "--noise", "0.1%",
                         "--engine", "reduced", "-o", "dwells.csv")

    def respond(self, recording):
        self.write("study.yaml", STUDY.format(recording=recording))
        return json.loads(self.run_program("response", "study.yaml", "--engine", "reduced", "--json").stdout)

    def test_is_what_a_study_makes_of_the_same_file(self):
        self.run_program("frf", "dwells.csv", "-o", "frf")
        files = {file.name for file in (self.folder / "frf").iterdir()}
        self.assertEqual(files, {"heave.csv", "heave.svg", "recordings.yaml", "frf.json"})
        table = self.respond("file: frf/heave.csv, posts: heave")
        history = self.respond("file: dwells.csv, posts: heave")
        for one, other in zip(table["channels"], history["channels"], strict=True):
            # A table has ten digits.
            self.assertAlmostEqual(one["rms_dB"], other["rms_dB"], 7)
            # The vehicle is the one that was simulated: noise of 0.1 % and what is left of the run-in.
            self.assertLess(other["rms_dB"], 0.05, other)
            self.assertLess(other["rms_deg"], 0.3, other)

    def test_of_a_study_names_what_contradicts_it(self):
        for recording, finding in (("file: dwells.csv, posts: {post: 0.5, x: 1}", "sine-post-unknown"),
                                   ("file: dwells.csv, posts: heave, repeats: 3", "sine-repeats-counted"),
                                   ("file: dwells.csv, posts: heave, post_channels: {post: nothing}",
                                    "response-post-missing"),
                                   ("file: dwells.csv, posts: heave, post_channels: 3", "sine-post-channels"),
                                   ("file: dwells.csv, posts: heave, post_channels: {FL: post_post, FR: s_strut}",
                                    "sine-posts-unmapped")):
            with self.subTest(recording):
                self.write("study.yaml", STUDY.format(recording=recording))
                self.assert_finding(self.run_program("response", "study.yaml", code=3).stderr, finding)

    def test_refuses_what_it_cannot_use(self):
        self.assert_finding(self.run_program("frf", "dwells.csv", "--post", "FL", code=2).stderr, "post-channel-malformed")
        self.assert_finding(self.run_program("frf", "dwells.csv", "--kind", "steped", code=2).stderr, "value-unknown")
        self.assert_finding(self.run_program("frf", "car.urdf", code=3).stderr, "vehicle-for-recording")
        self.assert_finding(self.run_program("frf", "dwells.csv", "-o", ".", code=5).stderr, "folder-holds-input")


if __name__ == "__main__":
    unittest.main()
