"""Reasons for what is impossible, checked again: nothing of the package is imported here.

A map is a pair of lists, sigma the next dart clockwise and alpha the other end of each dart; a move
by k leads from d to alpha[sigma^k[d]].  A ring is its number of vertices alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import combinations, product

Darts = Sequence[int]


# ---------------------------------------------------------------- maps


def around(sigma: Darts, dart: int) -> list[int]:
    """The darts of a vertex, clockwise from this one."""
    darts = [dart]
    while sigma[darts[-1]] != dart:
        darts.append(sigma[darts[-1]])
    return darts


def at_one_vertex(sigma: Darts, one: int, other: int) -> bool:
    """Whether two darts have one vertex."""
    return other in around(sigma, one)


def moved(sigma: Darts, alpha: Darts, dart: int) -> list[int]:
    """The darts to which the moves by 0, 1, 2, ... lead."""
    return [alpha[each] for each in around(sigma, dart)]


def common_words(sigma: Darts, alpha: Darts, one: int, other: int) -> set[tuple[int, int]] | None:
    """The pairs of darts to which one word leads both; None if they ever sense another degree."""
    pairs = {(one, other)}
    new = [*pairs]
    while new:
        a, b = new.pop()
        ways = moved(sigma, alpha, a), moved(sigma, alpha, b)
        if len(ways[0]) != len(ways[1]):
            return None
        for pair in zip(*ways, strict=True):
            if pair not in pairs:
                pairs.add(pair)
                new.append(pair)
    return pairs


def never_together(sigma: Darts, alpha: Darts, one: int, other: int, delay: int = 0) -> bool:
    """Whether two that do and sense the same can never be at one vertex, whatever they do.

    The first one may be ahead by so many rounds, in which it moves or waits.
    """
    pairs = common_words(sigma, alpha, one, other) or {(one, one)}
    for ahead, behind in pairs:
        reached = {ahead}
        for _ in range(delay):
            reached |= {dart for each in reached for dart in moved(sigma, alpha, each)}
        if any(at_one_vertex(sigma, dart, behind) for dart in reached):
            return False
    return True


def symmetries(sigma: Darts, alpha: Darts) -> Iterator[list[int]]:
    """The permutations of the darts that commute with sigma and alpha."""
    for image in range(len(sigma)):
        names = {0: image}
        new = [0]
        while new:
            dart = new.pop()
            for after in (sigma, alpha):
                if after[dart] not in names:
                    names[after[dart]] = after[names[dart]]
                    new.append(after[dart])
        found = [names[dart] for dart in range(len(sigma))]
        whole = sorted(found) == [*range(len(sigma))]
        if whole and all(found[p[d]] == p[found[d]] for p in (sigma, alpha) for d in range(len(p))):
            yield found


def kept_apart(sigma: Darts, alpha: Darts, starts: Darts) -> bool:
    """Whether a symmetry leads the robots onto one another, and no vertex to itself.

    Then robots that are told the same do the same for ever, and whoever is anywhere has another one
    elsewhere: they are never all at one vertex, whatever they lay down or write.
    """
    for names in symmetries(sigma, alpha):
        onto = sorted(names[dart] for dart in starts) == sorted(starts)
        if onto and not any(at_one_vertex(sigma, dart, names[dart]) for dart in range(len(sigma))):
            return True
    return False


# ---------------------------------------------------------------- oblivious robots on rings

Rule = Callable[[tuple[int, ...]], Sequence[int]]
"""The steps of which a robot makes one: 1 ahead, -1 back, 0 none.  It sees how many robots are at
each vertex, from its own one ahead: 0, 1, or 2 for two or more."""

State = tuple[tuple[int, ...], tuple[int, ...]]
"""The place of each robot, and the step that it has decided and not made."""

Edge = tuple[State, frozenset[int]]
"""The state that follows, and the robots that were activated; in async for one step."""

Graph = dict[State, list[Edge]]
"""The steps from each state."""


def ahead_of(places: Sequence[int], robot: int, vertices: int) -> tuple[int, ...]:
    """The number of robots at each vertex, as one of them sees it."""
    steps = [(places[robot] + step) % vertices for step in range(vertices)]
    return tuple(min(2, places.count(vertex)) for vertex in steps)


def collided(places: Sequence[int], before: Sequence[int]) -> bool:
    """Whether two are at one vertex, or have crossed on an edge."""
    pairs = combinations(range(len(places)), 2)
    crossed = (places[a] == before[b] and places[b] == before[a] for a, b in pairs)
    return len({*places}) < len(places) or any(crossed)


def one_step(state: State, robot: int, vertices: int, rule: Rule) -> Iterator[State]:
    """The states after the next step of a robot: a look, with each decision, or its move."""
    places, due = [*state[0]], [*state[1]]
    if due[robot]:
        places[robot] = (places[robot] + due[robot]) % vertices
        due[robot] = 0
        yield tuple(places), tuple(due)
    else:
        for step in rule(ahead_of(places, robot, vertices)):
            due[robot] = step
            yield tuple(places), tuple(due)


def whole_step(state: State, robots: Sequence[int], vertices: int, rule: Rule) -> Iterator[State]:
    """The states after these robots look at once, and then move at once."""
    places, due = state
    choices = [rule(ahead_of(places, robot, vertices)) for robot in robots]
    for steps in product(*choices):
        to = [*places]
        for robot, step in zip(robots, steps, strict=True):
            to[robot] = (to[robot] + step) % vertices
        yield tuple(to), due


def edges_of(state: State, vertices: int, rule: Rule, scheduler: str) -> Iterator[Edge]:
    """The steps from a state.

    In async one robot makes one step.  Steps at once are the same as all looks, and then all moves.
    """
    robots = range(len(state[0]))
    if scheduler == "async":
        for robot in robots:
            for after in one_step(state, robot, vertices, rule):
                yield after, frozenset([robot])
        return
    sizes = {"fsync": [len(robots)], "central": [1], "ssync": [size + 1 for size in robots]}
    for size in sizes[scheduler]:
        for group in combinations(robots, size):
            for after in whole_step(state, group, vertices, rule):
                yield after, frozenset(group)


def graph_from(
    start: Sequence[int], vertices: int, rule: Rule, scheduler: str, *, apart: bool = False
) -> Graph:
    """All states that are reached, each with its steps; none if two collide and must be apart."""
    graph: Graph = {}
    new = [(tuple(start), (0,) * len(start))]
    while new:
        state = new.pop()
        if state not in graph:
            graph[state] = [*edges_of(state, vertices, rule, scheduler)]
            if apart and any(collided(after[0], state[0]) for after, _ in graph[state]):
                return {}
            new += [after for after, _ in graph[state]]
    return graph


Condition = Callable[[State, frozenset[int]], bool]
"""Of a step: the state before it, and who is activated."""


def goes_on(graph: Graph, robots: int, *more: Condition) -> bool:
    """Whether a run never ends in which each robot acts again and again.

    So it is with each further condition (Emerson and Lei 1986).  States are numbers here.
    """
    acts = [lambda _state, group, robot=robot: robot in group for robot in range(robots)]
    number = {state: i for i, state in enumerate(graph)}
    into: list[set[int]] = [set() for _ in graph]
    for state, edges in graph.items():
        for after in {after for after, _ in edges} & number.keys():
            into[number[after]].add(number[state])
    ways = [
        [
            {number[after] for after, group in edges if after in number and holds(state, group)}
            for state, edges in graph.items()
        ]
        for holds in (*acts, *more)
    ]
    left, before = {*range(len(graph))}, -1
    while len(left) != before:
        before = len(left)
        for way in ways:
            new = [state for state in left if not left.isdisjoint(way[state])]
            reached = {*new}
            while new:
                behind = (into[new.pop()] & left) - reached
                new += behind
                reached |= behind
            left = reached
    return bool(left)


def gathers(start: Sequence[int], vertices: int, rule: Rule, scheduler: str) -> bool:
    """Whether in every fair run all are at one vertex at last, and stay there."""
    graph = graph_from(start, vertices, rule, scheduler)
    return not goes_on(graph, len(start), lambda state, _group: len({*state[0]}) > 1)


def explores(start: Sequence[int], vertices: int, rule: Rule, scheduler: str) -> bool:
    """Whether nobody collides, and in every fair run each robot is everywhere again and again."""
    graph = graph_from(start, vertices, rule, scheduler, apart=True)
    if not graph:
        return False
    for robot, vertex in product(range(len(start)), range(vertices)):
        without = {state: edges for state, edges in graph.items() if state[0][robot] != vertex}
        if goes_on(without, len(start)):
            return False
    return True


def fewest_steps(vertices: int, starts: Iterable[Sequence[int]], rule: Rule) -> int | None:
    """The fewest looks and moves, one at a time, to a collision; None if there is none."""
    layer: set[State] = {(tuple(start), (0,) * len(start)) for start in starts}
    met, steps = {*layer}, 0
    while layer:
        steps += 1
        new: set[State] = set()
        for state in layer:
            for after, _ in edges_of(state, vertices, rule, "async"):
                if collided(after[0], state[0]):
                    return steps
                new.add(after)
        layer = new - met
        met |= layer
    return None


Event = Sequence[tuple[int, int | None]]
"""Each robot that is activated, with the step that it decides, or None: it moves."""


def replayed(vertices: int, start: Sequence[int], events: Sequence[Event], rule: Rule) -> bool:
    """Whether these events are legal, and the last one is the first with a collision."""
    places, due = [*start], [0] * len(start)
    for number, event in enumerate(events, 1):
        before = tuple(places)
        for robot, decided in event:
            if decided is None:
                places[robot] = (places[robot] + due[robot]) % vertices
                due[robot] = 0
            elif due[robot] or decided not in rule(ahead_of(before, robot, vertices)):
                return False
            else:
                due[robot] = decided
        if collided(places, before):
            return number == len(events)
    return False


def turned_onto_itself(places: Iterable[int], vertices: int) -> bool:
    """Whether robots on a ring are led onto one another by a turn.

    If all are activated at once, who see the same do the same, and so it is again: nobody is ever
    alone with all others, and if one leaves its vertex, all do.
    """
    kept = {*places}
    turns = range(1, vertices)
    return any({(place + turn) % vertices for place in kept} == kept for turn in turns)


# ---------------------------------------------------------------- rings with a missing edge


Round = tuple[dict[int, int], int | None, list[int]]
"""The turn of each robot, the lesser dart of the missing edge, and the robots not on their port."""


def beyond(dart: int, turn: int, vertices: int) -> int:
    """The dart of arrival: dart 2v leads from vertex v to v + 1, and 2v + 1 back to v - 1."""
    leave = dart ^ (turn % 2)
    return (leave + 3 if leave % 2 == 0 else leave - 3) % (2 * vertices)


def left_out(vertices: int, starts: Darts, rounds: Sequence[Round]) -> int:
    """The number of vertices that nobody visits in these rounds."""
    darts, visited = [*starts], {dart // 2 for dart in starts}
    for turns, missing, waiting in rounds:
        for robot, turn in turns.items():
            there = beyond(darts[robot], turn, vertices)
            if robot not in waiting and min(darts[robot] ^ (turn % 2), there) != missing:
                darts[robot] = there
        visited |= {dart // 2 for dart in darts}
    return vertices - len(visited)


# ---------------------------------------------------------------- a black hole


def leaves_home(table: dict[tuple[int, int], tuple[int, int | None]]) -> bool:
    """Whether an automaton ever leaves home, where it senses two doors and nothing else.

    If it does, the hole may be the vertex it enters first; else it senses the same wherever the
    hole is, and can only answer the same.
    """
    state, seen = 0, set[int]()
    while state not in seen:
        seen.add(state)
        state, turn = table[state, 2]
        if turn is not None:
            return True
    return False


Decision = tuple[object, object, int | None]
"""The memory after a look, what is written (None: nothing), and the turn (None: no move)."""


def swallowed(
    vertices: int,
    hole: int,
    memories: list[object],
    decide: Callable[[object, tuple[int, bool, int, object]], Decision],
    events: Sequence[Sequence[int]],
    *,
    whole: bool = False,
) -> int:
    """The number of robots in the hole after these events, each a next step of robots at once.

    A step is a look with a decision, or what was decided: it writes at home, and then moves.  In
    whole activations it is both.
    """
    darts, board = [0] * len(memories), None
    due: list[tuple[object, int | None] | None] = [None] * len(memories)
    for event in events:
        before, old = [dart // 2 for dart in darts], board
        for robot in event:
            here, looks = before[robot], due[robot] is None
            if looks:
                percept = 2, here == 0, before.count(here) - 1, None if here else old
                memories[robot], *decided = decide(memories[robot], percept)
                due[robot] = None if decided == [None, None] else tuple(decided)
            plan = due[robot]
            if plan is None or (looks and not whole):
                continue
            due[robot] = None
            board = plan[0] if plan[0] is not None and here == 0 else board
            darts[robot] = (
                darts[robot] if plan[1] is None else beyond(darts[robot], plan[1], vertices)
            )
    return sum(dart // 2 == hole for dart in darts)


# ---------------------------------------------------------------- two robots with lights


def apart_for_ever(
    rules: dict[tuple[str, str], Sequence[str] | None], events: Sequence[Sequence[int]], colour: str
) -> bool:
    """Whether two robots on a line are after these events as before, and have been apart.

    Both lights have the colour at first, robots 0 and 1 the points 0 and 1.  An event is the next
    step of some robots at once: a look, or a move with the change of the light.
    """
    points, lights = [Fraction(0), Fraction(1)], [colour, colour]
    due: list[tuple[str, Fraction] | None] = [None, None]
    apart, active = False, set[int]()
    for event in events:
        before, seen = [*points], [*lights]
        for robot in event:
            active.add(robot)
            plan, rule = due[robot], rules[seen[robot], seen[1 - robot]]
            if plan is not None:
                lights[robot], points[robot] = plan
                due[robot] = None
            elif rule is not None:
                way = Fraction(rule[1]) * (before[1 - robot] - before[robot])
                due[robot] = rule[0], before[robot] + way
        apart = apart or points[0] != points[1]
    as_before = points[0] != points[1] and lights == [colour, colour] and due == [None, None]
    return apart and as_before and active == {0, 1}
