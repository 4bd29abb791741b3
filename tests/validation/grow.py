#!/usr/bin/env python3
"""Whether `fourpost fit --grow` finds its way to cars that are known, as CSV.

A vehicle with several things that the fitted one lacks, its other parameters drawn at random, answers stepped sines with
noise, and a road without noise that is held back from the fit. The fit grows from the vehicle without them. Of each case: what was
added, taken back and left out, the misfit and the error of the road before and after, and the median and the largest
error of the parameters that both vehicles have, in per cent.

  grow.py PROGRAM [--only WORD] [--keep FOLDER] > grow.csv
"""
import argparse
import csv
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import suggest


def with_series(dampers, rate):
    """Mounts of numbers, so that the vehicle has no parameter of the name that growth gives them."""
    def change(text):
        for damper in dampers:
            text = suggest.inside(text, "damper", damper, f'<series stiffness="{rate} kN/m"/>')
        return text
    return change


def struts(force, dampers=("front_damper", "rear_damper")):
    """Friction beside the dampers, as an element of its own, for these have mounts."""
    def change(text):
        for damper in dampers:
            ends = re.search(rf'<fp:damper name="{damper}" ([^>]*)>', text).group(1)
            text = suggest.at_the_end(text, f'<fp:damper name="planted_{damper}" {ends}><linear rate="0 N*s/m"/>'
                                            f'<friction force="{force} N"/></fp:damper>')
        return text
    return change


def joined(*changes):
    def change(text):
        for one in changes:
            text = one(text)
        return text
    return change


CAR = "landrover110_model1"
# name, vehicle, what the truth has, mechanisms that are right, where it is another file what the fitted vehicle has
CASES = [
    ("clean", "quarter_car", lambda text: text, set()),
    ("clean", CAR, lambda text: text, set()),
    ("friction and two rates", "quarter_car", joined(struts(40, ["damper"]), suggest.rebound_apart),
     {"friction", "bump_rebound"}, suggest.one_rate),
    ("friction and two rates", CAR, struts(120), {"friction", "bump_rebound"}, suggest.one_rate),
    ("friction behind a mount", "quarter_car",
     joined(with_series(["damper"], 150), suggest.friction("damper", 40)), {"friction", "mount", "friction_behind_mount"}),
    ("friction behind mounts", CAR,
     joined(with_series(["front_damper"], 900), with_series(["rear_damper"], 700),
            suggest.friction("front_damper", 150), suggest.friction("rear_damper", 150)), {"friction", "mount", "friction_behind_mount"}),
    ("friction and a mount", "quarter_car",
     joined(with_series(["damper"], 150), struts(40, ["damper"])), {"friction", "mount"}),
    ("friction, mounts and tyres", CAR,
     joined(with_series(["front_damper"], 900), with_series(["rear_damper"], 700), struts(150),
            suggest.tyres(["front_tyre", "rear_tyre"], 300)), {"friction", "mount", "tyre_damping"}),
    ("friction, mounts, tyres and a power unit", CAR,
     joined(with_series(["front_damper"], 900), with_series(["rear_damper"], 700), struts(150),
            suggest.tyres(["front_tyre", "rear_tyre"], 300), suggest.power_unit(0.8, 250, 11)),
     {"friction", "mount", "tyre_damping", "part_on_mounts"}),
    ("friction and a power unit", CAR, joined(suggest.power_unit(0.8, 250, 11), struts(120)),
     {"friction", "part_on_mounts"}),
    ("two parts on mounts", CAR, joined(suggest.power_unit(1.1, 250, 12), suggest.power_unit(-2.2, 150, 7, "tank")),
     {"part_on_mounts"}),
    ("digression and friction", CAR,
     joined(suggest.digression(["front_damper", "rear_damper"], 0.12, 0.4), struts(100)), {"digression", "friction"}),
]


def run(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True)


def rooted(result):
    """Root mean square error of the held-back road, in per cent."""
    errors = [channel["nmse_percent"] / 100 for channel in result["validation"]]
    return 100 * math.sqrt(sum(errors) / len(errors))


def hold_back_a_road(program, folder):
    """A class C road at 40 km/h through the truth, which record() left as truth.urdf."""
    run(program, "simulate", folder / "truth.urdf", *json.loads((folder / "truth.json").read_text()), "--road", "C",
        "--speed", "40km/h", "--duration", "20s", "--filter", "30Hz", "-o", folder / "road.csv")
    names = (folder / "road.csv").read_text().splitlines()[0].split(",")
    posts = [name[5:] for name in names if name.startswith("post_")]
    study = folder / "study.yaml"
    channels = re.search(r"channels:\n((?:  .*\n)+)", study.read_text()).group(1)
    study.write_text(study.read_text() + "histories:\n  - name: road\n    use: validation\n    file: road.csv\n"
                     "    filter: {order: 4, cutoff: 30 Hz}\n    posts: {" +
                     ", ".join(f"{post}: post_{post}" for post in posts) + "}\n    channels:\n" +
                     "".join("    " + line + "\n" for line in channels.splitlines()))


def errors_of(program, folder, result):
    """Of the parameters that the truth has as well, in per cent."""
    sets = json.loads((folder / "truth.json").read_text())
    known = json.loads(run(program, "check", folder / "truth.urdf", *sets, "--json").stdout)["parameters"]
    truth = {parameter["name"]: parameter["value"] for parameter in known}
    fitted = json.loads((folder / result).read_text())["parameters"]
    return sorted(100 * abs(p["value"] / truth[p["name"]] - 1) for p in fitted if truth.get(p["name"]))


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program")
    arguments.add_argument("--only", default="", help="cases whose name or vehicle has this")
    arguments.add_argument("--keep", help="folder for vehicles, recordings and fits")
    options = arguments.parse_args()
    out = csv.writer(sys.stdout)
    out.writerow("case,vehicle,misfit before,misfit,road before %,road %,parameters before: median %,largest %,"
                 "median %,largest %,added,not planted,taken back,end".split(","))
    for name, vehicle, planted, right, *fitted in CASES:
        if options.only not in f"{name} {vehicle}":
            continue
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(options.keep or temporary) / f"{name} {vehicle}".replace(" ", "_").replace(",", "")
            folder.mkdir(parents=True, exist_ok=True)
            suggest.four_post(options.program, folder, (name, vehicle, planted, fitted[0] if fitted else None, "", set(), []),
                              random.Random(f"{name} {vehicle}"))
            hold_back_a_road(options.program, folder)
            run(options.program, "fit", folder / "study.yaml", "-o", folder / "grown", "--grow", "--accept-implausible",
                "--accept-unidentified", "--no-suggest")
            path = json.loads((folder / "grown/steps/growth.json").read_text())
            first = json.loads((folder / "grown/steps/0/fit/result.json").read_text())
            last = json.loads((folder / "grown/result.json").read_text())
            before = errors_of(options.program, folder, "grown/steps/0/fit/result.json")
            after = errors_of(options.program, folder, "grown/result.json")
            gone = {step["takes_back"] for step in path["steps"] if step["kept"]}
            wrong = [step["added"] for step in path["steps"] if step["kept"] and step["added"] and not step["takes_back"]
                     and step["folder"] not in gone and step["mechanism"] not in right]
            out.writerow([name, vehicle, *(f"{number:.3g}" for number in (
                first["misfit"], last["misfit"], rooted(first), rooted(last), before[len(before) // 2], before[-1],
                after[len(after) // 2], after[-1])), "; ".join(path["added"]), "; ".join(wrong), "; ".join(path["taken_back"]),
                          path["end"]])
            sys.stdout.flush()


if __name__ == "__main__":
    main()
