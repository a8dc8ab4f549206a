"""The report of a job from the run directories of all its shards."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from allworlds.engines import WHOLE, Listener, Silent, merged
from allworlds.inputs import InputError, show
from allworlds.lazy import loaded
from allworlds.protocol import as_recorded
from allworlds.verbs import BY_NAME
from allworlds.version import __version__


@dataclass(frozen=True, slots=True)
class MergedReport:
    """The report that the verb would have made by itself.

    Attributes:
        verb: its name.
        report: as the verb hands it back.
    """

    verb: str
    report: Any

    @property
    def exit_code(self) -> int:
        """The exit code of the verb's report."""
        code: int = self.report.exit_code
        return code

    def to_json(self) -> dict[str, Any]:
        """The document of the verb's report."""
        document: dict[str, Any] = self.report.to_json()
        return document


def merge(*runs: str | Path, listener: Listener | None = None) -> MergedReport:
    """Merge the shards of a job, which were kept in run directories, into one report.

    Counts are compared with their source, and witnesses looked for, as if it had been one job.
    No explorer is needed, and none is run: findings were confirmed by those who found them.

    Args:
        runs: the directories, one a shard, in any order.
        listener: is told of the progress.

    Raises:
        InputError: if they are not of one job, overlap, or are damaged.
        Gap: if something is missing.
    """
    with merged(runs) as (identity, records):
        if identity.version != __version__:
            raise InputError(
                f"run directory {show(str(runs[0]))} is of version {show(identity.version)}, not "
                f"{show(__version__)}"
            )
        kind = loaded(BY_NAME[identity.verb].sweep)
        with as_recorded(identity.code):
            report = kind.known(identity, WHOLE, listener or Silent()).merged(records)
    return MergedReport(identity.verb, report)
