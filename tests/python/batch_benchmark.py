"""What a batch of responses costs by the Python module, against the same batch in C++, in processor time.

    PYTHONPATH=build/release/python /usr/bin/python3 tests/python/batch_benchmark.py build/release/batch_benchmark

Runs alternate; the ratio is of the medians, both of one machine at one time.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import time

import numpy as np

import fourpost as fp

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def by_module(car, values):
    began = time.process_time()
    car.responses(values, ["k_FL"], threads=1)
    return 1e3 * (time.process_time() - began)


def by_program(program):
    out = subprocess.run([program, "--benchmark_format=json"], capture_output=True, text=True, check=True).stdout
    return json.loads(out)["benchmarks"][0]["cpu_time"]


car = fp.load(SOURCE / "urdf/landrover110_model3.urdf")
k = car.parameters.loc["k_FL"]
values = np.linspace(k["lower"], k["upper"], 500)[:, None]
pairs = [(by_module(car, values), by_program(sys.argv[1])) for _ in range(7)]
python, cpp = (statistics.median(column) for column in zip(*pairs))
print(f"500 cars: Python {python:.1f} ms, C++ {cpp:.1f} ms, ratio {python / cpp:.3f}")
