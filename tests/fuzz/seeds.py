"""Writes the files that the fuzzers begin with into corpus/, but for those of vehicles: python3 seeds.py"""
import hashlib
import json
import math
import pathlib
import sqlite3
import struct
import zlib

CORPUS = pathlib.Path(__file__).parent / "corpus"


def write(name, content):
    file = CORPUS / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode())


# Curves of springs, dampers and bushes, as tables and as Adams property files.

PROPERTY_HEAD = """[MDI_HEADER]
 FILE_TYPE  =  '{}'
 FILE_VERSION  =  4.0
(COMMENTS)
{{comment_string}}
'of the fuzzers'
$ ---
[UNITS]
 LENGTH  =  'mm'
 ANGLE   =  'degrees'
 FORCE   =  'newton'
 MASS    =  'kg'
 TIME    =  'second'
"""
write("curve/spring_table", "extension [mm],force [kN]\n-100,-3\n-50,-1\n0,0\n")
write("curve/damper_table", "-speed;-force\nmm/s;N\n-500;-800\n100,5;300\n")
write("curve/spring", PROPERTY_HEAD.format("spr") +
      "[SPRING_DATA]\n FREE_LENGTH = 320.0\n[CURVE]\n{disp force}\n-50.0 -1500.0\n0.0 0.0\n60.0 1800.0\n")
write("curve/damper", PROPERTY_HEAD.format("dpr") +
      "[CURVE]\n{vel force}\n-500.0 -800.0\n0.0 0.0\n500.0 2400.0 ! rebound\n")
write("curve/bushing", PROPERTY_HEAD.format("bus") + "[DAMPING]\n" +
      "".join(f" {name}_DAMPING = 2.0\n" for name in ("FX", "FY", "FZ", "TX", "TY", "TZ")) +
      "".join(f"[{name}_CURVE]\n{{x f}}\n-2.0 -4000.0\n0.0 0.0\n2.0 4000.0\n"
              for name in ("FX", "FY", "FZ", "TX", "TY", "TZ")))

# MAT files of version 5 (MathWorks, "MAT-File Format"), and of version 4.

def element(kind, content, order="<"):
    return struct.pack(order + "II", kind, len(content)) + content + bytes(-len(content) % 8)


def small(kind, content):
    return struct.pack("<HH", kind, len(content)) + content.ljust(4, b"\0")


def matrix(kind, dims, name, content, order="<"):
    return element(14, element(6, struct.pack(order + "II", kind, 0), order) +
                   element(5, struct.pack(order + f"{len(dims)}I", *dims), order) +
                   element(1, name.encode(), order) + content, order)


def doubles(name, values, order="<"):
    return matrix(6, (len(values), 1), name, element(9, struct.pack(order + f"{len(values)}d", *values), order), order)


def text(name, words):
    return matrix(4, (1, len(words)), name, element(16, words.encode()))


def cells(name, parts):
    return matrix(1, (1, len(parts)), name, b"".join(parts))


def structure(name, fields):
    names = b"".join(field.encode().ljust(32, b"\0") for field in fields)
    return matrix(2, (1, 1), name, small(5, struct.pack("<I", 32)) + element(1, names) + b"".join(fields.values()))


def mat5(*variables, order=b"IM"):
    return b"MATLAB 5.0 MAT-file".ljust(124) + (b"\0\1" if order == b"IM" else b"\1\0") + order + b"".join(variables)


def packed(variable):
    squeezed = zlib.compress(variable)
    return struct.pack("<II", 15, len(squeezed)) + squeezed


def mat4(name, values, kind=0):
    return struct.pack("<5I", kind, len(values), 1, 0, len(name) + 1) + name.encode() + b"\0" + struct.pack(
        f"<{len(values)}d", *values)


def mat_files():
    times = [0.01 * k for k in range(8)]
    force = [100 * math.sin(k) for k in range(8)]
    write("mat/channels", mat5(doubles("time", times), text("time_unit", "s"), doubles("force", force),
                               text("force_unit", "N")))
    write("mat/big_endian", mat5(doubles("force", force, ">"), order=b"MI"))
    write("mat/packed", mat5(packed(doubles("time", times)), packed(doubles("force", force))))
    write("mat/structures", mat5(structure("run", {
        "time": doubles("", times), "force": structure("", {"data": doubles("", force), "unit": text("", "kN")}),
        "notes": cells("", [text("", "third run"), doubles("", [1, 2])])})))
    write("mat/rows", mat5(matrix(4, (2, 6), "channel", element(17, "as__btordut_".encode("utf-16-le"))),
                           matrix(12, (1, 2), "gain", small(4, struct.pack("<HH", 1, 2)))))
    write("mat/version4", mat4("time", times) + mat4("force", force) + mat4("force_unit", [78.0], 1))


