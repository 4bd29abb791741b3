#!/usr/bin/env python3
"""Batches by real schedulers on this machine, as CSV: results equal to those of a serial run, nothing lost, nothing paid
twice, and the efficiency. See README.md.

  demonstration.py PROGRAM --of efficiency,equal,kills > dask.csv
  slurm_here 8 demonstration.py PROGRAM --on slurm > slurm.csv
  slurm_here 8 demonstration.py PROGRAM --on srun --of equal > srun.csv
"""
import argparse
import csv
import os
import pathlib
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

from cluster import Cluster

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
STUB = HERE / "stub_program"
FITS = "fits:\n  - {study: car/study.yaml, seeds: 1..%d}\npredictions:\n  - {of: '*', recordings: car/stepped_sine.csv}\n"
WAITS = "comparisons:\n  - {study: wait.yaml, seeds: 1..%d}\n"


class Trial:
    """A folder with a plan; batches of it into folders of their own."""

    def __init__(self, folder, program, plan, delay=0.0):
        self.folder, self.program = folder, program
        (folder / "plan.yaml").write_text(plan)
        (folder / "wait.yaml").write_text(f"# delay {delay}\nproblem: none\n")
        if not (folder / "car").exists():
            shutil.copytree(SOURCE / "studies/starter", folder / "car")

    def run(self, output, *words, environment=None):
        command = [sys.executable, "-m", "fourpost_batch", "--program", self.program, "--plan", "plan.yaml",
                   f"--output={output}", *words]
        begin = time.monotonic()
        outcome = subprocess.run([str(word) for word in command], cwd=self.folder, capture_output=True, text=True,
                                 env={**os.environ, "PYTHONPATH": str(SOURCE / "python"), **(environment or {})})
        if outcome.returncode != 0:
            raise RuntimeError(outcome.stderr[-2000:])
        return time.monotonic() - begin

    def content(self, output):
        folder = self.folder / output
        return {str(path.relative_to(folder)): path.read_bytes()
                for path in [*folder.glob("units/*/[!.]*"), *folder.glob("*.csv")]}


def accounts(journal):
    """Units paid, paid more than once, begun; and the span from the first begun to the last paid [s]."""
    lines = [line.split() for line in journal.read_text().splitlines()]
    paid = [key for _, what, key, _ in lines if what == "paid"]
    return len(paid), len(paid) - len(set(paid)), sum(what == "begin" for _, what, _, _ in lines), \
        float(lines[-1][0]) - float(lines[0][0])


def cluster_of(folder, workers, program):
    """Workers write into the journal of the folder."""
    (folder / "journal").write_text("")
    cluster = Cluster(folder)
    for _ in range(workers):
        cluster.worker(FOURPOST_PROGRAM=str(program), FOURPOST_BATCH_JOURNAL=str(folder / "journal"))
    end = time.monotonic() + 120
    while sum("Registered to" in path.read_text() for path in folder.glob("log*")) < workers and time.monotonic() < end:
        time.sleep(0.1)
    return cluster


