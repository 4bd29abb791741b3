#!/usr/bin/env python3
"""Whether `fourpost suggest` names what was planted, and keeps silent about twins that lack nothing, as CSV.

Vehicles with one defect, their other parameters drawn at random, answer stepped sines with noise; a damper with gas
answers sines on a bench by its law, written out here. The vehicle without the defect is fitted, and the place of the
defect in the list is what counts.

  suggest.py PROGRAM --seeds 1 --clean 20 > suggest.csv
"""
import argparse
import csv
import io
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
FREQUENCIES = "0.5Hz:18Hz:32"
GAIN_SD, PHASE_SD_DEG, FLOOR = 0.005, 0.3, 0.002
MODES = {"quarter_car": ["heave"], "landrover110_model1": ["heave", "pitch"],
         "landrover110_model3": ["heave", "pitch", "roll", "warp"], "landrover110_rigid": ["heave", "roll", "warp"],
         "landrover110": ["heave", "pitch", "roll"]}
SERIES = {"quarter_car": ("200 kN/m", ["damper"]), "landrover110_model1": ("1600 kN/m", ["front_damper"])}


def inside(text, tag, name, xml):
    """Adds a child to an element."""
    return re.sub(rf'(<fp:{tag} name="{name}"[^>]*>)', lambda m: m.group(1) + xml, text, count=1)


def at_the_end(text, xml):
    return text.replace("</robot>", xml + "\n</robot>")


def friction(damper, force):
    return lambda text: inside(text, "damper", damper, f'<friction force="{force} N" speed="2 mm/s"/>')


def stop(ends, gap, rate):
    return lambda text: at_the_end(text, f'<fp:stop name="planted" {ends}><bump gap="{gap} mm" stiffness="{rate} kN/m"/>'
                                         "</fp:stop>")


def mount(vehicle, cubic=None):
    """A mount that the fitted vehicle has as well; in truth it may harden."""
    rate, dampers = SERIES[vehicle]
    def change(text):
        for damper in dampers:
            text = inside(text, "damper", damper, f'<series stiffness="$k_series"{cubic or ""}/>')
        least, most = (f"{float(rate.split()[0]) * factor} kN/m" for factor in (0.2, 5))
        return at_the_end(text, f'<fp:parameter name="k_series" value="{rate}" lower="{least}" upper="{most}" '
                                f'precision="1 kN/m" source="of the test"/>')
    return change


def tyres(names, damping):
    def change(text):
        for name in names:
            text = re.sub(rf'(<fp:tyre name="{name}")', rf'\1 damping="{damping} N*s/m"', text)
        return text
    return change


def bar(front, rate):
    ends = [f'parent="coil_top_{front}{side}" child="coil_foot_{front}{side}"' for side in "LR"]
    return lambda text: at_the_end(text, f'<fp:antiroll name="planted" stiffness="{rate} kN/m"><left {ends[0]}/>'
                                         f"<right {ends[1]}/></fp:antiroll>")


def weak(damper, share, mirrored_from=None):
    """One damper with a share of the rates of the other side."""
    def change(text):
        element = re.search(rf'<fp:damper name="{mirrored_from or damper}".*?</fp:damper>', text, re.S).group()
        scaled = re.sub(r'="\$', f'="{share}*$', element)
        if not mirrored_from:
            return text.replace(element, scaled)
        return at_the_end(text, scaled.replace("_FL", "_FR").replace("_RL", "_RR"))
    return change


def power_unit(x, mass, frequency, name="unit"):
    rate = mass * (2 * math.pi * frequency) ** 2
    return lambda text: at_the_end(text, f'''<link name="{name}"><inertial><mass value="{mass}"/>
<inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="{name}_travel" type="prismatic"><parent link="chassis"/><child link="{name}"/><origin xyz="{x} 0 0"/>
<axis xyz="0 0 1"/><limit lower="-0.1" upper="0.1" effort="0" velocity="0"/></joint>
<fp:spring name="{name}_mount" parent="chassis" child="{name}" axis="0 0 1"><linear stiffness="{rate} N/m"/></fp:spring>
<fp:damper name="{name}_damping" parent="chassis" child="{name}" axis="0 0 1">
<linear rate="{0.15 * math.sqrt(rate * mass)} N*s/m"/></fp:damper>''')


def digression(dampers, knee, share):
    def change(text):
        for damper in dampers:
            element = re.search(rf'<fp:damper name="{damper}".*?</fp:damper>', text, re.S).group()
            bump, rebound = re.search(r'bump="([^"]*)" rebound="([^"]*)"', element).groups()
            beyond = [f"{share * float(rate[:-1] if rate.endswith('*') else rate)}*" for rate in
                      (text.split("$")[0] or "1" for text in (bump, rebound))]
            law = (f'<digressive bump="{bump}" rebound="{rebound}" bump_knee="{knee} m/s" rebound_knee="{knee} m/s" '
                   f'bump_beyond="{beyond[0]}${bump.split("$")[1]}" rebound_beyond="{beyond[1]}${rebound.split("$")[1]}"/>')
            text = text.replace(element, re.sub(r"<bilinear [^>]*/>", law, element))
        return text
    return change


