"""Subjects: the explorers under test, found by name and made ready to play."""

from allworlds.subjects.program import Program
from allworlds.subjects.subject import Subject, SubjectError, load, subject_of

__all__ = ["Program", "Subject", "SubjectError", "load", "subject_of"]
