"""Batches on this machine: results are those of the program, whoever is killed meanwhile."""
import json
import os
import random
import re
import resource
import signal
import subprocess
import sys
import threading
import time

import pytest
from conftest import FOURPOST, SOURCE, STUB, content, states_in

from fourpost_batch import Program, Store, Unit, expand, read_plan, run
from fourpost_batch.errors import Trouble
from fourpost_batch.launcher import run_launched
from fourpost_batch.slurm import run_share
from fourpost_batch.unit import result_text
from fourpost_batch.work import Workplace

PLAN = "comparisons:\n  - {study: a.yaml, seeds: 1..%d}\n"


def test_results_are_those_of_the_program(starter):
    starter.write("settings.yaml", "knobs: {spring: {sets: k, values: [18 kN/m, 22 kN/m]}}\nduration: 5 s\ndraws: 20\n")
    starter.write("plan.yaml", "fits: [{study: car/study.yaml, seeds: 1..2}]\n"
                               "predictions: [{of: study, recordings: car/stepped_sine.csv}]\n"
                               "choices: [{of: study, settings: settings.yaml, checks: false}]\n"
                               "keep: ['*.csv', '*.svg', report.html]\n")
    answer = starter.json("--output=out", "--unpack", program=FOURPOST)
    assert answer["counts"] == {"done": 6, "failed": 0, "blocked": 0, "missing": 0} and answer["work"]["paid"] == 6

    def say(*words):
        return subprocess.run([FOURPOST, *words], cwd=starter.folder, capture_output=True, text=True).stdout
    say("fit", "car/study.yaml", "-o", "run", "--seed", "2")
    runs = starter.folder / "out/runs/study"
    for name in ("result.json", "vehicle.urdf", "report.html", "response.csv"):
        assert (runs / "seed2" / name).read_bytes() == (starter.folder / "run" / name).read_bytes(), name
    printed = say("fit", "car/study.yaml", "-o", "fourpost_fit", "--seed", "2", "--threads", "1")
    assert (runs / "seed2/printed.txt").read_text() == printed != ""
    prediction = say("predict", "run", "--recording", "car/stepped_sine.csv", "--json")
    assert (runs / "seed2/predict/stepped_sine/result.json").read_text() == prediction
    chosen = json.loads(say("choose", "run", "--settings", "settings.yaml", "--no-checks", "--json"))
    of_batch = json.loads((runs / "seed2/choose/settings/result.json").read_text())
    assert {**of_batch, "run": "run"} == chosen
    # Serial, elsewhere: the same bytes.
    starter.run("--output=other", "--workers=1", program=FOURPOST)
    assert content(starter.folder / "other") == content(starter.folder / "out")
    # All is there.
    assert starter.json("--output=out", program=FOURPOST)["work"] == {"found": 6, "paid": 0, "tried_again": 0}


def units_running(text):
    """Numbers of processes of units with this word in their command."""
    found = []
    for name in os.listdir("/proc"):
        try:
            if name.isdigit() and text in open(f"/proc/{name}/cmdline").read() and "unit-" in os.readlink(f"/proc/{name}/cwd"):
                found.append(int(name))
        except OSError:
            pass
    return found