def one_rate(text):
    """The first damper with the rate of bump in both directions."""
    name, law, bump, rebound = re.search(r'<fp:damper name="(\w+)"[^>]*>\s*(<bilinear bump="([^"]*)" rebound="[^$"]*\$(\w+)"/>)',
                                         text).groups()
    text = text.replace(law, f'<linear rate="{bump}"/>', 1)
    return re.sub(rf'<fp:parameter name="{rebound}"[^>]*/>', "", text)


def rebound_apart(text):
    """Rebound harder than bump, as the Land Rover's is."""
    return re.sub(r'(name="c_rebound" value=)"1500', r'\1"2600', text)


def lifting(is_true):
    """A tyre lifts off unless the file says otherwise."""
    return lambda text: text if is_true else re.sub(r"(<fp:tyre )", r'\1liftoff="false" ', text)


def soft_joint(tag, name, law, elastic):
    return lambda text: re.sub(rf'<fp:{tag} name="{name}" ([^>]*)/>', rf"<fp:{elastic} \1 " + f'name="{name}">' + law +
                               f"</fp:{elastic}>", text)


HARD = ["--amplitude", "40mm", "--velocity", "0.6m/s", "--acceleration", "18m/s^2"]
HARDER = ["--amplitude", "60mm", "--velocity", "1m/s", "--acceleration", "40m/s^2"]
STRUT = 'parent="strut_top" child="strut_bottom" axis="0 0 1"'

# name: vehicle, what the truth has, what the fitted vehicle has, mechanism, elements any of which is right, options
CASES = [
    ("friction", "quarter_car", friction("damper", 40), None, "friction", {"damper"}, []),
    ("friction", "landrover110_model3", friction("damper_FL", 120), None, "friction", {"damper_FL"}, []),
    ("stop", "quarter_car", stop(STRUT, 12, 60), None, "bump_stop", {"spring"}, []),
    ("stop", "landrover110_model1", stop('parent="front_top" child="front_centre"', 12, 400), None, "bump_stop",
     {"front_coil"}, []),
    ("mount_cubic", "quarter_car", mount("quarter_car", ' cubic="800 N/mm^3"'), mount("quarter_car"), "mount_cubic",
     {"damper"}, []),
    ("mount_cubic", "landrover110_model1", mount("landrover110_model1", ' cubic="1000 kN/mm^3"'),
     mount("landrover110_model1"), "mount_cubic", {"front_damper"}, []),
    ("lag", "quarter_car", "lag", None, "delay", {"all channels"}, []),
    ("lag", "landrover110_model1", "lag", None, "delay", {"all channels"}, []),
    ("tyre_damping", "quarter_car", tyres(["tyre"], 150), None, "tyre_damping", {"tyre"}, []),
    ("tyre_damping", "landrover110_model3", tyres(["tyre_FL", "tyre_FR"], 300), None, "tyre_damping",
     {"tyre_FL", "tyre_FR"}, []),
    ("bar", "landrover110_model3", bar("F", 12), None, "antiroll", {"coil_FL", "coil_FR"}, []),
    ("bar", "landrover110_rigid", bar("R", 12), None, "antiroll", {"coil_RL", "coil_RR"}, []),
    ("weak_damper", "landrover110_model3", weak("damper_FL", 0.7), None, "own_damper", {"damper_FL", "damper_FR"}, []),
    ("weak_damper", "landrover110_rigid", weak("damper_FR", 0.7, "damper_FL"), None, "own_damper",
     {"damper_FL", "damper_FR"}, []),
    ("power_unit", "landrover110_model1", power_unit(1.4, 250, 8.5), None, "part_on_mounts", {"chassis"}, []),
    ("power_unit", "landrover110_model3", power_unit(1.3, 300, 11), None, "part_on_mounts", {"chassis"}, []),
    ("digression", "quarter_car", digression(["damper"], 0.12, 0.5), None, "digression", {"damper"}, []),
    ("digression", "landrover110_model3", digression(["damper_RL", "damper_RR"], 0.1, 0.5), None, "digression",
     {"damper_RL", "damper_RR"}, []),
    ("bump_rebound", "quarter_car", rebound_apart, one_rate, "bump_rebound", {"damper"}, []),
    ("bump_rebound", "landrover110_model1", lambda text: text, one_rate, "bump_rebound", {"front_damper"}, []),
    ("liftoff", "quarter_car", lifting(True), lifting(False), "liftoff", {"tyre"}, HARDER),
    ("liftoff", "landrover110_model1", lifting(True), lifting(False), "liftoff", {"front_tyre", "rear_tyre"}, HARD),
    ("bush", "landrover110_rigid", soft_joint("rod", "panhard", '<linear stiffness="1500 kN/m"/>', "spring"), None, "bush",
     {"panhard"}, []),
    ("bush", "landrover110", "k_arm_lift", None, "free", {"k_arm_lift"}, []),
    ("gas", "bilinear damper", 150, None, "gas", {"damper"}, []),
    ("gas", "linear damper", 80, None, "gas", {"damper"}, []),
]


