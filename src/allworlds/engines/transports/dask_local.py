"""A Dask cluster of this machine alone, in processes that are killed when it is no longer needed.

The scheduler has a process of its own, whose children the workers are.  So no answer is waited for
at the end, and a worker that was stopped ends, too.
"""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from tempfile import TemporaryDirectory

from allworlds.engines.transports.dask_lanes import ClusterLost

QUIET = {
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "500ms",
    "distributed.admin.system-monitor.interval": "2s",
}
"""The settings of a local cluster: by default Dask samples each worker a hundred times a second,
for a page that is not shown here."""

_START = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from allworlds.engines.transports.dask_local import serve; "
    "serve(int(sys.argv[2]), sys.argv[3], int(sys.argv[4]))"
)


@contextmanager
def local_cluster(workers: int) -> Iterator[str]:
    """A context with the address of a cluster of that many processes, each with one thread.

    Raises:
        ClusterLost: if it does not start.
    """
    ours, theirs = socket.socketpair()
    with TemporaryDirectory(ignore_cleanup_errors=True) as place, ours:
        with theirs:
            words = [json.dumps(sys.path), str(workers), place, str(theirs.fileno())]
            process = subprocess.Popen(  # noqa: S603  # our own module
                # Its helpers would warn of what is left behind if it is killed.
                [sys.executable, "-P", "-W", "ignore", "-c", _START, *words],
                stdin=subprocess.DEVNULL,
                # What workers print is not the report.
                stdout=2,
                pass_fds=(theirs.fileno(),),
                # A Ctrl-C is for the owner.
                start_new_session=True,
            )
        try:
            with ours.makefile() as said:
                address = said.readline().strip()
            if not address:
                raise ClusterLost(
                    f"the local Dask cluster has not started (exit code {process.wait()})"
                )
            yield address
        finally:
            os.killpg(process.pid, 9)
            process.wait()


def serve(workers: int, place: str, descriptor: int) -> None:
    """Be a cluster until the owner is gone; tell its address first.

    Args:
        workers: the number of its workers.
        place: a directory, which is removed at the end.
        descriptor: of the socket to the owner.
    """
    import dask
    import distributed

    os.set_inheritable(descriptor, False)  # noqa: FBT003  # it takes no keyword
    with (
        socket.socket(fileno=descriptor) as owner,
        dask.config.set({**QUIET, "temporary-directory": place}),
        distributed.LocalCluster(  # type: ignore[no-untyped-call]  # Dask is not typed
            n_workers=workers,
            threads_per_worker=1,
            # Without an address of its own the scheduler would ask for port 8787.
            dashboard_address="127.0.0.1:0",
            silence_logs=50,
        ) as cluster,
    ):
        owner.sendall(f"{cluster.scheduler_address}\n".encode())
        owner.recv(1)
    shutil.rmtree(place, ignore_errors=True)
