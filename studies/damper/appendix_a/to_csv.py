#!/usr/bin/env python3
"""Runs `fourpost compare` on the studies that generate.py made and prints for each bounds, setting and method how many
runs came below 1 % of the force's variance, for how many evaluations and how much processor time, and, for runs of the
method named last that do not end there, the normalised mean square error after 100 evaluations.

    to_csv.py build/release/fourpost FOLDER RUNS SEED METHODS WHOLE > results.csv

FOLDER keeps the answer for each study and method: what is there is not run again, so that a table that was ended goes on.
"""
import json
import math
import pathlib
import subprocess
import sys

MODEL_ERROR = 0.05


def answer(program, study, method, runs, seed, more=()):
    kept = study.with_name(f"{study.stem}_{method}_{runs}_{seed}.json")
    if not kept.exists():
        command = [program, "compare", study, "--methods", method, "--runs", runs, "--seed", seed, "--threads", "1",
                   "--time", "--json", *more]
        result = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        partial = kept.with_suffix(".partial")
        partial.write_text(result)
        partial.rename(kept)
    return json.loads(kept.read_text())


def whole(program, study, method, runs, seed):
    """Mean, standard deviation and greatest error [%] of runs that go on below the target."""
    endless = study.with_name(f"{study.stem}_whole.yaml")
    endless.write_text("".join(line for line in study.open() if not line.startswith("target:")))
    one = answer(program, endless, method, runs, seed, ("--evaluations", "100"))
    errors = [100 * MODEL_ERROR**2 / one["residuals"] * cost for _, cost in one["methods"][0]["outcomes"]]
    mean = sum(errors) / len(errors)
    return mean, math.sqrt(sum((error - mean) ** 2 for error in errors) / (len(errors) - 1)), max(errors)


def main():
    program, folder, runs, seed, methods, whole_method = sys.argv[1:]
    print(f"# fourpost compare STUDY --methods METHOD --runs {runs} --seed {seed} --threads 1 --time, on the studies of "
          f"generate.py; the errors at the end with --evaluations 100, without target")
    print("bounds,setting,method,runs,below_1_percent,evaluations_mean,evaluations_sd,seconds_mean,seconds_sd,"
          "end_nmse_mean_percent,end_nmse_sd_percent,end_nmse_worst_percent", flush=True)
    for bounds in ("widened", "original"):
        for setting in range(1, 21):
            study = pathlib.Path(folder) / f"{bounds}{setting}.yaml"
            for name in methods.split(","):
                method = answer(program, study, name, runs, seed)["methods"][0]
                numbers = [method["evaluations"]["mean"], method["evaluations"]["sd"], method["seconds"]["mean"],
                           method["seconds"]["sd"]]
                errors = whole(program, study, name, runs, seed) if name == whole_method else ()
                print(",".join([bounds, str(setting), name, str(method["runs"]), str(method["successes"])] +
                               [f"{number:.4g}" for number in [*numbers, *errors]] + [""] * (3 - len(errors))), flush=True)


main()
