"""Random cars that have more than their models: see coverage.py."""
import csv
import json
import math
import re
import statistics

from run_program import SOURCE, run

CAR = SOURCE / "urdf" / "landrover110_engine.urdf"
MODES = {"bounce": "heave", "pitch": "pitch", "roll": "roll"}
# full_one_body as well, ten minutes a fit.
MODELS = ["model1", "model3"]
# By which an upright strut of Models 1 and 3 replaces the rear damper that leans: both ends' directions, squared.
LEAN = math.cos(math.radians(29.6)) ** 2
# Rates of mounts and bushes in line with what a simpler car has, so stiff that they barely yield.
STIFF = {"k_engine_mount": 2e6, "k_gearbox_mount": 2e6, "loss_mount": 0.05, "k_mount_front": 5e6, "k_mount_rear": 5e6,
         "k_arm_lift": 0.02e6}


def drawn(draw):
    """Everything at random at once: values of parameters, and the knee of the dampers if they digress."""
    around = lambda middle, share: middle * math.exp(draw.uniform(-share, share))
    car = {"m_body": around(1425, 0.12), "x_body": draw.uniform(-0.3, -0.14), "I_roll": around(600, 0.2),
           "I_pitch": around(2300, 0.2), "m_engine": around(290, 0.25), "x_engine": draw.uniform(-0.1, 0.1),
           "I_engine_pitch": around(40, 0.3), "k_engine_mount": around(0.7e6, 0.5), "k_gearbox_mount": around(0.7e6, 0.5),
           "loss_mount": draw.uniform(0.08, 0.3), "m_front": around(205, 0.25), "I_front_roll": around(75, 0.3),
           "m_rear": around(205, 0.25), "I_rear_roll": around(75, 0.3), "ct": draw.uniform(0, 800),
           "kt_lateral": around(150e3, 0.4), "k_arm_bush": around(8e6, 0.4), "k_panhard": around(5e6, 0.4),
           "k_arm_lift": around(0.2e6, 0.6), "k_mount_front": around(1e6, 0.7), "k_mount_rear": around(1e6, 0.7)}
    for name, middle in (("k_F", 46e3), ("k_R", 56e3), ("kt_F", 370e3), ("kt_R", 370e3)):
        both = around(middle, 0.3)
        for side in "LR":
            car[name + side] = around(both, 0.04)
    for axle in ("front", "rear"):
        car[f"c_{axle}_bump"] = around(1700, 0.4)
        car[f"c_{axle}_rebound"] = around(3600, 0.4)
        car[f"f_{axle}"] = draw.choice([0, draw.uniform(10, 60), draw.uniform(60, 160)])
    for place in ("y_body", "y_front", "y_rear"):
        car[place] = draw.uniform(-0.02, 0.02)
    knees = draw.choice([None, (draw.uniform(0.1, 0.3), draw.uniform(0.4, 0.8))])
    return car, knees


def drawn_with_one_flaw(draw):
    """As drawn(), but all is absent or stiff except one thing, which may be weak."""
    car, knees = drawn(draw)
    rich = dict(car)
    car.update(STIFF)
    car.update({"ct": 0, "f_front": 0, "f_rear": 0, "y_body": 0, "y_front": 0, "y_rear": 0})
    for name in ("k_F", "k_R", "kt_F", "kt_R"):
        car[name + "R"] = car[name + "L"]
    flaw = draw.choice(["engine", "friction", "knees", "mounts", "sides", "tyres"])
    if flaw == "engine":
        car.update({name: rich[name] for name in ("k_engine_mount", "k_gearbox_mount", "loss_mount")})
    elif flaw == "friction":
        car.update({"f_front": draw.uniform(5, 160), "f_rear": draw.uniform(5, 160)})
    elif flaw == "mounts":
        car.update({name: rich[name] for name in ("k_mount_front", "k_mount_rear")})
    elif flaw == "sides":
        car.update({name: rich[name] for name in rich if name.endswith("R") or name.startswith("y_")})
    elif flaw == "tyres":
        car["ct"] = draw.uniform(100, 1200)
    return car, (draw.uniform(0.1, 0.3), draw.uniform(0.4, 0.9)) if flaw == "knees" else None


def car_file(car, knees, path):
    text = CAR.read_text().replace("../meshes/", str(SOURCE / "meshes") + "/")
    if knees:
        speed, share = knees
        for axle in ("front", "rear"):
            bump, rebound = car[f"c_{axle}_bump"], car[f"c_{axle}_rebound"]
            text = text.replace(
                f'<bilinear bump="$c_{axle}_bump" rebound="$c_{axle}_rebound"/>',
                f'<digressive bump="{bump} N*s/m" rebound="{rebound} N*s/m" bump_knee="{speed} m/s" rebound_knee="{speed} m/s" '
                f'bump_beyond="{share * bump} N*s/m" rebound_beyond="{share * rebound} N*s/m"/>')
        text = re.sub(r'<fp:parameter name="c_[^>]*/>', "", text)
    path.write_text(text)


UNITS = {"m": "kg", "x": "m", "y": "m", "I": "kg*m^2", "k": "N/m", "kt": "N/m", "c": "N*s/m", "ct": "N*s/m", "f": "N",
         "loss": ""}


def settings(car, knees):
    for name, value in car.items():
        if not (knees and name.startswith("c_")):
            yield f"{name}={value}{' ' + UNITS[name.split('_')[0]]}".strip()