# Recordings in text.

def tables():
    write("table/time", "time,force,stroke\ns,N,mm\n" + "".join(
        f"{0.001 * k:.3f},{math.sin(k):.4f},{math.cos(k):.4f}\n" for k in range(12)))
    write("table/names_with_units", "sep=;\ntime [s];stroke [mm];force (kN);\n" + "".join(
        f"{0.5 * k};{k % 3},5;1e{k};\n".replace(".", ",") for k in range(6)))
    write("table/stepped_sine", "frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,unit\n"
          "1,0.01,a_body,1.02,-3,0.01,0.5,,m/s^2\n1,0.01,s_strut,0.2,170,0.01,0.5,1e-3,m\n"
          "2,0.01,a_body,1.2,-13,0.01,0.5,,m/s^2\n2,0.01,s_strut,0.4,150,0.01,0.5,1e-3,m\n")
    write("table/static", "quantity,value,unit,sd\nF_FL,4500,N,20\nF_FR,4.4,kN,0.02\n")
    write("table/quoted", '\ufefftime,"force, front","\'=1+1"\r\ns,N,m\r\n0,"1",2\r\n1,"""3""",\r\n\r\n2,"4\n",5\r\n')


# Studies.

STUDY = """vehicle: vehicle.urdf
recordings:
  - {name: heave, file: stepped_sine.csv, posts: heave}
channels:
  a_body: a_body
  s_strut: {channel: s_strut, sign: -1, scale: 1.5, delay: 2 ms}
free: [k, c]
band: [0.5 Hz, 12 Hz]
model_error: {gain_dB: 0.5, phase: 3 deg, mean: 0.2 mm, floor: 0.05, second_harmonic: 1 mm, history: 2 %}
search: {seed: 7, method: dvhde, evaluations: 400, population: 30, starts: 3, deadline: 250 ms, time: 3 s}
refine: {loss: cauchy, scale: 3}
"""


def studies():
    starter = CORPUS.parents[2] / "studies"
    write("study/starter", (starter / "starter/study.yaml").read_text())
    write("study/all_keys", STUDY)
    write("study/static", STUDY + "static_loads:\n  file: static.csv\n  tyres:\n    tyre: {sum: [F_FL, F_FR]}\n")
    write("study/aliases", STUDY.replace("a_body: a_body", "a_body: &a {mean: [x, y]}\n  other: *a"))
    write("study/methods", "problem: gear_train\ntarget: 3e-12\nsearch: {evaluations: 100}\nmethods:\n"
          "  mine: {method: dvhde, population: 10}\n")
    write("study/histories", "vehicle: vehicle.urdf\nhistories:\n  - name: run\n    file: run.csv\n    use: validation\n"
          "    posts: {post: {channel: z, unit: mm}}\n    channels: {a_body: a}\n    start: 1 s\n    end: 2 s\n"
          "    noise: {a_body: 0.1 m/s^2}\n    filter: {cutoff: 30 Hz, order: 2}\ncost: whitened\n")
    write("study/bench", (starter / "damper/model3.yaml").read_text())


# Models of Project Chrono: vehicle, chassis, wishbones, leaf, wheel, tyre, those of tests/data/chrono where empty.

STRUT = {
    "Template": "MacPhersonStrut", "Spindle": {"Mass": 10, "COM": [0, 0.75, 0], "Inertia": [0.05, 0.08, 0.05]},
    "Upright": {"Mass": 12, "COM": [0, 0.7, 0], "Moments of Inertia": [0.1, 0.1, 0.05]},
    "Strut": {"Mass": 2, "Inertia": [0.01, 0.01, 0.01]},
    "Control Arm": {"Mass": 5, "COM": [0, 0.525, -0.15], "Moments of Inertia": [0.05, 0.02, 0.06],
                    "Location Chassis Front": [0.15, 0.35, -0.15], "Location Chassis Back": [-0.15, 0.35, -0.15],
                    "Location Upright": [0, 0.7, -0.15]},
    "Tierod": {"Location Chassis": [0.12, 0.35, -0.1], "Location Upright": [0.12, 0.7, -0.1]},
    "Spring": {"Location Chassis": [0, 0.56, 0.5], "Location Upright": [0, 0.63, 0.15], "Spring Coefficient": 50000,
               "Free Length": 0.42, "Minimum Length": 0.29, "Maximum Length": 0.43},
    "Shock": {"Location Chassis": [0, 0.55, 0.55], "Location Upright": [0, 0.65, 0.05], "Damping Coefficient": 3000}}
