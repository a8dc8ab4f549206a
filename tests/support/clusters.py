"""Dask clusters for tests: of threads of this process, and of processes."""

import gc
import json
import subprocess
import sys
import warnings
from contextlib import ExitStack, contextmanager
from typing import NamedTuple

import processes


@contextmanager
def cluster_here(distributed):
    """The address of the scheduler.

    Dask leaves sockets to the collector of garbage, which says so in whatever test it happens to
    run; so it runs here.
    """
    with distributed.LocalCluster(2, processes=False, dashboard_address="127.0.0.1:0") as cluster:
        yield cluster.scheduler_address
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        gc.collect()


class ClusterApart(NamedTuple):
    """A cluster whose scheduler and two workers are processes."""

    address: str
    scheduler: subprocess.Popen
    workers: list[subprocess.Popen]

    @property
    def all(self):
        """Every process."""
        return [self.scheduler, *self.workers]


@contextmanager
def cluster_apart(distributed, place):
    """A cluster of processes, whose directories are in that place; at the end they are killed."""
    file = place / "scheduler.json"
    with ExitStack() as stack:

        def started(name, *words):
            command = [sys.executable, "-m", f"distributed.cli.{name}", "--no-dashboard", *words]
            quiet = {"stderr": subprocess.DEVNULL, "stdout": subprocess.DEVNULL}
            process = subprocess.Popen(command, cwd=place, **quiet)
            stack.callback(process.wait)
            stack.callback(process.kill)
            return process

        scheduler = started("dask_scheduler", "--port=0", f"--scheduler-file={file}")
        # The file is there before its text is.
        assert processes.wait(lambda: file.exists() and file.read_text().rstrip().endswith("}"))
        address = json.loads(file.read_text())["address"]
        workers = [started("dask_worker", address, "--nthreads=1", "--no-nanny") for _ in range(2)]
        with distributed.Client(address) as client:
            client.wait_for_workers(2, timeout=processes.PATIENCE)
        yield ClusterApart(address, scheduler, workers)
