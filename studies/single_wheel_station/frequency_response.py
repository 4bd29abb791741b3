"""Frequency responses about the amplitude that a sweep has at each frequency, as `recordings` of a study.

    python3 frequency_response.py sweep_12mm.csv > frf_12mm.csv

About the time at which the sweep passes a frequency, over four cycles of it and half a second at least, each channel is
fitted (least squares) by
    y = Re{(G + G1 (t - t0)) u} + b + c (t - t0),
u: the analytic signal of the post's height, for accelerometers of its acceleration. G is the response, G1 how it changes
meanwhile. The rig's filter went over both, so that G is that of the wheel station; the post's amplitude is told with the
filter's gain taken back. Takes numpy and scipy.
"""
import sys

import numpy as np
from scipy import signal

data = np.genfromtxt(sys.argv[1], delimiter=",", names=True, skip_header=0, dtype=float, encoding=None)
data = data[1:]  # the row of units
t = data["time"]
rate = 1 / np.mean(np.diff(t))
sos = signal.butter(4, 30, fs=rate, output="sos")

height = signal.hilbert(data["z_ground"] - np.mean(data["z_ground"]))
acceleration = signal.hilbert(data["a_ground"] - np.mean(data["a_ground"]))
phase = np.unwrap(np.angle(height))
# Of a sweep the phase bends little within a second.
inst = signal.savgol_filter(phase, 251, 3, deriv=1, delta=1 / rate) / (2 * np.pi)
CHANNELS = {"z_sprung": "m", "z_unsprung": "m", "a_sprung": "m/s^2", "a_unsprung": "m/s^2", "F_tyre": "N"}

print("frequency_Hz,post_amplitude_m,channel,gain,phase_deg,unit")
for f in np.geomspace(1.3, 24, 48):
    inside = (t > 0.6) & (t < t[-1] - 0.6)
    centre = np.argmin(np.abs(inst - f) + 1e3 * ~inside)
    half = int(rate * max(0.25, 2 / f))
    part = slice(max(0, centre - half), centre + half + 1)
    s = t[part] - t[centre]
    _, h = signal.sosfreqz(sos, [f], fs=rate)
    amplitude = np.abs(height[centre]) / np.abs(h[0])
    for channel, unit in CHANNELS.items():
        u = (acceleration if channel.startswith("a_") else height)[part]
        columns = np.c_[u.real, -u.imag, s * u.real, -s * u.imag, np.ones_like(s), s]
        size = np.linalg.norm(columns, axis=0)
        x = np.linalg.lstsq(columns / size, data[channel][part], rcond=None)[0] / size
        g = x[0] + 1j * x[1]
        print(f"{f:.6g},{amplitude:.6g},{channel},{abs(g):.6g},{np.degrees(np.angle(g)):.5g},{unit}")