BEAM = {
    "Template": "RigidPanhardAxle", "Spindle": {"Mass": 10, "COM": [0, 0.75, 0], "Inertia": [0.05, 0.08, 0.05]},
    "Axle Tube": {"Mass": 80, "COM": [0, 0, 0], "Inertia": [12, 0.5, 12]},
    "Spring": {"Location Chassis": [0, 0.5, 0.35], "Location Axle": [0, 0.5, 0], "Spring Coefficient": 30000,
               "Free Length": 0.45},
    "Shock": {"Location Chassis": [-0.1, 0.45, 0.35], "Location Axle": [-0.1, 0.45, -0.05], "Free Length": 0.4,
              "Deformation": [-0.1, 0.1], "Map Data": [[-1, -900, -800], [0, 0, 0], [1, 900, 1000]]},
    "Panhard Rod": {"Location Chassis": [-0.1, -0.5, 0.05], "Location Axle": [-0.1, 0.5, 0.05], "Mass": 4},
    "Anti Roll Bar": {"Location Chassis": [-0.3, 0.4, 0], "Location Axle": [0, 0.4, 0], "Rotational Stiffness": 1000,
                      "Mass": 3, "Inertia": [0.1, 0.01, 0.1]}}
CHASSIS = {"Components": [
    {"Centroidal Frame": {"Location": [0.1, 0, 0.2], "Orientation": [0.7, 0, 0.7, 0]}, "Mass": 1300,
     "Moments of Inertia": [450, 1600, 1800], "Products of Inertia": [1, -20, 2], "Void": False},
    {"Centroidal Frame": {"Location": [0, 0, 0.5]}, "Mass": 100, "Moments of Inertia": [10, 20, 20], "Void": True}]}
TYRE = {"Design": {"Mass [kg]": 12, "Inertia [kg.m2]": [0.4, 0.8, 0.4], "Unloaded Radius [m]": 0.32, "Rim Radius [m]": 0.2,
                   "Load Index": 91}}


def models():
    files = [(CORPUS.parents[1] / "data/chrono" / name).read_text()
             for name in ("vehicle.json", "car/chassis.json", "car/wishbones.json", "car/leaf.json")]
    for file, name in enumerate(("vehicle", "chassis", "wishbones", "leaf")):
        write(f"chrono/{name}", "\x1e" * file + files[file])
    for file, name, parts in ((1, "holes", CHASSIS), (2, "strut", STRUT), (3, "beam", BEAM), (5, "tyre", TYRE)):
        write(f"chrono/{name}", "\x1e" * file + json.dumps(parts))


# Folders of fits: result.json, response.csv, history.csv, motion.csv, validation.csv, bench.csv, study.yaml.

def parameter(name, value):
    return {"name": name, "unit": "N/m", "value": value, "start": 1.2 * value, "lower": 0.5 * value,
            "upper": 2 * value, "sd": 0.01 * value, "interval_95": [0.98 * value, 1.02 * value], "at_bound": False}


