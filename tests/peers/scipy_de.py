#!/usr/bin/env python3
"""Minimises on the unit cube by scipy's differential_evolution a cost that whoever started it computes.

stdin:  SIZE SEED POPULATION FACTOR_LOWER FACTOR_UPPER CROSSOVER VARIANT   starts a search
stdout: X1 X2 ...                                                          asks for the cost there
stdin:  the cost, or `leave`, which abandons the search
stdout: end                                                                after a search that was not abandoned

Numbers are hexadecimal, so that none is rounded.
"""
import signal
import sys

import numpy
from scipy.optimize import differential_evolution
from scipy.stats import qmc

VARIANTS = ["best1bin", "rand1bin", "best1exp", "rand1exp", "currenttobest1bin", "randtobest1bin"]


class Leave(Exception):
    pass


def say(line):
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def cost(point):
    say(" ".join(float(x).hex() for x in point))
    answer = sys.stdin.readline().strip()
    if answer in ("", "leave"):
        raise Leave
    return float.fromhex(answer)


def minimise(size, seed, population, factor_lower, factor_upper, crossover, variant):
    # The population's size itself, which scipy otherwise wants as a multiple of the number of parameters.
    start = qmc.LatinHypercube(int(size), seed=int(seed)).random(int(population))
    differential_evolution(cost, [(0, 1)] * int(size), strategy=VARIANTS[int(variant) - 1], init=start,
                           mutation=(factor_lower, factor_upper), recombination=crossover, maxiter=10**9, tol=0, atol=0,
                           polish=False, seed=numpy.random.default_rng(int(seed)))


# Whoever started it ends it.
signal.signal(signal.SIGINT, signal.SIG_IGN)
for request in iter(sys.stdin.readline, ""):
    try:
        minimise(*map(float, request.split()))
        say("end")
    except Leave:
        pass
