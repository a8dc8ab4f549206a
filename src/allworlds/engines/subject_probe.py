"""The subject of a name: a player loads the explorer and tells its keywords."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from allworlds.document import replace
from allworlds.engines.effort import Limits
from allworlds.engines.players import PlayerProcess, Setup
from allworlds.explorers import (
    BUILT_IN,
    Program,
    Subject,
    built_in,
    command_of,
    in_process_subject,
    is_program,
    source_of,
    whole_name,
    with_shield,
)
from allworlds.inputs import InputError, show


def subject_of(explore: str | Callable[..., Any], limits: Limits) -> Subject:
    """The subject for a name or a generator function.

    A named explorer is loaded in a process of its own: users' code does not get into this one.

    Raises:
        InputError: if there is no such explorer, it cannot be imported, or it is no explorer.
    """
    if not isinstance(explore, str):
        if not callable(explore):
            raise InputError(f"explore = {show(explore)} is neither a name nor a function")
        return in_process_subject(explore)
    explore = whole_name(explore)
    if explore in BUILT_IN:
        return built_in(explore)
    if is_program(explore):
        program = Program(command_of(explore), limits.answer_timeout)  # refuses what cannot be run
        program.ensure_readable()
        return Subject(explore, frozenset({"told"}))
    subject = Subject(explore, frozenset(), source=source_of(explore))
    player = PlayerProcess(Setup(subject, limits), 0)
    try:
        description = player.loaded()
    finally:
        player.close()
    found = replace(subject, keywords=description.keywords)
    return with_shield(found) if description.has_shield else found
