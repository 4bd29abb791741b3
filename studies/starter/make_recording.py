"""Makes stepped_sine.csv: `make_recording.py PATH/TO/fourpost > stepped_sine.csv`, here.

The response of vehicle.urdf with other parameters, which a fit should find again, and noise of a seed.
"""
import csv
import io
import pathlib
import random
import subprocess
import sys
import tempfile

TRUTH = {"m_body": "335kg", "m_wheel": "46kg", "k": "24kN/m", "kt": "230kN/m", "c_bump": "1100N*s/m",
         "c_rebound": "2300N*s/m"}
GAIN_SD, PHASE_SD_DEG, MEAN_SD_M = 0.01, 0.6, 5e-5

with tempfile.TemporaryDirectory() as folder:
    settings = [word for name, value in TRUTH.items() for word in ("--set", f"{name}={value}")]
    subprocess.run([sys.argv[1], "response", "vehicle.urdf", "--frequencies", "0.5Hz:20Hz:30", "-o", f"{folder}/truth",
                    *settings], check=True, stdout=subprocess.DEVNULL)
    rows = list(csv.DictReader(io.StringIO(pathlib.Path(folder, "truth/response.csv").read_text())))

noise = random.Random(1)
print("frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,unit")
# As a rig steps: all channels of one frequency together.
for row in sorted(rows, key=lambda row: float(row["frequency_Hz"])):
    gain = float(row["gain"])
    told = gain * (1 + noise.gauss(0, GAIN_SD))
    phase = float(row["phase_deg"]) + noise.gauss(0, PHASE_SD_DEG)
    mean = f"{float(row['mean']) + noise.gauss(0, MEAN_SD_M):.6f}" if row["unit"] == "m" else ""
    print(f"{float(row['frequency_Hz']):.4g},{float(row['post_amplitude_m']):.5g},{row['channel']},{told:.6g},"
          f"{phase:.5g},{GAIN_SD * gain:.3g},{PHASE_SD_DEG},{mean},{row['unit']}")
