"""Looking at an explorer once, where its code can do no harm."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from allworlds.engines.isolation.cast import started
from allworlds.engines.isolation.jobs import Casting
from allworlds.engines.isolation.process import guardian
from allworlds.engines.units.effort import Limits
from allworlds.explorers import (
    BUILT_IN,
    EXEC,
    Program,
    Subject,
    built_in,
    in_process_subject,
    source_of,
    whole_name,
)
from allworlds.inputs import InputError, show


def subject_of(explore: str | Callable[..., Any], limits: Limits) -> Subject:
    """The subject for a name or a generator function.

    What is named is loaded in a process of its own: foreign code does not get into this one.

    Raises:
        InputError: if there is no such explorer, it does not import, or it is none.
    """
    if not isinstance(explore, str):
        if not callable(explore):
            raise InputError(f"explore = {show(explore)} is neither a name nor a function")
        return in_process_subject(explore)
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
