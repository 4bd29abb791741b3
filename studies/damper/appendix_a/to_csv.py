#!/usr/bin/env python3
"""Runs `fourpost compare` on the studies that generate.py made and prints, for each bounds and method, how many runs came
below 1 % of the force's variance, and for how many evaluations.

    to_csv.py build/release/fourpost FOLDER RUNS SEED METHODS
"""
import json
import pathlib
import subprocess
import sys

program, folder, runs, seed, methods = sys.argv[1:]
print(f"# fourpost compare STUDY --methods {methods} --runs {runs} --seed {seed}, on the studies of generate.py")
print("bounds,setting,method,runs,below_1_percent,evaluations_mean,evaluations_sd,nmse_worst_percent", flush=True)
for bounds in ("original", "widened"):
    for setting in range(1, 21):
        study = pathlib.Path(folder) / f"{bounds}{setting}.yaml"
        command = [program, "compare", str(study), "--methods", methods, "--runs", runs, "--seed", seed, "--json"]
        result = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
        for method in result["methods"]:
            # The target stands for 1 %.
            worst = method["cost_worst"] / result["target_cost"]
            evaluations = method["evaluations"]
            print(f"{bounds},{setting},{method['name']},{method['runs']},{method['successes']},"
                  f"{evaluations['mean']:.4g},{evaluations['sd']:.4g},{worst:.3g}", flush=True)
