"""Makes signal_tools.csv: what scipy (1.10) makes of two signals. Run: python3 signal_tools.py > signal_tools.csv"""
import numpy as np
from scipy import signal

RATE = 500.0
N = 512


def draws(seed, count):
    """Of a linear congruential generator, uniform in -1..1."""
    out = []
    for _ in range(count):
        seed = (1664525 * seed + 1013904223) % 2**32
        out.append(2.0 * seed / 2**32 - 1.0)
    return np.array(out)


t = np.arange(N) / RATE
x = 0.4 + 0.7 * t + np.sin(2 * np.pi * 7 * t) + 0.3 * np.sin(2 * np.pi * 61 * t) + 0.2 * draws(1, N)
y = 0.5 * np.roll(x, 3) + 0.3 * draws(2, N)


def tell(name, values):
    for k, value in enumerate(np.atleast_1d(values)):
        print(f"{name},{k},{float(value)!r}")


print("quantity,index,value")
tell("x", x)
tell("y", y)
tell("causal", signal.sosfilt(signal.butter(4, 30, fs=RATE, output="sos"), x))
f, p = signal.welch(x, RATE, nperseg=128)
tell("frequency", f)
tell("density", p)
_, c = signal.csd(x, y, RATE, nperseg=128)
tell("cross_real", c.real)
tell("cross_imag", c.imag)
_, g = signal.coherence(x, y, RATE, nperseg=128)
tell("coherence", g)
tell("deviation", np.std(x))
