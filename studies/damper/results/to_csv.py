#!/usr/bin/env python3
"""Runs `fourpost compare` for several studies and methods and prints the thesis's table of them as CSV, the command in
front: mean and standard deviation of cost, evaluations and processor time.

    to_csv.py build/release/fourpost FOLDER RUNS SEED METHODS STUDY=EVALUATIONS... > comparison.csv

Every run may pay for so many evaluations. FOLDER keeps the answer for each study and method: what is there is not run
again, so that a table that was ended goes on. Costs are told as the normalised mean square error [%] of the sweep, which
the cost over the number of residuals is, times the model error of 5 % squared. A run has solved its study when it comes
within 1 % of the best cost of its method, which a message tells where another method finds better; its evaluations and its
time are those up to there, else all of them.
"""
import json
import math
import pathlib
import subprocess
import sys

MODEL_ERROR = 0.05


def answer(program, folder, study, method, runs, seed, evaluations):
    kept = folder / f"{study.stem}_{method}_{runs}_{seed}_{evaluations}.json"
    if not kept.exists():
        command = [program, "compare", study, "--methods", method, "--runs", runs, "--seed", seed, "--evaluations",
                   evaluations, "--threads", "1", "--time", "--json"]
        result = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        partial = kept.with_suffix(".partial")
        partial.write_text(result)
        partial.rename(kept)
    return json.loads(kept.read_text())


def mean_sd(values):
    mean = sum(values) / len(values)
    return mean, math.sqrt(sum((value - mean) ** 2 for value in values) / (len(values) - 1))


def main():
    program, folder, runs, seed, methods, *studies = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    print(f"# fourpost compare STUDY --methods METHOD --runs {runs} --seed {seed} --evaluations BUDGET --threads 1 --time")
    print("study,method,runs,budget,solved,nmse_mean_percent,nmse_sd_percent,nmse_worst_percent,"
          "evaluations_mean,evaluations_sd,seconds_mean,seconds_sd", flush=True)
    for argument in studies:
        study, evaluations = argument.split("=")
        study = pathlib.Path(study)
        answers = [answer(program, folder, study, method, runs, seed, evaluations) for method in methods.split(",")]
        # Each method's own target is 1 % above its own best.
        targets = [one["target_cost"] for one in answers]
        for one, target in zip(answers, targets):
            if target > 1.001 * min(targets):
                print(f"{study.stem}: {one['methods'][0]['name']} never finds the optimum; its 'solved' is of its own best",
                      file=sys.stderr)
            method = one["methods"][0]
            percent = 100 * MODEL_ERROR**2 / one["residuals"]
            costs = [percent * cost for _, cost in method["outcomes"]]
            numbers = [*mean_sd(costs), max(costs), method["evaluations"]["mean"], method["evaluations"]["sd"],
                       method["seconds"]["mean"], method["seconds"]["sd"]]
            print(",".join([study.stem, method["name"], str(method["runs"]), evaluations, str(method["successes"])] +
                           [f"{number:.4g}" for number in numbers]), flush=True)


main()