def test_half_of_the_workers_are_killed_again_and_again(batch):
    batch.study("a.yaml", "delay 0.1")
    batch.write("plan.yaml", PLAN % 60)
    batch.run("--output=serial", "--workers=4")
    journal = batch.folder / "journal"
    batch_run = threading.Thread(target=lambda: batch.run("--output=out", "--workers=4", "--tries=100",
                                                          FOURPOST_BATCH_JOURNAL=str(journal)))
    draw, kills = random.Random(1), 0
    batch_run.start()
    while batch_run.is_alive() and kills < 10:
        time.sleep(draw.uniform(0.03, 0.12))
        mine = units_running(f"{STUB}\0compare")
        for number in draw.sample(mine, (len(mine) + 1) // 2):
            try:
                os.kill(number, signal.SIGKILL)
                kills += 1
            except ProcessLookupError:
                pass
    batch_run.join()
    assert kills >= 10
    assert content(batch.folder / "out") == content(batch.folder / "serial")
    lines = [line.split() for line in journal.read_text().splitlines()]
    paid = [key for _, what, key, _ in lines if what == "paid"]
    # Nothing lost, nothing twice; what was begun and not paid was killed.
    assert len(paid) == len(set(paid)) == 60
    assert 60 < sum(what == "begin" for _, what, _, _ in lines) <= 60 + kills


def test_a_killed_batch_goes_on(batch):
    batch.study("a.yaml", "delay 0.1")
    batch.write("plan.yaml", PLAN % 20)
    command = [sys.executable, "-m", "fourpost_batch", "--program", STUB, "--plan", "plan.yaml", "--output=out",
               "--workers=2"]
    program = subprocess.Popen(command, cwd=batch.folder, env={**os.environ, "PYTHONPATH": str(SOURCE / "python")},
                               stdout=subprocess.DEVNULL)
    end = time.monotonic() + 60
    while len(list(batch.folder.glob("out/units/*/*.json"))) < 4 and time.monotonic() < end:
        time.sleep(0.02)
    program.kill()
    program.wait()
    there = len(list(batch.folder.glob("out/units/*/[!.]*.json")))
    answer = batch.json("--output=out")
    assert there >= 4 and answer["work"] == {"found": there, "paid": 20 - there, "tried_again": 0}
    batch.run("--output=whole")
    assert content(batch.folder / "out") == content(batch.folder / "whole")


def test_ctrl_c_keeps_what_there_is(batch):
    batch.study("a.yaml", "delay 0")
    batch.study("b.yaml", "delay 600")
    batch.write("plan.yaml", "comparisons: [{study: [a.yaml, b.yaml], seeds: 1..4}]")
    command = [sys.executable, "-m", "fourpost_batch", "--program", STUB, "--plan", "plan.yaml", "--output=out"]
    program = subprocess.Popen(command, cwd=batch.folder, env={**os.environ, "PYTHONPATH": str(SOURCE / "python")},
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + 60
    while not list(batch.folder.glob("out/units/*/*.json")) and time.monotonic() < end:
        time.sleep(0.02)
    program.send_signal(signal.SIGINT)
    # Nor does it wait for units of minutes.
    assert "interrupted" in program.communicate(timeout=60)[1] and program.returncode == 130
    there = len(list(batch.folder.glob("out/units/*/[!.]*.json")))
    assert there and states_in(batch) == ["done"] * there + ["missing"] * (8 - there)


def test_a_unit_that_begins_as_others_are_stopped_is_ended(batch):
    batch.study("a.yaml", "delay 5")
    unit, = expand(read_plan(batch.write("plan.yaml", PLAN % 1)), Program(STUB)).units
    store = Store.make(batch.folder / "out")
    store.add_file(batch.folder / "a.yaml", unit.inputs[0][1])
    workplace = Workplace(str(store.folder), store.id, unit.build, str(STUB))
    workplace.stop()
    with pytest.raises(Trouble, match="SIGKILL"):
        workplace.run(unit)


def test_a_unit_that_always_dies_is_given_up(batch):
    batch.study("a.yaml", "code 137")
    batch.study("b.yaml", "delay 0")
    batch.study("c.yaml", f"once {batch.folder}/was_here")
    batch.write("plan.yaml", "fits: [{study: '?.yaml'}]\npredictions: [{of: '*', recordings: plan.yaml}]")
    outcome = batch.run("--output=out", "--tries=3", code=75)
    assert "no result for the unit 'a': code 137: " in outcome.stderr and "[batch-unit-lost]" in outcome.stderr
    answer = batch.json("--output=out", "--tries=3", code=75)
    assert [unit["state"] for unit in answer["units"]] == ["missing", "done", "done", "missing", "done", "done"]
    assert answer["work"] == {"found": 4, "paid": 0, "tried_again": 3}


def test_a_unit_that_fails_by_its_inputs_is_a_result(batch):
    batch.study("a.yaml", "code 3")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]\npredictions: [{of: a, recordings: plan.yaml}]")
    for paid in (1, 0):
        outcome = batch.run("--output=out", "--json", code=1)
        answer = json.loads(outcome.stdout)
        assert answer["counts"] == {"done": 0, "failed": 1, "blocked": 1, "missing": 0}
        assert answer["work"]["paid"] == paid
        assert "study.yaml:2: error: it was to fail" in outcome.stderr
        assert "[batch-unit-failed]" in outcome.stderr and "[batch-unit-blocked]" in outcome.stderr


def test_a_defect_of_the_program_is_not_met_again(batch):
    batch.study("a.yaml", "code 70")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]")
    for paid in (1, 0):
        outcome = batch.run("--output=out", "--json", code=1)
        answer = json.loads(outcome.stdout)
        assert answer["counts"]["failed"] == 1 and answer["work"] == {"found": 1 - paid, "paid": paid, "tried_again": 0}
        # Its input is not what is to be corrected.
        kept = re.search(r"the unit 'a' met a defect of fourpost: .*: report it with the input and (units/\S+json), .* "
                         r"\[batch-unit-defect\]$", outcome.stderr.strip())[1]
        assert "[stub-failed]" in (batch.folder / "out" / kept).read_text() and "correct the input" not in outcome.stderr


