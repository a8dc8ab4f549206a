"""Runs that never end, found as fair cycles that break a condition on infinite runs.

The graph consists of configurations (a state of the world, with all that the programs remember) and
of transitions between them.  A cycle is fair (weak fairness) if each robot is activated on the
cycle, or cannot be activated in some configuration of the cycle.  A *criterion* is a condition on
one transition; the cycle must have a transition that meets it.  Fairness gives one criterion for
each robot, and each assumption on the adversary is one criterion.  A strongly connected component
has a cycle that meets all criteria if each criterion is met by some transition in the component.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeAlias

from allworlds.robots.graph import Broken
from allworlds.robots.model import Assumption, Liveness

if TYPE_CHECKING:
    from allworlds.robots.configurations import Search

Outgoing: TypeAlias = Callable[[int], Iterable[int]]
"""A function that returns the transitions by which a cycle may leave a configuration.

The transitions are given by their indices.
"""

Unable: TypeAlias = Callable[[int], int]
"""The function from a configuration to the robots that cannot be activated in it, as a bit set."""

Criterion: TypeAlias = Callable[[int, int], bool]
"""The function that says whether a transition meets the criterion.

Its arguments are the number of the configuration before the transition, and the transition's index.
"""


def broken_for_ever(search: Search) -> Broken | None:
    """The law that a fair cycle breaks, with this cycle; None if no fair cycle breaks a law.

    The conditions on infinite runs are tried in their order in the model.
    """
    graph = search.graph
    if search.minds.histories and all(map(graph.bits, range(len(graph)))):
        return None  # each transition makes a history longer
    fair, assumed = [*_fairness(search, search.unable)], [*_assumptions(search)]
    ways: list[tuple[Outgoing, list[Criterion]]] = [(graph.transitions, [*fair, *assumed])]
    if assumed and not search.timing.has_rounds:
        ways.append((graph.without_action, fair))  # the adversary is never asked
    every = range(len(search))
    for condition in search.world.progress():
        inside = [*every]
        if condition.holds is not None and not condition.forever:
            inside = [number for number in every if not _holds(search, condition, number)]
        for outgoing, counted in ways:
            criteria = [*_criteria_of(search, condition), *counted]
            for component in components(search, inside, outgoing):
                if broken := _broken_in_component(search, condition, component, criteria, outgoing):
                    return broken
    return None


def cut_for_ever(search: Search) -> int | None:
    """Find a cycle on which a robot is at the end of the budget, while other robots go on for ever.

    The budget is the largest number of activations of a robot whose program is a generator.  Return
    the number of a configuration on the cycle; None if there is no such cycle.
    """

    def cut(before: int, _index: int) -> bool:
        return bool(search.able(before)[1])

    criteria, outgoing = [cut, *_fairness(search, search.unable_or_cut)], search.graph.transitions
    for component in components(search, range(len(search)), outgoing):
        if _cycle(search, component, criteria, outgoing):
            return component[0]
    return None


def _broken_in_component(
    search: Search,
    condition: Liveness,
    component: list[int],
    criteria: list[Criterion],
    outgoing: Outgoing,
) -> Broken | None:
    """The law that a cycle in a strongly connected component breaks; None if no law is broken.

    Each cycle that meets ``criteria`` contradicts ``condition``.  First any such cycle is looked
    for.  If a robot is activated on it, the broken law is ``progress``.  If not, all robots stand
    still for ever, and :meth:`Search.stopped` says which law is broken by this, if any.  If it says
    that none is, a cycle is looked for that meets ``criteria`` and on which a robot is activated;
    if there is one, the broken law is ``progress``.

    ``component`` holds the numbers of the component's configurations, ``outgoing`` gives the
    transitions that a cycle may use.
    """
    cycle = _cycle(search, component, criteria, outgoing)
    if not cycle:
        return None
    if broken := _broken(search, condition, min(component), cycle):
        return broken
    cycle = _cycle(search, component, [*criteria, _activated(search)], outgoing)
    return _broken(search, condition, min(component), cycle) if cycle else None


def _broken(search: Search, condition: Liveness, at: int, cycle: tuple[int, ...]) -> Broken | None:
    if not any(search.graph.bits(index) for index in cycle):
        return search.stopped(at)  # nobody is able, while the world changes
    forever = condition.forever or condition.holds is None
    without = "and again and again without" if forever else "without"
    words = f"the run goes on for ever {without} {condition.name}"
    return Broken("progress", words, at, cycle=cycle)


def _activated(search: Search) -> Criterion:
    """The criterion that at least one robot is activated in a transition."""
    return lambda _before, index: bool(search.graph.bits(index))


def _holds(search: Search, condition: Liveness, number: int) -> bool:
    return search.world.holds(condition, search.states[search.state_number(number)])


def _criteria_of(search: Search, condition: Liveness) -> Iterator[Criterion]:
    """The criteria for a cycle that breaks the condition: one criterion, or none.

    There are three kinds of conditions:

    - The condition demands that from some time on no robot acts: the criterion is a transition in
      which a robot acts.
    - It demands that something holds in all states from some time on: the criterion is a transition
      from a configuration in which it does not hold.
    - It demands that something holds in a state again and again: there is no criterion, since the
      caller then gives only configurations in which it does not hold, so that every cycle breaks
      the condition.
    """
    if condition.holds is None:
        yield lambda _before, index: bool(search.graph.has_action(index))
    elif condition.forever:
        yield lambda before, _index: not _holds(search, condition, before)


def _fairness(search: Search, unable: Unable) -> Iterator[Criterion]:
    """The criteria of weak fairness, one for each robot.

    A transition meets the criterion of a robot if the robot is activated in the transition, or if
    ``unable`` says that the robot cannot be activated in the configuration before the transition.
    """
    bits, stuck = search.graph.bits, array("Q", map(unable, range(len(search))))
    for robot in range(len(search.program_of)):

        def fair(before: int, index: int, bit: int = 1 << robot) -> bool:
            return bool((bits(index) | stuck[before]) & bit)

        yield fair


def _assumptions(search: Search) -> Iterator[Criterion]:
    """The criteria of the assumptions on the adversary, one for each assumption of the model."""
    for assumption in search.world.assumes():

        def assumed(before: int, index: int, assumption: Assumption = assumption) -> bool:
            return search.assumed(assumption, before, index)

        yield assumed


def components(search: Search, inside: Sequence[int], outgoing: Outgoing) -> Iterator[list[int]]:
    """The strongly connected components of a subgraph, without those that have no transition.

    The components are sorted by their least configurations.  The algorithm is Tarjan's.

    Args:
        search: the search with the graph.
        inside: the numbers of the configurations of the subgraph, ascending.
        outgoing: the function that returns the transitions of the subgraph from a configuration.
    """
    following_of = search.graph.targets
    order = dict.fromkeys(inside, -1)
    low: dict[int, int] = {}
    stack: list[int] = []
    on, count = set[int](), 0
    found = list[list[int]]()
    for root in inside:
        if order[root] >= 0:
            continue
        work = [(root, iter(following_of(outgoing(root))))]
        order[root] = low[root] = count
        count += 1
        stack.append(root)
        on.add(root)
        while work:
            at, rest = work[-1]
            following = next((each for each in rest if each in order), None)
            if following is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[at])
                if low[at] == order[at]:
                    component = [stack.pop()]
                    while component[-1] != at:
                        component.append(stack.pop())
                    on.difference_update(component)
                    if len(component) > 1 or at in following_of(outgoing(at)):
                        found.append(sorted(component))
            elif order[following] < 0:
                order[following] = low[following] = count
                count += 1
                stack.append(following)
                on.add(following)
                work.append((following, iter(following_of(outgoing(following)))))
            elif following in on:
                low[at] = min(low[at], order[following])
    yield from sorted(found)


def _cycle(
    search: Search, component: Sequence[int], criteria: list[Criterion], outgoing: Outgoing
) -> tuple[int, ...]:
    """The transitions of a cycle that meets all criteria; empty if the component has no such cycle.

    The cycle begins at the component's least configuration.
    """
    inside, start = {*component}, component[0]
    if not _meets(search, inside, criteria, outgoing):
        return ()
    at, cycle = start, list[tuple[int, int]]()
    for criterion in criteria:
        if any(criterion(before, index) for before, index in cycle):
            continue
        cycle += _shortest(search, inside, at, criterion, outgoing)
        at = search.graph.target(cycle[-1][1])
    if at != start or not cycle:
        cycle += _shortest(
            search, inside, at, lambda _, index: search.graph.target(index) == start, outgoing
        )
    return tuple(index for _, index in cycle)


def _meets(search: Search, inside: set[int], criteria: list[Criterion], outgoing: Outgoing) -> bool:
    """Whether each criterion is met by some transition between configurations of ``inside``."""
    to = search.graph.target
    within = [(at, index) for at in inside for index in outgoing(at) if to(index) in inside]
    return all(any(criterion(at, index) for at, index in within) for criterion in criteria)


def _shortest(
    search: Search, inside: set[int], at: int, criterion: Criterion, outgoing: Outgoing
) -> list[tuple[int, int]]:
    """A shortest way that begins at ``at``, and whose last transition meets the criterion.

    The way stays in the set ``inside`` of configurations.  It is a list of pairs: the number of a
    configuration, and the index of the transition by which the way leaves this configuration.
    """
    to = search.graph.target
    reached_by: dict[int, tuple[int, int]] = {at: (-1, -1)}
    for number in (queue := [at]):
        for index in outgoing(number):
            if to(index) not in inside:
                continue
            if criterion(number, index):
                way = [(number, index)]
                while reached_by[way[-1][0]][0] >= 0:
                    way.append(reached_by[way[-1][0]])
                return way[::-1]
            if to(index) not in reached_by:
                reached_by[to(index)] = number, index
                queue.append(to(index))
    raise AssertionError("a strongly connected part is left by no way to a step of its own")
