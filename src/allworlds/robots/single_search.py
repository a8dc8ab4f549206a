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
from allworlds.robots.model import Guarded, Model, Scheduler
from allworlds.robots.schedulers import Time


class SearchOutcome(Struct, frozen=True):
    """The result of the search of one world.

    Attributes:
        law: the law that is broken; empty if none is.
        seen: how, in words.
        events: of a shortest run that breaks it; the last ``loop`` of them repeat for ever.
        loop: their number; 0 where the run ends.
        unfinished: the number of runs that the budget cuts off.
        configurations: the number of configurations that were met.
        schedules: the number of maximal runs; None where a run never ends, or one is cut off.
        longest: the largest number of activations of a robot in a run that ends.
        full: whether the search was ended, because there are more configurations than are allowed.
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
        """Whether no law is broken in any schedule."""
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
    """Every schedule of a team in one world, and every choice of the adversary.

    Args:
        map_: the map.
        starts: a dart for each robot.
        model: of the world.
        team: a program for each robot: a generator function, or an automaton.
        scheduler: ``fsync``, ``ssync``, ``central`` or ``async``; by default the model's first.
        budget: no robot is activated more often, if one of them is a generator.
        within: the same, as a bound that must be kept.
        lead: nobody is more than so many activations ahead.
        start_delay: robot 1 begins up to so many rounds later.
        configurations: the largest number of them.

    Raises:
        InputError: naming what is not legal.
    """
    scheduler = scheduler or model.schedulers[0]
    if scheduler not in model.schedulers:
        raise not_one_of("scheduler", scheduler, model.schedulers)
    if len(starts) != len(team):
        raise InputError(f"starts = {show(starts)} are not {len(team)}, one for each robot")
    time = Time(
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
    world = Guarded(model, map_, type(model).__name__)
    found = Search(world, starts, [numbers[id(program)] for program in team], minds, time)
    in_lockstep([found], minds)
    return searched(found)


def searched(search: Search) -> SearchOutcome:
    """The findings of a search."""
    broken = search.found
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
    """A program of this process, asked turn by turn.

    Raises:
        InputError: if it is no generator function, and no automaton.
    """
    keywords = keywords_of(getattr(program, "__name__", show(program)), program)

    def player(first: Any, choices: Any, told: Any) -> Any:
        offered = {"choices": choices, "told": told}
        return program(first, **{key: offered[key] for key in keywords})

    return Turns(program, player)