def test_a_reason_is_said_once(batch):
    batch.study("a.yaml", "code 3")
    batch.study("b.yaml", "code 4")
    batch.write("plan.yaml", "fits: [{study: a.yaml, seeds: 1..3}, {study: b.yaml}]\n"
                             "predictions: [{of: b, recordings: [plan.yaml, a.yaml]}]")
    said = batch.run("--output=out", code=1).stderr.splitlines()
    assert [line.split(":")[1] for line in said] == [
        " the unit 'a/seed1' and 2 others ended with code 3", " the unit 'b' ended with code 4",
        " the unit 'b/predict/plan' and 1 other cannot run, as 'b' has no fit"]


def test_the_same_work_is_done_once(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "fits: [{study: a.yaml, name: one}, {study: a.yaml, name: two}]")
    answer = batch.json("--output=out")
    assert answer["counts"]["done"] == 2 and answer["work"]["paid"] == 1
    page = (batch.folder / "out/progress.html").read_text()
    assert "Ended on local" in page and "computed now</td><td>1<" in page


def test_a_result_that_a_shared_folder_shows_later_is_waited_for(tmp_path):
    unit = Unit("a", "comparison", ("{program}",), (), "b")
    needs = Unit("c", "prediction", ("{program}",), (), "b", after=unit.key)
    store = Store.make(tmp_path / "out")

    class Crew:
        stops_at, carries, asked = (), False, []

        def send(self, units):
            self.asked += [unit for unit, _ in units]

        def receive(self):
            key = self.asked.pop().key
            text = result_text(key, {"code": 0, "printed": "", "files": {}, "messages": []})
            threading.Timer(0.3, store.put, (key, text)).start()
            return key, ("paid", None)

        def warnings(self):
            return []
    tally = run([unit, needs], store, Crew())
    assert tally.paid == 2 and not tally.lost and store.has(needs.key)


