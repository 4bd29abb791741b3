#!/usr/bin/env python3
"""Measures other people's optimisers on a test problem, each with the best of the settings tried here.

    tune_peers.py build/release/fourpost gear_train

The program must be built with -DFOURPOST_PEERS=ON. First every setting of a grid, then around each peer's best its
spacing and its patience, on seeds from 1; the best by evaluations per success (without a success: by median cost) goes
to seeds from 100001, which nothing was chosen on. Writes peers_PROBLEM_tried.csv and peers_PROBLEM.csv beside itself.
"""
import itertools
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
COLUMNS = ["runs", "successes", "evaluations_mean", "expected_evaluations", "cost_median"]
TRIAL_RUNS = {"oscillator": 20, "gear_train": 50, "coil_spring": 30, "half_car": 8}
# Less of what takes long: scipy's loop, and runs on the half car that end by evaluations.
SCIPY_TRIAL_RUNS = {"oscillator": 20, "gear_train": 10, "coil_spring": 30, "half_car": 8}
RUNS = {"oscillator": 200, "gear_train": 100, "coil_spring": 200, "half_car": 40}
POPULATIONS = {"oscillator": [8, 12, 20], "gear_train": [12, 20, 40, 80, 160], "coil_spring": [14, 20, 40],
               "half_car": [20, 40]}
SCIPY_POPULATIONS = {"oscillator": [8, 15], "gear_train": [40, 80], "coil_spring": [14, 20, 40],
                     "half_car": [20, 40]}
# Settings tried one after the other on the best so far. Discrete parameters know no spacing.
PATIENCES = [8, 20, 150]
AFTERWARDS = {"oscillator": {"logarithmic": [1], "patience": PATIENCES}, "gear_train": {"patience": PATIENCES + [500]},
              "coil_spring": {"patience": PATIENCES}, "half_car": {"logarithmic": [1], "patience": PATIENCES}}


def grid(peer, **values):
    for choice in itertools.product(*values.values()):
        yield ":".join([peer] + [f"{key}={value}" for key, value in zip(values, choice)])


def settings(problem):
    population = POPULATIONS[problem]
    yield list(grid("pagmo_de", population=population, factor=[0.5, 0.7, 0.8], crossover=[0.9], variant=[2, 6, 7]))
    yield list(grid("pagmo_sade", population=population, variant=[2, 6, 7], adaptation=[1, 2]))
    yield list(grid("pagmo_cmaes", population=[6, 10, 20, 40], deviation=[0.2, 0.5]))
    yield list(grid("nlopt_crs2", population=[4, 8, 15, 30, 60, 120]))
    yield list(grid("nlopt_isres", population=[10, 20, 50, 100]))
    # The factor drawn from 0.5 to 1 and the crossover 0.7 are scipy's own.
    yield [name + factor for name, factor in itertools.product(
        grid("scipy_de", population=SCIPY_POPULATIONS[problem], crossover=[0.7, 0.9], variant=[1, 2]),
        [":factor_lower=0.5:factor_upper=1", ":factor_lower=0.5:factor_upper=0.5"])]


def changed(name, key, values):
    return [f"{name}:{key}={value}" for value in values]


def compare(program, study, names, runs):
    command = [program, "compare", study, "--methods", ",".join(names), "--runs", str(runs), "--seed", "1", "--json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["methods"]


def rank(method):
    expected = method["expected_evaluations"]
    return (0, expected) if expected is not None else (1, method["cost_median"])


def best(methods):
    return min(methods, key=rank)["name"]


def text(number):
    return "" if number is None else f"{number:.6g}"


def main(program, problem):
    study = f"studies/test_problems/{problem}.yaml"
    tried, chosen = [], []
    for names in settings(problem):
        runs = (SCIPY_TRIAL_RUNS if names[0].startswith("scipy") else TRIAL_RUNS)[problem]
        methods = compare(program, study, names, runs)
        for key, values in AFTERWARDS[problem].items():
            methods += compare(program, study, changed(best(methods), key, values), runs)
        tried += methods
        chosen.append(best(methods))
        print(chosen[-1], file=sys.stderr, flush=True)
    rows = [",".join([method["name"]] + [text(method[column]) for column in COLUMNS]) for method in tried]
    head = f"# tune_peers.py on {study}, seeds from 1\n" + ",".join(["method"] + COLUMNS) + "\n"
    (HERE / f"peers_{problem}_tried.csv").write_text(head + "\n".join(rows) + "\n")
    command = [sys.executable, str(HERE / "to_csv.py"), program, "compare", study, "--methods",
               ",".join(["dvhde", "direct"] + chosen), "--runs", str(RUNS[problem]), "--seed", "100001",
               "--threads", "1"]
    table = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    (HERE / f"peers_{problem}.csv").write_text(table)


main(*sys.argv[1:])