def results():
    result = {
        "termination": "converged", "vehicle": "quarter car", "study": "study.yaml", "seed": 1, "cost": 12.5,
        "misfit": 1.2, "residuals": 40, "band_Hz": [0.5, 12], "evaluations": {"paid": 100, "reused": 3, "failed": 0},
        "parameters": [parameter("k", 2e4), parameter("c", 1500)],
        "identifiability": {"condition": 8.3, "correlation": [[1, 0.5], [0.5, 1]], "weakest": []},
        "refine": {"loss": "huber", "scale": 1.345}, "starts": {"agreeing": 2, "refined": 2},
        "recordings": [{"name": "heave", "posts": {"post": 1}}],
        "channels": [{"recording": "heave", "name": "a_body", "rms_dB": 0.5, "rms_deg": 3, "nmse_percent": 1.1}],
        "validation": [{"recording": "sweep", "name": "a_body", "nmse_percent": 2}], "warnings": ["check the sign"],
        "fitted_files": [{"name": "stepped_sine.csv", "sha256": "0" * 64}], "versions": {"fourpost": "0.1.0"}}
    header = ("recording,channel,unit,frequency_Hz,post_amplitude_m,gain_measured,phase_measured_deg,gain_modelled,"
              "phase_modelled_deg,mean_measured,mean_modelled\n")
    rows = "".join(f"heave,a_body,m/s^2,{f},0.01,1.1,-3,1.2,-4,,\n" for f in (1, 2, 4))
    write("result/fit", json.dumps(result))
    write("result/fit_with_files", "\x1e".join([json.dumps(result), header + rows, "", "", "", "", STUDY]))
    history = "time,heave/a_body/measured,heave/a_body/modelled\ns,m/s^2,m/s^2\n" + "".join(
        f"{0.01 * k:.2f},{math.sin(k):.3f},{math.sin(k + 0.1):.3f}\n" for k in range(10))
    write("result/histories", "\x1e".join([json.dumps(result), "", history, "", history]))


# Archives, as identify/search/evaluation_store.cpp has them.

def digest(*parts):
    total = hashlib.sha256()
    for part in parts:
        if isinstance(part, float):
            total.update(struct.pack(">Qd", 1, part))
        else:
            total.update(struct.pack(">Q", len(part)) + part)
    return total.hexdigest()


def archive(name, layout):
    file = CORPUS / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    checksum = ", checksum TEXT" if layout > 1 else ""
    database = sqlite3.connect(file)
    database.executescript(f"""
        PRAGMA page_size = 512;
        CREATE TABLE context (id INTEGER PRIMARY KEY, vehicle TEXT NOT NULL, data TEXT NOT NULL,
          settings TEXT NOT NULL, version TEXT NOT NULL, use INTEGER NOT NULL,
          UNIQUE (vehicle, data, settings, version));
        CREATE TABLE evaluation (context INTEGER NOT NULL REFERENCES context, parameters BLOB NOT NULL, residuals BLOB,
          failure TEXT, detail TEXT, violation REAL, paid INTEGER NOT NULL DEFAULT 1{checksum},
          PRIMARY KEY (context, parameters));
        PRAGMA application_id = 0x34707374; PRAGMA user_version = {layout};
        INSERT INTO context VALUES (1, 'car', 'rig', 'band', '1', 1);""")
    context = [b"car", b"rig", b"band", b"1"]
    for i in range(3):
        values = struct.pack("<2d", i, 0.5)
        residuals = struct.pack("<10d", *(i + k / 9 for k in range(10)))
        row = (values, residuals, None, None, None, digest(*context, values, b"", residuals, 0.0))
        if i == 2:
            row = (values, None, "infeasible", "too far", 2.0,
                   digest(*context, values, b"infeasible", b"too far", 2.0))
        places = ", checksum) VALUES (1, ?, ?, ?, ?, ?, ?)" if layout > 1 else ") VALUES (1, ?, ?, ?, ?, ?)"
        database.execute("INSERT INTO evaluation (context, parameters, residuals, failure, detail, violation" + places,
                         row if layout > 1 else row[:-1])
    database.commit()
    database.close()


# Formats of measurement systems.

def rpc(form, kind, data):
    keys = {"FORMAT": form, "NUM_HEADER_BLOCKS": 4, "NUM_PARAMS": 14, "DATA_TYPE": kind, "DELTA_T": "2.0E-03",
            "PTS_PER_FRAME": 4, "PTS_PER_GROUP": 8, "CHANNELS": 2, "FRAMES": 3, "HALF_FRAMES": 0, "DESC.CHAN_1": "FL",
            "UNITS.CHAN_1": "mm", "SCALE.CHAN_1": 0.5, "SCALE.CHAN_2": 2}
    header = b"".join(key.encode().ljust(32, b"\0") + str(value).encode().ljust(96, b"\0")
                      for key, value in keys.items())
    return header.ljust(2048, b"\0") + data


def rpc_files():
    counts = [k % 12 for k in range(32)]
    write("rpc/little", rpc("BINARY_IEEE_LITTLE_END", "SHORT_INTEGER", struct.pack("<32h", *counts)))
    write("rpc/big", rpc("BINARY_IEEE_BIG_END", "FLOATING_POINT", struct.pack(">32f", *counts)))
    write("rpc/text", rpc("ASCII", "SHORT_INTEGER", b"\n".join(b"%d %d" % (k, -k) for k in counts)))


