"""What a plan asks for, and what is wrong with it."""
import re
import subprocess

import pytest
from conftest import FOURPOST, STUB

from fourpost_batch import BatchError, Program, Unit, expand, read_plan

FITS = "fits:\n  - study: a.yaml\n    seeds: 1..3\n"


def units_of(batch, text):
    return expand(read_plan(batch.write("plan.yaml", text)), Program(STUB)).units


def refused(batch, text):
    """What is wrong, by id and line."""
    with pytest.raises(BatchError) as caught:
        units_of(batch, text)
    return [(finding.id, finding.line) for finding in caught.value.findings]


def test_a_plan_becomes_units(batch):
    batch.study("a.yaml", "delay 0")
    batch.study("b.yaml", "delay 0")
    batch.write("rig/one.csv", "x")
    batch.write("rig/two.csv", "y")
    units = units_of(batch, "fits:\n  - {study: [a.yaml, b.yaml], seeds: [1, 5..6], set: {k: 20 kN/m}}\n"
                            "predictions:\n  - {of: a, recordings: rig/*.csv, mode: heave}\n"
                            "comparisons:\n  - {study: '?.yaml', methods: [de, gb], runs: 3}\n")
    names = [unit.name for unit in units]
    assert names[:6] == [f"{study}/seed{seed}" for study in "ab" for seed in (1, 5, 6)]
    assert names[6:12] == [f"a/seed{seed}/predict/{file}" for file in ("one", "two") for seed in (1, 5, 6)]
    assert names[12:] == ["compare/a/seed1", "compare/b/seed1"]
    assert units[0].command[:3] == ("{program}", "fit", "a.yaml") and "--set=k=20 kN/m" in units[0].command
    assert units[6].after == units[0].key and "--mode=heave" in units[6].command
    assert "--methods=de,gb" in units[12].command


