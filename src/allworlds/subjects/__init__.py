"""Subjects: the explorers under test, found by name and made ready to play.

``subject``
    an explorer as a check speaks of it;
``loading``
    its code, found by its name, in a process that may run foreign code;
``naming``
    names that are nearly those of an explorer;
``content``
    the bytes that an explorer is, whatever it is called;
``place``
    the file and the line where one stands;
``program``
    a program in any language behind a pipe.
"""

from allworlds.subjects.content import content_digest, not_alike, with_content
from allworlds.subjects.loading import load, source_of
from allworlds.subjects.naming import whole_name
from allworlds.subjects.place import SourceLine, files_of_explorer, place_of_explorer
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
    subject_known,
)

__all__ = [
    "EXEC",
    "NATIVE",
    "Program",
    "Source",
    "SourceLine",
    "Subject",
    "built_in",
    "content_digest",
    "files_of_explorer",
    "load",
    "names_explorer",
    "not_alike",
    "own_bound",
    "own_lighthouse",
    "place_of_explorer",
    "source_of",
    "subject_here",
    "subject_known",
    "whole_name",
    "with_content",
]
