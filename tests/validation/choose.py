#!/usr/bin/env python3
"""Whether settings that `fourpost choose` takes for the best are the best of the car that was measured, as CSV.

Simulated cars, Land Rovers 110 (Model 1) with random parameters, answer stepped sines with noise of 15 %; half of them have
friction beside their dampers, which the fitted model lacks. Each is fitted, and one of 15 by 15 clicks of an adjustable
damper is chosen from a random present click. Then all settings are rated in the true car.

  choose.py PROGRAM --cars 100 > choose.csv
  choose.py PROGRAM --reliability choose.csv     # how often a setting with a stated P(best) is the best

A row per car: P(best) of the chosen setting and whether it is the best in truth; stated and true regret [%]; the number
of settings that cannot be distinguished, and whether the true best is among them; `stated`, P(best) of all settings that
have any, and `of_true_best`, that of the true best.
"""
import argparse
import csv
import json
import math
import random
import re
import sys
import tempfile
from pathlib import Path

import suggest
from run_program import SOURCE, run

VEHICLE = "landrover110_model1"
CLICKS = list(range(4, 19))
FRICTION_N = (50, 250)
# So much noise that several settings may be the best.
suggest.GAIN_SD, suggest.FLOOR = 0.15, 0.03


def settings(now):
    knob = ("{{sets: {{c_{0}_bump: bump, c_{0}_rebound: rebound}}, table: " + str(SOURCE / "studies/landrover110/clicks.csv") +
            ", positions: " + str(CLICKS) + ", now: " + str(now) + "}}")
    return ("knobs:\n  front: " + knob.format("front") + "\n  rear: " + knob.format("rear") +
            "\nroads:\n  - {class: A, speed: 110 km/h}\n  - {class: C, speed: 40 km/h}\n")


def planted(text, draw):
    for damper in ("front_damper", "rear_damper"):
        force = draw.uniform(*FRICTION_N)
        text = suggest.inside(text, "damper", damper, f'<friction force="{force:.1f} N" speed="5 mm/s"/>')
    return text


def with_values(text, values):
    """As a fit writes them: in the parameters, and in the numbers of links that follow them."""
    for name, value in values.items():
        text = re.sub(rf'(<fp:parameter name="{name}" value=")[^"]*"', lambda m: m.group(1) + value + '"', text)
        tag = re.search(rf'<fp:parameter name="{name}".*?(/>|</fp:parameter>)', text, re.S).group()
        if not tag.endswith("</fp:parameter>"):
            tag = re.search(rf'<fp:parameter name="{name}"[^>]*[^/]>.*?</fp:parameter>', text, re.S)
            tag = tag.group() if tag else ""
        for link, number in re.findall(r'to="link\[(\w+)\]/([\w/]+)"', tag):
            block = re.search(rf'<link name="{link}">.*?</link>', text, re.S).group()
            attribute = r'(<mass value=")[^"]*"' if number == "mass" else rf'({number.split("/")[1]}=")[^"]*"'
            changed = re.sub(attribute, lambda m: m.group(1) + value.split()[0] + '"', block, count=1)
            text = text.replace(block, changed)
    return text


def make_run(program, folder, seed, has_friction):
    draw = random.Random(seed)
    text = suggest.vehicle_text(VEHICLE)
    (folder / "vehicle.urdf").write_text(text)
    values = {}
    for parameter in json.loads(run(program, "params", folder / "vehicle.urdf", "--json").stdout)["parameters"]:
        if parameter.get("lower") is None:
            continue
        value = parameter["value"] * math.exp(draw.uniform(-0.2, 0.2))
        value = min(max(value, parameter["lower"] * 1.05), parameter["upper"] / 1.05)
        values[parameter["name"]] = f"{value:.6g} {parameter['unit']}"
    # The truth has its values in its file: what is set here is nothing new.
    truth = with_values(planted(text, draw) if has_friction else text, values)
    held = {name: value.replace(" ", "") for name, value in values.items()}
    channels = suggest.record(program, folder, truth, VEHICLE, draw, [], held, 0)
    (folder / "study.yaml").write_text(
        "vehicle: vehicle.urdf\nrecordings:\n" +
        "".join(f"  - {{name: {mode}, file: {mode}.csv, posts: {mode}}}\n" for mode in suggest.MODES[VEHICLE]) +
        "channels:\n" + "".join(f"  {name}: {name}\n" for name in channels) +
        "band: [0.5 Hz, 18 Hz]\nmodel_error: {gain_dB: 0.1, phase: 0.5 deg, floor: 0.005, mean: 0.05 mm}\n"
        f"search: {{seed: {seed}, evaluations: 60, starts: 2}}\n")
    run(program, "fit", folder / "study.yaml", "-o", folder / "run", "--threads", "1", "--accept-implausible")
    (folder / "settings.yaml").write_text(settings(draw.choice(CLICKS)))
    for source, target in ((folder / "run", "chosen"), (folder / "truth.urdf", "true")):
        run(program, "choose", source, "--settings", folder / "settings.yaml", "--no-checks", "--threads", "1", "-o",
            folder / target)


def rows_of(folder):
    with (folder / "settings.csv").open() as file:
        return list(csv.DictReader(file))[1:]


def judged(folder):
    stated, true = rows_of(folder / "chosen"), rows_of(folder / "true")
    chosen = json.loads((folder / "chosen/result.json").read_text())["best"]
    place = next(i for i, row in enumerate(stated)
                 if {"front": row["front"], "rear": row["rear"]} == chosen["setting"])
    costs = [1 + float(row["change"]) / 100 for row in true]
    best = costs.index(min(costs))
    shares = [float(row["best_probability"]) for row in stated]
    return {"best_probability": shares[place], "is_best": int(place == best),
            "stated_regret": 100 * chosen["regret"], "true_regret": 100 * (costs[place] - costs[best]),
            "indistinct": sum(int(row["is_indistinct"]) for row in stated),
            "holds_best": stated[best]["is_indistinct"],
            "stated": " ".join(f"{share:.4g}" for share in shares if share > 0), "of_true_best": shares[best]}


def reliability(file):
    rows = [row for row in csv.DictReader(file) if row["car"]]
    out = csv.writer(sys.stdout)
    out.writerow(["kind", "from", "to", "settings", "stated", "best"])
    for kind in sorted({row["kind"] for row in rows}) + [None]:
        for lower, upper in ((0, 0.1), (0.1, 0.3), (0.3, 0.6), (0.6, 0.9), (0.9, 1.01)):
            shares, hits = [], 0
            for row in rows:
                if kind and row["kind"] != kind:
                    continue
                within = [float(share) for share in row["stated"].split() if lower <= float(share) < upper]
                shares += within
                hits += lower <= float(row["of_true_best"]) < upper and float(row["of_true_best"]) > 0
            if shares:
                out.writerow([kind or "all", lower, min(upper, 1), len(shares), f"{sum(shares) / len(shares):.3f}",
                              f"{hits / len(shares):.3f}"])


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program", type=Path)
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--cars", type=int, default=100)
    arguments.add_argument("--reliability", type=argparse.FileType())
    options = arguments.parse_args()
    if options.reliability:
        reliability(options.reliability)
        return
    out = None
    for seed in range(options.first, options.first + options.cars):
        kind = "friction" if seed % 2 == 0 else "clean"
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            make_run(options.program, folder, seed, kind == "friction")
            row = {"car": seed, "kind": kind, **judged(folder)}
        if out is None:
            out = csv.DictWriter(sys.stdout, list(row))
            out.writeheader()
        out.writerow({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()})
        sys.stdout.flush()


if __name__ == "__main__":
    main()
