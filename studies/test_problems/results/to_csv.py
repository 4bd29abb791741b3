#!/usr/bin/env python3
"""Runs `fourpost compare ... --json` with the arguments given and prints its table as CSV, the command in front.

    to_csv.py build/release/fourpost compare studies/test_problems/gear_train.yaml --methods dvhde --runs 1000 --seed 100001
"""
import json
import subprocess
import sys

answer = subprocess.run(sys.argv[1:] + ["--json"], check=True, capture_output=True, text=True).stdout
result = json.loads(answer)
print("# fourpost " + " ".join(sys.argv[2:]))
print("method,runs,successes,share_lower,share_upper,evaluations_mean,expected_evaluations,expected_lower,expected_upper,"
      "cost_median,cost_worst" + (",seconds_mean" if "--time" in sys.argv else ""))
for method in result["methods"]:
    numbers = [method["runs"], method["successes"], *method["success_share_95"], method["evaluations_mean"],
               method["expected_evaluations"], *method["expected_evaluations_95"], method["cost_median"],
               method["cost_worst"]] + [method[key]["mean"] for key in ["seconds"] if key in method]
    print(",".join([method["name"]] + ["" if number is None else f"{number:.6g}" for number in numbers]))
