#!/usr/bin/env python3
"""Which seeded faults of a rig `fourpost info STUDY` names, and how often it names one where there is none, as CSV.

  audit.py PROGRAM --sets 200 > audit.csv      random cars (random_cars.py), clean and with one fault each
  audit.py PROGRAM --table > audit_table.csv   common faults in the Land Rover's recordings, by Model 2
  audit.py PROGRAM --histories 60 > audit_histories.csv   time histories, clean and with one delay each

Recordings of random cars are of a richer vehicle than any that audits them: power unit on mounts, bushes, friction,
digressive dampers; noise of three repeats, scale errors of 0.3 %. In a planar model a fault is in both channels of a
sensor. Time histories are of three vehicles at drawn parameters, which the audit does not know, on sweeps, random motions
and roads, with noise on all channels, posts too; one channel, or all of a kind, comes 2 to 5 ms late or early.
"""
import argparse
import csv
import itertools
import json
import math
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import coverage_over_time
import random_cars
import run_program

SOURCE = Path(__file__).resolve().parents[2]
LAND_ROVER = SOURCE / "studies" / "landrover110"
KINDS = ["gain 3 %", "delay 2 ms", "position 5 cm", "sign", "swap", "tare 2 %", "clipping 1 %", "scale 4.45"]
NAMES = {"gain 3 %": "scale", "delay 2 ms": "delay", "position 5 cm": "position", "sign": "scale", "swap": "exchange",
         "tare 2 %": "scale", "clipping 1 %": "scale", "scale 4.45": "scale"}


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write(path, rows):
    with open(path, "w", newline="") as file:
        out = csv.DictWriter(file, rows[0].keys())
        out.writeheader()
        out.writerows(rows)


def each_row(folder, change):
    """Changes every row of every stepped sine."""
    for path in sorted(folder.glob("*_frf.csv")):
        rows = read(path)
        for row in rows:
            change(row)
        write(path, rows)


def scaled(row, factor):
    row["gain"] = float(row["gain"]) * abs(factor)
    row["gain_sd"] = float(row["gain_sd"]) * abs(factor)
    if factor < 0:
        row["phase_deg"] = float(row["phase_deg"]) + 180
    if row["mean"]:
        row["mean"] = float(row["mean"]) * factor


def delayed(row, seconds):
    row["phase_deg"] = float(row["phase_deg"]) - 360 * float(row["frequency_Hz"]) * seconds


def clip(folder, names, share):
    """Of the time at which a channel is beyond its range; its first harmonic is what a rig makes of it."""
    level = {}
    for name in names:
        readings = []
        for path in folder.glob("*_frf.csv"):
            for row in read(path):
                if row["channel"] == name:
                    readings.append(reading_of(row))
        low, high = 0.0, max(readings)
        for _ in range(60):
            middle = (low + high) / 2
            beyond = sum(2 / math.pi * math.acos(middle / r) for r in readings if r > middle) / len(readings)
            low, high = (middle, high) if beyond > share else (low, middle)
        level[name] = high

    def change(row):
        if row["channel"] in level and (top := reading_of(row)) > (limit := level[row["channel"]]):
            angle = math.asin(limit / top)
            scaled(row, 2 / math.pi * (angle + limit / top * math.cos(angle)))
    each_row(folder, change)


def reading_of(row):
    acceleration = (2 * math.pi * float(row["frequency_Hz"])) ** 2 if row["channel"].startswith("a_") else 1
    return float(row["gain"]) * float(row["post_amplitude_m"]) * acceleration


def channels_of(text):
    """Sensor of a study, and the recorded channels it stands for."""
    block = re.search(r"\nchannels:\n((?:  .*\n)+)", text).group(1)
    return {name: re.findall(r"\w+_\w+", rest.replace("mean", "").replace("sum", ""))
            for name, rest in re.findall(r"  (\w+): (.*)\n", block)}


def make_set(program, folder, model, draw):
    random_cars.record(program, folder, random_cars.drawn(draw), draw, 40)


def repeated_study(model, folder):
    study = random_cars.study(model, folder)
    text = study.read_text()
    text = re.sub(r"file: (bounce|pitch|roll)_frf.csv", r"file: \1_frf.csv\n    repeats: 3", text)
    study.write_text(text)
    return study


def device(name):
    return name.split("_")[0]


