#!/usr/bin/env python3
"""What a unit costs beside its own work, as CSV: processor time of the Dask scheduler, of the one who began the batch and
of the workers, bytes of messages, of results and of files. Units are those of the program that stands in, which does
nothing, so that its processes count too.

  cost.py --units 2000 > cost.csv
"""
import argparse
import csv
import os
import pathlib
import pickle
import sys
import tempfile
import time

from demonstration import STUB, WAITS, Trial, accounts, cluster_of

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from fourpost_batch import Program, Store, expand, read_plan  # noqa: E402
from fourpost_batch.unit import result_text  # noqa: E402


def seconds_of(pid):
    """Processor time of a process so far, and of children that have ended."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    ticks = os.sysconf("SC_CLK_TCK")
    return sum(map(int, fields[11:13])) / ticks, sum(map(int, fields[13:15])) / ticks


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--units", type=int, default=2000)
    count = arguments.parse_args().units
    out = csv.writer(sys.stdout, lineterminator="\n")
    print(f"# tests/batch/cost.py --units {count}; a unit, in ms of one processor and in bytes")
    out.writerow(["what", "value"])
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "cluster").mkdir()
        trial = Trial(folder, STUB, WAITS % count, 0)
        cluster = cluster_of(folder / "cluster", 2, STUB)
        try:
            scheduler = cluster.processes[0].pid
            workers = [child for nanny in cluster.processes[1:] for child in cluster.working(nanny)]
            begin = {pid: seconds_of(pid) for pid in [scheduler, *workers]}
            before = sum(os.times()[2:4])
            trial.run("out", f"--on=dask:{cluster.file}")
            began = sum(os.times()[2:4]) - before
            end = {pid: seconds_of(pid) for pid in begin}
        finally:
            cluster.close()
        paid, _, _, span = accounts(folder / "cluster/journal")
        spent = {pid: [1000 * (b - a) / count for a, b in zip(begin[pid], end[pid])] for pid in begin}
        before = sum(os.times()[2:4])
        trial.run("out", "--workers=1")
        idle = sum(os.times()[2:4]) - before
        unit = expand(read_plan(folder / "plan.yaml"), Program(STUB)).units[0]
        result = next((folder / "out").glob("units/*/*.json"))
        store, text = Store.make(folder / "store"), result_text("0" * 64, {"printed": "x" * 40000})
        begin_s = time.perf_counter()
        for number in range(500):
            store.put(f"{number:064x}", text)
        put = (time.perf_counter() - begin_s) / 500
        out.writerows([["units", paid], ["span_s", f"{span:.2f}"],
                       ["scheduler_ms", f"{spent[scheduler][0]:.3f}"],
                       ["began_ms", f"{1000 * began / count:.3f}"],
                       ["began_when_all_is_there_ms", f"{1000 * idle / count:.3f}"],
                       ["worker_ms", f"{sum(spent[pid][0] for pid in workers):.3f}"],
                       ["process_of_the_unit_ms", f"{sum(spent[pid][1] for pid in workers):.3f}"],
                       ["message_bytes", len(pickle.dumps(unit.to_dict()))], ["answer_bytes", len(pickle.dumps(("paid", None)))],
                       ["result_bytes", result.stat().st_size],
                       ["keeping_40_kB_ms", f"{1000 * put:.3f}"]])
    return 0


if __name__ == "__main__":
    sys.exit(main())
