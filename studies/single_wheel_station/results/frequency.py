#!/usr/bin/env python3
"""Misfits at each amplitude of the wheel station's Model 4, fitted to frequency responses at both at once, as CSV; fits it
where FOLDER does not hold it yet (ten minutes with hysteresis).

    results/frequency.py ../../build/release/fourpost FOLDER > results/frequency.csv        (in studies/single_wheel_station)
"""
import json
import pathlib
import subprocess
import sys

STUDIES = {"model4_frequency": "", "model4_frequency_hysteresis": "_sparse"}


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    print("# results/frequency.py ../../build/release/fourpost FOLDER, in studies/single_wheel_station")
    print("study,recording,channel,rms_dB,rms_deg,nmse_percent", flush=True)
    for study, which in STUDIES.items():
        run = folder / study
        if not (run / "result.json").exists():
            subprocess.run([program, "fit", f"{study}.yaml", "-o", run], check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
        for recording in (f"frf_12mm{which}", f"frf_7mm{which}"):
            command = [program, "predict", run, "--recording", f"{recording}.csv", "--json"]
            told = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
            for channel in json.loads(told)["channels"]:
                print(study, recording, channel["name"], f"{channel['rms_dB']:.3g}", f"{channel['rms_deg']:.3g}",
                      f"{channel['nmse_percent']:.3g}", sep=",", flush=True)


if __name__ == "__main__":
    main()
