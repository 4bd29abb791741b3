#!/usr/bin/env python3
"""Makes recordings of an adjustable hydraulic damper in 20 settings, and a study of each, as in the thesis's appendix A.

    generate.py FOLDER

The thesis names the damper's parts and its three fitted parameters, but prints neither its equations nor its data: both
are a reconstruction. Extension x from mid-stroke and rebound positive, tension positive, chambers r (rebound) and c:

    dP = P_r - P_c
    m' = sgn(dP) sqrt|dP| / Rm1 sqrt(|dP| / (|dP| + 2 kPa)) + max(dP, 0) / Rm2 + min(dP, 0) / Rm3,  Q = m' / rho
    P_r' = Ke / (V_r0 - A_a x) (A_a x' - Q)
    P_c' = (Q - A_p x') / ((V_c0 + A_p x) / Ke + V_g / (gamma P_c)),  V_g = V_g0 (P_g0 / P_c)^(1/gamma)
    f = P_r A_a - P_c A_p - P_g0 (A_a - A_p) + ff tanh(x' / 5 mm/s)

by Runge-Kutta steps of 50 us, no pressure below 5 kPa. Settings go from soft to hard: Rm1 from 1e4 to 4e4 Pa^0.5/(kg/s),
Rm2 from 4e6 to 2.5e7 Pa/(kg/s), both in equal ratios, Ke from 1.5e8 to 4e8 Pa in equal steps. The motion is a swept sine,
1 to 12 Hz in 3 s, of 20 mm or 0.5 m/s. What no model of the study knows: 4 % more force on the way out of a reversal than
into it, fading over 2 mm, and noise of 0.5 % of the force.

The fitted model is fourpost's own, which keeps the mass of the oil and lets vapour take room; the equations above do not.
Two studies for each setting: bounds of the thesis, and the widened ones (Rm1 to 5e5, Rm2 to 5e8, Ke to 5e9).
"""
import math
import pathlib
import random
import sys

PISTON, ROD = 0.030, 0.0125
A_P = math.pi / 4 * PISTON**2
A_A = A_P - math.pi / 4 * ROD**2
RHO, GAMMA, P_GAS, V_GAS = 860.0, 1.3, 2e6, 60e-6
V_R, V_C, RM3 = 0.1 * A_A, 0.1 * A_P, 2.597e6
FRICTION, FRICTION_SPEED = 50.0, 0.005
STEP, SAMPLE, SECONDS = 50e-6, 2e-3, 3.0
SETTINGS = 20


def parameters(setting):
    """Rm1, Rm2, Ke of setting 1 to 20."""
    share = (setting - 1) / (SETTINGS - 1)
    return 1e4 * 4**share, 4e6 * 6.25**share, 1.5e8 + 2.5e8 * share


def motion(t):
    """x, x' of a linear sweep that grows in its first 0.2 s."""
    f0, f1 = 1.0, 12.0
    phase = 2 * math.pi * (f0 * t + (f1 - f0) / (2 * SECONDS) * t * t)
    w = 2 * math.pi * (f0 + (f1 - f0) / SECONDS * t)
    amplitude = min(0.02, 0.5 / w)
    rise = 0.5 - 0.5 * math.cos(math.pi * min(1.0, t / 0.2))
    return rise * amplitude * math.sin(phase), w


def height(t):
    return motion(max(t, 0.0))[0]


def rate(t):
    h = 1e-5
    return (height(t + h) - height(t - h)) / (2 * h)


def pressure_rates(t, p_r, p_c, rm1, rm2, ke):
    x, v = height(t), rate(t)
    p_r, p_c = max(p_r, 5e3), max(p_c, 5e3)
    dp = p_r - p_c
    size = abs(dp)
    flow = math.copysign(size / math.sqrt(size + 2e3), dp) / rm1 + (dp / rm2 if dp > 0 else dp / RM3)
    q = flow / RHO
    gas = V_GAS * (P_GAS / p_c) ** (1 / GAMMA)
    return (ke / (V_R - A_A * x) * (A_A * v - q),
            (q - A_P * v) / ((V_C + A_P * x) / ke + gas / (GAMMA * p_c)))


