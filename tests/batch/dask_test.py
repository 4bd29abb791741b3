"""Batches by a Dask scheduler and its worker processes, which are killed, refused, full or blind."""
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

import pytest
from cluster import Cluster, command_of
from conftest import SOURCE, STUB, content

from fourpost_batch import Program, Store, expand, read_plan
from fourpost_batch import run as run_units
from fourpost_batch.work import Workplace

distributed = pytest.importorskip("distributed")
dask_plant = pytest.importorskip("fourpost_batch.dask_plant")
dask_crew = pytest.importorskip("fourpost_batch.dask_crew")
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
    batch.write("plan.yaml", "fits:\n  - {study: a.yaml, seeds: 1..30}\npredictions: [{of: a, recordings: plan.yaml}]\n")
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
    assert "60 done" in printed
    assert "[batch-worker-of-other-build]" in said and str(other) in said
    # Another batch may be of its build.
    assert cluster.processes[3].poll() is None and cluster.working(cluster.processes[3])
    assert content(batch.folder / "out") == serial(batch)


def test_batches_of_different_builds_share_a_scheduler(batch, cluster):
    """Each has its worker, which is killed once; each ends as a serial run, and sends nobody away."""
    other = batch.write("other_program", STUB.read_text() + "# Another build.\n")
    other.chmod(0o755)
    programs = {"a": STUB, "b": other}
    for name, program in programs.items():
        batch.study(f"{name}.yaml", "delay 0.1")
        batch.write(f"{name}.plan", f"fits: [{{study: {name}.yaml, seeds: 1..20}}]\n"
                                    f"predictions: [{{of: {name}, recordings: a.yaml}}]\n")
        cluster.worker(FOURPOST_PROGRAM=str(program))
    both = {name: start(batch, cluster, f"{name}.plan", name, program) for name, program in programs.items()}
    for name in "ab":
        wait_for(batch, name, 5)
    killed = [cluster.kill_worker(nanny) for nanny in cluster.processes[1:]]
    for one in both.values():
        printed, said = one.communicate(timeout=100)
        assert one.returncode == 0 and "40 done" in printed, said
        assert said.count("[batch-worker-of-other-build]") >= 1
    assert killed == [True, True] and all(cluster.working(nanny) for nanny in cluster.processes[1:])
    assert plugins(cluster) == []
    for name, program in programs.items():
        batch.write("plan.yaml", (batch.folder / f"{name}.plan").read_text())
        batch.run("--output=serial_" + name, "--workers=4", program=program)
        assert content(batch.folder / name) == content(batch.folder / f"serial_{name}")


def test_no_worker_and_no_scheduler_are_said(batch, cluster):
    batch.study("a.yaml", "delay 0.2")
    batch.write("plan.yaml", PLAN % 25)
    other = batch.write("other_program", STUB.read_text() + "# Another build.\n")
    other.chmod(0o755)
    cluster.worker(FOURPOST_PROGRAM=str(other))
    said = run(batch, cluster, code=75).stderr
    assert "[batch-no-workers]" in said and "is refused: it has 0.2.0" in said
    assert f"waits for workers of {cluster.file}" in said
    misspelt = batch.run("--output=out", f"--on=dask:{cluster.folder}/schduler.json", code=75).stderr
    assert ", did you mean 'scheduler.json'?" in misspelt and "[batch-scheduler-away]" in misspelt
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
    assert batch_run.returncode == 75 and "[batch-scheduler-away]" in said and "Traceback" not in said, said
    assert "[batch-scheduler-away]" in run(batch, cluster, code=75).stderr
    # What is there is paid no more.
    there = len(list(batch.folder.glob("out/units/*/[!.]*.json")))
    assert there >= 4 and batch.json("--output=out", "--workers=8")["work"] == {
        "found": there, "paid": 25 - there, "tried_again": 0}


def start(batch, cluster, plan, output, program=STUB):
    """A batch that goes on meanwhile."""
    return subprocess.Popen([sys.executable, "-m", "fourpost_batch", "--program", program, f"--plan={plan}",
                             f"--output={output}", f"--on=dask:{cluster.file}"], cwd=batch.folder, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            env={**os.environ, "PYTHONPATH": str(SOURCE / "python")})


