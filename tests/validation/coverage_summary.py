#!/usr/bin/env python3
"""Summary of CSVs of coverage.py and coverage_over_time.py: how many intervals hold the truth, and how wide they are.

  coverage_summary.py FILE [COLUMN ...]     by model, or by these columns, one after the other
"""
import csv
import statistics
import sys


def summary(rows):
    """Count, those that hold the truth, median error and median width in per cent; of what is not about zero."""
    holds = sum(float(r["lower"]) <= float(r["truth"]) <= float(r["upper"]) for r in rows)
    sized = [r for r in rows if not r["parameter"].startswith("y_") and float(r["truth"]) > 0 and float(r["value"]) > 0]
    error = statistics.median(abs(float(r["value"]) / float(r["truth"]) - 1) for r in sized)
    width = statistics.median((float(r["upper"]) - float(r["lower"])) / float(r["value"]) for r in sized)
    return len(rows), holds, 100 * error, 100 * width


def main():
    rows = [r for r in csv.DictReader(line for line in open(sys.argv[1], newline="") if not line.startswith("#"))
            if r["lower"] and r["upper"]]
    print(f"{'':22}{'intervals':>10}{'hold':>8}{'%':>7}{'error %':>9}{'width %':>9}{'ratio':>7}")
    for column in sys.argv[2:] or ["model"]:
        by = {}
        for row in rows:
            by.setdefault(row[column], []).append(row)
        for name, part in sorted(by.items()):
            try:
                count, holds, error, width = summary(part)
            except statistics.StatisticsError:
                continue
            print(f"{name:22}{count:10}{holds:8}{100 * holds / count:7.1f}{error:9.2f}{width:9.2f}{width / error:7.2f}")


if __name__ == "__main__":
    main()
