#!/usr/bin/env python3
"""Fits every model of a damper where FOLDER does not hold it yet, and prints as CSV what `fourpost rank` tells of them:
normalised mean square errors [%] of the sweep and, as their mean, of the fifteen sines not fitted, AICc and BIC.

    results/models.py ../../build/release/fourpost FOLDER > results/models.csv        (in studies/damper)
"""
import json
import pathlib
import subprocess
import sys

MODELS = ("model1", "model2", "model3", "model4", "model5", "friction_knees")


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    for model in MODELS:
        if not (folder / model / "result.json").exists():
            subprocess.run([program, "fit", f"{model}.yaml", "-o", folder / model], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    told = subprocess.run([program, "rank", "--json", *(folder / model for model in MODELS)], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    print("# results/models.py ../../build/release/fourpost FOLDER, in studies/damper: in the order of fourpost rank")
    print("model,parameters,sweep_percent,sines_percent,aicc,bic")
    for model in json.loads(told)["models"]:
        print(model["name"], model["parameters"], f"{model['fitted_nmse_percent']:.4g}",
              f"{model['validation_nmse_percent']:.3g}", f"{model['aicc']:.6g}", f"{model['bic']:.6g}", sep=",")


if __name__ == "__main__":
    main()
