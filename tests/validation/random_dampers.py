"""Random dampers on a bench that have more than their models, integrated here: see coverage.py."""
import csv
import math
import re

from run_program import SOURCE

MODELS = ["model2", "model3", "model4", "model5", "friction_knees"]
RATE_HZ = 500
DURATION_S = 20
STEPS = 20  # of the integration, per sample


def drawn(draw):
    """Bilinear rates, smooth about zero, in line with a hardening mount; at random knees, friction, gas, and the mass
    between damper and load cell."""
    around = lambda middle, share: middle * math.exp(draw.uniform(-share, share))
    damper = {"c_bump": around(1000, 0.5), "c_rebound": around(2000, 0.5), "k_series": around(0.8e6, 1.0),
              "k_series_cubic": draw.choice([0, draw.uniform(1e11, 10e12)]),
              "v_transition": draw.choice([0, draw.uniform(0.005, 0.05)]),
              "F_friction": draw.choice([0, draw.uniform(5, 60)]), "F_gas": draw.choice([0, draw.uniform(3, 40)]),
              "rod": draw.choice([0, draw.uniform(0.1, 0.8)])}
    damper["c_rebound"] = max(damper["c_rebound"], 1.3 * damper["c_bump"])
    knees = draw.choice([True, False])
    for side in ("bump", "rebound"):
        damper[f"v_{side}_knee"] = draw.uniform(0.1, 0.3) if knees else None
        damper[f"c_{side}_beyond"] = draw.uniform(0.4, 0.9) * damper[f"c_{side}"] if knees else damper[f"c_{side}"]
    return damper


def dashpot(damper):
    """Force over speed."""
    transition = damper["v_transition"]

    def of_side(v, side):
        knee, rate = damper[f"v_{side}_knee"], damper[f"c_{side}"]
        if knee is None or v <= knee:
            return rate * v
        return rate * knee + damper[f"c_{side}_beyond"] * (v - knee)

    def force(v):
        bump, rebound = -of_side(abs(v), "bump"), of_side(abs(v), "rebound")
        if transition == 0:
            return rebound if v > 0 else bump
        share = 0.5 + 0.5 * math.tanh(v / transition)
        return share * math.copysign(rebound, v) + (1 - share) * math.copysign(bump, v)

    return force


def inverse(force, most):
    """Speed over force, linear between a thousand points of an increasing law."""
    count = 4000
    speeds = [most * (2 * i / count - 1) * abs(2 * i / count - 1) for i in range(count + 1)]
    forces = [force(v) for v in speeds]
    where = [0]

    def speed(f):
        i = where[0]
        while i < count - 1 and forces[i + 1] < f:
            i += 1
        while i > 0 and forces[i] > f:
            i -= 1
        where[0] = i
        return speeds[i] + (speeds[i + 1] - speeds[i]) * (f - forces[i]) / (forces[i + 1] - forces[i])

    return speed


def motion(t):
    """Swept sine of 0.5 to 30 Hz: 25 mm at first, 1 mm at last."""
    octaves = math.log2(30 / 0.5) / DURATION_S
    hertz = 0.5 * 2 ** (octaves * t)
    angle = 2 * math.pi * (hertz - 0.5) / (octaves * math.log(2))
    return 0.025 / (1 + (hertz / 4) ** 2) ** 0.75 * math.sin(angle) * min(1, t)


def record(_, folder, damper, draw):
    """Force behind the mount: dashpot = spring; x: the spring's extension, by Runge and Kutta's method."""
    law, h = inverse(dashpot(damper), 5), 1 / (RATE_HZ * STEPS)
    spring = lambda x: damper["k_series"] * x + damper["k_series_cubic"] * x ** 3
    places = [motion((i - 2) * h / 2) for i in range(2 * RATE_HZ * STEPS * DURATION_S + 8)]
    rate = lambda i: (places[i + 3] - places[i + 1]) / h  # at half step i
    x, rows = 0.0, []
    for k in range(RATE_HZ * STEPS * DURATION_S):
        v = rate(2 * k)
        if k % STEPS == 0:
            pull = (places[2 * k + 4] - 2 * places[2 * k + 2] + places[2 * k]) / (h * h)
            force = spring(x) + damper["F_friction"] * math.tanh(v / 0.002) - damper["F_gas"] + damper["rod"] * pull
            rows.append((k * h, places[2 * k + 2], force))
        slope = lambda x, v: v - law(spring(x))
        half, full = rate(2 * k + 1), rate(2 * k + 2)
        k1 = slope(x, v)
        k2 = slope(x + h / 2 * k1, half)
        k3 = slope(x + h / 2 * k2, half)
        x += h / 6 * (k1 + 2 * k2 + 2 * k3 + slope(x + h * k3, full))
    with open(folder / "sweep.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerows([["time", "displacement", "force"], ["s", "m", "N"]])
        out.writerows([f"{t:.4f}", f"{z:.9g}", f"{f + draw.gauss(0, 2):.6g}"] for t, z, f in rows)


def rate_of_work(damper, side):
    """That of a linear dashpot that takes as much work from the swept sine."""
    force, work, squares = dashpot(damper), 0.0, 0.0
    for k in range(RATE_HZ * DURATION_S):
        v = (motion((k + 0.5) / RATE_HZ) - motion((k - 0.5) / RATE_HZ)) * RATE_HZ
        if (v > 0) == (side == "rebound"):
            work += force(v) * v
            squares += v * v
    return work / squares


def truth(damper, model):
    """What a model's parameters stand for; a knee or a transition that is not there for nothing. One rate in place of two
    with a knee between them: that of the same work."""
    known = {name: damper[name] for name in ("c_bump", "c_rebound", "k_series", "k_series_cubic", "F_friction", "F_gas")}
    if damper["v_transition"] > 0:
        known["v_transition"] = damper["v_transition"]
    if damper["v_bump_knee"] and model != "friction_knees":
        known.update({f"c_{side}": rate_of_work(damper, side) for side in ("bump", "rebound")})
    elif damper["v_bump_knee"]:
        for side in ("bump", "rebound"):
            known[f"v_{side}_knee"] = damper[f"v_{side}_knee"]
            known[f"c_{side}_beyond"] = damper[f"c_{side}_beyond"]
    return known


def study(model, folder):
    text = (SOURCE / "studies" / "damper" / f"{model}.yaml").read_text()
    text = re.sub(r"  validation:\n(    - .*\n)+", "", text)
    text = re.sub(r"  # Displacement and force were.*\n  rig_filter:.*\n", "", text)
    text = text.replace("vehicle: ", f"vehicle: {SOURCE}/studies/damper/")
    path = folder / f"{model}.yaml"
    path.write_text(text)
    return path
