#!/usr/bin/env python3
"""Frequency responses that `fourpost frf` makes of simulated recordings, against the harmonic balance, as CSV.

A vehicle is simulated on stepped sines, also of few cycles, on a sweep and a random motion, with noise on all channels,
posts too. `fourpost frf` makes responses of them, and `fourpost response` has the truth at the same frequencies and, of stepped sines, the same
amplitudes. Sweeps and random motions of a car with bilinear dampers are compared as well, with the balance at the
amplitudes of stepped sines: they are not the same. Stepped sines of the quarter car with bilinear dampers are compared with
the integration in time, which the balance differs from by 1e-4.

  frequency_response.py PROGRAM > frequency_response.csv

A row per vehicle, motion, noise and channel:
  points      numbers compared, a gain and a phase at each frequency
  covered     share of these within 1.96 of their standard deviations, %
  sharp       frequencies at which three standard deviations are below 0.05 dB and 0.3 degrees
  worst_dB, worst_deg   largest errors at these
  median_sd_dB          of all
  means, means_covered  of struts on stepped sines: mean offsets, and the share of them within 1.96 deviations, %
  worst_mean_mm, median_mean_sd_mm
"""
import argparse
import cmath
import csv
import json
import math
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
RATE = 500
# Posts, how they move, and the dampers that are tried.
VEHICLES = {
    "quarter_car": (["post"], "heave", {"linear": [], "bilinear": ["c_bump=1000N*s/m", "c_rebound=3000N*s/m"]}),
    "landrover110_linkage": (["front", "rear"], "heave", {"bilinear": []}),
}
NOISE = ["0.1%", "1%"]
ALL_HZ = [0.5 * 60 ** (k / 39) for k in range(40)]
LOW_HZ = [0.5 * 1.05**k for k in range(37)]
# Dwells that are short in cycles or in seconds: cycles, pauses in seconds, frequencies.
SHORT = {"four": (4, 0, LOW_HZ), "four_paused": (4, 2, LOW_HZ), "six": (6, 0, LOW_HZ), "six_paused": (6, 2, LOW_HZ),
         "eight": (8, 0, LOW_HZ), "ten_to_30_Hz": (10, 0, ALL_HZ)}


def run(*arguments):
    outcome = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if outcome.returncode not in (0, 1):
        raise RuntimeError(" ".join(map(str, arguments)) + "\n" + outcome.stderr[-2000:])
    return outcome.stdout


def amplitude(frequency):
    """Of the rig's limits, as `fourpost response` has them without options."""
    w = 2 * math.pi * frequency
    return min(12e-3, 0.15 / w, 6 / w**2)


def stepped_heights(frequencies, cycles=20, least_s=4, pause_s=0):
    """Rest, then dwells of whole numbers of samples, without jumps of the phase, with pauses between them."""
    heights = [0.0] * (2 * RATE)
    phase = 0.0
    for frequency in frequencies:
        for _ in range(round(max(cycles / frequency, least_s) * RATE)):
            phase += 2 * math.pi * frequency / RATE
            heights.append(amplitude(frequency) * math.sin(phase))
        heights += [0.0] * round(pause_s * RATE)
    return heights


def write_heights(path, posts, heights):
    with open(path, "w") as file:
        file.write("time," + ",".join(posts) + "\ns" + ",m" * len(posts) + "\n")
        for k, z in enumerate(heights):
            file.write(f"{k / RATE:.6f}" + f",{z:.12g}" * len(posts) + "\n")


def truth(program, model, mode, settings, frequencies):
    words = [word for setting in settings for word in ("--set", setting)]
    listed = ",".join(f"{f!r}Hz" for f in frequencies)
    answer = json.loads(run(program, "response", model, "--mode", mode, "--engine", "reduced", "--frequencies", listed,
                            "--json", *words))["modes"][0]
    return {channel["name"]: ([g * cmath.exp(1j * math.radians(p)) for g, p in zip(channel["gain"], channel["phase_deg"])],
                              channel["mean"]) for channel in answer["channels"]}


def by_integration(program, model, mode, settings, frequencies):
    """By frequency and channel the response by time integration over that of the balance, which knows bilinear dampers to
    1e-4 only: deviations are smaller at 0.1 % noise."""
    words = [word for setting in settings for word in ("--set", setting)]
    listed = ",".join(f"{f!r}Hz" for f in frequencies)
    engines = []
    for engine in ("time", "reduced"):
        answer = json.loads(run(program, "response", model, "--mode", mode, "--engine", engine, "--frequencies", listed,
                                "--json", *words))["modes"][0]
        engines.append({channel["name"]: [g * cmath.exp(1j * math.radians(p))
                                          for g, p in zip(channel["gain"], channel["phase_deg"])]
                        for channel in answer["channels"]})
    return {f: {name: engines[0][name][k] / engines[1][name][k] for name in engines[0]} for k, f in enumerate(frequencies)}


def corrected(true, frequencies, ratios):
    """The truth at measured frequencies, with the ratio of the nearest nominal one."""
    near = [ratios[min(ratios, key=lambda f: abs(f - at))] for at in frequencies]
    return {name: ([p * ratio[name] for p, ratio in zip(phasors, near)], offsets)
            for name, (phasors, offsets) in true.items()}


