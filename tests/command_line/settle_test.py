"""Files whose springs do not hold the design pose: what is shown, and the files that are at rest."""
import json
import re
import unittest

from program import SOURCE, ProgramTest

MESHES = SOURCE / "meshes"


class Settle(ProgramTest):
    def lowered(self, old='<linear stiffness="$k_front"/>',
                new='<linear stiffness="$k_front" free_length="440 mm"/>'):
        """A roadster on front coils that are too short to hold it as drawn."""
        text = (SOURCE / "urdf/independent_roadster.urdf").read_text()
        self.assertIn(old, text)
        return self.write("lowered.urdf", text.replace("../meshes", str(MESHES)).replace(old, new))

    def pose(self, file, *words):
        return json.loads(self.run_program("settle", file, *words, "--json").stdout)

    def test_writes_the_file_at_rest(self):
        file = self.lowered()
        self.run_program("check", file, code=3)
        pose = self.pose(file, "--equilibrium", "-o", "rest.urdf")
        self.assertFalse(pose["is_at_rest_as_drawn"])
        body = next(link for link in pose["links"] if link["name"] == "body")
        self.assertLess(body["shift_m"][2], -0.02)
        self.assertTrue(self.pose("rest.urdf")["is_at_rest_as_drawn"])
        checked = json.loads(self.run_program("check", "rest.urdf", "--json").stdout)
        for strut, spring in zip(checked["struts"], pose["springs"]):
            self.assertEqual(strut["element"], spring["element"])
            # Of a length of 0.4 m and a force of 3 kN, Newton's method keeps nine digits.
            self.assertAlmostEqual(strut["length_m"], spring["length_m"], places=9)
            self.assertAlmostEqual(strut["tension_N"], spring["force_N"], places=4)
        for corner, tyre in zip(checked["corners"], pose["tyres"]):
            self.assertAlmostEqual(corner["load_N"], tyre["force_N"], places=4)

    def test_headline_has_the_turn_of_the_body(self):
        # Shorter coils in front only: the nose goes down.
        headline = self.run_program("settle", self.lowered()).stdout.splitlines()[0]
        self.assertRegex(headline, r": settles by up to [0-9.]+ mm and [0-9.]+ deg; 'body' rolls [-0-9.]+ deg and pitches [0-9.]+ deg$")
        body = next(link for link in self.pose(self.lowered())["links"] if link["name"] == "body")
        self.assertGreater(body["turn_rad"][1], 0.005)
        self.assertIn(f"pitches {180 / 3.141592653589793 * body['turn_rad'][1]:.3f} deg", headline)

    def test_keeps_free_lengths_and_warns_of_bounds(self):
        run = self.run_program("settle", self.lowered(), "-o", "rest.urdf")
        self.assert_finding(run.stderr, "settled-at-one-value", "rest.urdf")
        self.assertIn('free_length="440 mm"', (self.folder / "rest.urdf").read_text())
        self.assertTrue(self.pose("rest.urdf")["is_at_rest_as_drawn"])

    def test_holds_the_design_pose(self):
        for what in ("preload", "free_length"):
            self.run_program("settle", self.lowered(), "--hold", what, "-o", f"{what}.urdf")
            self.assertTrue(self.pose(f"{what}.urdf")["is_at_rest_as_drawn"])
            self.assertIn(f'<linear stiffness="$k_front" {what}=', (self.folder / f"{what}.urdf").read_text())

    def test_moves_a_spring_along_its_table(self):
        points = "".join(f'<point extension="{x} mm" force="{f} N"/>'
                         for x, f in ((-200, -8000), (-100, -3000), (0, 0), (50, 1000)))
        file = self.lowered(new=f'<table at="-60 mm" preload="-2500 N">{points}</table>')
        text = (self.folder / file).read_text()
        self.write("lowered.urdf", re.sub(r'<fp:parameter name="k_front".*?/>', "", text, flags=re.DOTALL))
        self.assertFalse(self.pose(file, "--equilibrium", "-o", "rest.urdf")["is_at_rest_as_drawn"])
        self.assertTrue(self.pose("rest.urdf")["is_at_rest_as_drawn"])
        rest = (self.folder / "rest.urdf").read_text()
        self.assertNotIn('at="-60 mm"', rest)
        self.assertIn('<point extension="-100 mm" force="-3000 N"/>', rest)
        before, after = (json.loads(self.run_program("settle", one, "--json").stdout)["springs"] for one in (file, "rest.urdf"))
        for drawn, written in zip(before, after):
            self.assertAlmostEqual(drawn["force_N"], written["force_N"], delta=1)

    def test_refuses_what_a_file_cannot_state(self):
        new = '<cubic stiffness="$k_front" cubic="0.001 N/mm^3" free_length="440 mm"/>'
        run = self.run_program("settle", self.lowered(new=new), "-o", "rest.urdf", code=3)
        self.assert_finding(run.stderr, "law-counts-from-design")
        self.assertFalse((self.folder / "rest.urdf").exists())
        self.pose(self.folder / "lowered.urdf")

    def test_says_where_nothing_holds(self):
        run = self.run_program("settle", self.lowered('<linear stiffness="$k_front"/>',
                                                      '<linear stiffness="0 N/mm" preload="-100 N"/>'), code=3)
        self.assertRegex(run.stderr, r"\[(does-not-settle|parameter-unused)\]")


if __name__ == "__main__":
    unittest.main()
