#!/usr/bin/env python3
"""How well a few time histories tell what those of all other settings would say, as a table.

  fourpost choose RUN --settings all.yaml -o all      # `shortlist` as large as the lattice
  engine_error.py all/result.json

Time histories change an objective by another factor than spectra. `fourpost choose` draws its logarithm, at settings that
were not driven, from fractional Brownian motion (identify/choice/engine_error.h). Here three neighbouring settings at
random are taken for driven, 300 times: the rms error at all others, how many errors lie within the 95 % of Student's
distribution that the draws have, and both of the settings within a third of the lattice; for this process, other
exponents, and a plane. Needs numpy.
"""
import json
import sys

import numpy as np

TRIALS, DRIVEN, NEAR = 300, 3, 0.35
# Quantile of 97.5 % of Student's distribution with n + 3 degrees.
REACH = 2.447


def differences(result, objective):
    """Positions from the present ones, as shares of each knob's, and logarithms of factors."""
    rows = [row for row in result["engines"] if row["engine"] == "histories" and row["of"] == objective]
    now = result["present"]["setting"]
    knobs = list(now)
    positions = {knob: sorted({row["setting"][knob] for row in rows} | {now[knob]}, key=float)
                 for knob in knobs}
    def place(setting):
        return [positions[knob].index(setting[knob]) / (len(positions[knob]) - 1) for knob in knobs]
    here = np.array(place(now))
    points = np.array([place(row["setting"]) for row in rows]) - here
    return points, np.array([np.log((1 + row["by_engine"]) / (1 + row["by_spectra"])) for row in rows])


def brownian(exponent):
    def covariance(a, b):
        size = lambda x: np.linalg.norm(x, axis=-1) ** (2 * exponent)
        return 0.5 * (size(a)[:, None] + size(b)[None] - size(a[:, None] - b[None]))
    return covariance


def plane(a, b):
    same = np.linalg.norm(a[:, None] - b[None], axis=-1) == 0
    return a @ b.T + 0.1 * same * np.sum(a**2, axis=1)[:, None]


def trial(points, logarithms, covariance, random):
    middle = random.integers(len(points))
    nearest = np.argsort(np.linalg.norm(points - points[middle], axis=1))[:DRIVEN + 1]
    driven = random.permutation(nearest)[:DRIVEN]
    others = np.setdiff1d(np.arange(len(points)), driven)
    inverse = np.linalg.pinv(covariance(points[driven], points[driven]))
    gain = covariance(points[others], points[driven]) @ inverse
    size = logarithms[driven] @ inverse @ logarithms[driven] / DRIVEN
    own = np.diag(covariance(points[others], points[others]))
    sd = np.sqrt(np.maximum(size * (own - np.sum(gain * covariance(points[others], points[driven]), axis=1)), 1e-18))
    error = logarithms[others] - gain @ logarithms[driven]
    return error, np.abs(error) < REACH * sd, np.linalg.norm(points[others] - points[middle], axis=1) < NEAR


def main():
    result = json.loads(open(sys.argv[1]).read())
    kinds = {"0.5": brownian(0.5), "0.75": brownian(0.75), "0.9": brownian(0.9), "plane": plane}
    print("objective,process,rms_error_percent,within_percent,near_rms_error_percent,near_within_percent")
    for objective in dict.fromkeys(row["of"] for row in result["engines"]):
        points, logarithms = differences(result, objective)
        moved = np.linalg.norm(points, axis=1) > 0
        points, logarithms = points[moved], logarithms[moved]
        for name, covariance in kinds.items():
            random = np.random.default_rng(1)
            error, held, near = (np.concatenate(part) for part in zip(
                *(trial(points, logarithms, covariance, random) for _ in range(TRIALS))))
            rms = lambda x: 100 * np.sqrt(np.mean(x**2))
            print(f"{objective},{name},{rms(error):.2f},{100 * held.mean():.0f},{rms(error[near]):.2f},"
                  f"{100 * held[near].mean():.0f}")


if __name__ == "__main__":
    main()
