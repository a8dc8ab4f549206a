"""What there is to say of a finding, for every report that people read."""

from __future__ import annotations

from typing import Any

from allworlds.judging import Finding
from allworlds.words import number, plural

LONGEST_LIST = 60
"""The choices of a longer list are told from both ends."""


def headline(finding: Finding) -> str:
    """Who breaks which law in what world."""
    map_ = finding.world.map
    size = f"{plural(map_.edge_count, 'edge')}, {plural(map_.vertex_count, 'vertex', 'vertices')}"
    return f"{finding.explorer} breaks the law '{finding.law}' in a world with {size}"


def wrong(finding: Finding) -> str:
    """What is wrong with an answer; empty where the law is about something else."""
    return {
        "map": "the answer is not the same map as the world",
        "pose": "the answer is the same map, but 'here' is not the robot's dart",
    }.get(finding.law, "")


def expected_words(finding: Finding) -> str:
    """What was expected, where it is no map."""
    at_most = "at most " if isinstance(finding.expected, int) else ""
    return at_most + _traversals(finding.expected)


def seen_words(finding: Finding) -> str:
    """What was seen, where it is no map."""
    return _traversals(finding.seen)


def _traversals(value: Any) -> str:
    return plural(value, "traversal") if isinstance(value, int) else str(value)


def choices_words(finding: Finding) -> str:
    """The index taken at each choice; of many the first and the last."""
    indices = [*map(str, finding.choices)]
    if len(indices) > LONGEST_LIST:
        half = LONGEST_LIST // 2
        between = f"... ({number(len(indices) - 2 * half)} more) ..."
        indices = [*indices[:half], between, *indices[-half:]]
    return ", ".join(indices)


def remarks(finding: Finding) -> str:
    """Whether it was confirmed, and whether it is the smallest."""
    confirmed = (
        "yes: a fresh process did the same from the recorded percepts alone"
        if finding.confirmed
        else "no"
    )
    minimal = (
        "no smaller world of the scope refutes" if finding.minimal else "a smaller one may refute"
    )
    return f"{confirmed}; {minimal}"