def run(*arguments):
    outcome = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    if outcome.returncode not in (0, 1):
        raise RuntimeError(outcome.stderr[-1500:])
    return outcome.stdout


def vehicle_text(vehicle):
    return (SOURCE / "urdf" / f"{vehicle}.urdf").read_text().replace("../meshes/", f"{SOURCE}/meshes/")


def record(program, folder, truth, vehicle, draw, options, held, lag_s):
    """Stepped sines of the true vehicle as a rig writes them; returns the channels."""
    (folder / "truth.urdf").write_text(truth)
    sets = []
    for parameter in json.loads(run(program, "params", folder / "truth.urdf", "--json"))["parameters"]:
        if parameter.get("lower") is None or parameter["name"] in held or parameter["value"] == 0:
            continue
        # Between the bounds, which a digressive law's rates keep as well.
        value = parameter["value"] * math.exp(draw.uniform(-0.12, 0.12))
        value = min(max(value, parameter["lower"]), parameter["upper"])
        sets += ["--set", f"{parameter['name']}={value}{parameter['unit'] if parameter['unit'] != '1' else ''}"]
    sets += [word for name, value in held.items() for word in ("--set", f"{name}={value}")]
    (folder / "truth.json").write_text(json.dumps(sets))
    modes = [word for mode in MODES[vehicle] for word in ("--mode", mode)]
    run(program, "response", folder / "truth.urdf", *modes, "--frequencies", FREQUENCIES, "--engine", "reduced", *sets,
        *options, "-o", folder / "truth")
    rows = list(csv.DictReader(io.StringIO((folder / "truth" / "response.csv").read_text())))
    rows = [row for row in rows if row["gain"] and not row["channel"].startswith(("F_pan", "z_"))]
    loudest = {}
    for row in rows:
        key = (row["mode"], row["unit"], row["frequency_Hz"])
        loudest[key] = max(loudest.get(key, 0), float(row["gain"]))
    for mode in MODES[vehicle]:
        with open(folder / f"{mode}.csv", "w", newline="") as file:
            out = csv.writer(file)
            out.writerow("frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,second_harmonic,unit"
                         .split(","))
            for row in (row for row in rows if row["mode"] == mode):
                gain, frequency = float(row["gain"]), float(row["frequency_Hz"])
                sd = math.hypot(GAIN_SD * gain, FLOOR * loudest[(mode, row["unit"], row["frequency_Hz"])])
                seen = complex(draw.gauss(gain, sd), draw.gauss(0, sd))
                strut = row["channel"].startswith("s_")
                out.writerow([frequency, row["post_amplitude_m"], row["channel"], abs(seen),
                              float(row["phase_deg"]) + math.degrees(math.atan2(seen.imag, seen.real)) -
                              360 * frequency * lag_s, sd, math.degrees(sd / max(gain, 1e-12)),
                              float(row["mean"]) + draw.gauss(0, 3e-5) if strut else "",
                              abs(float(row["second_harmonic"]) + draw.gauss(0, 5e-6)) if strut else "", row["unit"]])
    return list(dict.fromkeys(row["channel"] for row in rows))


def four_post(program, folder, case, draw):
    _, vehicle, planted, fitted, _, _, options = case
    text = vehicle_text(vehicle)
    held = {"k_arm_lift": "70kN/m"} if planted == "k_arm_lift" else {}
    lag = 0.004 if planted == "lag" else 0
    truth = planted(text) if callable(planted) else text
    channels = record(program, folder, truth, vehicle, draw, options, held, lag)
    (folder / "vehicle.urdf").write_text(fitted(text) if fitted else text)
    free = ""
    if held:
        # As Model 3 has them.
        free = "free: [m_body, I_roll, I_pitch, m_front, I_front_roll, m_rear, I_rear_roll, k_FL, k_FR, k_RL, k_RR, kt_FL, " \
               "kt_FR, kt_RL, kt_RR, c_front_bump, c_front_rebound, c_rear_bump, c_rear_rebound, y_body]\n"
    (folder / "study.yaml").write_text(
        "vehicle: vehicle.urdf\nrecordings:\n" +
        "".join(f"  - {{name: {mode}, file: {mode}.csv, posts: {mode}}}\n" for mode in MODES[vehicle]) +
        "channels:\n" + "".join(f"  {name}: {name}\n" for name in channels) + free +
        "band: [0.5 Hz, 18 Hz]\n"
        "model_error: {gain_dB: 0.02, phase: 0.1 deg, floor: 0.001, mean: 0.02 mm, second_harmonic: 0.005 mm}\n"
        "search: {seed: 1, evaluations: 40, starts: 1}\n")


