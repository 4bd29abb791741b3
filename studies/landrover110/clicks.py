#!/usr/bin/env python3
"""Rates of the thesis's adjustable damper (appendix A, a reconstruction) at its 20 settings: clicks.csv on stdout.

At a steady speed v all oil that the piston displaces flows through it, rho A_a v = m', with the laws of
studies/damper/appendix_a/generate.py,

    m' = sqrt(dP) / Rm1 + dP / Rm,  Rm = Rm2 in rebound, Rm3 in bump,  f = A_a dP,

and the rate is f / v at 0.2 m/s.
"""
import math

PISTON, ROD, RHO, RM3, SPEED = 0.030, 0.0125, 860.0, 2.597e6, 0.2
AREA = math.pi / 4 * (PISTON**2 - ROD**2)


def rate(rm1, rm):
    """The root x = sqrt(dP) of x^2 / Rm + x / Rm1 = m'."""
    flow = RHO * AREA * SPEED
    root = 2 * flow / (1 / rm1 + math.sqrt(1 / rm1**2 + 4 * flow / rm))
    return AREA * root**2 / SPEED


print("click,bump,rebound")
print(",N*s/m,N*s/m")
for click in range(1, 21):
    share = (click - 1) / 19
    rm1, rm2 = 1e4 * 4**share, 4e6 * 6.25**share
    print(f"{click},{rate(rm1, RM3):.1f},{rate(rm1, rm2):.1f}")
