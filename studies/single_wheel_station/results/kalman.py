#!/usr/bin/env python3
"""Mean square errors with and without a Kalman filter (thesis, table 4.5.3) of Models 1 (the filter is linear) and 3 (it
is the extended one), each fitted by simulation and by prediction, as CSV on stdout. The filter's noise comes from the
12 mm sweep for both recordings.

    kalman.py build/release/fourpost FOLDER_FOR_RUNS > kalman.csv
"""
import json
import pathlib
import subprocess
import sys

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
here = pathlib.Path(__file__).parent.parent
print("# kalman.py build/release/fourpost FOLDER_FOR_RUNS")
print("model,filter,fitted_by,recording,channel,simulated_nmse_percent,one_step_nmse_percent,"
      "innovation_correlation,innovations_beyond_percent")
for model, kind in (("model1", "linear"), ("model3", "extended")):
    for study, by in ((model, "simulation"), (model + "_kalman", "prediction")):
        run = folder / study
        if not (run / "result.json").exists():
            subprocess.run([program, "fit", here / (study + ".yaml"), "-o", run], check=True, stdout=subprocess.DEVNULL)
        for recording in ("sweep_12mm", "sweep_7mm"):
            command = [program, "predict", run, "--recording", here / (recording + ".csv"), "--kalman", "--json"]
            if by == "simulation":
                command += ["--noise-from", here / "sweep_12mm.csv"]
            result = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
            for channel in result["channels"]:
                numbers = [channel["nmse_percent"], channel["one_step_nmse_percent"],
                           channel["innovation_correlation"], 100 * channel["innovations_beyond"]]
                print(",".join([model, kind, by, recording, channel["name"]] + [f"{n:.3g}" for n in numbers]),
                      flush=True)
