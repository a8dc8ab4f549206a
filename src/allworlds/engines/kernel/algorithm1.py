"""Algorithm 1, compiled: an explorer with the functions start, step and answer.

These functions take the same arguments as those of a user's explorer in a shared library, so the
judge calls both kinds of explorers in the same way.  The first percept goes to ``start``, each
later one to ``step``; each of these calls writes the robot's next action to ``action``.  ``robot``
is the explorer's state, an array ``ROBOT``.

S is the explored part of the world, and U holds its open darts.  In each pass the robot explores a
dart e of U.  The docstrings name the lines of the paper's Algorithm 1:

    1      let S be v0, and U its darts
    2-5    while U is not empty: take a dart e from U, walk through S to e, and cross e
    6      find the hypotheses: other darts of U by which a robot arrives with the same percept
    7-9    take the next hypothesis, and a path in S from its vertex to v0
    10-13  test it: walk along this path, as long as each percept is the expected one
    15     after a test that fails, on its path (case 1) or at the path's end (case 2): walk back
    18-19  after a test that succeeded (case 3): e and the dart of the hypothesis become an edge
    20-21  if every test has failed: add a new vertex to S, at the other end of e
    22     answer S

If the lighthouse has a direction, a test that succeeds proves its hypothesis.  Two lighthouses have
no direction, and only let the robot recognise v0 and one neighbour v1: ``cluster`` by their marks,
``natural`` by their degrees, which no other vertex has.  Under these lighthouses the robot has two
further tasks.  Before its first pass it searches for the dart of v0 that leads to v1.  After a test
whose path has ended at v0 it makes the *query*.  From the hypothesis follows which dart of v0 leads
to v1; the robot leaves v0 by this dart, senses whether it has come to v1, and goes back.

Hypotheses are tried in the order in which their darts came into S; each test walks to v0 on a
shortest path: at each vertex by the first dart that leads nearer to v0.

The twin, Python code with the same results: :mod:`allworlds.explorers.builtin.algorithm1`.

Source: Algorithm 1, Section IV.
"""

from functools import cache

from numba import types
from numpy import int64

from allworlds.engines.kernel import capabilities as names
from allworlds.engines.kernel.arrays import ACTION, ANSWER, NONE, PERCEPT, ROBOT
from allworlds.engines.kernel.compiling import RECORD, address_of, callback, inlined, inner

PASSING, FOLLOWING, CROSSING, TESTING, RETRACING, MATCHED = range(6)
"""The phases of a robot: between two passes; on the way through S; on the dart e; on a path that
tests a hypothesis; on the way back; at v0, where all percepts of a test were the expected ones."""


def start(robot, percept, _told, action):  # pragma: no cover  # compiled
    """Begin a run with the first percept (line 1), and write the robot's first action.

    ``_told`` is not used, because a directional lighthouse tells no value before the start.
    """
    begin(robot, int64(percept.degree), percept.marks, percept.bearing)
    next_pass(robot, action)


def step(robot, percept, action):  # pragma: no cover  # compiled
    """Write the robot's next action; ``percept`` is the percept after the previous action."""
    if robot.phase == PASSING:
        next_pass(robot, action)
    else:
        sense(robot, percept.degree, percept.marks, percept.bearing, action)
        if robot.phase == MATCHED:
            confirm(robot, robot.here, action)


def answer(robot, published):  # pragma: no cover  # compiled
    """Write S, and the robot's dart in S, to ``published``, which is an array ``ANSWER``.

    The robot's last action says whether the caller takes S and the dart as the explorer's answer or
    as a checkpoint.
    """
    published.sigma, published.alpha = address_of(robot.sigma), address_of(robot.alpha)
    published.darts, published.here = robot.darts, robot.here


@cache
def explorer_addresses(explorer: str) -> tuple[int, int, int]:
    """The addresses of the compiled functions start, step and answer of an explorer.

    ``explorer`` is a name in :data:`allworlds.engines.kernel.capabilities.EXPLORERS`.
    """
    robot, percept, action = RECORD(ROBOT), RECORD(PERCEPT), RECORD(ACTION)
    directed = explorer == "algorithm1"
    begins, goes_on = (start, step) if directed else (start_undirected, step_undirected)
    return (
        callback(begins, types.void(robot, percept, types.int32, action)),
        callback(goes_on, types.void(robot, percept, action)),
        callback(answer, types.void(robot, RECORD(ANSWER))),
    )


