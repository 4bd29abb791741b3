#!/usr/bin/env python3
"""The thesis's loop: identify dampers and car, choose their clicks, test a few on the rig, identify and choose again.

    loop.py PROGRAM FOLDER      # one car; open FOLDER/choice_2/choose.html
    loop.py PROGRAM FOLDER --cars 1..19 --tests 0 --draws 20 --step 3 > results/cars.csv

The first line of what it prints is its command, which the other results have as well. Steps and files of FOLDER are
explained in README.md; virtual_rig.py makes what a bench and a rig would record.
"""
import argparse
import csv
import json
import math
import re
import shutil
import sys
from pathlib import Path

from virtual_rig import (AXLES, BENCHED, CLICKS, MODES, PRESENT, SOURCE, SPEEDS, Car, record_bench, run,
                         valve_force)

HERE = Path(__file__).resolve().parent
# Ends of the segments of bench_damper.urdf on either side [m/s], and their slopes.
ENDS = (0.05, 0.15, 0.4, 1.5)
FOLLOWERS = [f"{side}_{i}" for side in ("bump", "rebound") for i in range(1, len(ENDS) + 1)]
UNIT = "N*s/m"
# What a damper in the car may differ by from the one on the bench, as a share.
BENCH_TO_CAR = 0.03


def identify_dampers(program, folder, clicks):
    """Step 1: the law of each of these clicks of bench.yaml."""
    shutil.copy(HERE / "bench_damper.urdf", folder)
    lines = (HERE / "bench.yaml").read_text().splitlines(keepends=True)
    is_left_out = lambda line: "file:" in line and int(re.search(r"control: (\d+)", line).group(1)) not in clicks
    (folder / "bench.yaml").write_text("".join(line for line in lines if not is_left_out(line)))
    record_bench(folder, clicks)
    run(program, "fit", folder / "bench.yaml", "-o", folder / "bench", "--no-suggest", "--threads", "1")
    laws = laws_of_bench(folder)
    fit = json.loads((folder / "bench/result.json").read_text())
    errors = {int(one["recording"].removeprefix("click")): one["nmse_percent"] for one in fit["channels"]}
    write_forces(folder / "force_speed.csv", laws, lambda click, v: force(laws[click], v), errors)
    # What no bench gives: the valves without hysteresis and friction.
    write_forces(folder / "true_force_speed.csv", CLICKS, valve_force)


def write_forces(file, clicks, force_of, errors=None):
    """A row of each click; the error is that of its recording, of a benched click."""
    speeds = sorted(side * v / 100 for side in (-1, 1) for v in (2, 5, 10, 15, 20, 30, 50))
    with file.open("w") as stream:
        out = csv.writer(stream, lineterminator="\n")
        out.writerow(["click", *(["nmse_percent"] if errors else []), *(f"{v} m/s" for v in speeds)])
        for click in clicks:
            error = [f"{errors[click]:.3f}" if click in errors else ""] if errors else []
            out.writerow([click, *error, *(f"{force_of(click, v):.1f}" for v in speeds)])


def force(law, v):
    """At the ends of the segments that of the law, and straight lines between them."""
    side, sign = ("bump", -1) if v < 0 else ("rebound", 1)
    total, start = 0, 0
    for i, end in enumerate((*ENDS[:-1], math.inf), 1):
        total += law[f"{side}_{i}"] * max(0, min(abs(v), end) - start)
        start = end
    return sign * total


def benched_clicks(folder):
    return [int(click) for click in re.findall(r"csv, control: (\d+)", (folder / "bench.yaml").read_text())]


def laws_of_bench(folder):
    """{click: {"bump": N*s/m, ...}}, straight lines between the benched clicks, as `choose` takes them."""
    fitted = {one["name"]: one["value"] for one in json.loads((folder / "bench/result.json").read_text())["parameters"]}
    benched = benched_clicks(folder)
    at = lambda name, click: fitted[name if click == benched[0] else f"{name}_at_{click}"]
    laws = {}
    for click in range(benched[0], benched[-1] + 1):
        upper = next(one for one in benched[1:] if click <= one)
        lower = benched[benched.index(upper) - 1]
        share = (click - lower) / (upper - lower)
        laws[click] = {name: (1 - share) * at(name, lower) + share * at(name, upper) for name in FOLLOWERS}
    return laws


def parameter(name, value, is_free=True):
    known = (f'lower="{0.5 * value:.6g} {UNIT}" upper="{2 * value:.6g} {UNIT}" precision="1 {UNIT}" '
             f'prior_sd="{BENCH_TO_CAR * value:.4g} {UNIT}" ')
    return f'  <fp:parameter name="{name}" value="{value:.6g} {UNIT}" {known if is_free else ""}source="the bench"/>\n'


def curve(axle):
    """Of both dampers of an axle."""
    segment = lambda side, i, end: f'<segment to="{end} m/s" rate="2*${side}_{i}_{axle}"/>'
    bump = [segment("bump", i, -end) for i, end in enumerate(ENDS, 1)]
    rebound = [segment("rebound", i, end) for i, end in enumerate(ENDS, 1)]
    return "<curve>" + "".join(bump[::-1] + rebound) + "</curve>"


