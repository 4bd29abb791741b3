#!/usr/bin/env python3
"""Runs `fourpost compare ... --json` for several studies and prints the thesis's table of them as CSV, the command in
front: mean and standard deviation of cost and of evaluations. The cost is told as the normalised mean square error [%]
of the sweep, which the cost over the number of residuals is, at a model error of 5 %.

    to_csv.py build/release/fourpost RUNS SEED METHODS STUDY...
"""
import json
import pathlib
import subprocess
import sys

program, runs, seed, methods, *studies = sys.argv[1:]
print(f"# fourpost compare STUDY --methods {methods} --runs {runs} --seed {seed}")
print("study,method,runs,solved,nmse_mean_percent,nmse_sd_percent,nmse_worst_percent,evaluations_mean,evaluations_sd")
# Of the sweep, two per period of the cutoff of 30 Hz.
RESIDUALS = 2493


def percent(cost):
    return cost / RESIDUALS * 100 * 0.05**2


for study in studies:
    command = [program, "compare", study, "--methods", methods, "--runs", runs, "--seed", seed, "--json"]
    result = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
    for method in result["methods"]:
        cost, evaluations = method["cost"], method["evaluations"]
        numbers = [percent(cost["mean"]), percent(cost["sd"]), percent(method["cost_worst"]), evaluations["mean"],
                   evaluations["sd"]]
        print(",".join([pathlib.Path(study).stem, method["name"], str(method["runs"]), str(method["successes"])] +
                       [f"{number:.4g}" for number in numbers]), flush=True)