def seed_fault(kind, study, folder, draw):
    """Puts a fault in; returns what an audit should name."""
    text = study.read_text()
    sensors = channels_of(text)
    name = draw.choice([one for one in sensors if kind != "position 5 cm" or one.startswith("a_")])
    raw = sensors[name]
    if kind == "gain 3 %":
        factor = draw.choice([1.03, 1 / 1.03])
        each_row(folder, lambda row: row["channel"] in raw and scaled(row, factor))
    if kind == "delay 2 ms":
        seconds = draw.choice([0.002, -0.002])
        each_row(folder, lambda row: row["channel"] in raw and delayed(row, seconds))
    if kind == "sign":
        each_row(folder, lambda row: row["channel"] in raw and scaled(row, -1))
    if kind == "scale 4.45":
        factor = draw.choice([4.4482216, 1 / 4.4482216])
        each_row(folder, lambda row: row["channel"] in raw and scaled(row, factor))
    if kind == "clipping 1 %":
        clip(folder, raw, 0.01)
    if kind == "swap":
        other = draw.choice([one for one in sensors if device(one) == device(name) and one != name])
        first, second = re.search(rf"  {name}: (.*)\n", text).group(1), re.search(rf"  {other}: (.*)\n", text).group(1)
        text = text.replace(f"  {name}: {first}\n", "  @\n").replace(f"  {other}: {second}\n", f"  {other}: {first}\n")
        study.write_text(text.replace("  @\n", f"  {name}: {second}\n"))
        return {f"{name} and {other}", f"{other} and {name}"}
    if kind == "tare 2 %":
        rows = read(folder / "static.csv")
        loads = [row for row in rows if row["quantity"].startswith("static_load")]
        row = draw.choice(loads)
        row["value"] = float(row["value"]) * draw.choice([1.02, 0.98])
        write(folder / "static.csv", rows)
        return {"load at rest"}
    if kind == "position 5 cm":
        vehicle = Path(re.search(r"vehicle: (.*)", text).group(1))
        body = vehicle.read_text().replace("../meshes/", str(SOURCE / "meshes") + "/")
        place = re.search(rf'name="{name}" type="accelerometer" link="\w+" xyz="([^ "]+)', body)
        if not place:
            return None
        moved = float(place.group(1)) + draw.choice([0.05, -0.05])
        body = body[:place.start(1)] + str(moved) + body[place.end(1):]
        (folder / "moved.urdf").write_text(body)
        study.write_text(text.replace(str(vehicle), "moved.urdf"))
    return {name}


def audit(program, study):
    outcome = subprocess.run([str(program), "info", str(study), "--json"], capture_output=True, text=True)
    # 3: a fit refuses it, and there is no audit.
    if outcome.returncode not in (0, 1, 3):
        raise RuntimeError(outcome.stderr[-2000:])
    return json.loads(outcome.stdout)["files"][0]


def words(suspicions):
    return "; ".join(f"{s['kind']} of {s['of']} {s['size']:.3g}" +
                     "".join(f" or {r['kind']} of {r['of']} {r['size']:.3g}" for r in s["rivals"][:3]) for s in suspicions)


def named(suspicion, kind, expected):
    kinds = {NAMES[kind], "other channel"} if kind == "clipping 1 %" else {NAMES[kind]}
    return suspicion["kind"] in kinds and any(suspicion["of"].startswith(one) for one in expected)


# Of a study that the checks before it refuse.
NO_AUDIT = {"suspicions": [], "misfit": math.nan}


