#!/usr/bin/env python3
"""Fits every model of a damper from ten starts, the file's values and nine points of the search, and prints as CSV how they
ended: the normalised mean square error of the sweep [%], how many refinements agree with the best, evaluations, and
processor time [s] from the file to the folder of results.

    results/starts.py ../../build/release/fourpost > results/starts.csv        (in studies/damper)
"""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

MODELS = ("model1", "model2", "model3", "model4", "model5", "friction_knees")


def children_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    print("# results/starts.py ../../build/release/fourpost, in studies/damper")
    print("study,starts,agree,nmse_percent,evaluations,seconds", flush=True)
    for model in MODELS:
        # Beside its files, which it names relative to itself.
        with tempfile.NamedTemporaryFile("w", dir=".", suffix=".yaml") as study, tempfile.TemporaryDirectory() as run:
            text = pathlib.Path(f"{model}.yaml").read_text()
            assert text.count("search: {seed: 1") == 1, model
            study.write(text.replace("search: {seed: 1", "search: {starts: 9, seed: 1"))
            study.flush()
            before = children_s()
            subprocess.run([program, "fit", study.name, "-o", run, "--threads", "1"], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            seconds = children_s() - before
            result = json.loads((pathlib.Path(run) / "result.json").read_text())
        print(model, result["starts"]["asked"] + 1, result["starts"]["agreeing"],
              f"{result['channels'][0]['nmse_percent']:.4g}", result["evaluations"]["paid"], f"{seconds:.3g}", sep=",",
              flush=True)


if __name__ == "__main__":
    main()