@inner
def begin(robot, degree, marks, bearing):
    """Begin a run (line 1): let S be v0 alone.

    ``degree``, ``marks`` and ``bearing`` are the first percept; ``bearing`` may be NONE.  For each
    dart of v0 the percept that is expected on arriving by this dart is written to ``robot``: with
    the same degree and marks, and with the bearing that follows from ``bearing``, or NONE.
    """
    robot.darts = robot.vertices = robot.known = robot.here = robot.turned = 0
    _add_vertex(robot, degree, marks, bearing)
    if bearing != NONE:
        for dart in range(degree):
            robot.bearing[dart] = (bearing - dart) % degree


@inner
def next_pass(robot, action):
    """Begin a pass (lines 2-4): choose the dart e from U, and take the first step towards e.

    If U is empty, announce the answer instead.
    """
    if robot.known == 0:
        action.kind = names.ANSWER_READY
        return
    taken = 0
    if robot.policy == names.LIFO:
        taken = robot.known - 1
    elif robot.policy != names.FIFO:
        _measure(robot, robot.owner[robot.here])
        least = robot.length[robot.owner[robot.unexplored[0]]]
        for i in range(1, robot.known):
            length = robot.length[robot.owner[robot.unexplored[i]]]
            if length < least:
                taken, least = i, length
    robot.goal = robot.unexplored[taken]
    _plan(robot, robot.owner[robot.here], robot.owner[robot.goal])
    robot.done = 0
    _follow(robot, action)


@inner
def sense(robot, degree, marks, bearing, action):
    """Go on with a pass after a percept, up to the next action (lines 5-16 and 20-21).

    ``degree``, ``marks`` and ``bearing`` are the percept.  The field ``robot.phase`` says what the
    robot is doing, and so what this call does.  On the way to e: take the next step.  Just beyond
    e: find the hypotheses, and begin the first test.  In a test: compare the percept with the
    expected one, and go on or give up.  On the way back: take the next step.

    When a test has come to v0 and each percept was the expected one, the phase becomes MATCHED, and
    this function writes no action: the caller confirms the hypothesis, or makes the query first.
    """
    if robot.phase == FOLLOWING:
        _follow(robot, action)
    elif robot.phase == CROSSING:
        robot.seen_degree, robot.seen_marks, robot.seen_bearing = degree, marks, bearing
        robot.alike = robot.tried = robot.turned = 0
        for i in range(robot.known):
            dart = robot.unexplored[i]
            if dart != robot.goal and _expected(robot, dart, degree, marks, bearing):
                robot.hypotheses[robot.alike] = dart
                robot.alike += 1
        robot.events[names.EMPTY_H] += robot.alike == 0
        next_hypothesis(robot, action)
    elif robot.phase == TESTING:
        if _expected(robot, robot.here, degree, marks, bearing):
            _test(robot, action)
        else:
            reject(robot, action)
    else:
        retrace(robot, action)


@inner
def _follow(robot, action):
    """Take the next step through S towards the dart e, or cross e (lines 4-5)."""
    dart = robot.goal
    robot.phase = CROSSING
    if robot.done < robot.steps:
        robot.phase = FOLLOWING
        dart = robot.path[robot.done]
        robot.done += 1
    action.kind, action.motion = names.MOVE, offset(robot, dart)
    robot.here = robot.alpha[dart]


@inlined
def offset(robot, dart):
    """The motion k by which the robot leaves along this dart of the vertex where it stands in S."""
    motion = dart - robot.here
    if motion < 0:
        motion += robot.degree[dart]
    return motion


@inlined
def _expected(robot, dart, degree, marks, bearing):
    """Whether this percept is expected on arriving by ``dart``, a dart of S.

    ``degree``, ``marks`` and ``bearing`` are the percept.
    """
    return (
        robot.degree[dart] == degree
        and robot.marks[dart] == marks
        and robot.bearing[dart] == bearing
    )


@inner
def next_hypothesis(robot, action):
    """Begin the test of the next hypothesis (lines 7-9); if none is left, add a new vertex to S."""
    if robot.tried == robot.alike:
        _augment_by_vertex(robot, action)
        return
    robot.partner = robot.here = robot.hypotheses[robot.tried]
    robot.tried += 1
    robot.done = 0
    if robot.owner[robot.partner] == 0:
        robot.events[names.AT_V0] += 1
    _test(robot, action)


