#!/usr/bin/env python3
"""How often 95 % intervals of fits to time histories hold the truth where the model is exact, as CSV.

Each shipped model is simulated at drawn parameters on a sweep, a random motion, a road and a step, and noise is added to
all channels, posts too: white, correlated from sample to sample, or limited to a band. Each recording is fitted as the
tutorial does.

  coverage_over_time.py PROGRAM --fits 500 > coverage_over_time.csv
"""
import argparse
import csv
import json
import math
import random
import sys
import tempfile
from pathlib import Path

from run_program import SOURCE, run

MODELS = {"quarter_car": ["post"], "single_wheel_station": None, "landrover110_model1": None}
MOTIONS = {"sweep": ["--sweep", "0.5Hz:20Hz"], "random": ["--random", "4mm"], "road": ["--road", "C", "--speed", "50km/h"],
           "step": ["--step", "15mm"]}
COLOURS = [0, 0.5, 0.9, 0.95, "band"]
LEVELS = [0.001, 0.01]
# A step of 50 ms has to be sampled as closely as that.
RATE = {"sweep": 200, "random": 200, "road": 200, "step": 500}
DURATION = {"sweep": 20, "random": 20, "road": 20, "step": 6}


def noise(draw, count, colour):
    """Of deviation 1."""
    if colour == "band":  # a low-pass of second order at a tenth of the rate
        white = [draw.gauss(0, 1) for _ in range(count + 200)]
        c = math.tan(math.pi * 0.1)
        norm = 1 / (1 + math.sqrt(2) * c + c * c)
        b0, a1, a2 = c * c * norm, 2 * (c * c - 1) * norm, (1 - math.sqrt(2) * c + c * c) * norm
        out = [0.0, 0.0]
        for k in range(2, len(white)):
            out.append(b0 * (white[k] + 2 * white[k - 1] + white[k - 2]) - a1 * out[-1] - a2 * out[-2])
        out = out[200:]
        sd = math.sqrt(sum(v * v for v in out) / len(out))
        return [v / sd for v in out]
    out = [draw.gauss(0, 1)]
    for _ in range(count - 1):
        out.append(colour * out[-1] + math.sqrt(1 - colour * colour) * draw.gauss(0, 1))
    return out


def read(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], rows[1], [list(map(float, column)) for column in zip(*rows[2:])]


def write(path, names, units, columns):
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(names)
        out.writerow(units)
        out.writerows(zip(*columns))


def parameters(program, vehicle):
    found = json.loads(run(program, "check", vehicle, "--json").stdout)["parameters"]
    return [p for p in found if p["lower"] < p["upper"]]


def drawn(draw, known):
    values = {}
    for p in known:
        if p["lower"] > 0:
            values[p["name"]] = p["value"] * math.exp(draw.uniform(-0.25, 0.25))
            values[p["name"]] = min(max(values[p["name"]], 1.02 * p["lower"]), 0.98 * p["upper"])
        else:
            values[p["name"]] = p["value"]
    if "c_bump" in values and abs(values["c_bump"] / values["c_rebound"] - 1) < 0.3:
        values["c_rebound"] = 1.8 * values["c_bump"]
    return values


def study(folder, vehicle, posts, sensors, free):
    lines = [f"vehicle: {vehicle}", "histories:", "  - file: recording.csv",
             "    posts: {" + ", ".join(f"{p}: post_{p}" for p in posts) + "}",
             "    channels: {" + ", ".join(f"{s}: {s}" for s in sensors) + "}",
             "model_error: {history: 1 %}", f"free: [{', '.join(free)}]", "search: {evaluations: 20, starts: 1}"]
    (folder / "study.yaml").write_text("\n".join(lines) + "\n")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program")
    arguments.add_argument("--fits", type=int, default=500)
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--models", default="quarter_car,single_wheel_station,landrover110_model1")
    arguments.add_argument("--motions", default=",".join(MOTIONS))
    arguments.add_argument("--cut", type=float, default=0, help="seconds of the start to leave out of the recording")
    arguments.add_argument("--clean-posts", action="store_true")
    options = arguments.parse_args()
    models = options.models.split(",")
    motions = options.motions.split(",")
    out = csv.writer(sys.stdout)
    out.writerow(["fit", "model", "motion", "level", "colour", "parameter", "truth", "value", "lower", "upper", "sd"])
    known = {m: parameters(options.program, SOURCE / "urdf" / f"{m}.urdf") for m in models}
    cases = [(m, t, level, colour) for m in models for t in motions for level in LEVELS for colour in COLOURS]
    for number in range(options.first, options.first + options.fits):
        model, motion, level, colour = cases[(number * 7919) % len(cases)]
        draw = random.Random(number)
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            vehicle = SOURCE / "urdf" / f"{model}.urdf"
            values = drawn(draw, known[model])
            units = {p["name"]: p["unit"] for p in known[model]}
            sets = [part for name, value in values.items() for part in ("--set", f"{name}={value}{units[name]}")]
            seed = ["--seed", str(number)] if motion in ("random", "road") else []
            run(options.program, "simulate", vehicle, *MOTIONS[motion], *seed, *sets, "--engine", "reduced", "--error", "0.002%",
                "--duration", f"{DURATION[motion] + options.cut}s", "--rate", f"{RATE[motion]}Hz", "-o", folder / "clean.csv")
            names, row_units, columns = read(folder / "clean.csv")
            first = round(options.cut * RATE[motion])
            columns = [column[first:] for column in columns]
            posts = [n[5:] for n in names if n.startswith("post_")]
            sensors = [n for n in names[1:] if not n.startswith("post_")]
            for i, name in enumerate(names):
                if i == 0 or (options.clean_posts and name.startswith("post_")):
                    continue
                column = columns[i]
                mean = sum(column) / len(column)
                sd = level * math.sqrt(sum((v - mean) ** 2 for v in column) / len(column))
                columns[i] = [v + sd * e for v, e in zip(column, noise(draw, len(column), colour))]
            write(folder / "recording.csv", names, row_units, columns)
            study(folder, vehicle, posts, sensors, list(values))
            try:
                run(options.program, "fit", folder / "study.yaml", "-o", folder / "run", "--threads", "1",
                    "--accept-implausible")
            except RuntimeError as fault:
                print(fault, file=sys.stderr)
                continue
            for p in json.loads((folder / "run" / "result.json").read_text())["parameters"]:
                low, high = p["interval_95"]
                out.writerow([number, model, motion, level, colour, p["name"], f"{values[p['name']]:.6g}",
                              f"{p['value']:.6g}", low, high, p["sd"]])
            sys.stdout.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
