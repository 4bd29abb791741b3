#!/usr/bin/env python3
"""Frequency responses by Fourier coefficients (thesis, section 4.2.3: the multibody system is run until its motion
repeats, then whole cycles are taken) against the condensed model's: of the linear model the closed form, of the others
harmonic balance. 0.5 to 30 Hz at 12 mm, 0.15 m/s and 6 m/s^2 at most. The largest differences of every channel as CSV.

    fourier.py build/release/fourpost FOLDER_FOR_RUNS > fourier.csv
"""
import csv
import math
import pathlib
import subprocess
import sys

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
here = pathlib.Path(__file__).parent.parent
FREQUENCIES = "0.5Hz:30Hz:12"


def responses(model, engine):
    out = folder / f"{model}_{engine}"
    subprocess.run([program, "response", here / f"{model}.urdf", "--engine", engine, "--frequencies", FREQUENCIES,
                    "-o", out], check=True, stdout=subprocess.DEVNULL)
    with open(out / "response.csv", newline="") as file:
        return [row for row in csv.DictReader(file)]


print("# fourier.py build/release/fourpost FOLDER_FOR_RUNS")
print("model,against,channel,frequencies,gain_error_dB,at_Hz,phase_error_deg,at_Hz")
for model, against in (("model1", "closed form"), ("model2", "harmonic balance"), ("model3", "harmonic balance"),
                       ("model4_frequency", "harmonic balance")):
    worst = {}
    for ours, theirs in zip(responses(model, "time"), responses(model, "reduced")):
        f, channel = float(ours["frequency_Hz"]), ours["channel"]
        gain = abs(20 * math.log10(float(ours["gain"]) / float(theirs["gain"])))
        phase = abs((float(ours["phase_deg"]) - float(theirs["phase_deg"]) + 180) % 360 - 180)
        entry = worst.setdefault(channel, [0, 0, 0, 0, 0])
        entry[0] += 1
        if gain > entry[1]:
            entry[1:3] = gain, f
        if phase > entry[3]:
            entry[3:5] = phase, f
    for channel, entry in worst.items():
        print(",".join([model, against, channel, str(entry[0])] + [f"{n:.2g}" for n in entry[1:]]), flush=True)
