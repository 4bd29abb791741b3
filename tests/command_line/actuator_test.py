"""A vehicle that measured forces drive: the fit finds it, and a force of the other sign is named as what it is."""
import json
import math
import unittest

from program import SOURCE, ProgramTest

RATE, STEPS = 250, 20
MASS, WHEEL, K, KT, C = 220.0, 24.0, 16e3, 210e3, 1300.0


def force(t):
    return 150 * sum(math.sin(2 * math.pi * hertz * t + phase) for hertz, phase in ((1.1, 0.3), (2.9, 1.2), (8.3, 0.4)))


def slope(t, y):
    body, body_rate, wheel, wheel_rate = y
    tension = K * (body - wheel) + C * (body_rate - wheel_rate) + force(t)
    return body_rate, -tension / MASS, wheel_rate, (tension - KT * wheel) / WHEEL


def recording(seconds=8):
    """Of a linear quarter car on a post at rest, by Runge and Kutta's method."""
    h, y = 1 / (RATE * STEPS), (0.0, 0.0, 0.0, 0.0)
    rows = ["time,tension,a_sprung,a_unsprung,s_strut", "s,N,m/s^2,m/s^2,m"]
    on = lambda share, k: tuple(a + share * h * b for a, b in zip(y, k))
    for step in range(seconds * RATE * STEPS):
        t = step * h
        k1 = slope(t, y)
        if step % STEPS == 0:
            rows.append(f"{t:.4f},{force(t):.6g},{k1[1]:.7g},{k1[3]:.7g},{y[0] - y[2]:.8g}")
        k2 = slope(t + h / 2, on(0.5, k1))
        k3 = slope(t + h / 2, on(0.5, k2))
        k4 = slope(t + h, on(1, k3))
        y = tuple(v + h / 6 * (a + 2 * b + 2 * c + d) for v, a, b, c, d in zip(y, k1, k2, k3, k4))
    return "\n".join(rows) + "\n"


class DrivenByAForce(ProgramTest):
    def setUp(self):
        super().setUp()
        text = (SOURCE / "urdf/quarter_car.urdf").read_text().replace("../meshes", str(SOURCE / "meshes"))
        self.write("car.urdf", text.replace(
            "<fp:post ", '<fp:actuator name="shaker" parent="strut_top" child="strut_bottom" axis="0 0 1"/>\n  <fp:post '))
        self.write("driven.csv", recording())

    def fit(self, sign, code):
        self.write("study.yaml", "vehicle: car.urdf\nhistories:\n  - file: driven.csv\n    start: 3 s\n"
                   f"    actuators: {{shaker: {{channel: tension, sign: {sign}}}}}\n"
                   "channels: {a_sprung: a_sprung, a_unsprung: a_unsprung, s_strut: s_strut}\n"
                   "search: {evaluations: 40, population: 20, starts: 1}\n")
        return self.run_program("fit", "study.yaml", "-o", f"run{sign}", "--json", code=code)

    def test_finds_what_was_driven(self):
        found = {p["name"]: p["value"] for p in json.loads(self.fit(1, 0).stdout)["parameters"]}
        true = {"m_sprung": MASS, "m_unsprung": WHEEL, "k": K, "kt": KT, "c_bump": C, "c_rebound": C}
        for name, value in true.items():
            # The force is a spline through its samples: 30 a period of the fastest, off by (2 pi / 30)^4 / 384 of it.
            self.assertAlmostEqual(found[name] / value, 1, delta=2e-3, msg=name)

    def test_names_a_force_of_the_other_sign(self):
        outcome = self.fit(-1, 1)
        self.assertIn("tension of actuator 'shaker' had the wrong sign", outcome.stderr)
        self.assertNotIn("channel-inverted", outcome.stderr)
        self.assertIn("study.yaml:5: warning", outcome.stderr)


if __name__ == "__main__":
    unittest.main()
