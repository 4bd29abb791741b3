#!/usr/bin/env python3
"""Compares the engines over every shipped vehicle, as CSV.

Histories: `reduced` and `auto` against `full`, as the largest rms difference of a channel as a share of its rms.
Stepped sines: `auto` against `time`, as the largest difference of a first harmonic as a share of the channel's largest.
`stated` is the error that the result of `auto` itself states of linear kinematics, in the same shares.
Channels below a hundredth of the loudest of their unit are silent by symmetry and left out.
"""
import argparse
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
HISTORIES = {
    "sweep": (["--sweep", "0.5Hz:30Hz", "--duration", "20s"],
              [[], ["--amplitude", "50mm", "--velocity", "0.5m/s"]]),
    "sine": (["--sine", "1.5Hz", "--duration", "6s"],
             [["--amplitude", "5mm"], ["--amplitude", "40mm", "--velocity", "1m/s"]]),
    "step": (["--duration", "4s"], [["--step", "10mm"], ["--step", "60mm"]]),
    "random": (["--duration", "10s"], [["--random", "2mm"], ["--random", "10mm"]]),
    "road": (["--speed", "60km/h", "--duration", "10s"], [["--road", "A"], ["--road", "D"]]),
}
MODES = ["heave", "roll"]
# Of rigs: the default limits, and larger ones.
LEVELS = [["--amplitude", "5mm"], ["--amplitude", "20mm", "--velocity", "0.3m/s", "--acceleration", "12m/s^2"]]
FREQUENCIES = "1.4Hz,7Hz,15Hz"


def run(program, *arguments):
    outcome = subprocess.run([program, *arguments], capture_output=True, text=True)
    return outcome if outcome.returncode in (0, 1) else None


def columns(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    return {name: (unit, [float(row[i]) for row in rows[2:]])
            for i, (name, unit) in enumerate(zip(rows[0], rows[1]))}


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def furthest(reference, other):
    """(share, channel)"""
    loudest = {}
    for name, (unit, values) in reference.items():
        loudest[unit] = max(loudest.get(unit, 0), rms(values))
    worst = (0.0, "")
    for name, (unit, values) in reference.items():
        if name == "time" or name.startswith("post") or rms(values) <= 0.01 * loudest[unit]:
            continue
        share = rms([a - b for a, b in zip(values, other[name][1])]) / rms(values)
        worst = max(worst, (share, name))
    return worst


def history(program, folder, vehicle, arguments):
    found = {}
    stated = engine = ""
    for name in ("full", "reduced", "auto"):
        path = folder / f"{name}.csv"
        path.unlink(missing_ok=True)
        outcome = run(program, "simulate", str(vehicle), *arguments, "--engine", name, "--rate", "500Hz",
                      "-o", str(path), "--json")
        if outcome is None:
            return None
        found[name] = columns(path)
        if name == "auto":
            summary = json.loads(outcome.stdout)
            engine = summary["engine"]
            stated = (summary["linear_kinematics_error"] or {}).get("value", "")
    reduced, channel = furthest(found["full"], found["reduced"])
    return reduced, channel, stated, engine, furthest(found["full"], found["auto"])[0]


def responses(path):
    found = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row["gain"]:
                phase = math.radians(float(row["phase_deg"]))
                gain = float(row["gain"])
                value = complex(gain * math.cos(phase), gain * math.sin(phase))
                found.setdefault((row["unit"], row["channel"]), {})[row["frequency_Hz"]] = value
    return found


def response(program, folder, vehicle, arguments):
    found = {}
    engine = ""
    for name in ("time", "reduced", "auto"):
        outcome = run(program, "response", str(vehicle), *arguments, "--engine", name,
                      "-o", str(folder / name), "--json")
        if outcome is None:
            return None
        found[name] = responses(folder / name / "response.csv")
        if name == "auto":
            rows = (folder / name / "response.csv").read_text().splitlines()[1:]
            engine = "+".join(sorted({row.rsplit(",", 1)[1] for row in rows}))
    march = found["time"]
    loudest = {}
    for (unit, _), values in march.items():
        loudest[unit] = max([loudest.get(unit, 0), *map(abs, values.values())])

    def apart(other):
        worst = (0.0, "")
        for (unit, channel), values in march.items():
            largest = max(map(abs, values.values()))
            if largest <= 0.01 * loudest[unit]:
                continue
            for frequency, value in values.items():
                if frequency in other.get((unit, channel), {}):
                    worst = max(worst, (abs(other[unit, channel][frequency] - value) / largest, f"{channel} {frequency} Hz"))
        return worst

    reduced, channel = apart(found["reduced"])
    return reduced, channel, "", engine, apart(found["auto"])[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("vehicles", nargs="*", type=Path, default=sorted((SOURCE / "urdf").glob("*.urdf")))
    parser.add_argument("--histories", action="store_true", help="these only")
    parser.add_argument("--responses", action="store_true", help="these only")
    options = parser.parse_args()
    cases = []
    if not options.responses:
        cases += [(history, name, common, level) for name, (common, levels) in HISTORIES.items() for level in levels]
    if not options.histories:
        cases += [(response, mode, ["--mode", mode, "--frequencies", FREQUENCIES], level)
                  for mode in MODES for level in LEVELS]
    out = csv.writer(sys.stdout, lineterminator="\n")
    print("# tests/validation/engines.py build/release/fourpost; shares in per cent, see the script")
    out.writerow(["vehicle", "motion", "level", "reduced_off", "channel", "stated", "auto_engine", "auto_off"])
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for vehicle in options.vehicles:
            for compare, name, common, level in cases:
                answer = compare(options.program, folder, vehicle, [*common, *level])
                if answer is None:
                    continue  # No such motion of this vehicle.
                share = lambda value: "" if value == "" else f"{100 * value:.3g}"
                off, channel, stated, engine, chosen = answer
                out.writerow([vehicle.stem, name, " ".join(level), share(off), channel, share(stated), engine, share(chosen)])
                sys.stdout.flush()


if __name__ == "__main__":
    main()