def record(setting):
    rm1, rm2, ke = parameters(setting)
    noise = random.Random(setting)
    p_r = p_c = P_GAS
    rows = []
    reversal, last_sign = 0.0, 0.0
    per_sample = round(SAMPLE / STEP)
    for k in range(round(SECONDS / STEP)):
        t = k * STEP
        if k % per_sample == 0:
            x, v = height(t), rate(t)
            if v * last_sign < 0:
                reversal = x
            last_sign = v or last_sign
            fluid = p_r * A_A - p_c * A_P - P_GAS * (A_A - A_P) + FRICTION * math.tanh(v / FRICTION_SPEED)
            force = fluid * (1 + 0.04 * math.exp(-abs(x - reversal) / 0.002)) * (1 + noise.gauss(0, 0.005))
            rows.append((t, x, force))
        a = pressure_rates(t, p_r, p_c, rm1, rm2, ke)
        b = pressure_rates(t + STEP / 2, p_r + STEP / 2 * a[0], p_c + STEP / 2 * a[1], rm1, rm2, ke)
        c = pressure_rates(t + STEP / 2, p_r + STEP / 2 * b[0], p_c + STEP / 2 * b[1], rm1, rm2, ke)
        d = pressure_rates(t + STEP, p_r + STEP * c[0], p_c + STEP * c[1], rm1, rm2, ke)
        p_r = max(5e3, p_r + STEP / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0]))
        p_c = max(5e3, p_c + STEP / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1]))
    return rows


def bleed_area(rm1):
    """Cd A in mm^2 of an orifice, m' = Cd A sqrt(2 rho dP)."""
    return 1e6 / (rm1 * math.sqrt(2 * RHO))


VEHICLE = """<?xml version="1.0"?>
<!-- The thesis's adjustable damper (appendix A, a reconstruction) between the clamps of a bench. -->
<robot name="adjustable_damper" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="tube"/>
  <link name="rod">
    <inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="stroke" type="prismatic">
    <parent link="tube"/><child link="rod"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
    <limit lower="-0.08" upper="0.08" effort="0" velocity="0"/>
  </joint>
  <fp:parameter name="bleed" value="1.2 mm^2" lower="{0:.4g} mm^2" upper="2.412 mm^2" precision="0.0001 mm^2"
                source="1 / (Rm1 sqrt(2 rho)), Rm1 1e4 to {1:.0e}"/>
  <fp:parameter name="rebound_valve" value="10 MPa*s/kg" lower="1 MPa*s/kg" upper="{2:g} MPa*s/kg"
                precision="0.001 MPa*s/kg" source="Rm2"/>
  <fp:parameter name="bulk_modulus" value="300 MPa" lower="100 MPa" upper="{3:g} MPa" precision="0.1 MPa" source="Ke"/>
  <fp:damper name="damper" parent="tube" child="rod">
    <hydraulic bleed="$bleed" rebound_valve="$rebound_valve" bulk_modulus="$bulk_modulus"/>
    <friction force="50 N" speed="5 mm/s"/>
  </fp:damper>
</robot>
"""

# 1 % of the force's variance, at a model error of 5 %: four per residual, one for each sample.
STUDY = """vehicle: {0}.urdf
bench:
  recordings: [setting{1}.csv]
search: {{seed: 1, population: 15, generations: 150, evaluations: 2250}}
target: {2}
"""


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "original.urdf").write_text(VEHICLE.format(bleed_area(4e4), 4e4, 70, 600))
    (folder / "widened.urdf").write_text(VEHICLE.format(bleed_area(5e5), 5e5, 500, 5000))
    for setting in range(1, SETTINGS + 1):
        rows = record(setting)
        with (folder / f"setting{setting}.csv").open("w") as file:
            file.write("time,displacement,force\ns,m,N\n")
            file.writelines(f"{t:.3f},{x:.9g},{force:.7g}\n" for t, x, force in rows)
        for bounds in ("original", "widened"):
            (folder / f"{bounds}{setting}.yaml").write_text(STUDY.format(bounds, setting, 4 * len(rows)))


if __name__ == "__main__":
    main()
