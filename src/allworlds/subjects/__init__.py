"""Subjects: the explorers under test, found by name and made ready to play.

``subject``
    an explorer as a check speaks of it;
``loading``
    its code, found by its name, in a process that may run foreign code;
``program``
    a program in any language behind a pipe.
"""

from allworlds.subjects.loading import load, source_of
from allworlds.subjects.program import Program
from allworlds.subjects.subject import (
    EXEC,
    NATIVE,
    Source,
    Subject,
    built_in,
    names_explorer,
    own_bound,
    own_lighthouse,
    subject_here,
)

__all__ = [
    "EXEC",
    "NATIVE",
    "Program",
    "Source",
    "Subject",
    "built_in",
    "load",
    "names_explorer",
    "own_bound",
    "own_lighthouse",
    "source_of",
    "subject_here",
]
