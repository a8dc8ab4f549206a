"""The texts of ``init``."""

from __future__ import annotations

from allworlds.reports.text_layout import entry
from allworlds.studies.init import Header, Skeleton


def init_text(begun: Skeleton | Header, width: int) -> str:
    """The header line by line; or what was written, and what to do next."""
    if isinstance(begun, Header):
        return begun.header.rstrip("\n")
    return _skeleton_text(begun, width)


def _skeleton_text(skeleton: Skeleton, width: int) -> str:
    lines = entry("written", ", ".join(skeleton.files), width)
    if skeleton.language.needs:
        lines += entry("needs", ", ".join(skeleton.language.needs), width)
    lines += ["next", f"  {skeleton.check}", ""]
    said = f"{skeleton.explorer} is wrong so far: the check draws the smallest world that"
    return "\n".join([*lines, f"{said} refutes it."])
