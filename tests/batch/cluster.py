"""A Dask scheduler and its workers on this machine, as processes of their own."""
import os
import pathlib
import signal
import subprocess
import sys
import time


class Cluster:
    """A scheduler and workers of one thread each, in a folder."""

    def __init__(self, folder):
        self.folder, self.file, self.processes = folder, folder / "scheduler.json", []
        self.scheduler = self._start("distributed.cli.dask_scheduler", "--port", "0", "--scheduler-file", self.file,
                                     "--no-dashboard")
        end = time.monotonic() + 30
        while not self.file.exists() and time.monotonic() < end:
            time.sleep(0.05)

    def worker(self, *words, before=(), limit=None, **environment):
        return self._start("distributed.cli.dask_worker", "--scheduler-file", self.file, "--nthreads", "1",
                           "--no-dashboard", "--death-timeout", "30", "--local-directory", self.folder / "space", *words,
                           before=before, preexec_fn=limit, environment=environment)

    def _start(self, module, *words, before=(), preexec_fn=None, environment=None):
        # Workers need nothing of the package.
        clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        log = open(self.folder / f"log{len(self.processes)}", "w")
        command = [*before, sys.executable, "-m", module, *map(str, words)]
        process = subprocess.Popen(command, stdout=log, stderr=log, preexec_fn=preexec_fn, start_new_session=True,
                                   env={**clean, **(environment or {})})
        log.close()
        self.processes.append(process)
        return process

    def close(self):
        for process in self.processes:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()

    @staticmethod
    def working(nanny):
        """Numbers of the processes that a nanny has started to work: one, or none for a moment."""
        found = []
        for path in pathlib.Path(f"/proc/{nanny.pid}/task").glob("*/children"):
            try:
                found += [int(word) for word in path.read_text().split()]
            except OSError:
                pass
        return [pid for pid in found if "spawn_main" in command_of(pid)]

    @classmethod
    def kill_worker(cls, nanny):
        """SIGKILL for the process that works; its nanny starts another one. Whether there was one."""
        working = cls.working(nanny)
        for pid in working:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        return bool(working)


def command_of(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/cmdline").read_text()
    except OSError:
        return ""