@inner
def _test(robot, action):
    """Take the next step of a test (lines 10-13).

    If the path of the test has ended at v0, set the phase to MATCHED instead.
    """
    v = robot.owner[robot.here]
    if v == 0:
        robot.phase = MATCHED
        return
    robot.phase = TESTING
    dart = robot.home[v]
    motion = offset(robot, dart)
    robot.motions[robot.done] = motion
    robot.done += 1
    action.kind, action.motion = names.MOVE, motion - robot.turned
    robot.turned = 0
    robot.here = robot.alpha[dart]


@inner
def reject(robot, action):
    """Give up a test that has failed, and take the first step of the way back (line 15).

    The failure is counted as case 2 if the test had come to v0, at the end of its path, and as case
    1 if not.
    """
    robot.events[names.CASE_2 if robot.owner[robot.here] == 0 else names.CASE_1] += 1
    robot.turned = -robot.turned
    retrace(robot, action)


@inner
def retrace(robot, action):
    """Take the next step of the way back after a failed test (line 15).

    The step undoes the last motion of the test that is not undone yet.  If all motions are undone,
    begin the next test.

    ``robot.turned`` has two meanings.  On the way back it is the number k of the next motion.  At
    any other time after the crossing of e it says where the robot faces: so many darts clockwise
    from the dart by which it has come to its vertex.
    """
    if robot.done == 0:
        robot.turned = -robot.turned
        next_hypothesis(robot, action)
        return
    robot.phase = RETRACING
    action.kind, action.motion = names.MOVE, robot.turned
    robot.done -= 1
    robot.turned = -robot.motions[robot.done]


@inner
def confirm(robot, here, action):
    """End a pass after a test that succeeded (case 3, lines 18-19), and show a checkpoint.

    The dart e and the dart of the hypothesis become an edge of S.  ``here`` is the robot's dart in
    S; it is a dart of v0.
    """
    robot.events[names.CASE_3] += 1
    robot.events[names.LOOP] += 1
    goal, partner = robot.goal, robot.partner
    _explore(robot, goal, partner)
    if robot.owner[goal] != robot.owner[partner]:
        _ways_home(robot)
    robot.here = here
    robot.phase = PASSING
    action.kind = names.CHECKPOINT


@inlined
def _augment_by_vertex(robot, action):
    """End a pass in which every test has failed (lines 20-21), and show a checkpoint.

    The other end of the dart e becomes a new vertex of S; the first dart of this vertex is the dart
    by which the robot has entered it.
    """
    robot.events[names.NON_LOOP] += 1
    v, entry = robot.vertices, robot.darts
    degree = robot.seen_degree
    _add_vertex(robot, degree, robot.seen_marks, robot.seen_bearing)
    _explore(robot, robot.goal, entry)
    robot.home[v] = entry
    robot.here = entry + robot.turned % degree
    robot.phase = PASSING
    action.kind = names.CHECKPOINT


@inner
def _add_vertex(robot, degree, marks, bearing):
    """Add a vertex to S, and its darts to U.

    ``degree``, ``marks`` and ``bearing`` are the percept that a robot is expected to get when it
    arrives by any of these darts.  At v0 the bearing depends on the dart, and :func:`begin`
    corrects the bearings.
    """
    entry, v = robot.darts, robot.vertices
    for dart in range(entry, entry + degree):
        robot.sigma[dart] = dart + 1
        robot.alpha[dart] = dart
        robot.owner[dart] = v
        robot.degree[dart], robot.marks[dart], robot.bearing[dart] = degree, marks, bearing
        robot.unexplored[robot.known] = dart
        robot.known += 1
    robot.sigma[entry + degree - 1] = entry
    robot.first[v] = entry
    robot.darts += degree
    robot.vertices += 1


@inner
def _explore(robot, dart, partner):
    """Add the edge of these two darts to S; both darts leave U."""
    robot.alpha[dart], robot.alpha[partner] = partner, dart
    left = 0
    for i in range(robot.known):
        other = robot.unexplored[i]
        robot.unexplored[left] = other
        left += other != dart and other != partner
    robot.known = left


@inner
def _measure(robot, goal):
    """Write to ``robot.length``, for each vertex of S, the length of a shortest walk to ``goal``.

    ``goal`` is a vertex of S; the walks lie in S.
    """
    for v in range(robot.vertices):
        robot.length[v] = NONE
    robot.length[goal] = 0
    robot.queue[0] = goal
    known, taken = 1, 0
    while taken < known:
        v = robot.queue[taken]
        taken += 1
        for dart in range(robot.first[v], robot.first[v] + robot.degree[robot.first[v]]):
            w = robot.owner[robot.alpha[dart]]
            if robot.length[w] == NONE:
                robot.length[w] = robot.length[v] + 1
                robot.queue[known] = w
                known += 1


