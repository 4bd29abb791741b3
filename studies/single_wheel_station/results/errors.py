#!/usr/bin/env python3
"""Fits the studies of the wheel station where FOLDER does not hold them yet, predicts the sweep that they have not seen, and
prints as CSV the normalised mean square errors [%] of both sweeps, of the 12 mm sweep also by the multibody system.

    results/errors.py ../../build/release/fourpost FOLDER > results/errors.csv        (in studies/single_wheel_station)
"""
import json
import pathlib
import subprocess
import sys

STUDIES = [f"model{model}{cost}" for cost in ("", "_compromise") for model in (1, 2, 3, 4)]
CHANNELS = ("z_sprung", "z_unsprung", "a_sprung", "a_unsprung", "F_tyre")


def answer(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    print("# results/errors.py ../../build/release/fourpost FOLDER, in studies/single_wheel_station")
    print("study,recording,engine,evaluations,cost", *CHANNELS, sep=",", flush=True)
    for study in STUDIES:
        run = folder / study
        if not (run / "result.json").exists():
            answer(program, "fit", f"{study}.yaml", "-o", run)
        result = json.loads((run / "result.json").read_text())
        for recording, engine in (("sweep_12mm", "condensed"), ("sweep_12mm", "full"), ("sweep_7mm", "condensed")):
            told = json.loads(answer(program, "predict", run, "--recording", f"{recording}.csv", "--json", *(
                ["--engine", "reduced" if engine == "condensed" else engine])))
            errors = {channel["name"]: channel["nmse_percent"] for channel in told["channels"]}
            print(study, recording, engine, result["evaluations"]["paid"], f"{result['cost']:.5g}",
                  *(f"{errors[channel]:.3g}" for channel in CHANNELS), sep=",", flush=True)


if __name__ == "__main__":
    main()
