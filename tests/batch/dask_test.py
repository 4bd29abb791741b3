"""Batches by a Dask scheduler and its worker processes, which are killed, refused, full or blind."""
import os
import resource
import signal
import subprocess
import sys
import time

import pytest
from cluster import Cluster
from conftest import SOURCE, STUB, content

pytest.importorskip("distributed")
PLAN = "comparisons:\n  - {study: a.yaml, seeds: 1..%d}\n"


@pytest.fixture
def cluster(tmp_path_factory):
    cluster = Cluster(tmp_path_factory.mktemp("cluster"))
    yield cluster
    cluster.close()


def run(batch, cluster, *words, **more):
    return batch.run("--output=out", f"--on=dask:{cluster.file}", *words, **more)


def serial(batch):
    """What it must be."""
    batch.run("--output=serial", "--workers=4")
    return content(batch.folder / "serial")


def test_a_worker_of_another_build_is_refused_and_one_that_is_killed_is_replaced(batch, cluster):
    batch.study("a.yaml", "delay 0.1")
    batch.write("plan.yaml", "fits:\n  - {study: a.yaml, seeds: 1..60}\npredictions: [{of: a, recordings: plan.yaml}]\n")
    other = batch.write("other_program", STUB.read_text() + "# Another build.\n")
    other.chmod(0o755)
    for _ in range(2):
        cluster.worker(FOURPOST_PROGRAM=str(STUB))
    cluster.worker(FOURPOST_PROGRAM=str(other))
    batch_run = subprocess.Popen([sys.executable, "-m", "fourpost_batch", "--program", STUB, "--plan", "plan.yaml",
                                  "--output=out", f"--on=dask:{cluster.file}"], cwd=batch.folder, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
    end = time.monotonic() + 60
    while len(list(batch.folder.glob("out/units/*/*.json"))) < 10 and time.monotonic() < end:
        time.sleep(0.02)
    # The process that works, not the nanny that starts it again.
    killed = cluster.kill_worker(cluster.processes[1])
    printed, said = batch_run.communicate(timeout=100)
    assert batch_run.returncode == 0, said
    assert killed and "was killed by signal 9" in (cluster.folder / "log1").read_text()
    assert "120 done" in printed
    assert "[batch-worker-of-other-build]" in said and str(other) in said
    assert content(batch.folder / "out") == serial(batch)


def test_no_worker_and_no_scheduler_are_said(batch, cluster):
    batch.study("a.yaml", "delay 0.2")
    batch.write("plan.yaml", PLAN % 50)
    other = batch.write("other_program", STUB.read_text() + "# Another build.\n")
    other.chmod(0o755)
    cluster.worker(FOURPOST_PROGRAM=str(other))
    said = run(batch, cluster, code=75).stderr
    assert "[batch-no-workers]" in said and "is refused: it has 0.2.0" in said
    # A scheduler that goes away in the middle.
    cluster.worker(FOURPOST_PROGRAM=str(STUB))
    batch_run = subprocess.Popen([sys.executable, "-m", "fourpost_batch", "--program", STUB, "--plan", "plan.yaml",
                                  "--output=out", f"--on=dask:{cluster.file}"], cwd=batch.folder, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})
    end = time.monotonic() + 60
    while len(list(batch.folder.glob("out/units/*/*.json"))) < 4 and time.monotonic() < end:
        time.sleep(0.02)
    cluster.scheduler.kill()
    said = batch_run.communicate(timeout=100)[1]
    assert batch_run.returncode == 75 and "[batch-scheduler-away]" in said, said
    assert "[batch-scheduler-away]" in run(batch, cluster, code=75).stderr
    # What is there is paid no more.
    there = len(list(batch.folder.glob("out/units/*/[!.]*.json")))
    assert there >= 4 and batch.json("--output=out", "--workers=8")["work"] == {
        "found": there, "paid": 50 - there, "tried_again": 0}


def test_a_worker_with_a_full_disk_leaves(batch, cluster):
    batch.write("a.yaml", "# delay 0.02\nproblem: none\n" + "#" * 50000 + "\n")
    batch.write("plan.yaml", PLAN % 40)

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (40000, 40000))
    cluster.worker(FOURPOST_PROGRAM=str(STUB))
    cluster.worker("--no-nanny", limit=limit, FOURPOST_PROGRAM=str(STUB))
    outcome = run(batch, cluster)
    assert "[batch-worker-disk-full]" in outcome.stderr
    assert content(batch.folder / "out") == serial(batch)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can hide a folder from a process")
def test_files_are_shipped_to_workers_that_see_none(batch, cluster):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "fits: [{study: a.yaml, seeds: 1..5}]\npredictions: [{of: a, recordings: plan.yaml}]")
    (batch.folder / "out").mkdir()
    hide = ["unshare", "-m", "sh", "-c", 'mount -t tmpfs none "$0" && exec "$@"', str(batch.folder / "out")]
    if subprocess.run([*hide, "true"], capture_output=True).returncode != 0:
        pytest.skip("this machine cannot hide a folder from a process")
    cluster.worker(before=hide, FOURPOST_PROGRAM=str(STUB))
    said = run(batch, cluster, code=75).stderr
    assert "[batch-no-workers]" in said and "does not see" in said
    cluster.worker(before=hide, FOURPOST_PROGRAM=str(STUB))
    run(batch, cluster, "--ship")
    assert content(batch.folder / "out") == serial(batch)
