"""The version of this program, and a description of this machine; both are in documents."""

from __future__ import annotations

import os
import platform
import re
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from allworlds.documents.report import Host

__version__ = "0.3.0"
"""The version of the program."""


def host() -> Host:
    """A description of this machine and its software, on which measured times depend.

    Cost: some milliseconds.
    """
    from allworlds.documents.report import Host

    return Host(
        name=platform.node(),
        system=platform.system(),
        machine=platform.machine(),
        processor=_processor(),
        cores=os.cpu_count(),
        load=round(os.getloadavg()[0], 2),
        python=platform.python_version(),
        numba=_version_of("numba"),
    )


def _version_of(package: str) -> str | None:
    """The version of a package; None if it is not installed."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(package)
    except PackageNotFoundError:
        return None


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.exists():
        text = info.read_text(encoding="utf-8")
        if found := re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE):
            return found[1]
    return platform.processor()