def car_file(laws, more=""):
    """Model 1 with the benched law at the present clicks, and friction of each axle."""
    text = (SOURCE / "urdf/landrover110_model1.urdf").read_text().replace("../meshes/", f"{SOURCE}/meshes/")
    text = re.sub(r'  <fp:parameter name="c_[^>]*/>\n', "", text)
    parameters = more
    for axle, click in zip(AXLES, PRESENT):
        text = text.replace(f'<bilinear bump="2*$c_{axle}_bump" rebound="2*$c_{axle}_rebound"/>',
                            curve(axle) + f'<friction force="2*$friction_{axle}" speed="5 mm/s"/>')
        parameters += "".join(parameter(f"{name}_{axle}", laws[click][name]) for name in FOLLOWERS)
        parameters += (f'  <fp:parameter name="friction_{axle}" value="70 N" lower="10 N" upper="300 N" precision="1 N" '
                       'source="range: seals of the damper, links and seats"/>\n')
    return text.replace('  <fp:frame name="front_centre"', parameters + '  <fp:frame name="front_centre"', 1)


def identify_car(program, folder, car):
    """Step 2: the car at its present clicks, two runs of stepped sines."""
    car.record_sines(PRESENT)
    car.record_loads()
    (folder / "car.urdf").write_text(car_file(laws_of_bench(folder)))
    shutil.copy(HERE / "car.yaml", folder)
    run(program, "fit", folder / "car.yaml", "-o", folder / "car_1", "--no-suggest", "--threads", "1")
    return len(MODES)


def settings(options):
    """The file as it is shipped, with the draws and the length of road that are asked for."""
    text = re.sub(r"draws: \d+", f"draws: {options.draws}", (HERE / "settings.yaml").read_text())
    return text + (f"duration: {options.road} s\n" if options.road else "")


def choose(program, folder, fit, choice, options):
    """Steps 3 and 6: the best clicks, and those to test next."""
    text = settings(options)
    laws = laws_of_bench(folder)
    positions = f"from: {min(laws)}, to: {max(laws)}, step: {options.step}"
    (folder / "settings.yaml").write_text(text.replace("from: 1, to: 20", positions))
    run(program, "choose", folder / fit, "--settings", folder / "settings.yaml", "--threads", "1", "-o", folder / choice)
    return json.loads((folder / choice / "result.json").read_text())


