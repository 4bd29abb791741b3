#!/usr/bin/env python3
"""Search methods on model3_methods.yaml (thesis, table 4.5.2), each by `fourpost compare` of its own, as CSV on stdout.
The search's cost is the sum of the squared mean square errors; the thesis tells its root J.

    methods.py build/release/fourpost RUNS SEED METHOD... > methods.csv
"""
import json
import math
import pathlib
import subprocess
import sys

program, runs, seed, *methods = sys.argv[1:]
study = pathlib.Path(__file__).parent.parent / "model3_methods.yaml"
print(f"# fourpost compare model3_methods.yaml --methods METHOD --runs {runs} --seed {seed} --json")
print("method,runs,J_median,J_worst,cost_mean,cost_sd,evaluations_mean,evaluations_sd,ended_by")


def row(method):
    cost, evaluations = method["cost"], method["evaluations"]
    numbers = [math.sqrt(method["cost_median"]), math.sqrt(method["cost_worst"]), cost["mean"], cost["sd"],
               evaluations["mean"], evaluations["sd"]]
    ends = "; ".join(f"{end} ({count})" for end, count in method["ends"].items())
    return ",".join([method["name"], str(method["runs"])] + [f"{number:.5g}" for number in numbers] + [ends])


for name in methods:
    command = [program, "compare", study, "--methods", name, "--runs", runs, "--seed", seed, "--json"]
    result = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
    for method in result["methods"]:
        print(row(method), flush=True)
