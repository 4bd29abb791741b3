#!/usr/bin/env python3
"""Summary of coverage.py's CSV: how many intervals hold the truth, and how wide they are beside the errors."""
import csv
import statistics
import sys


def summary(rows):
    judged = [row for row in rows if row["lower"] and row["upper"]]
    holds = sum(float(r["lower"]) <= float(r["truth"]) <= float(r["upper"]) for r in judged)
    # Shares of what is not about zero.
    sized = [r for r in judged if not r["parameter"].startswith("y_") and float(r["truth"]) > 0 and float(r["value"]) > 0]
    error = statistics.median(abs(float(r["value"]) / float(r["truth"]) - 1) for r in sized)
    width = statistics.median((float(r["upper"]) - float(r["lower"])) / float(r["value"]) for r in sized)
    return len(judged), holds, 100 * error, 100 * width


def main():
    rows = list(csv.DictReader(open(sys.argv[1], newline="")))
    print(f"{'':22}{'intervals':>10}{'hold':>8}{'%':>7}{'error %':>9}{'width %':>9}{'ratio':>7}")
    by = {}
    for row in rows:
        by.setdefault(row["model"], []).append(row)
        if len(sys.argv) > 2:
            by.setdefault(row["model"] + " " + row["parameter"], []).append(row)
    for name, part in sorted(by.items()):
        try:
            count, holds, error, width = summary(part)
        except statistics.StatisticsError:
            continue
        print(f"{name:22}{count:10}{holds:8}{100 * holds / count:7.1f}{error:9.2f}{width:9.2f}{width / error:7.2f}")


if __name__ == "__main__":
    main()
