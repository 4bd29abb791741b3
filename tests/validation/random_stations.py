"""Random single wheel stations that have more than their models: see coverage.py."""
import csv
import math
import re

from run_program import SOURCE, run

STATIONS = SOURCE / "studies" / "single_wheel_station"
MODELS = ["model1", "model2", "model3"]
SENSORS = {"z_sprung": 5e-6, "z_unsprung": 15e-6, "a_sprung": 0.01, "a_unsprung": 0.02, "F_tyre": 20}
UNITS = {"m": "kg", "k": "N/m", "kt": "N/m", "c": "N*s/m", "f": "N"}


def drawn(draw):
    """Friction of strut and guides, hysteresis, a mount, knees and a tyre's damping, each at random."""
    around = lambda middle, share: middle * math.exp(draw.uniform(-share, share))
    maybe = lambda most: draw.choice([0.1, draw.uniform(0.05, 1) * most])
    station = {"m_sprung": around(178, 0.12), "m_unsprung": around(29, 0.12), "k": around(15e3, 0.25),
               "kt": around(220e3, 0.2), "c_bump": around(1000, 0.35), "c_rebound": around(1750, 0.3),
               "k_damper": draw.choice([2e6, around(350e3, 0.6)]), "f_strut": maybe(40), "f_guide_sprung": maybe(20),
               "f_guide_unsprung": maybe(15), "f_hysteresis": maybe(30), "k_hysteresis": around(60e3, 0.8),
               "ct": draw.choice([0, draw.uniform(20, 250)])}
    station["c_rebound"] = max(station["c_rebound"], 1.2 * station["c_bump"])
    knees = draw.choice([None, (draw.uniform(0.1, 0.4), draw.uniform(0.5, 0.9))])
    return station, knees


def record(program, folder, made, draw):
    """A swept sine, 12 mm at first."""
    station, knees = made
    text = (STATIONS / "model4.urdf").read_text().replace("../../meshes/", str(SOURCE / "meshes") + "/")
    text = text.replace('stiffness="$kt"', f'stiffness="$kt" damping="{station["ct"]} N*s/m"')
    if knees:
        speed, share = knees
        text = text.replace(
            '<bilinear bump="$c_bump" rebound="$c_rebound"/>',
            f'<digressive bump="$c_bump" rebound="$c_rebound" bump_knee="{speed} m/s" rebound_knee="{speed} m/s" '
            f'bump_beyond="{share}*$c_bump" rebound_beyond="{share}*$c_rebound"/>')
    (folder / "station.urdf").write_text(text)
    sets = [part for name, value in station.items() if name != "ct"
            for part in ("--set", f"{name}={value} {UNITS[name.split('_')[0]]}")]
    run(program, "simulate", folder / "station.urdf", "--sweep", "1Hz:22Hz", "--amplitude", "12mm", "--velocity", "0.15m/s",
        "--acceleration", "6m/s^2", "--duration", "30s", "--rate", "250Hz", "--engine", "reduced", *sets, "-o",
        folder / "clean.csv")
    with open(folder / "clean.csv", newline="") as file:
        rows = list(csv.reader(file))
    deviations = [SENSORS.get(name, 2e-6 if name.startswith("post_") else 0) for name in rows[0]]
    with open(folder / "sweep.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerows(rows[:2])
        for row in rows[2:]:
            out.writerow([f"{float(v) + draw.gauss(0, sd):.9g}" if sd else v for v, sd in zip(row, deviations)])


def truth(made, model):
    """A linear damper takes as much work from a sine as a bilinear one of that mean."""
    station, _ = made
    known = {name: station[name] for name in ("m_sprung", "m_unsprung", "k", "kt", "c_bump", "c_rebound", "k_damper")}
    known["c"] = (station["c_bump"] + station["c_rebound"]) / 2
    return known


def study(model, folder):
    text = (STATIONS / f"{model}.yaml").read_text().replace("vehicle: ", f"vehicle: {STATIONS}/")
    text = text.replace("sweep_12mm.csv", "sweep.csv").replace("z_ground", "post_ground")
    text = re.sub(r"    # What all channels.*?(?=\nsearch)", "", text, flags=re.S)
    path = folder / f"{model}.yaml"
    path.write_text(text)
    return path
