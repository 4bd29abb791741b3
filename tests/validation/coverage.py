#!/usr/bin/env python3
"""How often intervals hold the truth where the model is simpler than what was measured, as CSV.

cars: landrover110_engine.urdf with every mass, rate and damper drawn, digressive dampers, friction, mounts, bushes,
differences between left and right, each at random; stepped sines of it with noise of three repeats and scale errors of
the sensors. flawed_cars: such cars with one of these things each. dampers: on a bench, with smooth corners, knees,
friction, gas, a hardening mount and inertia. stations: single wheel stations with friction, hysteresis, knees and a
tyre's damping. Each is fitted by simpler models, and intervals are compared with what was drawn.

  coverage.py PROGRAM --of cars --first 101 --count 30 > coverage_cars.csv
"""
import argparse
import csv
import json
import random
import sys
import tempfile
from pathlib import Path

import random_cars
import random_dampers
import random_stations
from run_program import run

KINDS = {"cars": (random_cars, random_cars.drawn), "flawed_cars": (random_cars, random_cars.drawn_with_one_flaw),
         "dampers": (random_dampers, random_dampers.drawn), "stations": (random_stations, random_stations.drawn)}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program")
    arguments.add_argument("--of", choices=KINDS, default="cars")
    arguments.add_argument("--first", type=int, default=1, help="number of the first, the seed of its draws")
    arguments.add_argument("--count", type=int, default=30)
    arguments.add_argument("--models", help="studies it is fitted by, default: " + "; ".join(
        kind + ": " + ",".join(of.MODELS) for kind, (of, _) in KINDS.items()))
    arguments.add_argument("--keep", help="folder for what was recorded and for the fits")
    options = arguments.parse_args()
    of, drawn = KINDS[options.of]
    out = csv.writer(sys.stdout)
    out.writerow(["number", "model", "parameter", "truth", "value", "lower", "upper", "sd", "noise", "at_bound"])
    for number in range(options.first, options.first + options.count):
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(options.keep or temporary) / f"{options.of}{number}"
            draw = random.Random(number)
            made = drawn(draw)
            if not folder.exists():
                folder.mkdir(parents=True)
                of.record(options.program, folder, made, draw)
            for model in options.models.split(",") if options.models else of.MODELS:
                run(options.program, "fit", of.study(model, folder), "-o", folder / model, "--threads", "1",
                    "--accept-implausible")
                result = json.loads((folder / model / "result.json").read_text())
                known = of.truth(made, model)
                for parameter in result["parameters"]:
                    if parameter["name"] not in known:
                        continue
                    low, high = parameter["interval_95"]
                    out.writerow([number, model, parameter["name"], f"{known[parameter['name']]:.6g}",
                                  f"{parameter['value']:.6g}", low, high, parameter["sd"],
                                  (parameter.get("sd_parts") or {}).get("noise"), int(parameter["at_bound"])])
                sys.stdout.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
