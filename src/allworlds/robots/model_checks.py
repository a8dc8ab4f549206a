"""Checks that a model gives the same answers twice, also if the darts have other numbers."""

from __future__ import annotations

from collections.abc import Sequence

from allworlds.robots.configurations import Search, in_lockstep
from allworlds.robots.events import event_of
from allworlds.robots.model import ModelError, ModelInMap


def ensure_same_model(search: Search) -> None:
    """Ask the model again about every state of a search; then search again with renumbered darts.

    The second questions come in the reverse order of the states.

    Raises:
        ModelError: if the model answers differently; or if a search in the map with renumbered
            darts finds another broken law, a shortest run of another length, or another number of
            configurations.
    """
    _ensure_same_answers(search)
    if search.full:
        return
    for names in _other_names(len(search.world.map.sigma)):
        _ensure_same_verdict(search, names)


def _ensure_same_answers(search: Search) -> None:
    world, name = search.world, search.world.name
    for number in reversed(range(len(search.states))):
        state = search.states[number]
        for robot in range(len(search.program_of)):
            sensed = search.sensed_first(number, robot)
            if sensed is not None and world.sensed(state, robot) != sensed:
                raise ModelError(
                    f"the model {name!r} is not the same twice: robot {robot} senses something "
                    f"else in one state, {state!r}"
                )
    for number in reversed(range(len(search))):
        for step in search.graph.transitions(number):
            reached = search.states[search.state_number(search.graph.target(step))]
            if event_of(search, search.graph.transition(number, step)).state != reached:
                raise ModelError(
                    f"the model {name!r} is not the same twice: another state follows "
                    f"{search.states[search.state_number(number)]!r} after the same actions"
                )


def _other_names(darts: int) -> list[list[int]]:
    """Two ways to renumber ``darts`` darts; each is a list of the new numbers."""
    turned = [(dart + 1) % darts for dart in range(darts)]
    return [turned, [darts - 1 - dart for dart in range(darts)]]


def _ensure_same_verdict(search: Search, names: Sequence[int]) -> None:
    map_ = search.world.map.relabelled(names)
    world = ModelInMap(search.world.model, map_, search.world.name)
    starts = [names[dart] for dart in search.starts]
    other = Search(world, starts, search.program_of, search.minds, search.timing)
    in_lockstep([other], search.minds)
    if _verdict(search) != _verdict(other):
        first, second = (_verdict(each)[0] or "no law" for each in (search, other))
        raise ModelError(
            f"the model {world.name!r} tells renumbered darts apart: {first} is broken in the map "
            f"sigma={[*search.world.map.sigma]} alpha={[*search.world.map.alpha]}, and {second} "
            f"with the darts renamed to {[*names]}"
        )


def _verdict(search: Search) -> tuple[str, int]:
    """The law that a search has broken, and the length of a shortest run that breaks this law.

    The length is 0 if the run never ends.  If no law is broken, the pair is an empty text and the
    number of configurations.
    """
    found = search.broken
    if found is None:
        return "", len(search)
    return found.law, 0 if found.cycle else len(search.way(found.at))