def run_sets(options):
    out = csv.writer(sys.stdout)
    out.writerow(["set", "model", "fault", "of", "named_first", "named_among", "anything_named", "misfit", "found"])
    models = options.models.split(",")
    for number in range(options.first, options.first + options.sets):
        with tempfile.TemporaryDirectory() as temporary:
            model = models[number % len(models)]
            kept = Path(options.keep or temporary) / f"set{number}"
            if not (kept / "static.csv").exists():
                kept.mkdir(parents=True, exist_ok=True)
                make_set(options.program, kept, model, random.Random(number))
            folder = Path(temporary) / "faulty"
            shutil.copytree(kept, folder)
            study = repeated_study(model, folder)
            draw = random.Random(f"fault {number}")
            clean = audit(options.program, study)["audit"] or NO_AUDIT
            out.writerow([number, model, "none", "", "", "", int(bool(clean["suspicions"])), f"{clean['misfit']:.2f}",
                          words(clean["suspicions"])])
            kind = KINDS[(number // len(models)) % len(KINDS)]
            expected = seed_fault(kind, study, folder, draw)
            if expected:
                faulty = audit(options.program, study)["audit"] or NO_AUDIT
                found = faulty["suspicions"]
                first = bool(found) and named(found[0], kind, expected)
                among = any(named(s, kind, expected) or any(named(r, kind, expected) for r in s["rivals"]) for s in found)
                out.writerow([number, model, kind, "; ".join(sorted(expected)), int(first), int(among), int(bool(found)),
                              f"{faulty['misfit']:.2f}", words(found)])
            sys.stdout.flush()


HISTORY_MODELS = ["quarter_car", "single_wheel_station", "landrover110_linkage"]
HISTORY_MOTIONS = {"sweep": ["--sweep", "0.5Hz:20Hz"], "random": ["--random", "4mm"],
                   "road": ["--road", "C", "--speed", "50km/h"]}
FINE_RATE = 1000


def simulated_history(options, number, model, motion, seconds):
    """Names, units and columns at FINE_RATE, without noise; and the parameters."""
    vehicle = SOURCE / "urdf" / f"{model}.urdf"
    known = coverage_over_time.parameters(options.program, vehicle)
    values = coverage_over_time.drawn(random.Random(f"history {number}"), known)
    units = {p["name"]: p["unit"] for p in known}
    sets = [part for name, value in values.items() for part in ("--set", f"{name}={value}{units[name]}")]
    seed = [] if motion == "sweep" else ["--seed", str(number)]
    with tempfile.TemporaryDirectory() as temporary:
        file = Path(temporary) / "fine.csv"
        run_program.run(options.program, "simulate", vehicle, *HISTORY_MOTIONS[motion], *seed, *sets, "--engine", "reduced",
                        "--duration", f"{seconds}s", "--rate", f"{FINE_RATE}Hz", "-o", file)
        names, row_units, columns = coverage_over_time.read(file)
    return (names, row_units, columns), list(values)


def smoothed(values, step):
    """Four running means: a recorder's filter, without which kinks of dampers are mirrored into the band."""
    for _ in range(4):
        sums = [0.0, *itertools.accumulate(values)]
        values = [(sums[k + step] - sums[k]) / step for k in range(len(values) - step + 1)]
    return values


def recorded_history(folder, model, free, fine, late_s, rate, level, is_stated, draw):
    """Writes a study of a recording at `rate` with noise of `level`, which it states or not; `late_s`: of channels."""
    names, units, columns = fine
    step = FINE_RATE // rate
    edge = 10
    recorded = []
    noise = {}
    for name, column in zip(names, columns):
        shift = round(late_s.get(name, 0) * FINE_RATE)
        taken = column[edge - shift:len(column) - edge - shift]
        taken = taken[::step] if name == "time" else smoothed(taken, step)[::step]
        if name != "time":
            mean = sum(taken) / len(taken)
            sd = level * math.sqrt(sum((v - mean) ** 2 for v in taken) / len(taken))
            taken = [v + draw.gauss(0, sd) for v in taken]
            noise[name] = sd
        recorded.append(taken)
    recorded[0] = [k / rate for k in range(len(recorded[1]))]
    coverage_over_time.write(folder / "recording.csv", names, units, recorded)
    posts = [name[5:] for name in names if name.startswith("post_")]
    # Load cells are not audited over time.
    sensors = [name for name in names[1:] if not name.startswith(("post_", "F_"))]
    coverage_over_time.study(folder, SOURCE / "urdf" / f"{model}.urdf", posts, sensors, free)
    if is_stated:
        text = (folder / "study.yaml").read_text()
        stated = ", ".join(f"{name}: {noise[name]:.4g} {unit}" for name, unit in zip(names, units) if name in sensors)
        (folder / "study.yaml").write_text(text.replace("model_error:", f"    noise: {{{stated}}}\nmodel_error:"))


def run_histories(options):
    out = csv.writer(sys.stdout)
    out.writerow(["set", "model", "motion", "rate", "level", "noise", "late", "by_ms", "named_first", "named_among", "anything_named",
                  "misfit", "found"])
    cases = [(model, motion, rate, level, is_stated) for model in HISTORY_MODELS for motion in HISTORY_MOTIONS
             for rate in (200, 500) for level in (0.001, 0.01) for is_stated in (True, False)]
    for number in range(options.first, options.first + options.histories):
        model, motion, rate, level, is_stated = cases[(number * 7919) % len(cases)]
        draw = random.Random(number)
        fine, free = simulated_history(options, number, model, motion, draw.choice([30, 60]))
        kinds = {}
        for name in fine[0][1:]:
            if not name.startswith(("post_", "F_")):
                kinds.setdefault(device(name), []).append(name)
        late = [draw.choice([name for names in kinds.values() for name in names])]
        if draw.random() < 0.3:
            late = draw.choice(list(kinds.values()))
        milliseconds = draw.choice([2, 3, 4, 5]) * draw.choice([1, -1])
        for delayed_ones, by in ((late, milliseconds), ([], 0)):
            with tempfile.TemporaryDirectory() as temporary:
                folder = Path(temporary)
                recorded_history(folder, model, free, fine, {name: by / 1000 for name in delayed_ones}, rate, level,
                                 is_stated, draw)
                found = audit(options.program, folder / "study.yaml")["audit"]
            suspicions = found["suspicions"] if found else []

            def is_it(one):
                return one["kind"] == "delay" and abs(one["size"] - by / 1000) < 0.001 and (
                    one["of"] in delayed_ones or one["of"].startswith("all "))
            first = bool(suspicions) and is_it(suspicions[0])
            among = any(is_it(s) or any(is_it(r) for r in s["rivals"]) for s in suspicions)
            out.writerow([number, model, motion, rate, level, "stated" if is_stated else "", " ".join(delayed_ones), by, int(first), int(among),
                          int(bool(suspicions)), f"{found['misfit']:.2f}" if found else "", words(suspicions)])
            sys.stdout.flush()


def table_faults():
    """Name, and what it changes in a folder of recordings."""
    def of(prefix, change):
        return lambda folder: each_row(folder, lambda row: row["channel"].startswith(prefix) and change(row))

    def late(prefix, milliseconds):
        return of(prefix, lambda row: delayed(row, milliseconds / 1000))

    def gain(prefix, factor):
        return of(prefix, lambda row: scaled(row, factor))

    def amplitude(factor):
        return lambda folder: each_row(
            folder, lambda row: row.update(post_amplitude_m=float(row["post_amplitude_m"]) * factor))

    def mean_sign(row):
        if row["mean"]:
            row["mean"] = -float(row["mean"])

    def load(change):
        def apply(folder):
            rows = read(folder / "static.csv")
            for row in rows:
                if row["quantity"].startswith("static_load"):
                    change(row)
            write(folder / "static.csv", rows)
        return apply

    def rear_for_front(folder):
        path = folder / "model2.yaml"
        path.write_text(path.read_text().replace("s_strut_front: {mean: [s_strut_FL, s_strut_FR]}",
                                                 "s_strut_front: {mean: [s_strut_RL, s_strut_RR]}"))
    yield "untouched", lambda folder: None
    yield "post_amplitude_m x2 (peak to peak for amplitude)", amplitude(2)
    yield "post_amplitude_m /1000", amplitude(0.001)
    for ms in (2, 5, 10):
        yield f"all channels {ms} ms late (posts on another device)", late("", ms)
    yield "all accelerometers 5 ms late", late("a_", 5)
    for ms in (2, 5, 10):
        yield f"tyre forces {ms} ms late", late("F_", ms)
    yield "struts x1.1", gain("s_", 1.1)
    yield "struts x1.2", gain("s_", 1.2)
    yield "struts sum for mean (x2)", gain("s_", 2)
    yield "sign of the struts' mean alone", of("s_", mean_sign)
    yield "frequency x1.05", of("", lambda row: row.update(frequency_Hz=float(row["frequency_Hz"]) * 1.05))
    yield "front strut sensor mapped to the rear's channels", rear_for_front
    yield "everything x1.05 (post transducer)", gain("", 1.05)
    yield "static FL +200 N", load(
        lambda row: row["quantity"].endswith("FL") and row.update(value=float(row["value"]) + 200))
    yield "struts x25.4", gain("s_", 25.4)
    yield "struts x1000", gain("s_", 1000)
    yield "forces x0.001", gain("F_", 0.001)
    yield "a x9.8", gain("a_", 9.80665)
    yield "static x1000", load(lambda row: row.update(value=float(row["value"]) * 1000))


def run_table(options):
    out = csv.writer(sys.stdout)
    out.writerow(["fault", "named", "misfit", "findings"])
    for name, change in table_faults():
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(temporary)
            for file in ("bounce_frf.csv", "pitch_frf.csv", "static.csv"):
                shutil.copy(LAND_ROVER / file, folder)
            random_cars.study("model2", folder)
            change(folder)
            result = audit(options.program, folder / "model2.yaml")
            found = result["audit"]
            out.writerow([name, words(found["suspicions"]) if found else "", f"{found['misfit']:.2f}" if found else "",
                          " ".join(warning["id"] for warning in result["warnings"])])
            sys.stdout.flush()


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program")
    arguments.add_argument("--sets", type=int, default=200)
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--models", default="model1,model2,model3,full_one_body")
    arguments.add_argument("--keep", help="folder for clean recordings")
    arguments.add_argument("--table", action="store_true")
    arguments.add_argument("--histories", type=int, default=0)
    options = arguments.parse_args()
    if options.histories:
        run_histories(options)
    elif options.table:
        run_table(options)
    else:
        run_sets(options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
