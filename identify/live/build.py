#!/usr/bin/env python3
"""Makes the WebAssembly of live pages from the project's own sources, by Debian's emscripten (apt-get install
emscripten): `identify/live/build.py` writes `bundle/live.base64`, and the digests of all files that went into it.

`--check` compares these digests instead, for which emscripten is not needed: exit code 1 where one differs. Comments and
layout do not count.
"""
import base64
import concurrent.futures
import gzip
import hashlib
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
OBJECTS = ROOT / "build" / "live"
BUNDLE = ROOT / "identify" / "live" / "bundle"
PROGRAM = BUNDLE / "live.base64"
DIGESTS = BUNDLE / "live.sources"
EIGEN = os.environ.get("EIGEN", "/usr/include/eigen3")

SOURCES = """
analysis/comfort/weighted_acceleration analysis/comfort/weighting
analysis/numerics/anderson_acceleration analysis/numerics/bessel analysis/numerics/decompositions
analysis/process/deadline analysis/process/thread_time
identify/live/live_calls identify/live/live_ride identify/live/live_vehicle
vehicles/condensed/condensed_body vehicles/condensed/condensed_model vehicles/condensed/linear_vehicle
vehicles/condensed/modes vehicles/condensed/port vehicles/condensed/preload_map vehicles/condensed/receptance
vehicles/condensed/reduced_bytes vehicles/condensed/reduced_vehicle
vehicles/description/element_laws
vehicles/laws/dahl_cycle vehicles/laws/dahl_friction vehicles/laws/dashpot_law vehicles/laws/hydraulic_cycle vehicles/laws/hydraulic_damper vehicles/laws/hydraulic_oil
vehicles/laws/monotone_curve vehicles/laws/mounted_hydraulic_damper vehicles/laws/spring_law vehicles/laws/tyre_law
vehicles/posts/road_tracks
vehicles/random_response/post_spectra vehicles/random_response/random_vehicle vehicles/random_response/spectral_grid
vehicles/random_response/statistical_gain
vehicles/response/contact_cycle vehicles/response/cycle_transform vehicles/response/excitation
vehicles/response/harmonic_balance vehicles/response/hysteresis vehicles/response/linearised_cycle
vehicles/response/mean_slope_step vehicles/response/port_cycle vehicles/response/port_newton
vehicles/response/response_recorder
vehicles/response/tyre_contact
vehicles/ride_metrics/ride_bytes vehicles/ride_metrics/ride_metrics vehicles/ride_metrics/ride_spectra
vehicles/ride_metrics/road_ride vehicles/ride_metrics/spectral_ride
""".split()

CALLS = ["live_room", "live_answer", "live_fault", "live_open", "live_set", "live_response", "live_modes",
         "live_ride"]

COMPILE = ["em++", "-std=c++20", "-O2", "-fwasm-exceptions", "-fno-rtti", "-ffunction-sections", "-fdata-sections",
           "-DEIGEN_NO_DEBUG", f"-isystem{EIGEN}", "-I."]
LINK = ["em++", "-Os", "-fwasm-exceptions", "--no-entry", "-sSTANDALONE_WASM", "-sALLOW_MEMORY_GROWTH",
        "-sFILESYSTEM=0", "-sEXPORTED_FUNCTIONS=" + ",".join("_" + call for call in CALLS)]


def object_of(source):
    return OBJECTS / (source.replace("/", "_") + ".o")


def files_of(source):
    """The project's files that went into an object, by the rule that the compiler wrote beside it."""
    rule = object_of(source).with_suffix(".d").read_text().replace("\\\n", " ")
    return {name for name in rule.split(": ", 1)[1].split() if not name.startswith("/")}


def is_fresh(source):
    rule = object_of(source).with_suffix(".d")
    if not rule.exists() or not object_of(source).exists():
        return False
    made = object_of(source).stat().st_mtime
    return all((ROOT / name).exists() and (ROOT / name).stat().st_mtime < made for name in files_of(source))


def compile_one(source):
    if not is_fresh(source):
        print(source, flush=True)
        subprocess.run([*COMPILE, "-MMD", "-c", f"{source}.cpp", "-o", object_of(source)], check=True, cwd=ROOT)


def digest(name):
    """Of a file's code, whatever its comments and its layout."""
    code = re.sub(r"//[^\n]*", "", (ROOT / name).read_text())
    return hashlib.sha256("".join(code.split()).encode()).hexdigest()[:16]


def build():
    OBJECTS.mkdir(parents=True, exist_ok=True)
    BUNDLE.mkdir(exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        list(pool.map(compile_one, SOURCES))
    program = OBJECTS / "live.wasm"
    subprocess.run([*LINK, *map(object_of, SOURCES), "-o", program], check=True)
    packed = gzip.compress(program.read_bytes(), 9, mtime=0)
    PROGRAM.write_text(base64.b64encode(packed).decode())
    names = sorted(set().union(*map(files_of, SOURCES)))
    DIGESTS.write_text("".join(f"{digest(name)} {name}\n" for name in names))
    print(f"{program.stat().st_size} bytes, {PROGRAM.stat().st_size} as text")


def check():
    stale = []
    for line in DIGESTS.read_text().splitlines():
        known, name = line.split(" ", 1)
        if not (ROOT / name).exists() or digest(name) != known:
            stale.append(name)
    if stale:
        sys.exit(f"{PROGRAM.relative_to(ROOT)} is stale: {', '.join(stale)} changed since it was made.\n"
                 "Run `identify/live/build.py`, which needs Debian's package emscripten, and commit what it writes.")


if __name__ == "__main__":
    check() if "--check" in sys.argv else build()