def test_an_entry_may_have_a_name(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("r.csv", "x")
    units = units_of(batch, "fits: [{study: a.yaml}]\npredictions:\n"
                            "  - {of: a, recordings: r.csv, engine: reduced, name: fast}\n"
                            "  - {of: a, recordings: r.csv, engine: full, name: sure}\n")
    assert [unit.name for unit in units] == ["a", "a/fast/predict/r", "a/sure/predict/r"]


@pytest.mark.parametrize("folder", ["plain", "p[1]"])
def test_runs_are_folders_and_patterns_of_them(batch, folder):
    there = type(batch)(batch.folder / folder)
    there.write("r.csv", "x")
    for name in ("one", "two"):
        there.write(f"runs/{name}/result.json", '{"versions": {"fourpost": "0.2.0"}}')
    units = units_of(there, "predictions: [{run: runs/*, recordings: r.csv}]")
    assert [unit.name for unit in units] == ["one/predict/r", "two/predict/r"]


def test_a_key_is_that_of_the_inputs(batch):
    batch.study("a.yaml", "delay 0")
    unit, = units_of(batch, "fits: [{study: a.yaml}]")
    assert units_of(batch, "fits: [{study: a.yaml, name: other}]")[0].key == unit.key
    # Nor does it depend on where the folder is.
    elsewhere = type(batch)(batch.folder / "deep/er")
    elsewhere.study("a.yaml", "delay 0")
    assert units_of(elsewhere, "fits: [{study: a.yaml}]")[0].key == unit.key
    batch.study("a.yaml", "delay 0.0")
    changed, = units_of(batch, "fits: [{study: a.yaml}]")
    seeded, = units_of(batch, "fits: [{study: a.yaml, seeds: 1}]")
    built = Unit.of({**changed.to_dict(), "build": "another"})
    assert len({unit.key, changed.key, seeded.key, built.key}) == 4
    assert Unit.of(changed.to_dict()).key == changed.key


def test_a_prediction_has_the_key_of_its_fit(batch):
    study, recording = batch.study("a.yaml", "delay 0"), batch.write("r.csv", "x")
    plan = "fits: [{study: a.yaml}]\npredictions: [{of: a, recordings: r.csv}]"
    keys = {units_of(batch, plan)[1].key}
    study.write_text("# delay 1\nproblem: none\n")
    keys.add(units_of(batch, plan)[1].key)
    recording.write_text("y")
    keys.add(units_of(batch, plan)[1].key)
    assert len(keys) == 3


def test_faults_of_a_plan_are_found_at_once(batch):
    batch.study("a.yaml", "delay 0")
    text = ("fits:\n  - study: a.yaml\n    seeds: 1..\n  - studdy: a.yaml\n  - study: b.yaml\n    grow: 3\n"
            "predictions:\n  - recordings: a.yaml\nfit: []\nchoices: 7\n")
    assert refused(batch, text) == [
        ("batch-value-wrong", 3), ("batch-key-unknown", 4), ("batch-key-missing", 4), ("batch-file-missing", 5),
        ("batch-value-wrong", 6), ("batch-key-missing", 8), ("batch-key-unknown", 9), ("batch-value-wrong", 10)]


@pytest.mark.parametrize("text, id, line", [
    ("", "batch-plan-malformed", 1), ("[]", "batch-plan-malformed", 1), ("fits: [", "batch-plan-malformed", 1),
    ("fits: []", "batch-empty", 1), ("fits: [{study: .nan}]", "batch-file-missing", 1),
    ("fits:\n- {study: a.yaml, seeds: .nan}", "batch-value-wrong", 2),
    ("fits:\n- {study: a.yaml, seeds: -1}", "batch-value-wrong", 2),
    ("fits:\n- {study: a.yaml, seeds: 1..99999999}", "batch-value-wrong", 2),
    ("fits:\n- {study: a.yaml, seeds: [1, 1]}", "batch-value-wrong", 2),
    ("fits:\n- {study: a.yaml, name: ../../a}", "batch-value-wrong", 2),
    ("comparisons:\n- {study: a.yaml, runs: 0.5}", "batch-value-wrong", 2),
    ("fits:\n- {study: a.yaml}\n- {study: a.yaml}", "batch-name-twice", 3),
    ("fits:\n- {study: a.yaml}\npredictions:\n- {of: b, recordings: a.yaml}", "batch-run-unknown", 4),
    ("predictions:\n- {run: run, recordings: a.yaml}", "batch-run-of-other-version", 2),
    ("predictions:\n- {run: empty, recordings: a.yaml}", "batch-file-missing", 2),
])
def test_a_fault_has_its_line(batch, text, id, line):
    batch.study("a.yaml", "delay 0")
    batch.write("run/result.json", '{"versions": {"fourpost": "0.1.0"}}')
    batch.write("empty/x", "")
    assert refused(batch, text) == [(id, line)]


def test_what_a_study_reads_is_what_the_program_says(starter):
    starter.write("plan.yaml", "fits: [{study: car/study.yaml}]")
    expanded = expand(read_plan(starter.folder / "plan.yaml"), Program(FOURPOST))
    assert [name for name, _ in expanded.units[0].inputs] == ["stepped_sine.csv", "study.yaml", "vehicle.urdf"]


@pytest.mark.parametrize("before, after, id", [
    ("stepped_sine.csv", "1.0,0.01", "nan"), ("stepped_sine.csv", "m", "unit")])
def test_recordings_are_read_before_anything_is_paid(starter, before, after, id):
    """NaN in a table, and a column in a unit of another kind."""
    file = starter.folder / "car" / before
    lines = file.read_text().splitlines()
    if id == "nan":
        cells = lines[-1].split(",")
        lines[-1] = ",".join([cells[0], *["nan"] * (len(cells) - 1)])
    else:
        lines = [line.replace("m/s^2", "kg") for line in lines]
    file.write_text("\n".join(lines) + "\n")
    starter.write("plan.yaml", "fits: [{study: car/study.yaml}]")
    outcome = starter.run("--output=out", program=FOURPOST, code=3)
    assert re.search(r"stepped_sine\.csv(:\d+)?: error: .*\[[a-z0-9-]+\]$", outcome.stderr, re.M), outcome.stderr
    assert not list((starter.folder / "out").glob("units/*/*"))


def test_ids_are_those_of_the_program():
    shown = subprocess.run([FOURPOST, "help", "findings"], capture_output=True, text=True, check=True).stdout
    known = dict(re.findall(r"^\| `(batch-[a-z-]+)` \| (error|warning)", shown, re.M))
    package = STUB.parents[2] / "python/fourpost_batch"
    used = {id: severity for path in package.glob("*.py")
            for severity, id in re.findall(r'\b(error|warning)\("(batch-[a-z-]+)"', path.read_text())}
    of_program = {"batch-without-plan", "batch-without-output", "batch-without-package", "batch-without-python"}
    assert {id: severity for id, severity in known.items() if id in used} == used
    text = "".join(path.read_text() for path in package.glob("*.py"))
    assert {id for id in known if f'"{id}"' not in text} == of_program
