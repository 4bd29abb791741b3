"""Workers that mpirun, srun or a shell started on one plan: they share its units, and the last one speaks for all."""
import os
import shutil
import subprocess
import sys

import pytest
from conftest import SOURCE, STUB, content, states_in


def test_workers_of_a_launcher_share_the_units(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("r.csv", "")
    batch.write("plan.yaml", "fits: [{study: a.yaml, seeds: 1..7}]\npredictions: [{of: a, recordings: r.csv}]")
    batch.run("--output=serial")
    paid = [batch.json("--output=out", "--on=launcher", FOURPOST_BATCH_SHARE=f"{rank}/3")["work"]["paid"]
            for rank in range(3)]
    assert sorted(paid) == [4, 4, 6]
    # The last one wrote the tables.
    assert content(batch.folder / "out") == content(batch.folder / "serial")
    assert "[batch-launcher-unknown]" in batch.run("--output=out", "--on=launcher", code=2).stderr


def test_the_last_worker_of_a_launcher_speaks_for_all(batch):
    """mpirun ends the others where one ends with another code than 0."""
    batch.study("a.yaml", "code 3")
    batch.study("b.yaml", "warn 2")
    batch.write("plan.yaml", "fits: [{study: a.yaml}, {study: b.yaml}]")
    first = batch.run("--output=out", "--on=launcher", FOURPOST_BATCH_SHARE="0/2")
    assert first.stderr == ""
    last = batch.run("--output=out", "--on=launcher", code=1, FOURPOST_BATCH_SHARE="1/2").stderr
    assert "[stub-warns]" in last and "[batch-unit-failed]" in last


def test_a_worker_of_a_launcher_that_gives_up_leaves_it_to_the_last_to_say(batch):
    batch.study("a.yaml", "code 137")
    batch.study("b.yaml", "delay 0")
    batch.write("plan.yaml", "fits: [{study: '?.yaml'}]\npredictions: [{of: '*', recordings: plan.yaml}]")
    # Again, as the same command is what the last one asks for.
    for _ in range(2):
        first = batch.run("--output=out", "--on=launcher", "--tries=2", FOURPOST_BATCH_SHARE="0/2")
        assert first.stderr == "" and len(list(batch.folder.glob("out/launched/*/0.json"))) == 1
        last = batch.run("--output=out", "--on=launcher", code=75, FOURPOST_BATCH_SHARE="1/2").stderr
        assert "no result for the unit 'a': code 137: " in last and last.count("[batch-unit-lost]") == 1
        assert states_in(batch) == ["done"] * 2 + ["missing"] * 2
        assert list((batch.folder / "out/launched").iterdir()) == []


def test_a_worker_of_a_launcher_without_the_program_ends_nobody(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "comparisons: [{study: a.yaml, seeds: 1..4}]")
    first = batch.run("--output=out", "--on=launcher", FOURPOST_BATCH_SHARE="0/2", FOURPOST_PROGRAM="/no/program").stderr
    assert first.count("[batch-worker-lacks-program]") == 1
    last = batch.run("--output=out", "--on=launcher", code=75, FOURPOST_BATCH_SHARE="1/2").stderr
    assert "the unit 'compare/a/seed1' and 1 other: its worker has no program fourpost: " in last


def test_marks_of_workers_that_were_killed_are_not_of_the_next_start(batch):
    batch.study("a.yaml", "code 137")
    batch.study("b.yaml", "delay 0")
    batch.write("plan.yaml", "fits: [{study: '?.yaml'}]")

    def worker(rank, step, code=0):
        names = {"SLURM_PROCID": str(rank), "SLURM_NTASKS": "2", "SLURM_JOB_ID": "7", "SLURM_STEP_ID": str(step)}
        return batch.run("--output=out", "--on=launcher", "--tries=1", code=code, **names).stderr
    # The other one of the first start was killed; the first one to end of the next start does not speak for it.
    assert worker(0, step=0) == worker(1, step=1) == ""
    assert "[batch-unit-lost]" in worker(0, step=1, code=75)


def test_the_last_worker_of_a_launcher_knows_units_that_are_blocked(batch):
    batch.study("a.yaml", "code 3")
    batch.write("plan.yaml", "fits: [{study: a.yaml}]\npredictions: [{of: a, recordings: plan.yaml}]")
    last = batch.run("--output=out", "--on=launcher", code=1, FOURPOST_BATCH_SHARE="0/1").stderr
    assert "[batch-unit-failed]" in last and "[batch-unit-blocked]" in last and states_in(batch) == ["blocked", "failed"]


@pytest.mark.skipif(shutil.which("mpirun") is None, reason="needs mpirun")
def test_mpirun_does_not_end_the_others_for_a_unit_that_was_given_up(batch):
    batch.study("a.yaml", "code 137")
    batch.study("b.yaml", "delay 3")
    batch.write("plan.yaml", "fits: [{study: '?.yaml'}]")
    command = ["mpirun", "--oversubscribe", "-n", "2", sys.executable, "-m", "fourpost_batch", "--program", STUB,
               "--plan=plan.yaml", "--output=out", "--on=launcher", "--tries=1"]
    as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    outcome = subprocess.run(command, cwd=batch.folder, capture_output=True, text=True, timeout=100,
                             env={**os.environ, **as_root, "PYTHONPATH": str(SOURCE / "python")})
    assert outcome.returncode == 75 and "no result for the unit 'a'" in outcome.stderr, outcome.stderr
    assert states_in(batch) == ["done", "missing"]