def simulate(program, model, motion, settings, noise, seed, output):
    words = [word for setting in settings for word in ("--set", setting)]
    run(program, "simulate", model, *motion, *words, "--rate", f"{RATE}Hz", "--noise", noise, "--seed", seed, "--engine",
        "reduced", "-o", output)


def compare(measured, true):
    """Points, covered, sharp, worst dB and degrees of one channel."""
    covered = points = sharp = 0
    worst_dB = worst_deg = 0.0
    deviations = []
    for gain, phase, gain_sd, phase_sd, value in zip(measured["gain"], measured["phase_deg"], measured["gain_sd"],
                                                     measured["phase_sd_deg"], true):
        ratio = gain * cmath.exp(1j * math.radians(phase)) / value
        sd = gain_sd / gain
        # Along and across the measured phasor, as a fit uses them.
        points += 2
        error = 1 - 1 / ratio
        covered += (abs(error.real) < 1.96 * sd) + (abs(error.imag) < 1.96 * math.radians(phase_sd))
        sd_dB = 20 / math.log(10) * sd
        deviations.append(sd_dB)
        if 3 * sd_dB < 0.05 and 3 * phase_sd < 0.3:
            sharp += 1
            worst_dB = max(worst_dB, abs(20 * math.log10(abs(ratio))))
            worst_deg = max(worst_deg, abs(math.degrees(cmath.phase(ratio))))
    return points, covered, sharp, worst_dB, worst_deg, statistics.median(deviations)


def compare_means(measured, true):
    """Errors and standard deviations of a strut's means [m]; nothing for other channels and motions."""
    if measured["unit"] != "m" or not measured["mean"]:
        return []
    return [(mean - at, sd) for mean, at, sd in zip(measured["mean"], true, measured["mean_sd"])]


def means_row(means):
    if not means:
        return [0, "", "", ""]
    covered = sum(abs(error) < 1.96 * sd for error, sd in means)
    return [len(means), f"{100 * covered / len(means):.1f}", f"{1e3 * max(abs(error) for error, _ in means):.4f}",
            f"{1e3 * statistics.median(sd for _, sd in means):.4f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--vehicle", choices=VEHICLES, action="append")
    options = parser.parse_args()
    program = Path(options.program).resolve()
    table = csv.writer(sys.stdout, lineterminator="\n")
    table.writerow(["vehicle", "motion", "dampers", "noise", "channel", "points", "covered_percent", "sharp", "worst_dB",
                    "worst_deg", "median_sd_dB", "means", "means_covered_percent", "worst_mean_mm", "median_mean_sd_mm"])
    for name in options.vehicle or VEHICLES:
        posts, mode, dampers_of = VEHICLES[name]
        model = SOURCE / f"urdf/{name}.urdf"
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            write_heights(folder / "heights.csv", posts, stepped_heights(ALL_HZ))
            for kind, (cycles, pause_s, frequencies) in SHORT.items():
                write_heights(folder / f"{kind}.csv", posts, stepped_heights(frequencies, cycles, 0, pause_s))
            runs = []
            for dampers, settings in dampers_of.items():
                runs.append(("stepped", dampers, ["--recording", folder / "heights.csv"], settings))
                runs += [(kind, dampers, ["--recording", folder / f"{kind}.csv"], settings) for kind in SHORT]
                if name == "quarter_car":
                    runs += [("sweep", dampers, ["--sweep", "0.4Hz:32Hz", "--mode", mode, "--duration", "180s"], settings),
                             ("random", dampers, ["--random", "4mm", "--mode", mode, "--band", "0.3Hz:32Hz", "--duration",
                                                  "300s"], settings)]
            ratios = {}
            for motion, dampers, words, settings in runs:
                if name == "quarter_car" and settings and motion in {"stepped", *SHORT} and not ratios:
                    ratios = by_integration(program, model, mode, settings, sorted({*ALL_HZ, *LOW_HZ}))
                for noise in NOISE:
                    sums = {}
                    means = {}
                    for seed in range(1, options.seeds + 1):
                        simulate(program, model, words, settings, noise, seed, folder / "recording.csv")
                        grid = [] if motion in {"stepped", *SHORT} else ["--frequencies", "0.7Hz:25Hz:40"]
                        measured = json.loads(run(program, "frf", folder / "recording.csv", *grid, "--json"))
                        if measured["kind"] != ("stepped" if motion in SHORT else motion) or len(measured["responses"]) != 1:
                            raise RuntimeError(f"{name}, {motion}: found {measured['kind']}")
                        response = measured["responses"][0]
                        true = truth(program, model, mode, settings, response["frequency_Hz"])
                        if settings and motion in {"stepped", *SHORT} and ratios:
                            true = corrected(true, response["frequency_Hz"], ratios)
                        for channel in response["channels"]:
                            phasors, offsets = true[channel["name"]]
                            sums.setdefault(channel["name"], []).append(compare(channel, phasors))
                            means.setdefault(channel["name"], []).extend(compare_means(channel, offsets))
                    for channel, found in sums.items():
                        points = sum(part[0] for part in found)
                        table.writerow([name, motion, dampers, noise, channel, points,
                                        f"{100 * sum(part[1] for part in found) / points:.1f}",
                                        sum(part[2] for part in found), f"{max(part[3] for part in found):.4f}",
                                        f"{max(part[4] for part in found):.3f}",
                                        f"{statistics.median(part[5] for part in found):.4f}",
                                        *means_row(means[channel])])
                    sys.stdout.flush()


if __name__ == "__main__":
    main()