def function(kind, type_of_data, samples, even, data, head="58"):
    quantity = 18 if kind == 4 else 17
    return (f"    -1\n{head:>6}\nforce\nNONE\nNONE\nNONE\nNONE\n{kind:5}{1:10}{1:5}{0:10} {'F':10}{7:10}{3:4} "
            f"{'post':10}{1:10}{3:4}\n{type_of_data:10}{samples:10}{even:10}  0.00000E+00  1.00000E-02  0.00000E+00\n"
            f"{quantity:10}    0    0    0 {'NONE':20} {'NONE':20}\n{13:10}    0    1    0 {'force':20} {'N':20}\n"
            f"{8 if kind == 4 else 0:10}    1    0    0 {'NONE':20} {'m':20}\n{0:10}    0    0    0 {'NONE':20} {'NONE':20}\n"
            ).encode() + data + b"\n    -1\n"


def universal_files():
    write("universal/text", b"    -1\n   151\nrig\nNONE\n    -1\n" +
          b"    -1\n   164\n         1SI                           2\n  1.0D+00  1.0D+00  1.0D+00\n  2.7D+02\n    -1\n" +
          function(1, 2, 3, 1, b"  1.00000E+00 -2.00000E+00  3.00000E+000"))
    write("universal/binary", function(1, 4, 3, 0, struct.pack("<6d", 0, 1, 0.1, 2, 0.3, 3),
                                       "58b     1     2          11          48     0     0           0           0"))
    write("universal/big", function(1, 2, 3, 1, struct.pack(">3f", 1, 2, 3),
                                    "58b     2     2          11          12     0     0           0           0"))
    write("universal/response", function(4, 5, 2, 1, b"  1.00000E+00  2.00000E+00  3.00000E+00 -4.00000E+00"))


def segment(objects, data, mask=0xE, order="<"):
    def words(words_):
        return struct.pack(order + "I", len(words_)) + words_.encode()

    meta = struct.pack(order + "I", len(objects)) if objects else b""
    for path, index, properties in objects:
        meta += words(path) + (struct.pack(order + "I", index) if isinstance(index, int) else
                               struct.pack(order + "IIIQ", 20, index[0], 1, index[1]))
        meta += struct.pack(order + "I", len(properties))
        for name, value in properties.items():
            meta += words(name) + (struct.pack(order + "I", 0x20) + words(value) if isinstance(value, str) else
                                   struct.pack(order + "Id", 10, value) if isinstance(value, float) else
                                   struct.pack(order + "II", 7, value))
    return b"TDSm" + struct.pack("<I", mask) + struct.pack(order + "IQQ", 4713, len(meta + data), len(meta)) + meta + data


def tdms_files():
    linear = {"NI_Number_Of_Scales": 1, "NI_Scale[0]_Scale_Type": "Linear", "NI_Scale[0]_Linear_Slope": 2.0,
              "NI_Scale[0]_Linear_Y_Intercept": 1.0}
    pair = [("/", 0xFFFFFFFF, {"name": "run"}), ("/'g'/'F'", (10, 2), {"wf_increment": 0.01, "unit_string": "N"}),
            ("/'g'/'z'", (2, 2), linear)]
    write("tdms/segments", segment(pair, struct.pack("<2d2h", 1, 2, 3, 4) * 2) +
          segment([], struct.pack("<2d2h", 5, 6, 7, 8), 0x8) + segment([("/'g'/'F'", 0, {})], struct.pack("<2d", 9, 10)))
    write("tdms/interleaved", segment(pair, struct.pack("<dhdh", 1, 3, 2, 4), 0x2E))
    write("tdms/big", segment(pair, struct.pack(">2d2h", 1, 2, 3, 4), 0x4E, ">"))
    write("tdms/stamps", segment([("/'g'/'t'", (0x44, 2), {})], struct.pack("<QqQq", 0, 5, 1 << 63, 6)))