def test_an_altered_result_is_computed_again(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", PLAN % 3)
    batch.run("--output=out")
    before = content(batch.folder / "out")
    next(batch.folder.glob("out/units/*/*.json")).write_text("{}")
    outcome = batch.run("--output=out", "--json")
    assert json.loads(outcome.stdout)["work"]["paid"] == 1 and "warning: 1 results were altered" in outcome.stderr
    assert content(batch.folder / "out") == before


@pytest.mark.parametrize("size", [1000, 60])
def test_a_full_disk_ends_a_local_batch_and_keeps_what_is_there(batch, size):
    """Of the worker, whose program answers 5, and of the batch's folder, where no file may be longer than this."""
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "comparisons: [{study: a.yaml, seeds: 1..5}]")
    batch.run("--output=out")
    before = content(batch.folder / "out")
    batch.study("b.yaml", "code 5")
    batch.write("plan.yaml", "comparisons: [{study: [a.yaml, %s.yaml], seeds: 1..6}]" % ("b" if size == 1000 else "a"))
    if size == 1000:
        outcome = batch.run("--output=out", code=5)
        assert "[batch-worker-disk-full]" in outcome.stderr
    else:
        batch.write("plan.yaml", "comparisons: [{study: a.yaml, seeds: 1..6}]")
        command = [sys.executable, "-m", "fourpost_batch", "--program", STUB, "--plan", "plan.yaml", "--output=out"]
        limit = lambda: (signal.signal(signal.SIGXFSZ, signal.SIG_IGN),  # noqa: E731
                         resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        outcome = subprocess.run(command, cwd=batch.folder, preexec_fn=limit, capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
        assert outcome.returncode == 5 and "batch" in outcome.stderr
    kept = content(batch.folder / "out")
    assert {name: text for name, text in kept.items() if name in before and name.startswith("units")} == {
        name: text for name, text in before.items() if name.startswith("units")}


def test_coverage_is_a_script_of_a_number(batch):
    batch.write("cars.py", "import sys, helper\nprint('number,square')\nprint(f'{sys.argv[2]},{helper.square(int(sys.argv[2]))}')\n")
    batch.write("helper.py", "def square(x): return x * x\n")
    batch.write("plan.yaml", "coverage: [{script: cars.py, files: helper.py, arguments: ['{program}', '{number}'], "
                             "numbers: 2..4}]")
    batch.run("--output=out", "--unpack")
    assert (batch.folder / "out/coverage.csv").read_text() == "number,square\n2,4\n3,9\n4,16\n"
    assert (batch.folder / "out/runs/cars/3/result.csv").read_text() == "number,square\n3,9\n"


def test_a_script_that_ends_by_itself_is_not_tried_again(batch):
    batch.write("cars.py", f"open('{batch.folder}/began', 'a').write('x')\nraise SystemExit(1)\n")
    batch.write("plan.yaml", "coverage: [{script: cars.py, arguments: [], numbers: 1}]")
    assert batch.json("--output=out", code=1)["counts"]["failed"] == 1
    assert (batch.folder / "began").read_text() == "x"


def test_a_full_folder_ends_the_share_of_a_worker(batch, monkeypatch):
    """Of a task of Slurm's, and of a launcher's worker: what is computed could not be kept."""
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", PLAN % 5)
    units = list(expand(read_plan(batch.folder / "plan.yaml"), Program(STUB)).units)
    store = Store.make(batch.folder / "out")
    computed = []
    monkeypatch.setattr(Workplace, "run", lambda self, unit: computed.append(unit) or ("paid", b"result"))
    workplace = Workplace(str(store.folder), store.id, units[0].build, str(STUB))
    troubles = batch.folder / "troubles/0.json"
    assert not run_share(units, workplace, troubles)
    assert [one["kind"] for one in json.loads(troubles.read_text())] == ["disk"] and len(computed) == 1
    monkeypatch.setenv("FOURPOST_BATCH_SHARE", "0/1")
    tally, _ = run_launched(units, workplace, 3, lambda tally, left: None)
    # All that it leaves undone.
    assert [trouble.kind for trouble in tally.lost.values()] == ["disk"] * 5 and len(computed) == 2


def test_the_example_of_python_runs(starter):
    starter.write("plan.yaml", "fits: [{study: car/study.yaml}]")
    block = re.search(r"^```python\n(.*?)^```", (SOURCE / "docs/batch.md").read_text(), re.S | re.M)[1]
    script = block.replace("build/release/fourpost", FOURPOST) + "print(results['study']['code'])\n"
    outcome = subprocess.run([sys.executable, "-c", script], cwd=starter.folder, capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
    assert outcome.stdout == "0\n", outcome.stderr


def test_the_plan_of_how_to_runs(starter):
    plan = re.search(r"^```yaml\n(# plan.yaml.*?)^```", (SOURCE / "docs/how_to.md").read_text(), re.S | re.M)[1]
    starter.write("plan.yaml", plan)
    assert starter.json("--output=out", program=FOURPOST)["counts"]["done"] == 8


def test_a_misspelt_place_is_asked_about(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", PLAN % 1)
    assert ", did you mean 'slurm'? write one of local, " in batch.run("--output=out", "--on=slrum", code=2).stderr
    assert ", did you mean 'dask:'?" in batch.run("--output=out", "--on=dusk://head:8786", code=2).stderr


def test_the_program_refuses_what_it_cannot_run(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", PLAN % 2)

    def say(*words, **environment):
        return subprocess.run([FOURPOST, "batch", *words], cwd=batch.folder, capture_output=True, text=True,
                              env={**os.environ, **environment})
    for words, code, id in ((["-o", "out"], 2, "batch-without-plan"), (["plan.yaml"], 2, "batch-without-output"),
                            (["plan.yaml", "-o", "out", "--on", "moon"], 2, "batch-place-unknown"),
                            (["plan.yml", "-o", "out"], 3, "batch-file-missing"),
                            (["plan.yaml", "-o", "."], 3, "batch-folder-other")):
        outcome = say(*words)
        assert outcome.returncode == code and f"[{id}]" in outcome.stderr, outcome.stderr
    outcome = say("plan.yaml", "-o", "out", FOURPOST_PYTHON="/no/python")
    assert outcome.returncode == 3 and "[batch-without-python]" in outcome.stderr
    outcome = say("plan.yaml", "-o", "out", "--on", "slurm", PATH="/nowhere")
    assert outcome.returncode == 2 and "slurm-client [batch-lacks-package]" in outcome.stderr
    (batch.folder / "lacking/yaml.py").parent.mkdir()
    for module, on in (("yaml", "local"), ("distributed", "dask://127.0.0.1:9")):
        for path in (batch.folder / "lacking").iterdir():
            path.unlink()
        (batch.folder / f"lacking/{module}.py").write_text("raise ImportError")
        outcome = say("plan.yaml", "-o", "out", "--on", on, PYTHONPATH=str(batch.folder / "lacking"))
        assert outcome.returncode == 2 and "[batch-lacks-package]" in outcome.stderr, outcome.stderr
