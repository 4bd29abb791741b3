"""What a plan asks for, and what is wrong with it."""
import re

import pytest
from conftest import FOURPOST, SOURCE, STUB

from fourpost_batch import BatchError, Program, Unit, expand, findings, read_plan

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


@pytest.mark.parametrize("of, fits", [
    ("var", ["var/a/seed1", "var/a/seed2", "var/b/seed1", "var/b/seed2"]), ("var/a", ["var/a/seed1", "var/a/seed2"]),
    ("var/b/seed2", ["var/b/seed2"]), ("[var/a/seed1, '*seed1']", ["var/a/seed1", "var/b/seed1"])])
def test_predictions_are_of_an_entry_a_study_or_a_unit(batch, of, fits):
    batch.study("a.yaml", "delay 0")
    batch.study("b.yaml", "delay 0")
    batch.write("r.csv", "x")
    units = units_of(batch, "fits: [{study: '?.yaml', name: var, seeds: 1..2}]\n"
                            "predictions: [{of: %s, recordings: r.csv}]" % of)
    assert [unit.name for unit in units[4:]] == [f"{fit}/predict/r" for fit in fits]


def test_an_unknown_fit_is_answered_with_the_names_there_are(batch):
    batch.study("a.yaml", "delay 0")
    batch.study("b.yaml", "delay 0")
    text = "fits: [{study: '?.yaml', name: var}]\npredictions: [{of: varr, recordings: a.yaml}]"
    with pytest.raises(BatchError, match=r"'varr', did you mean 'var'\? name one of var/a, var, var/b, or a folder"):
        units_of(batch, text)
    # The name of an entry and that of a fit are two.
    text = "fits:\n- {study: a.yaml, name: var}\n- {study: '?.yaml', name: var}"
    assert refused(batch, text) == [("batch-name-twice", 3)]


def test_files_of_one_name_are_told_apart_by_their_folders(batch):
    for car in ("a", "b/old"):
        batch.study(f"cars/{car}/study.yaml", "delay 0")
        batch.write(f"rig/{car}/sweep.csv", "x")
    units = units_of(batch, "fits: [{study: 'cars/**/study.yaml'}]\npredictions: [{of: a/study, recordings: 'rig/**/*.csv'}]")
    assert [unit.name for unit in units] == ["a/study", "b/old/study", "a/study/predict/a/sweep", "a/study/predict/b/old/sweep"]


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
    ("predictions:\n- {run: run, recordings: a.yaml, engine: ful}", "batch-value-wrong", 2),
    ("predictions:\n- {run: run, recordings: a.yaml, mode: heav}", "batch-value-wrong", 2),
    ("fits:\n- {study: a.yaml}\npredictions:\n- {of: b, recordings: a.yaml}", "batch-run-unknown", 4),
    ("predictions:\n- {run: run, recordings: a.yaml}", "batch-run-of-other-version", 2),
    ("predictions:\n- {run: empty, recordings: a.yaml}", "batch-file-missing", 2),
])
def test_a_fault_has_its_line(batch, text, id, line):
    batch.study("a.yaml", "delay 0")
    batch.write("run/result.json", '{"versions": {"fourpost": "0.1.0"}}')
    batch.write("empty/x", "")
    assert refused(batch, text) == [(id, line)]


def test_what_set_allows_is_said(batch):
    batch.study("a.yaml", "delay 0")
    for value, shown in (("[1 N, 2 N]", "a list"), ("{from: 1}", "keys with values")):
        with pytest.raises(BatchError) as caught:
            units_of(batch, "fits: [{study: a.yaml, set: {k: %s}}]" % value)
        assert caught.value.findings[0].text == (
            f"'k' cannot be {shown}: write one value with its unit, such as 20 kN/m; for several values write an entry "
            "for each, with a 'name' of its own")


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


def test_all_names_are_read_before_anything_is_paid(starter):
    """Of parameters, of channels, and recordings of predictions, at once."""
    recording = (starter.folder / "car/stepped_sine.csv").read_text()
    starter.write("other.csv", "time,p9,q9\ns,m,N\n0,1,2\n1,2,3\n2,3,1\n")
    starter.write("broken.csv", recording.replace("1.18668", "x"))
    starter.write("plan.yaml", "fits:\n- {study: car/study.yaml, set: {kk: 20 kN/m}}\n"
                               "- {study: car/study.yaml, name: b, set: {k: '20'}, profile: [k, c_bum]}\n"
                               "predictions:\n- {of: '*', recordings: other.csv}\n- {of: b, recordings: broken.csv}\n")
    said = starter.run("--output=out", program=FOURPOST, code=3).stderr.splitlines()
    profile = said.pop(3)
    assert "plan.yaml:3: error: 'profile' cannot be 'c_bum', did you mean 'c_bump'? write parameters of " in profile
    places = {line.partition(": error: ")[0].rpartition("/")[2]: line.partition(": error: ")[2] for line in said}
    assert list(places) == ["broken.csv:2", "plan.yaml:2", "plan.yaml:3", "plan.yaml:5"], said
    assert places["plan.yaml:2"].startswith("the vehicle has no parameter 'kk'; it has m_body, ")
    assert "needs a unit" in places["plan.yaml:3"]
    assert "none of the channels of 'other.csv': " in places["plan.yaml:5"] and "this one has p9, q9" in places["plan.yaml:5"]
    assert len(said) == 5 and not (starter.folder / "out").exists()


def test_findings_have_the_words_of_the_program():
    """Each, in its table, by which `fourpost help` explains it."""
    text = (SOURCE / "identify/command_line/batch_findings.h").read_text()
    string = r'((?:"(?:[^"\\\\]|\\\\.)*"\s*)+)'
    row = re.compile(r'inline const Finding \w+\{\s*"([a-z-]+)",\s*Severity::k(\w+),\s*%s,\s*%s\};' % (string, string))
    words = [(id, severity.lower(), *("".join(re.findall(r'"((?:[^"\\]|\\.)*)"', part)) for part in parts))
             for id, severity, *parts in row.findall(text)]
    assert len(words) == text.count("inline const Finding")
    of_program = {"batch-without-plan", "batch-without-output", "batch-without-package", "batch-without-python"}
    assert {tuple(kind) for kind in findings.TABLE} == {one for one in words if one[0] not in of_program}
    known = set(re.findall(r"^\| `(batch-[a-z-]+)`", (SOURCE / "docs/findings.md").read_text(), re.M))
    assert known == {one[0] for one in words}


def test_every_finding_is_used_and_none_is_written_elsewhere():
    package = SOURCE / "python/fourpost_batch"
    code = "".join(path.read_text() for path in package.glob("*.py") if path.name != "findings.py")
    names = {name for name, kind in vars(findings).items() if isinstance(kind, findings.Kind)}
    assert names == set(re.findall(r"findings\.([A-Z_]+)\b", code))
    assert "batch-" not in re.sub(r"fourpost-batch-", "", code)
