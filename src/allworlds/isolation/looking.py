"""Looking at an explorer once, where its code can do no harm."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from allworlds.explorers import BUILT_IN
from allworlds.inputs import InputError, show
from allworlds.isolation.cast import started
from allworlds.isolation.jobs import Casting
from allworlds.isolation.process import guardian
from allworlds.subjects import EXEC, Program, Subject, built_in, source_of, subject_here, whole_name
from allworlds.work import Limits


def subject_of(explore: str | Callable[..., Any], limits: Limits) -> Subject:
    """The subject for a name or a generator function.

    What is named is loaded in a process of its own: foreign code does not get into this one.

    Raises:
        InputError: if there is no such explorer, it does not import, or it is none.
    """
    if not isinstance(explore, str):
        if not callable(explore):
            raise InputError(f"explore = {show(explore)} is neither a name nor a function")
        return subject_here(explore)
    explore = whole_name(explore)
    if explore in BUILT_IN:
        return built_in(explore)
    if explore.startswith(EXEC):
        Program(explore.removeprefix(EXEC), limits.answer_timeout)  # refuses what cannot be run
        return Subject(explore, frozenset({"told"}))
    subject = Subject(explore, frozenset(), source=source_of(explore))
    casting = Casting(explore, subject.source, limits.answer_timeout, limits.memory)
    player, described = started(guardian(), casting)
    player.close()
    return replace(subject, keywords=described.keywords)
