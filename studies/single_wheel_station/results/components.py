#!/usr/bin/env python3
"""Estimated against component values (thesis, table 4.5.4): parameters.csv of fits, whose start is what components.csv
says, side by side as CSV on stdout.

    components.py RUN... > components.csv
"""
import csv
import pathlib
import sys

print("# components.py RUN... of `fourpost fit STUDY -o RUN`")
print("study,parameter,unit,component,estimated,difference_percent,lower_95,upper_95")
for run in map(pathlib.Path, sys.argv[1:]):
    with open(run / "parameters.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["source_of_start"] != "components.csv":
                continue
            number = lambda key, digits: f"{float(row[key]):.{digits}g}" if row[key] else ""
            print(",".join([run.name, row["parameter"], row["unit"], number("start", 5), number("fitted", 5),
                            number("difference_percent", 3), number("lower_95", 5), number("upper_95", 5)]))