def plugins(cluster):
    """Names of those of batches at the scheduler."""
    with distributed.Client(scheduler_file=str(cluster.file), set_as_default=False) as client:
        names = client.run_on_scheduler(lambda dask_scheduler: list(dask_scheduler.worker_plugins))
    return [name for name in names if "fourpost" in name]


def test_batches_share_a_scheduler(batch, cluster):
    """One that ends, or is killed, leaves nothing that another would meet."""
    batch.study("a.yaml", "delay 0.1")
    batch.study("b.yaml", "delay 0.1")
    for name in "ab":
        batch.write(f"{name}.plan", f"comparisons: [{{study: {name}.yaml, seeds: 1..20}}]")
    cluster.worker(FOURPOST_PROGRAM=str(STUB))
    killed = start(batch, cluster, "a.plan", "killed")
    wait_for(batch, "killed", 2)
    killed.kill()
    killed.communicate()
    assert len(plugins(cluster)) == 1
    # Nobody sends this one away.
    other = batch.write("other_program", STUB.read_text() + "# Another build.\n")
    other.chmod(0o755)
    cluster.worker(FOURPOST_PROGRAM=str(other))
    batch.write("plan.yaml", "comparisons: [{study: a.yaml}]")
    batch.run("--output=other", f"--on=dask:{cluster.file}", program=other)
    cluster.worker(FOURPOST_PROGRAM=str(STUB))
    both = [start(batch, cluster, f"{name}.plan", name) for name in "ab"]
    for one in both:
        said = one.communicate(timeout=100)[1]
        assert one.returncode == 0, said
    assert plugins(cluster) == []
    for name in "ab":
        batch.write("plan.yaml", (batch.folder / f"{name}.plan").read_text())
        batch.run("--output=serial_" + name, "--workers=4")
        assert content(batch.folder / name) == content(batch.folder / f"serial_{name}")


def test_a_batch_that_another_one_took_for_killed_goes_on(batch, cluster):
    """As one does that begins while the client of this one connects anew."""
    batch.study("a.yaml", "delay 0.1")
    expanded = expand(read_plan(batch.write("plan.yaml", PLAN % 6)), Program(STUB))
    store = Store.make(batch.folder / "out")
    for digest, path in expanded.sources.items():
        store.add_file(path, digest)
    cluster.worker(FOURPOST_PROGRAM=str(STUB))
    place = Workplace(str(store.folder), store.id, Program(STUB).build, str(STUB))
    place.store = store
    forgotten = []

    def forget(tally, left):
        with distributed.Client(scheduler_file=str(cluster.file), set_as_default=False) as client:
            for name in plugins(cluster) if not forgotten else []:
                client.unregister_worker_plugin(name)
                forgotten.append(name)
    crew = dask_crew.DaskCrew(str(cluster.file), place)
    try:
        tally = run_units(expanded.units, store, crew, tries=4, progress=forget)
    finally:
        crew.close()
    assert forgotten and not tally.lost and tally.paid == 6
    assert plugins(cluster) == []


def test_ctrl_c_ends_units_that_run(batch, cluster):
    batch.study("a.yaml", "delay 600")
    batch.write("plan.yaml", PLAN % 3)
    cluster.worker(FOURPOST_PROGRAM=str(STUB), FOURPOST_BATCH_JOURNAL=str(batch.folder / "journal"))
    one = start(batch, cluster, "plan.yaml", "out")
    end = time.monotonic() + 60
    while not (batch.folder / "journal").exists() and time.monotonic() < end:
        time.sleep(0.05)
    nanny = cluster.processes[1]
    worker, = cluster.working(nanny)
    one.send_signal(signal.SIGINT)
    assert "interrupted" in one.communicate(timeout=60)[1] and one.returncode == 130
    end = time.monotonic() + 20
    while units_of(worker) and time.monotonic() < end:
        time.sleep(0.05)
    assert not units_of(worker) and cluster.working(nanny) == [worker]
    assert "missing" in (batch.folder / "out/results.csv").read_text()


def units_of(worker):
    children = [path.read_text().split() for path in pathlib.Path(f"/proc/{worker}/task").glob("*/children")]
    return [pid for pids in children for pid in pids if "compare" in command_of(int(pid))]


def wait_for(batch, output, count):
    end = time.monotonic() + 60
    while len(list(batch.folder.glob(f"{output}/units/*/*.json"))) < count and time.monotonic() < end:
        time.sleep(0.02)


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
