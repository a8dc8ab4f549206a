"""Subjects: the explorers under test, found by name and made ready to play."""

from allworlds.subjects.program import Program
from allworlds.subjects.subject import (
    Subject,
    SubjectError,
    default_lighthouse,
    load,
    own_bound,
    subject_of,
)

__all__ = [
    "Program",
    "Subject",
    "SubjectError",
    "default_lighthouse",
    "load",
    "own_bound",
    "subject_of",
]
