#!/usr/bin/env python3
"""Makes the tables of this study: simulated, no rig was used.

Car.urdf at other values of its hard points and bush than it is drawn with, by `fourpost kinematics`, with white noise of
the standard deviations in study.yaml and, of camber and toe, a static alignment that the study leaves free. FOURPOST
names the program.
"""
import csv
import os
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TRUTH = {"dz_upper_ball": "3.2 mm", "dz_tie_outer": "-1.6 mm", "k_rear_pivot": "3.1 kN/mm"}
SIDES = {"left": "front_tyre_left", "right": "front_tyre_right"}
ALIGNMENT = {"camber_left": -0.40, "camber_right": -0.55, "toe_left": 0.08, "toe_right": 0.06}
NOISE = {"camber": 0.02, "toe": 0.01, "track": 0.2, "force_toe": 0.003, "centre_y": 0.02}


def rows(folder, name):
    with open(folder / name, newline="") as file:
        return list(csv.DictReader(file))


def write(name, head, lines):
    text = ",".join(head) + "\n" + "".join(",".join(line) + "\n" for line in lines)
    (HERE / name).write_text(text)


def main():
    draw = random.Random(4)
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place) / "out"
        options = [part for name, value in TRUTH.items() for part in ("--set", name + "=" + value.replace(" ", ""))]
        subprocess.run([os.environ["FOURPOST"], "kinematics", HERE / "car.urdf", *options, "--travel", "60mm", "--step",
                        "10mm", "-o", folder], check=True, stdout=subprocess.DEVNULL)
        wheels, compliance = rows(folder, "wheels.csv"), rows(folder, "compliance.csv")
    heave = [row for row in wheels if row["axle"] == "front" and row["travel"] == "heave"]
    lines = []
    for travel in sorted({float(row["travel_mm"]) for row in heave}):
        here = {row["wheel"]: row for row in heave if float(row["travel_mm"]) == travel}
        line = [f"{travel:.2f}"]
        for quantity in ("camber", "toe"):
            for side, wheel in SIDES.items():
                value = float(here[wheel][quantity + "_deg"]) + ALIGNMENT[f"{quantity}_{side}"]
                line.append(f"{draw.gauss(value, NOISE[quantity]):.4f}")
        lines.append([*line, f"{draw.gauss(float(here[SIDES['left']]['track_mm']), NOISE['track']):.2f}"])
    write("front_heave.csv", ["travel [mm]", "camber_left [deg]", "camber_right [deg]", "toe_left [deg]",
                              "toe_right [deg]", "track [mm]"], lines)
    lateral = {row["wheel"]: row for row in compliance
               if row["axle"] == "rear" and row["load"] == "lateral" and row["case"] == "together"}
    lines = []
    for force in (-2.0, -1.0, 0.0, 1.0, 2.0):
        line = [f"{force:.1f}"]
        for column, noise in (("toe_deg", "force_toe"), ("centre_y_mm", "centre_y")):
            for side in ("left", "right"):
                line.append(f"{draw.gauss(force * float(lateral['rear_tyre_' + side][column]), NOISE[noise]):.4f}")
        lines.append(line)
    write("rear_lateral.csv", ["force [kN]", "toe_left [deg]", "toe_right [deg]", "centre_y_left [mm]",
                               "centre_y_right [mm]"], lines)


if __name__ == "__main__":
    main()
