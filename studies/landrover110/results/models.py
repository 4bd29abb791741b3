#!/usr/bin/env python3
"""Fits the studies of the Land Rover where FOLDER does not hold them yet, as they are and without their recording in pitch, and
prints as CSV how well each fits, and how well it foretells what it was not fitted to.

    results/models.py ../../build/release/fourpost FOLDER > results/models.csv        (in studies/landrover110)
"""
import json
import pathlib
import re
import subprocess
import sys

STUDIES = ("model1", "model1_time", "model1_joint", "model2", "model3", "full_one_body", "full")
GROUPS = {"body": ("a_body", "a_cross_member", "a_tow_point", "a_cg", "a_left_sill"), "axles": ("a_axle",), "struts": ("s_strut",),
          "forces": ("F_pan",), "engine": ("a_engine",)}
PITCH = "  - name: pitch\n    file: pitch_frf.csv\n    posts: pitch\n"


def answer(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def fitted(program, study, run):
    if not (run / "result.json").exists():
        # 1: done, but not converged.
        subprocess.run((program, "fit", study, "-o", run), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads((run / "result.json").read_text())


def without_pitch(study, folder):
    """A copy elsewhere; its files are told by their whole paths."""
    text = pathlib.Path(f"{study}.yaml").read_text()
    absolute = re.sub(r"(file|vehicle): (\S+)", lambda m: f"{m[1]}: {pathlib.Path(m[2]).resolve()}", text.replace(PITCH, ""))
    copy = folder / f"{study}_without_pitch.yaml"
    copy.write_text(absolute)
    return copy


def mean(channels, key, prefixes=("",)):
    values = [channel[key] for channel in channels if channel["name"].startswith(prefixes)]
    return f"{sum(values) / len(values):.3g}" if values else ""


def root_mean_square(channels, key):
    return f"{(sum(channel[key] ** 2 for channel in channels) / len(channels)) ** 0.5:.3g}"


def pitch_left_out(program, study, folder):
    """How the channels answer in pitch; None of a study over time, which names no channels of stepped sines."""
    if PITCH not in pathlib.Path(f"{study}.yaml").read_text():
        return None
    run = folder / f"{study}_without_pitch"
    fitted(program, without_pitch(study, folder), run)
    told = answer(program, "predict", run, "--recording", "pitch_frf.csv", "--mode", "pitch", "--json")
    return json.loads(told)["channels"]


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    folder.mkdir(exist_ok=True)
    print("# results/models.py ../../build/release/fourpost FOLDER, in studies/landrover110; errors of the swept sine and of",
          "pitch left out are NMSE in per cent, means over channels; dB and degrees root mean squares")
    print("study,free,residuals,misfit,evaluations,refinements_agreeing,refinements,sweep", *GROUPS,
          "pitch_dB,pitch_deg,pitch_percent", sep=",", flush=True)
    for study in STUDIES:
        result = fitted(program, f"{study}.yaml", folder / study)
        kept = result.get("validation", [])
        sweep = [channel for channel in kept + result["channels"] if channel.get("recording") == "bounce_sweep"]
        told = "foretold" if kept else "fitted"
        pitch = pitch_left_out(program, study, folder)
        starts = result["starts"]
        print(study, len(result["parameters"]), result["residuals"], f"{result['misfit']:.3g}", result["evaluations"]["paid"],
              starts["agreeing"], starts["refined"], told, *(mean(sweep, "nmse_percent", names) for names in GROUPS.values()),
              *((root_mean_square(pitch, "rms_dB"), root_mean_square(pitch, "rms_deg"), mean(pitch, "nmse_percent"))
                if pitch else ("", "", "")), sep=",", flush=True)


if __name__ == "__main__":
    main()