def on_dask(trial, workers, output, meanwhile=lambda cluster: None, tries=10):
    """Of one batch on a scheduler with so many workers: accounts(), and whether its results are those of `serial`."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        cluster = cluster_of(folder, workers, trial.program)
        try:
            other = threading.Thread(target=meanwhile, args=(cluster,), daemon=True)
            other.start()
            seconds = trial.run(output, f"--on=dask:{cluster.file}", f"--tries={tries}")
            other.join()
        finally:
            cluster.close()
        return *accounts(folder / "journal"), seconds, trial.content(output) == trial.content("serial")


def on_slurm(trial, workers, output, meanwhile=lambda cluster: None, tries=10):
    """The same of arrays of so many tasks; of srun and mpirun of workers that these start."""
    journal = trial.folder / f"journal_{output}"
    environment = {**os.environ, "PYTHONPATH": str(SOURCE / "python"), "FOURPOST_BATCH_JOURNAL": str(journal)}
    other = threading.Thread(target=meanwhile, args=(None,), daemon=True)
    other.start()
    begin = time.monotonic()
    if ON == "slurm":
        trial.run(output, "--on=slurm", f"--workers={workers}", f"--tries={tries}", environment=environment)
    else:
        launcher = ["srun"] if ON == "srun" else ["mpirun", "--allow-run-as-root", "--oversubscribe"]
        subprocess.run([*launcher, "-n", str(workers), trial.program, "batch", "--plan=plan.yaml" if trial.program == STUB
                        else "plan.yaml", f"--output={output}", "--on=launcher"], cwd=trial.folder, env=environment,
                       check=True, stdout=subprocess.DEVNULL)
    seconds = time.monotonic() - begin
    other.join()
    return *accounts(journal), seconds, trial.content(output) == trial.content("serial")


ON = "dask"


def on_place(*arguments):
    return (on_dask if ON == "dask" else on_slurm)(*arguments)


def kill_tasks(draw):
    """SIGKILL for half of the tasks of arrays that run."""
    tasks = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = path.read_text().split("\0")
        except OSError:
            continue
        if "fourpost_batch" in words and any(word.startswith("--task=") or word == "--task" for word in words):
            tasks.append(int(path.parent.name))
    killed = 0
    for task in draw.sample(tasks, (len(tasks) + 1) // 2):
        try:
            os.kill(task, signal.SIGKILL)
            killed += 1
        except ProcessLookupError:
            pass
    return killed


def killer(rounds, output):
    """Kills half of the workers `rounds` times, at random moments while units are missing."""
    draw, killed = random.Random(1), []

    def kill(cluster):
        nannies = cluster.processes[1:] if cluster else []
        while not list(output.glob("units/*/*")):
            time.sleep(0.1)
        while len(killed) < rounds and not (output / "results.csv").exists():
            time.sleep(draw.uniform(0.5, 2.5))
            count = sum(cluster.kill_worker(nanny) for nanny in draw.sample(nannies, len(nannies) // 2)) if cluster else (
                kill_tasks(draw))
            if count:
                killed.append(count)
    return kill, killed


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("program")
    arguments.add_argument("--of", default="efficiency,equal,kills")
    arguments.add_argument("--workers", default="1,2,4,8")
    arguments.add_argument("--delays", default="0.05,0.2")
    arguments.add_argument("--fits", type=int, default=60)
    arguments.add_argument("--rounds", type=int, default=20)
    arguments.add_argument("--on", choices=["dask", "slurm", "srun", "mpirun"], default="dask")
    options = arguments.parse_args()
    global ON
    ON = options.on
    out = csv.writer(sys.stdout, lineterminator="\n")
    print("# " + " ".join(["tests/batch/demonstration.py", "PROGRAM", *sys.argv[2:]]))
    out.writerow(["of", "workers", "unit_s", "units", "span_s", "whole_s", "efficiency", "kills", "begun", "paid", "twice",
                  "equal"])
    workers = [int(word) for word in options.workers.split(",")]
    for part in options.of.split(","):
        if part == "efficiency":
            for delay in map(float, options.delays.split(",")):
                efficiency(out, delay, workers)
        else:
            fits(out, part, options, workers)
    return 0


def alone(folder):
    """What a unit takes without a batch: the median of 60 calls of its program, one after the other [s]."""
    times = []
    for _ in range(60):
        begin = time.monotonic()
        subprocess.run([STUB, "compare", "wait.yaml"], cwd=folder, capture_output=True, check=True)
        times.append(time.monotonic() - begin)
    return statistics.median(times)


def efficiency(out, delay, workers):
    """Of units that only wait, so that the processors of this machine do not count, against the program alone."""
    for count in workers:
        with tempfile.TemporaryDirectory() as temporary:
            units = int(8 / delay) * count
            trial = Trial(pathlib.Path(temporary), STUB, WAITS % units, delay)
            unit = alone(trial.folder)
            trial.run("serial", "--workers=16")
            paid, twice, begun, span, seconds, equal = on_place(trial, count, f"on{count}")
            out.writerow(["wait", count, f"{unit:.4f}", units, f"{span:.2f}", f"{seconds:.2f}",
                          f"{units * unit / count / span:.3f}", 0, begun, paid, twice, int(equal)])
            sys.stdout.flush()


def fits(out, part, options, workers):
    with tempfile.TemporaryDirectory() as temporary:
        trial = Trial(pathlib.Path(temporary), os.path.abspath(options.program), FITS % options.fits)
        journal = trial.folder / "journal"
        trial.run("serial", "--workers=1", environment={"FOURPOST_BATCH_JOURNAL": str(journal)})
        units, _, _, serial = accounts(journal)
        for count in workers if part == "equal" else workers[-1:]:
            kill, killed = killer(options.rounds, trial.folder / f"on{count}") if part == "kills" else (
                lambda cluster: None, [])
            paid, twice, begun, span, seconds, equal = on_place(trial, count, f"on{count}", kill, 100)
            out.writerow([part, count, f"{serial / units:.4f}", units, f"{span:.2f}", f"{seconds:.2f}",
                          f"{serial / count / span:.3f}", f"{len(killed)} x half: {sum(killed)}" if killed else 0, begun,
                          paid, twice, int(equal)])
            sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