def bench(folder, case, draw):
    _, kind, gas, *_ = case
    bump, rebound = (1400, 1400) if kind.startswith("linear") else (900, 2300)
    text = (SOURCE / "studies" / "damper" / ("model1.urdf" if kind.startswith("linear") else "model2.urdf")).read_text()
    (folder / "vehicle.urdf").write_text(text)
    rate, names = 500, []
    for frequency, amplitude in ((1, 0.02), (3, 0.01), (8, 0.004)):
        names.append(f"sine_{frequency}Hz.csv")
        with open(folder / names[-1], "w", newline="") as file:
            out = csv.writer(file)
            out.writerow(["time", "displacement", "force"])
            out.writerow(["s", "m", "N"])
            omega = 2 * math.pi * frequency
            for i in range(int(6 / frequency * rate) + 1):
                t = i / rate
                speed = amplitude * omega * math.cos(omega * t)
                force = (rebound if speed > 0 else bump) * speed - gas
                out.writerow([t, amplitude * math.sin(omega * t) + draw.gauss(0, 1e-6), force + draw.gauss(0, 4)])
    (folder / "study.yaml").write_text("vehicle: vehicle.urdf\nbench:\n  recordings: [" + ", ".join(names) +
                                       "]\n  model_error: 1 %\nsearch: {seed: 1, evaluations: 40, starts: 1}\n")


def judged(program, folder, case):
    """Misfit, and the list of suggestions."""
    run(program, "fit", folder / "study.yaml", "-o", folder / "run", "--threads", "1", "--accept-implausible",
        "--accept-unidentified")
    result = json.loads(run(program, "suggest", folder / "run", "--study", folder / "study.yaml", "--threads", "1",
                            "--json"))
    _, _, _, _, mechanism, elements, _ = case
    rank = ""
    for one in result["suggestions"]:
        if one["mechanism"] == mechanism and set(one["elements"]) <= elements:
            rank = one["number"]
            break
    return result, rank


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program")
    arguments.add_argument("--seeds", type=int, default=1, help="of each defect")
    arguments.add_argument("--clean", type=int, default=20, help="twins without a defect")
    arguments.add_argument("--only", help="defects whose name or vehicle has this")
    arguments.add_argument("--keep", help="folder for vehicles, recordings and fits")
    options = arguments.parse_args()
    clean = [("none", vehicle, lambda text: text, None, "", set(), []) for vehicle in
             ("quarter_car", "landrover110_model1", "landrover110_model3")]
    cases = [(case, seed) for case in CASES for seed in range(1, options.seeds + 1)]
    cases += [(clean[(0, 1, 0, 1, 2)[seed % 5]], seed) for seed in range(1, options.clean + 1)]
    out = csv.writer(sys.stdout)
    out.writerow("defect,vehicle,seed,misfit,suggestions,rank,first,at,fall_percent,criterion,second,third".split(","))
    for case, seed in cases:
        if options.only and not re.search(options.only, case[0] + " " + case[1]):
            continue
        with tempfile.TemporaryDirectory() as temporary:
            folder = Path(options.keep or temporary) / f"{case[0]}_{case[1].replace(' ', '_')}_{seed}"
            folder.mkdir(parents=True, exist_ok=True)
            draw = random.Random(f"{case[0]} {case[1]} {seed}")
            try:
                if "damper" in case[1]:
                    bench(folder, case, draw)
                else:
                    four_post(options.program, folder, case, draw)
                result, rank = judged(options.program, folder, case)
            except RuntimeError as failure:
                print(case[0], case[1], failure, file=sys.stderr)
                out.writerow([case[0], case[1], seed, "failed"])
                continue
            found = result["suggestions"]
            what = [f"{one['mechanism']} {'+'.join(one['elements'])}" for one in found[:3]] + [""] * 3
            first = found[0] if found else None
            out.writerow([case[0], case[1], seed, f"{result['misfit']:.3g}", len(found), rank, what[0],
                          " ".join(f"{p['value']:.3g}" for p in first["parameters"]) if first else "",
                          f"{first['fall_percent']:.3g}" if first else "",
                          f"{first['criterion_change']:.4g}" if first else "", what[1], what[2]])
            sys.stdout.flush()


if __name__ == "__main__":
    main()