def record(program, folder, made, draw, count=48):
    """Stepped sines and corner loads as a rig writes them: noise of three repeats, and scale errors of the sensors."""
    car, knees = made
    car_file(car, knees, folder / "car.urdf")
    sets = [part for setting in settings(car, knees) for part in ("--set", setting)]
    modes = [part for mode in MODES.values() for part in ("--mode", mode)]
    run(program, "response", folder / "car.urdf", *modes, "--frequencies", f"0.5Hz:30Hz:{count}", "--engine", "reduced",
        *sets, "-o", folder / "response")
    with open(folder / "response" / "response.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    channels = {row["channel"] for row in rows}
    scale = {name: draw.gauss(1, 0.003) for name in sorted(channels)}
    loudest = {}
    for row in rows:
        key = (row["mode"], row["unit"], row["frequency_Hz"])
        loudest[key] = max(loudest.get(key, 0), float(row["gain"] or 0))
    for name, mode in MODES.items():
        with open(folder / f"{name}_frf.csv", "w", newline="") as file:
            out = csv.writer(file)
            out.writerow("frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,second_harmonic"
                         .split(","))
            for row in rows:
                if row["mode"] != mode or row["gain"] == "":
                    continue
                gain, phase = float(row["gain"]), float(row["phase_deg"])
                sd = math.hypot(0.004 * gain, 0.002 * loudest[(mode, row["unit"], row["frequency_Hz"])])
                repeats = [complex(draw.gauss(gain, sd), draw.gauss(0, sd)) for _ in range(3)]
                mean = sum(repeats) / 3
                strut = row["channel"].startswith("s_strut")
                out.writerow([row["frequency_Hz"], row["post_amplitude_m"], row["channel"],
                              scale[row["channel"]] * abs(mean),
                              phase + math.degrees(math.atan2(mean.imag, mean.real)),
                              statistics.stdev([r.real for r in repeats]),
                              math.degrees(statistics.stdev([r.imag for r in repeats]) / max(gain, 1e-9)),
                              float(row["mean"]) + draw.gauss(0, 2e-5) if strut else "",
                              abs(float(row["second_harmonic"]) + draw.gauss(0, 2e-6))])
    static_loads(car, draw, folder / "static.csv")


def static_loads(car, draw, path):
    """Of the rigid car, links and arms with their shares."""
    parts = [(car["m_body"], -1.456 + car["x_body"], car["y_body"]), (car["m_engine"], -0.42 + car["x_engine"], 0),
             (car["m_front"], 0, car["y_front"]), (car["m_rear"], -2.794, car["y_rear"]),
             (4, -1.9, 0), (8, -2.43, 0), (2, 0.09, -0.46)]
    mass = sum(m for m, _, _ in parts)
    x = sum(m * x for m, x, _ in parts) / mass
    y = sum(m * y for m, _, y in parts) / mass
    front = mass * (x + 2.794) / 2.794
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["quantity", "unit", "value", "sd"])
        for corner in ("FL", "FR", "RL", "RR"):
            axle = front if corner[0] == "F" else mass - front
            side = 0.5 + (1 if corner[1] == "L" else -1) * y / 1.486
            out.writerow([f"static_load_{corner}", "N", 9.80665 * axle * side + draw.gauss(0, 20), 20])


def truth(made, model):
    """What a model's parameters stand for in the car."""
    car, _ = made
    sprung = car["m_body"] + car["m_engine"] + 7
    body_x, engine_x = -1.456 + car["x_body"], -0.42 + car["x_engine"]
    centre = (car["m_body"] * body_x + car["m_engine"] * engine_x) / (car["m_body"] + car["m_engine"])
    pitch = (car["I_pitch"] + car["I_engine_pitch"] + car["m_body"] * (body_x - centre) ** 2 +
             car["m_engine"] * (engine_x - centre) ** 2)
    lean = 1 if model == "full_one_body" else LEAN
    both = {"m_sprung": sprung, "I_pitch": pitch, "m_front": car["m_front"], "m_rear": car["m_rear"],
            "c_front_bump": car["c_front_bump"], "c_front_rebound": car["c_front_rebound"],
            "c_rear_bump": lean * car["c_rear_bump"], "c_rear_rebound": lean * car["c_rear_rebound"]}
    if model == "model1":
        for name in ("k", "kt"):
            both[f"{name}_front"] = (car[f"{name}_FL"] + car[f"{name}_FR"]) / 2
            both[f"{name}_rear"] = (car[f"{name}_RL"] + car[f"{name}_RR"]) / 2
        return both
    for name in ("k_FL", "k_FR", "k_RL", "k_RR", "kt_FL", "kt_FR", "kt_RL", "kt_RR", "I_front_roll", "I_rear_roll", "y_front",
                 "y_rear"):
        both[name] = car[name]
    # Axes of the power unit lie lower than the body's: its mass adds to the roll inertia about the common centre.
    mass = car["m_body"] * car["m_engine"] / (car["m_body"] + car["m_engine"])
    both["I_roll"] = car["I_roll"] + 12 + mass * (0.832 - 0.65) ** 2
    both["y_body"] = car["m_body"] * car["y_body"] / (car["m_body"] + car["m_engine"])
    if model == "full_one_body":
        for name in ("ct", "kt_lateral", "k_mount_front", "k_mount_rear", "f_front", "f_rear", "k_arm_lift"):
            both[name] = car[name]
    return both


def study(model, folder):
    text = (SOURCE / "studies" / "landrover110" / f"{model}.yaml").read_text()
    text = re.sub(r"\n(#[^\n]*\n)?histories:.*?(?=\n#|\nstatic_loads)", "\n", text, flags=re.S)
    text = text.replace("../../urdf/", str(SOURCE / "urdf") + "/")
    path = folder / f"{model}.yaml"
    path.write_text(text)
    return path
