"""Run directories: what is finished of a job, kept so that nobody has to do it again.

``identity``
    what a job is: two results can be put together exactly if they are of the same;
``database``
    the file of a run directory, in which every row has a checksum;
``records``
    where the finished units of a job are: nowhere, in a run directory, or in several.

A result is kept as a JSON value.  Nothing that is read from a directory is ever run.
"""

from allworlds.store.database import Database, reading
from allworlds.store.identity import Identity, canonical
from allworlds.store.records import (
    ENDED,
    Gap,
    Merged,
    NoRecords,
    Records,
    in_use,
    merged,
    records_in,
    shelf,
)

__all__ = [
    "ENDED",
    "Database",
    "Gap",
    "Identity",
    "Merged",
    "NoRecords",
    "Records",
    "canonical",
    "in_use",
    "merged",
    "reading",
    "records_in",
    "shelf",
]