class Mdf4:
    """Blocks one behind the other."""

    def __init__(self):
        self.bytes = bytearray(b"MDF     4.10    seed".ljust(64 + 104, b"\0"))

    def add(self, name, links, data):
        self.bytes += bytes(-len(self.bytes) % 8)
        at = len(self.bytes)
        self.bytes += self.block(name, links, data)
        return at

    @staticmethod
    def block(name, links, data):
        return (b"##" + name + bytes(4) + struct.pack(f"<QQ{len(links)}Q", 24 + 8 * len(links) + len(data), len(links), *links)
                + data)

    def channel(self, following, name, kind, type_of_data, byte, bits, conversion=0):
        text = self.add(b"TX", [], name + b"\0")
        return self.add(b"CN", [following, 0, text, 0, conversion, 0, 0, 0],
                        struct.pack("<4BII", kind, kind == 2, type_of_data, 0, byte, bits) + bytes(60))

    def file(self, data, cycles=4):
        linear = self.add(b"CC", [0] * 4, struct.pack("<BBHHHdd2d", 1, 0, 0, 0, 2, 0, 0, 100, 0.5))
        channels = self.channel(self.channel(0, b"z", 0, 2, 8, 16, linear), b"t", 2, 4, 0, 64)
        group = self.add(b"CG", [0, channels, 0, 0, 0, 0], struct.pack("<QQQII", 0, cycles, 0, 10, 0))
        group = self.add(b"DG", [0, group, data, 0], bytes(8))
        self.bytes[64:168] = self.block(b"HD", [group, 0, 0, 0, 0, 0], bytes(32))
        return bytes(self.bytes)


def mdf_files():
    records = b"".join(struct.pack("<dh", 0.1 * k, -10 * k) for k in range(4))
    plain = Mdf4()
    write("mdf/plain", plain.file(plain.add(b"DT", [], records)))
    deflated = Mdf4()
    columns = zlib.compress(bytes(records[r * 10 + c] for c in range(10) for r in range(4)))
    block = deflated.add(b"DZ", [], b"DT" + struct.pack("<BBIQQ", 1, 0, 10, len(records), len(columns)) + columns)
    block = deflated.add(b"DL", [0, block], bytes(16))
    write("mdf/packed", deflated.file(deflated.add(b"HL", [block], bytes(8))))
    old = bytearray(b"MDF     3.30    seed".ljust(64, b"\0"))

    def add(name, content):
        at = len(old)
        old.extend(name + struct.pack("<H", len(content) + 4) + content)
        return at

    add(b"HD", bytes(12) + struct.pack("<H", 1) + bytes(138))
    linear = add(b"CC", bytes(18) + b"mm".ljust(20, b"\0") + struct.pack("<HHdd", 0, 2, 100, 0.5))
    z = add(b"CN", struct.pack("<5IH32s128sHHHH24xIIH", 0, linear, 0, 0, 0, 0, b"z", b"", 64, 16, 1, 0, 0, 0, 0))
    t = add(b"CN", struct.pack("<5IH32s128sHHHH24xIIH", z, 0, 0, 0, 0, 1, b"t", b"", 0, 64, 3, 0, 0, 0, 0))
    group = add(b"CG", struct.pack("<IIIHHHI", 0, t, 0, 0, 2, 10, 4))
    data = len(old)
    old.extend(records)
    group = add(b"DG", struct.pack("<IIIIHHI", 0, group, 0, data, 1, 0, 0))
    old[68:72] = struct.pack("<I", group)
    write("mdf/version3", bytes(old))


def lvm_files():
    head = "LabVIEW Measurement\t\nSeparator\tTab\nDecimal_Separator\t.\n***End_of_Header***\t\n\t\n"
    part = ("Channels\t2\t\nY_Unit_Label\tkN\tmm\nX0\t0\t0\nDelta_X\t0.001\t0.001\n***End_of_Header***\t\n"
            "X_Value\tF\tz\tComment\n0\t1\t2\n0.001\t3\t4\thit\n\n")
    write("lvm/parts", head + part + part.replace("X0\t0\t0", "X0\t1\t1"))
    write("lvm/times", head + part.replace("X_Value\tF\tz", "X_Value\tF\tX_Value\tz")
          .replace("\n0\t1\t2", "\n0\t1\t0\t2").replace("3\t4", "3\t0.001\t4"))


if __name__ == "__main__":
    mat_files()
    rpc_files()
    universal_files()
    tdms_files()
    mdf_files()
    lvm_files()
    tables()
    studies()
    models()
    results()
    archive("archive/three", 2)
    archive("archive/version_0_1_0", 1)
    write("archive/empty", "")
