#!/usr/bin/env python3
"""Processor seconds of each command on shipped vehicles and studies, with one thread, as CSV.

Machines differ and are busy: the last column is the time over that of `check` of the quarter car in the same run, of
which the median of five is taken; the others run once.

  waiting_times.py PROGRAM > tests/benchmarks/results/waiting_times.csv
"""
import argparse
import csv
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]

# What is run, in the order in which runs are needed; {o} is a folder for results, {s} and {u} studies and vehicles.
COMMANDS = [
    ("check, quarter car", "check {u}/quarter_car.urdf"),
    ("check, Land Rover with its links", "check {u}/landrover110.urdf"),
    ("modes, Land Rover with its links", "modes {u}/landrover110.urdf"),
    ("response, Land Rover with its links, 64 frequencies", "response {u}/landrover110.urdf --mode heave "
     "--frequencies 0.5Hz:30Hz:64 --amplitude 5mm -o {o}/response"),
    ("kinematics, roadster", "kinematics {u}/independent_roadster.urdf -o {o}/kinematics"),
    ("simulate, Land Rover with its links, 10 s of a sweep", "simulate {u}/landrover110.urdf --mode heave "
     "--sweep 0.5Hz:15Hz --amplitude 3mm --duration 10s -o {o}/simulated"),
    ("ride, Land Rover with its links, 60 s of road C", "ride {u}/landrover110.urdf --road C --speed 60km/h"),
    ("info, a study", "info {s}/landrover110/model2.yaml"),
    ("fit, damper Model 3", "fit {s}/damper/model3.yaml -o {o}/damper3"),
    ("fit, damper Model 5", "fit {s}/damper/model5.yaml -o {o}/damper5"),
    ("fit, station Model 2, over time", "fit {s}/single_wheel_station/model2.yaml -o {o}/station2"),
    ("fit, station Model 4, over time", "fit {s}/single_wheel_station/model4.yaml -o {o}/station4"),
    ("fit, Land Rover Model 1", "fit {s}/landrover110/model1.yaml -o {o}/model1"),
    ("fit, Land Rover Model 1, over time", "fit {s}/landrover110/model1_time.yaml -o {o}/model1_time"),
    ("fit, Land Rover Model 2", "fit {s}/landrover110/model2.yaml -o {o}/model2"),
    ("fit, Land Rover Model 3", "fit {s}/landrover110/model3.yaml -o {o}/model3"),
    ("fit, full Land Rover", "fit {s}/landrover110/full.yaml -o {o}/full"),
    ("fit, full Land Rover, --no-suggest", "fit {s}/landrover110/full.yaml --no-suggest -o {o}/full_alone"),
    ("predict, Land Rover Model 2, a sweep", "predict {o}/model2 "
     "--recording {s}/landrover110/bounce_sweep.csv -o {o}/predicted"),
    ("draws, Land Rover Model 2, 200", "draws {o}/model2 -n 200"),
    ("choose, Land Rover Model 2, 400 settings", "choose {o}/model2 --settings {s}/landrover110/settings.yaml "
     "-o {o}/choice"),
    ("plan, Land Rover Model 2", "plan {o}/model2 --time 20min -o {o}/plan"),
    ("report, Land Rover Model 2", "report {o}/model2"),
]


def seconds(program, line, folder):
    """Of the processor; and whether the command did its work."""
    words = line.format(o=folder, s=SOURCE / "studies", u=SOURCE / "urdf").split()
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    threads = ["--threads", "1"] if words[0] in ("fit", "choose", "plan") else []
    done = subprocess.run([program, *words, *threads], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    # A poor fit ends with 1, and is one all the same.
    if done.returncode not in ((0, 1) if words[0] == "fit" else (0,)):
        sys.stderr.write(done.stderr)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    options = parser.parse_args()
    program = str(Path(options.program).resolve())
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["work", "processor_s", "status", "over_check"])
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        unit = statistics.median(seconds(program, COMMANDS[0][1], folder)[0] for _ in range(5))
        for name, line in COMMANDS:
            taken, status = seconds(program, line, folder)
            writer.writerow([name, f"{taken:.2f}", status, f"{taken / unit:.1f}"])
            sys.stdout.flush()
            failed = failed or status not in (0, 1)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
