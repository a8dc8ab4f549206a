"""The parts of requests that name the listener, the run directory and the Dask cluster."""

from pathlib import Path
from typing import Annotated

from allworlds.engines.listeners import NOBODY, Listener
from allworlds.inputs.requests import RARE_EFFORT, Converted, Option, Request


class ListenerOptions(Request):
    """The part of a request that names the listener, which is told of the job's progress."""

    listener: Annotated[
        Converted[Listener | None, Listener],
        "is told of the progress; by default nobody",
    ] = Converted(lambda listener: listener or NOBODY, None)


class RunDirectoryOptions(Request):
    """The part of a request that names the run directory, which keeps the finished units."""

    run: Annotated[
        str | Path | None,
        Option(
            RARE_EFFORT,
            "DIR",
            "A directory that keeps what is finished: the same command goes on from there, and "
            "'merge' joins shards.",
            apart=True,
        ),
    ] = None


class ClusterOptions(Request):
    """The part of a request that names the Dask cluster."""

    dask: Annotated[
        str | None,
        Option(
            RARE_EFFORT,
            "ADDRESS|local",
            "Do the work on the workers of this Dask scheduler (extra: distributed).",
            apart=True,
        ),
    ] = None
