"""What a batch shows of its units: tables, lists, warnings."""
import csv
import json

import pytest
from conftest import FOURPOST, STUB, content, states_in


def test_a_list_writes_tables_of_what_is_done(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "fits: [{study: a.yaml, seeds: 1..2}]")
    batch.run("--output=out")
    (batch.folder / "out/results.csv").unlink()
    batch.write("plan.yaml", "fits: [{study: a.yaml, seeds: 1..5}]")
    batch.run("--output=out", "--list")
    assert states_in(batch) == ["done"] * 2 + ["missing"] * 3
    # Without a result of the plan there are none.
    (batch.folder / "out/results.csv").unlink()
    batch.write("plan.yaml", "fits: [{study: a.yaml, seeds: 7}]")
    batch.run("--output=out", "--list")
    assert not (batch.folder / "out/results.csv").exists()
    # A folder of others is left alone.
    batch.write("other/file", "")
    batch.run("--output=other", "--list")
    assert [path.name for path in (batch.folder / "other").iterdir()] == ["file"]


@pytest.mark.parametrize("words, code", [(["--list"], 0), (["--tries=1"], 75)])
def test_tables_stay_where_nothing_of_the_plan_has_a_result(batch, words, code):
    """After an update of the program, which changes all keys."""
    batch.study("a.yaml", "delay 0")
    batch.write("r.csv", "")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]\npredictions: [{of: a, recordings: r.csv}]")
    batch.run("--output=out")
    before = content(batch.folder / "out")
    assert {"results.csv", "predictions.csv"} <= set(before)
    newer = batch.write("newer", STUB.read_text().replace("\ncase $what in", "\nkill -9 $$", 1) + "# Another build.\n")
    newer.chmod(0o755)
    assert "2 missing" in batch.run("--output=out", *words, program=newer, code=code).stdout
    assert content(batch.folder / "out") == before


def test_a_list_removes_no_table(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("r.csv", "")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]\npredictions: [{of: a, recordings: r.csv}]")
    batch.run("--output=out")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]")
    batch.run("--output=out", "--list")
    assert states_in(batch) == ["done"] and (batch.folder / "out/predictions.csv").exists()


def test_warnings_of_units_are_counted_and_shown_once(batch):
    for name, fate in (("a", "warn 2.5"), ("b", "warn 3"), ("c", "delay 0")):
        batch.study(f"{name}.yaml", fate)
    batch.write("plan.yaml", "fits: [{study: '?.yaml', seeds: 1..2}]")
    outcome = batch.run("--output=out", "--json")
    shown = "study.yaml:2: warning: a damper is 2.5 times too stiff: measure it [stub-warns]"
    assert outcome.stderr == f"the unit 'a/seed1' and 3 others: {shown}\n"
    answer = json.loads(outcome.stdout)
    assert [unit["warnings"] for unit in answer["units"]] == [1, 1, 1, 1, 0, 0]
    assert answer["warnings"] == [{"id": "stub-warns", "text": "a damper is 2.5 times too stiff: measure it",
                                   "units": ["a/seed1", "a/seed2", "b/seed1", "b/seed2"]}]
    with open(batch.folder / "out/results.csv") as table:
        assert [row["warnings"] for row in csv.DictReader(table)] == list("111100")


def test_a_table_of_parameters_says_of_which_fit_they_are(starter):
    starter.write("plan.yaml", "fits:\n- {study: car/study.yaml, seeds: 3, set: {k: 21 kN/m, c_bump: 1400 N*s/m}}\n"
                               "- {study: car/study.yaml, name: own}\n")
    starter.run("--output=out", "--unpack", program=FOURPOST)
    with open(starter.folder / "out/parameters.csv") as table:
        rows = [row for row in csv.DictReader(table) if row["parameter"] == "k"]
    result = json.loads((starter.folder / "out/runs/study/seed3/result.json").read_text())
    assert [(row["unit"], row["study"], row["seed"], row["set"]) for row in rows] == [
        ("study/seed3", "study.yaml", "3", "k=21 kN/m; c_bump=1400 N*s/m"), ("own", "study.yaml", "1", "")]
    assert rows[0]["value_unit"] == "N/m" and rows[0]["explains_data"] == "true"
    assert float(rows[0]["misfit"]) == result["misfit"]


def test_tables_are_those_of_the_plan(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("r.csv", "")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]\npredictions: [{of: a, recordings: r.csv}]")
    batch.run("--output=out")
    assert (batch.folder / "out/predictions.csv").exists()
    batch.write("plan.yaml", "fits: [{study: a.yaml}]")
    batch.run("--output=out")
    assert not (batch.folder / "out/predictions.csv").exists()
