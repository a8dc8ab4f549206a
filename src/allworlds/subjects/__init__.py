"""Subjects: the explorers under test, found by name and made ready to play."""

from allworlds.subjects.program import Program
from allworlds.subjects.subject import (
    EXEC,
    Subject,
    load,
    names_explorer,
    own_bound,
    own_lighthouse,
    subject_of,
)

__all__ = [
    "EXEC",
    "Program",
    "Subject",
    "load",
    "names_explorer",
    "own_bound",
    "own_lighthouse",
    "subject_of",
]