@inner
def _plan(robot, start, goal):
    """Write a shortest path between two vertices of S to ``robot.path``, as a list of darts.

    At each vertex the path takes the first dart that leads nearer to ``goal``.
    """
    robot.steps = 0
    if start == goal:
        return
    _measure(robot, goal)
    v = start
    while v != goal:
        dart = _nearer(robot, v)
        robot.path[robot.steps] = dart
        robot.steps += 1
        v = robot.owner[robot.alpha[dart]]


@inner
def _nearer(robot, v):
    """The first dart of vertex v that leads nearer to the goal.

    The goal is the vertex for which :func:`_measure` was called last.
    """
    dart = robot.first[v]
    while robot.length[robot.owner[robot.alpha[dart]]] != robot.length[v] - 1:
        dart += 1
    return dart


@inner
def _ways_home(robot):
    """Write to ``robot.home`` the way to v0 from each other vertex of S.

    The way from a vertex is given by the first dart of the vertex that leads nearer to v0.
    """
    _measure(robot, robot.owner[0])
    for v in range(1, robot.vertices):
        robot.home[v] = _nearer(robot, v)


# Without a direction.

SEARCHING, SEARCHED, ASKING, ASKED = range(MATCHED + 1, MATCHED + 5)
"""The further phases: in the search, at the other end of a dart of v0, and then back at v0; in the
query, at the other end of the dart to v1, and then back at v0."""


def start_undirected(robot, percept, told, action):  # pragma: no cover  # compiled
    """Begin a run under a lighthouse without a direction: ``cluster`` or ``natural``.

    Let S be v0 alone, and take the first step of the search for the dart to v1.  ``told`` is the
    number that the lighthouse tells before the start: under ``natural`` the degree of v1; under
    ``cluster`` it is not used.
    """
    robot.degree_of_v0, robot.degree_of_v1 = percept.degree, told
    marks = _is(robot, percept.degree, percept.marks, percept.degree, 1)
    begin(robot, int64(percept.degree), marks, NONE)
    _search(robot, 0, action)


def step_undirected(robot, percept, action):  # pragma: no cover  # compiled
    """Write the robot's next action, under a lighthouse without a direction.

    ``percept`` is the percept after the previous action.
    """
    degree, marks = percept.degree, percept.marks
    if robot.phase == SEARCHING or robot.phase == ASKING:
        robot.matched = _is(robot, degree, marks, robot.degree_of_v1, 2)
        robot.phase += 1
        action.kind, action.motion = names.MOVE, 0
    elif robot.phase == SEARCHED:
        robot.here = robot.pointed
        if robot.matched or robot.pointed + 1 == robot.darts:
            next_pass(robot, action)
        else:
            _search(robot, robot.pointed + 1, action)
    elif robot.phase == PASSING:
        next_pass(robot, action)
    else:
        if robot.phase == ASKED and robot.matched:
            confirm(robot, robot.pointed, action)
        elif robot.phase == ASKED:
            reject(robot, action)
        else:
            at_v0 = _is(robot, degree, marks, robot.degree_of_v0, 1)
            sense(robot, degree, at_v0, NONE, action)
        if robot.phase == MATCHED:
            _ask(robot, action)


@inlined
def _is(robot, degree, marks, own_degree, own_marks):
    """Return 1 if the percept ``degree``, ``marks`` is that of a certain vertex; else return 0.

    The vertex, which is v0 or v1, has the degree ``own_degree`` and the marks ``own_marks``.  If
    ``robot.natural`` is set, only the degrees are compared; else only the marks.
    """
    if robot.natural:
        return 1 if degree == own_degree else 0
    return 1 if marks == own_marks else 0


@inner
def _search(robot, dart, action):
    """Leave v0 by this dart, to find out whether it leads to v1."""
    robot.phase, robot.pointed = SEARCHING, dart
    action.kind, action.motion = names.MOVE, dart - robot.here


@inner
def _ask(robot, action):
    """Begin the query: leave v0 by a dart which, if the hypothesis is true, leads to v1."""
    towards = offset(robot, robot.pointed)
    robot.phase = ASKING
    action.kind, action.motion = names.MOVE, towards - robot.turned
    robot.turned = towards
