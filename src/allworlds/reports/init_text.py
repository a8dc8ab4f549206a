"""The text of ``init``."""

from __future__ import annotations

from allworlds.reports.layout import entry
from allworlds.skeletons import Skeleton


def init_text(skeleton: Skeleton, width: int) -> str:
    """What was written, and what to do next."""
    lines = entry("written", ", ".join(skeleton.files), width)
    if skeleton.language.needs:
        lines += entry("needs", ", ".join(skeleton.language.needs), width)
    lines += ["next", f"  {skeleton.check}", ""]
    said = f"{skeleton.language.explorer} is wrong so far: the check draws the smallest world that"
    return "\n".join([*lines, f"{said} refutes it."])
