"""Runs that never end: a fair cycle on which what must be so again and again never is.

Weak fairness: on the cycle each robot is activated, or somewhere it could not be.  With the
assumptions on the adversary these are conditions of the form 'again and again', and a cycle through
all that a strongly connected part has of them is there if each is met in the part.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeAlias

from allworlds.robots.graph import Broken
from allworlds.robots.model import Assumption, Liveness

if TYPE_CHECKING:
    from allworlds.robots.configurations import Search

Steps: TypeAlias = Callable[[int], Iterable[int]]
"""Of a configuration the steps that count."""

Unable: TypeAlias = Callable[[int], int]
"""The robots that cannot be activated in a configuration, as bits."""

Wish: TypeAlias = Callable[[int, int], bool]
"""Whether a step, by the configuration before it and its number, is what is looked for."""


def broken_for_ever(search: Search) -> Broken | None:
    """The first condition that an infinite run breaks, with a shortest way to a cycle that does."""
    graph = search.graph
    if search.minds.histories and all(map(graph.group, range(len(graph)))):
        return None  # each step makes a history longer
    fair, assumed = [*_fairness(search, search.unable)], [*_assumptions(search)]
    ways: list[tuple[Steps, list[Wish]]] = [(graph.steps, [*fair, *assumed])]
    if assumed and not search.time.has_rounds:
        ways.append((graph.still_steps, fair))  # the adversary is never asked
    every = range(len(search))
    for condition in search.world.progress():
        inside = [*every]
        if condition.holds is not None and not condition.forever:
            inside = [number for number in every if not _holds(search, condition, number)]
        for steps, counted in ways:
            wishes = [*_broken_by(search, condition), *counted]
            for part in components(search, inside, steps):
                if broken := _broken_in(search, condition, part, wishes, steps):
                    return broken
    return None


def cut_for_ever(search: Search) -> int | None:
    """A configuration of a cycle on which others go on while the budget keeps a robot from it."""

    def cut(before: int, _step: int) -> bool:
        return bool(search.able(before)[1])

    wishes, steps = [cut, *_fairness(search, search.unable_or_cut)], search.graph.steps
    for part in components(search, range(len(search)), steps):
        if _cycle(search, part, wishes, steps):
            return part[0]
    return None


def _broken_in(
    search: Search, condition: Liveness, part: list[int], wishes: list[Wish], steps: Steps
) -> Broken | None:
    """The law that a cycle in a part breaks; one without activations may be harmless."""
    cycle = _cycle(search, part, wishes, steps)
    if not cycle:
        return None
    if broken := _broken(search, condition, min(part), cycle):
        return broken
    cycle = _cycle(search, part, [*wishes, _activated(search)], steps)
    return _broken(search, condition, min(part), cycle) if cycle else None


def _broken(search: Search, condition: Liveness, at: int, cycle: tuple[int, ...]) -> Broken | None:
    if not any(search.graph.group(step) for step in cycle):
        return search.stopped(at)  # nobody is able, while the world changes
    forever = condition.forever or condition.holds is None
    seen = (
        f"again and again not {condition.name}" if forever else f"for ever without {condition.name}"
    )
    return Broken("progress", seen, at, cycle=cycle)


def _activated(search: Search) -> Wish:
    """The steps in which somebody is activated: of a cycle that is not harmless."""
    return lambda _before, step: bool(search.graph.group(step))


def _holds(search: Search, condition: Liveness, number: int) -> bool:
    return search.world.holds(condition, search.states[search.state_number(number)])


def _broken_by(search: Search, condition: Liveness) -> Iterator[Wish]:
    """The steps of which a cycle that breaks the condition has one, if that is not any."""
    if condition.holds is None:
        yield lambda _before, step: bool(search.graph.acts(step))
    elif condition.forever:
        yield lambda before, _step: not _holds(search, condition, before)


def _fairness(search: Search, unable: Unable) -> Iterator[Wish]:
    """The steps of which every cycle that counts has one."""
    group, stuck = search.graph.group, array("Q", map(unable, range(len(search))))
    for robot in range(len(search.team)):

        def fair(before: int, step: int, bit: int = 1 << robot) -> bool:
            return bool((group(step) | stuck[before]) & bit)

        yield fair


def _assumptions(search: Search) -> Iterator[Wish]:
    """The steps of the adversary of which every cycle that counts has one."""
    for assumption in search.world.assumes():

        def assumed(before: int, step: int, assumption: Assumption = assumption) -> bool:
            return search.assumed(assumption, before, step)

        yield assumed


def components(search: Search, inside: Sequence[int], steps: Steps) -> Iterator[list[int]]:
    """The strongly connected parts that hold a step, by the least configuration met (Tarjan).

    Args:
        search: the search.
        inside: the configurations, ascending; others do not count.
        steps: of each configuration those that count.
    """
    following_of = search.graph.following
    index = dict.fromkeys(inside, -1)
    low: dict[int, int] = {}
    stack: list[int] = []
    on, count = set[int](), 0
    found = list[list[int]]()
    for root in inside:
        if index[root] >= 0:
            continue
        work = [(root, iter(following_of(steps(root))))]
        index[root] = low[root] = count
        count += 1
        stack.append(root)
        on.add(root)
        while work:
            at, rest = work[-1]
            following = next((each for each in rest if each in index), None)
            if following is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[at])
                if low[at] == index[at]:
                    part = [stack.pop()]
                    while part[-1] != at:
                        part.append(stack.pop())
                    on.difference_update(part)
                    if len(part) > 1 or at in following_of(steps(at)):
                        found.append(sorted(part))
            elif index[following] < 0:
                index[following] = low[following] = count
                count += 1
                stack.append(following)
                on.add(following)
                work.append((following, iter(following_of(steps(following)))))
            elif following in on:
                low[at] = min(low[at], index[following])
    yield from sorted(found)


def _cycle(
    search: Search, part: Sequence[int], wishes: Iterable[Wish], steps: Steps
) -> tuple[int, ...]:
    """The steps of a cycle from the least configuration of a part that has all that is wished for.

    Empty if the part has not.
    """
    inside, start = {*part}, part[0]
    if not _has_all(search, inside, wishes, steps):
        return ()
    at, cycle = start, list[tuple[int, int]]()
    for wish in wishes:
        if any(wish(before, step) for before, step in cycle):
            continue
        cycle += _shortest(search, inside, at, wish, steps)
        at = search.graph.to(cycle[-1][1])
    if at != start or not cycle:
        cycle += _shortest(
            search, inside, at, lambda _, step: search.graph.to(step) == start, steps
        )
    return tuple(step for _, step in cycle)


def _has_all(search: Search, inside: set[int], wishes: Iterable[Wish], steps: Steps) -> bool:
    """Whether for each wish a part holds a step that is as wished for."""
    to = search.graph.to
    within = [(at, step) for at in inside for step in steps(at) if to(step) in inside]
    return all(any(wish(at, step) for at, step in within) for wish in wishes)


def _shortest(
    search: Search, inside: set[int], at: int, wish: Wish, steps: Steps
) -> list[tuple[int, int]]:
    """The steps of a shortest way inside whose last one is as wished; there is one."""
    to = search.graph.to
    came: dict[int, tuple[int, int]] = {at: (-1, -1)}
    for number in (queue := [at]):
        for step in steps(number):
            if to(step) not in inside:
                continue
            if wish(number, step):
                way = [(number, step)]
                while came[way[-1][0]][0] >= 0:
                    way.append(came[way[-1][0]])
                return way[::-1]
            if to(step) not in came:
                came[to(step)] = number, step
                queue.append(to(step))
    raise AssertionError("a strongly connected part is left by no way to a step of its own")
