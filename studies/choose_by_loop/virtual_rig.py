"""The rig of the loop: a bench with the adjustable damper, and a car on four posts that has more than the fitted model.

The car is Model 1 of the Land Rover 110 with random masses, rates and inertias (by its seed), and with what the model lacks: a
power unit on mounts, friction beside the dampers, tyres that lose energy, dampers that follow the valves of appendix A from
point to point, each of which differs from the benched one by a standard deviation of 2 %. With your own car, recordings take
the place of this file.
"""
import csv
import importlib.util
import json
import math
import random
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
MODES = ("heave", "pitch")
BENCHED = (1, 4, 7, 10, 13, 16, 20)
CLICKS = range(1, 21)
PRESENT = (4, 4)
AXLES = ("front", "rear")
SPEEDS = [side * v for side in (-1, 1) for v in (0.01, 0.03, 0.06, 0.12, 0.2, 0.3, 0.5, 0.8, 1.5)]
SPEEDS.sort()
UNITS = {"m": "kg", "I": "kg*m^2", "k": "N/m", "kt": "N/m", "y": "m"}


def appendix_a():
    spec = importlib.util.spec_from_file_location("generate", HERE.parent / "damper/appendix_a/generate.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


DAMPER = appendix_a()


def run(*arguments):
    """Of the program; code 1, a model that does not explain its data, is a result."""
    outcome = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if outcome.returncode not in (0, 1):
        sys.exit(" ".join(map(str, arguments)) + "\n" + outcome.stderr[-2000:])
    return outcome.stdout


def record_bench(folder, clicks):
    """A sweep of each of these clicks, click1.csv and so on."""
    for click in clicks:
        with (folder / f"click{click}.csv").open("w") as file:
            file.write("time,displacement,force\ns,m,N\n")
            file.writelines(f"{t:.3f},{x:.9g},{force:.7g}\n" for t, x, force in DAMPER.record(click))


def valve_force(click, speed):
    """Of the valves at a steady speed: m' = sqrt(dP) / Rm1 + dP / Rm, f = A_a dP."""
    rm1, rm2, _ = DAMPER.parameters(click)
    rm = rm2 if speed > 0 else DAMPER.RM3
    flow = DAMPER.RHO * DAMPER.A_A * abs(speed)
    root = 2 * flow / (1 / rm1 + math.sqrt(1 / rm1**2 + 4 * flow / rm))
    return math.copysign(DAMPER.A_A * root**2, speed)


class Car:
    """The true car; its recordings are all that the loop sees of it until the end."""

    def __init__(self, program, folder, seed):
        self.program, self.folder, self.seed = program, folder, seed
        draw = random.Random(seed)
        around = lambda middle, share: middle * math.exp(draw.uniform(-share, share))
        self.values = {"m_sprung": around(1400, 0.1), "I_pitch": around(2400, 0.15), "m_front": around(215, 0.15),
                       "m_rear": around(215, 0.15), "k_front": around(44e3, 0.2), "k_rear": around(52e3, 0.2),
                       "kt_front": around(360e3, 0.2), "kt_rear": around(360e3, 0.2)}
        self.engine_mass, self.engine_x = around(290, 0.15), draw.uniform(0.9, 1.1)
        self.engine_rate = self.engine_mass * (2 * math.pi * draw.uniform(12, 16))**2
        self.friction = {axle: 2 * draw.uniform(10, 70) for axle in AXLES}
        # Both dampers of an axle, and the benched one's 50 N each.
        self.scatter = {axle: draw.gauss(2, 2 * 0.02) for axle in AXLES}
        self.tyre_damping = draw.uniform(200, 1200)
        self.write()

    def law(self, axle):
        points = "".join(f'<point speed="{v} m/s" force="{self.scatter[axle]:.4f}*$f{i}_{axle}"/>'
                         for i, v in enumerate(SPEEDS))
        return f'<table>{points}</table><friction force="100 N" speed="5 mm/s"/>'

    def with_values(self, text):
        """In the parameters, and in the numbers of links that follow them."""
        v = self.values
        for name, value in v.items():
            unit = UNITS[name.split("_")[0]]
            text = re.sub(rf'(<fp:parameter name="{name}" value=")[^"]*" lower=[^>]*?source', rf'\g<1>{value:.8g} {unit}" source',
                          text)
        for link, mass, roll, pitch in (("chassis", v["m_sprung"], 650, v["I_pitch"]), ("front_axle", v["m_front"], 0, 0),
                                        ("rear_axle", v["m_rear"], 0, 0)):
            inertial = (f'<link name="{link}"><inertial><mass value="{mass:.8g}"/><inertia ixx="{roll}" iyy="{pitch:.8g}" '
                        f'izz="{pitch:.8g}" ixy="0" ixz="0" iyz="0"/></inertial>')
            text = re.sub(rf'<link name="{link}">\s*<inertial>.*?</inertial>', inertial, text, flags=re.S)
        return text

    def write(self):
        """The car's file, and the forces of its clicks."""
        text = (SOURCE / "urdf/landrover110_model1.urdf").read_text().replace("../meshes/", f"{SOURCE}/meshes/")
        text = self.with_values(re.sub(r'  <fp:parameter name="c_[^>]*/>\n', "", text))
        more = ""
        for axle in AXLES:
            text = re.sub(rf'<bilinear bump="2\*\$c_{axle}[^>]*/>', lambda _: self.law(axle), text)
            more += f'''  <fp:damper name="{axle}_friction" parent="{axle}_top" child="{axle}_centre">
    <linear rate="0 N*s/m"/><friction force="{self.friction[axle]:.1f} N" speed="2 mm/s"/>
  </fp:damper>
'''
        text = re.sub(r'(<fp:tyre name="\w+")', rf'\1 damping="{self.tyre_damping:.0f} N*s/m"', text)
        points = "".join(f'<fp:parameter name="f{i}_{axle}" value="{valve_force(PRESENT[0], v):.6g} N" source="valves"/>\n'
                         for axle in AXLES for i, v in enumerate(SPEEDS))
        text = text.replace('  <fp:frame name="front_centre"', points + '  <fp:frame name="front_centre"', 1)
        text = text.replace("</robot>", more + f'''  <link name="power_unit"><inertial><mass value="{self.engine_mass:.2f}"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="power_unit" type="prismatic"><parent link="chassis"/><child link="power_unit"/>
    <origin xyz="{self.engine_x:.3f} 0 0"/><axis xyz="0 0 1"/><limit lower="-0.1" upper="0.1" effort="0" velocity="0"/></joint>
  <fp:spring name="engine_mounts" parent="chassis" child="power_unit" axis="0 0 1">
    <linear stiffness="{self.engine_rate:.0f} N/m"/></fp:spring>
  <fp:damper name="engine_damping" parent="chassis" child="power_unit" axis="0 0 1">
    <linear rate="{0.2 * math.sqrt(self.engine_rate * self.engine_mass):.0f} N*s/m"/></fp:damper>
</robot>''')
        self.file = self.folder / "true_car.urdf"
        self.file.write_text(text)
        forces = [f"f{i}" for i in range(len(SPEEDS))]
        with (self.folder / "true_clicks.csv").open("w") as file:
            out = csv.writer(file)
            out.writerow(["click", *forces])
            out.writerow(["", *["N"] * len(forces)])
            out.writerows([click, *(f"{valve_force(click, v):.6g}" for v in SPEEDS)] for click in CLICKS)

    def at(self, clicks):
        """Options of the program: the car at these clicks."""
        words = [f"f{i}_{axle}={valve_force(click, v):.6g}N" for axle, click in zip(AXLES, clicks)
                 for i, v in enumerate(SPEEDS)]
        return [part for word in words for part in ("--set", word)]

    def record_sines(self, clicks):
        """Two runs of stepped sines and the loads at rest: noise of three repeats, scales of sensors off by 0.3 %."""
        draw = random.Random(1000 + self.seed)
        modes = [part for mode in MODES for part in ("--mode", mode)]
        run(self.program, "response", self.file, *modes, "--frequencies", "0.5Hz:18Hz:36", "--engine", "reduced",
            *self.at(clicks), "-o", self.folder / "response")
        with (self.folder / "response/response.csv").open() as file:
            rows = [row for row in csv.DictReader(file) if row["gain"]]
        scale = {name: draw.gauss(1, 0.003) for name in sorted({row["channel"] for row in rows})}
        for mode in MODES:
            with (self.folder / f"{mode}.csv").open("w") as file:
                out = csv.writer(file)
                out.writerow("frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean".split(","))
                for row in rows:
                    if row["mode"] == mode:
                        out.writerow(noisy(row, scale[row["channel"]], draw))

    def record_loads(self):
        """Of the tyres at rest, by the program's `check`; standard deviation 20 N."""
        draw = random.Random(2000 + self.seed)
        answer = json.loads(run(self.program, "check", self.file, "--json"))
        with (self.folder / "static.csv").open("w") as file:
            out = csv.writer(file)
            out.writerow(["quantity", "unit", "value", "sd"])
            for corner in answer["corners"]:
                out.writerow([f"load_{corner['name'].split('_')[0]}", "N", corner["load_N"] + draw.gauss(0, 20), 20])

    def drive(self, clicks, name, seed):
        """One run on a rough road, as a time history with 1 % of noise on every channel."""
        run(self.program, "simulate", self.file, *self.at(clicks), "--road", "C", "--speed", "50km/h", "--duration", "5s",
            "--rate", "100Hz", "--noise", "1%", "--seed", str(seed), "--engine", "reduced", "-o", self.folder / f"{name}.csv")


def noisy(row, scale, draw):
    gain = float(row["gain"])
    sd = math.hypot(0.004 * gain, 0.003 if row["channel"][0] != "F" else 300)
    repeats = [complex(draw.gauss(gain, sd), draw.gauss(0, sd)) for _ in range(3)]
    mean = sum(repeats) / 3
    offset = float(row["mean"]) + draw.gauss(0, 2e-5) if row["channel"].startswith("s_") else ""
    return [row["frequency_Hz"], row["post_amplitude_m"], row["channel"], scale * abs(mean),
            float(row["phase_deg"]) + math.degrees(math.atan2(mean.imag, mean.real)), max(sd, 1e-9) / math.sqrt(3),
            math.degrees(sd / math.sqrt(3) / max(gain, 1e-9)), offset]