def clicks_to_test(folder, most):
    """Step 4: of test_next.csv; those that the present recordings do not have."""
    with (folder / "choice_1/test_next.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if row["front"].isdigit()]
    clicks = [(int(row["front"]), int(row["rear"])) for row in rows]
    return [pair for pair in clicks if pair != PRESENT][:most]


def test_on_rig(car, tests):
    """Step 5: the present clicks and those to test, each once on a rough road."""
    for i, clicks in enumerate([PRESENT, *tests]):
        car.drive(clicks, f"drive_{i}", 100 * car.seed + i)
    return 1 + len(tests)


def identify_car_again(program, folder, tests):
    """Step 6: the car by all recordings. Dampers at tested clicks are changed as the bench says from what step 2 found."""
    laws = laws_of_bench(folder)
    fitted = {one["name"]: one["value"] for one in json.loads((folder / "car_1/result.json").read_text())["parameters"]}
    held = "".join(parameter(f"{name}_{axle}_at_{i}", fitted[f"{name}_{axle}"] * laws[click][name] / laws[now][name], False)
                   for i, clicks in enumerate(tests, 1) for axle, click, now in zip(AXLES, clicks, PRESENT)
                   for name in FOLLOWERS)
    (folder / "car_again.urdf").write_text(car_file(laws, held))
    text = (folder / "car.yaml").read_text().replace("car.urdf", "car_again.urdf")
    text = text.replace("evaluations: 60, starts: 2", "evaluations: 5, starts: 1")
    text += "control: {" + ", ".join(f"{name}_{axle}: per setting" for axle in AXLES for name in FOLLOWERS) + "}\nhistories:\n"
    for i in range(len(tests) + 1):
        text += (f"  - {{file: drive_{i}.csv, control: {i}, posts: {{front: post_front, rear: post_rear}}, "
                 "start: 1 s}\n")
    (folder / "car_again.yaml").write_text(text)
    run(program, "fit", folder / "car_again.yaml", "-o", folder / "car_2", "--no-suggest", "--threads", "1")


def true_costs(program, folder, car, options):
    """What 400 runs on the rig would tell: every pair of clicks in the true car, without doubt; twelve of the best by time
    histories, which correct the spectra of all."""
    knob = lambda axle, now: ("{sets: {" + ", ".join(f"f{i}_{axle}: f{i}" for i in range(len(SPEEDS))) +
                              f"}}, table: true_clicks.csv, now: {now}, change: absolute}}")
    text = settings(options)
    roads = text[text.index("roads:"):]
    (folder / "true_settings.yaml").write_text(
        "knobs:\n" + "".join(f"  {axle}: {knob(axle, now)}\n" for axle, now in zip(AXLES, PRESENT)) + roads +
        "shortlist: 12\n")
    run(program, "choose", car.file, "--settings", folder / "true_settings.yaml", "--threads", "1", "-o",
        folder / "true_choice")
    return {clicks: 1 + float(row["change"]) / 100 for clicks, row in rated(folder, "true_choice").items()}


def rated(folder, choice):
    """{(front, rear): row} of settings.csv."""
    with (folder / choice / "settings.csv").open() as file:
        return {(int(row["front"]), int(row["rear"])): row for row in csv.DictReader(file) if row["front"].isdigit()}


def loop(program, folder, seed, options):
    """One car; the folder holds the benched dampers."""
    car = Car(program, folder, seed)
    rig_runs = identify_car(program, folder, car)
    first = choose(program, folder, "car_1", "choice_1", options)
    tests = clicks_to_test(folder, options.tests)
    last = first
    if tests:
        rig_runs += test_on_rig(car, tests)
        identify_car_again(program, folder, tests)
        last = choose(program, folder, "car_2", "choice_2", options)
    costs = true_costs(program, folder, car, options)
    best = min(costs, key=costs.get)
    best_of_rated = min(rated(folder, "choice_1"), key=costs.get)
    row = {"car": seed, "rig_runs": rig_runs, "tested": " ".join(f"{f}/{r}" for f, r in tests), "true_best": "%d/%d" % best,
           "best_of_rated": "%d/%d" % best_of_rated}
    for name, choice in (("first", first), ("last", last)):
        clicks = chosen(choice)
        row |= {name: "%d/%d" % clicks, f"{name}_best_probability": f"{choice['best']['best_probability']:.3g}",
                f"{name}_stated_regret": f"{100 * choice['best']['regret']:.3g}",
                f"{name}_true_regret": f"{100 * (costs[clicks] / costs[best] - 1):.3g}"}
    row["present_regret"] = f"{100 * (costs[PRESENT] / costs[best] - 1):.3g}"
    write_choices(folder / "choices.csv", {"choice_1": first} | ({"choice_2": last} if tests else {}), costs, best_of_rated)
    return row


def chosen(choice):
    return tuple(int(choice["best"]["setting"][axle]) for axle in AXLES)


def write_choices(file, choices, costs, best_of_rated):
    """The gain over the present clicks that each choice states and the true one, in per cent; how many settings it does not
    distinguish from the best, itself included, and whether the true best of the rated ones is among these."""
    best = {axle: str(click) for axle, click in zip(AXLES, best_of_rated)}
    with file.open("w") as stream:
        out = csv.writer(stream, lineterminator="\n")
        out.writerow(["choice", "clicks", "stated_gain", "true_gain", "indistinct", "true_best_is_indistinct"])
        for name, choice in choices.items():
            clicks = chosen(choice)
            gains = (-choice["best"]["change"]["mean"], 1 - costs[clicks] / costs[PRESENT])
            out.writerow([name, "%d/%d" % clicks, *(f"{100 * gain:.3g}" for gain in gains), len(choice["indistinct"]),
                          "yes" if best in choice["indistinct"] else "no"])


def clicks_to_bench(text):
    known = {str(click): click for click in BENCHED}
    clicks = set(text.split(","))
    if len(clicks) < 2 or not clicks <= set(known):
        raise argparse.ArgumentTypeError(f"'{text}' is not two or more of {','.join(known)}, the clicks of bench.yaml")
    return sorted(known[click] for click in clicks)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program", type=Path)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--cars", default="1", help="seeds of the virtual cars, 3 or 1..20")
    arguments.add_argument("--tests", type=int, default=3, help="clicks to test on the rig, at the most")
    arguments.add_argument("--draws", type=int, default=60, help="possible cars in which settings are rated")
    arguments.add_argument("--benched", type=clicks_to_bench, help="clicks on the bench, such as 4,10,16 (default: those of "
                           "FOLDER/bench, else " + ",".join(map(str, BENCHED)) + ")")
    arguments.add_argument("--step", type=int, default=1, help="3 rates each third click, 49 settings in place of 400")
    arguments.add_argument("--road", type=int, help="seconds of road of the time histories that check a choice, as `choose` "
                           "has them: 60")
    options = arguments.parse_args()
    first, _, last = options.cars.partition("..")
    options.folder.mkdir(parents=True, exist_ok=True)
    if not (options.folder / "bench/result.json").exists():
        identify_dampers(options.program, options.folder, options.benched or BENCHED)
    elif options.benched not in (None, benched_clicks(options.folder)):
        there, asked = (",".join(map(str, clicks)) for clicks in (benched_clicks(options.folder), options.benched))
        sys.exit(f"{options.folder}/bench was fitted to clicks {there}, not to {asked}: take another folder, or delete bench "
                 "in it")
    print("# loop.py PROGRAM FOLDER", *sys.argv[3:], flush=True)
    out = None
    for seed in range(int(first), int(last or first) + 1):
        row = loop(options.program, options.folder, seed, options)
        if out is None:
            out = csv.DictWriter(sys.stdout, list(row), lineterminator="\n")
            out.writeheader()
        out.writerow(row)
        sys.stdout.flush()


if __name__ == "__main__":
    main()
