"""Findings: a refuting run as a value, and how to read it.

``rules``
    how a run is played and judged; a finding records it;
``finding``
    a world, an explorer, what it did there, and the law that it broke;
``walks``
    the walk of a log in the world, and the same walk in a wrong answer;
``parting``
    the first step at which these two part;
``belief``
    both together, from where in the answer they go along for longest;
``store``
    a directory of findings, which outlives the checks that made them.
"""

from allworlds.findings.belief import BelievedWalk, believed_walk
from allworlds.findings.finding import Finding, canonical_world, place_of
from allworlds.findings.parting import Parting, find_parting
from allworlds.findings.rules import Rules, RulesOptions, make_rules
from allworlds.findings.store import KeptFinding, file_name, kept_findings, write_finding
from allworlds.findings.walks import recorded_trail, true_trail, true_walk

__all__ = [
    "BelievedWalk",
    "Finding",
    "KeptFinding",
    "Parting",
    "Rules",
    "RulesOptions",
    "believed_walk",
    "canonical_world",
    "file_name",
    "find_parting",
    "kept_findings",
    "make_rules",
    "place_of",
    "recorded_trail",
    "true_trail",
    "true_walk",
    "write_finding",
]
