"""The search of one world, in this process: for notebooks, and for loops over programs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from msgspec import Struct

from allworlds.explorers.loading import keywords_of
from allworlds.inputs.checks import InputError, not_one_of, show
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.turns import Turns
from allworlds.robots.configurations import Search, in_lockstep
from allworlds.robots.events import Event, events_of
from allworlds.robots.minds import Minds
from allworlds.robots.model import Model, ModelInMap, Scheduler
from allworlds.robots.schedulers import Timing


class SearchOutcome(Struct, frozen=True):
    """The result of the search of one world.

    Attributes:
        law: the broken law; empty if no law is broken.
        seen: how the law is broken, in words.
        events: the events of a shortest run that breaks the law; empty if no law is broken.
        loop: how many of ``events``, the last ones, repeat for ever; 0 if the run ends.
        unfinished: the number of configurations in which the budget cuts a run off.
        configurations: the number of configurations that the search reached.
        schedules: the number of complete runs: those that cannot be continued.  None if a law is
            broken, if a run never ends or is cut off, or if the search is ``full``.
        longest: the largest number of activations of a robot in a run that ends.
        full: whether the search stopped because it reached too many configurations.
        search: the search itself.
    """

    law: str
    seen: str
    events: tuple[Event, ...]
    loop: int
    unfinished: int
    configurations: int
    schedules: int | None
    longest: int
    full: bool
    search: Search

    @property
    def holds(self) -> bool:
        """Whether no law is broken in any schedule, and every run was searched to its end."""
        return not (self.law or self.unfinished or self.full)


def search(
    map_: CombinatorialMap,
    starts: Sequence[Dart],
    model: Model,
    team: Sequence[Any],
    scheduler: Scheduler | None = None,
    *,
    budget: int = 1000,
    within: int | None = None,
    lead: int | None = None,
    start_delay: int = 0,
    configurations: int = 1_000_000,
) -> SearchOutcome:
    """Search every schedule of a team in one world, and every choice of the adversary.

    Args:
        map_: the map.
        starts: a dart for each robot.
        model: the model of the world.
        team: a program for each robot: a generator function, or an automaton.
        scheduler: ``fsync``, ``ssync``, ``central`` or ``async``; by default the model's first.
        budget: the largest number of activations, in a run, of a robot whose program is a
            generator.
        within: a number of activations that is used in place of ``budget``, and that is a law: a
            run that exceeds it breaks the law ``budget``.  None: ``budget`` only cuts runs off.
        lead: the largest number of activations by which a robot may be ahead of another robot; None
            for no limit.
        start_delay: the largest number of rounds by which robot 1 may begin later than the others.
        configurations: the largest number of configurations.

    Raises:
        InputError: for an illegal value; the error names the value.
    """
    scheduler = scheduler or model.schedulers[0]
    if scheduler not in model.schedulers:
        raise not_one_of("scheduler", scheduler, model.schedulers)
    if len(starts) != len(team):
        raise InputError(f"starts = {show(starts)} are not {len(team)}, one for each robot")
    timing = Timing(
        scheduler,
        budget if within is None else within,
        lead,
        start_delay,
        within is not None,
        configurations,
    )
    each = {id(program): program for program in team}  # equal ones may differ: 1 and True are equal
    minds = Minds([turns_of(program) for program in each.values()])
    numbers = {key: number for number, key in enumerate(each)}
    world = ModelInMap(model, map_, type(model).__name__)
    found = Search(world, starts, [numbers[id(program)] for program in team], minds, timing)
    in_lockstep([found], minds)
    return outcome_of(found)


def outcome_of(search: Search) -> SearchOutcome:
    """The result of a finished search."""
    broken = search.broken
    exact = not (broken or search.ends.cut_off or search.full)
    return SearchOutcome(
        law=broken.law if broken else "",
        seen=broken.seen if broken else "",
        events=tuple(events_of(search, broken)) if broken else (),
        loop=len(broken.cycle) if broken else 0,
        unfinished=search.ends.cut_off,
        configurations=len(search),
        schedules=search.schedules() if exact else None,
        longest=search.ends.longest,
        full=search.full,
        search=search,
    )


def turns_of(program: Callable[..., Any]) -> Turns:
    """Return a program of this process in the form that can be asked turn by turn.

    Raises:
        InputError: if the program is neither a generator function nor an automaton.
    """
    keywords = keywords_of(getattr(program, "__name__", show(program)), program)

    def player(first: Any, choices: Any, told: Any) -> Any:
        offered = {"choices": choices, "told": told}
        return program(first, **{key: offered[key] for key in keywords})

    return Turns(program, player)
