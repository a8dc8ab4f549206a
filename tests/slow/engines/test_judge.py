"""The compiled judge against the Python judge, run by run, on explorers that are wrong."""

from functools import cache

import pytest
from numba import cfunc, from_dtype, types

from allworlds import CombinatorialMap, Estimate, Move
from allworlds.documents.document import replace
from allworlds.engines.compiled_engine import level_of, played_tally
from allworlds.engines.kernel.algorithm1 import explorer_addresses
from allworlds.engines.kernel.arrays import ACTION, ANSWER, PERCEPT, ROBOT
from allworlds.engines.kernel.capabilities import ANSWER_READY, CHECKPOINT, MOVE
from allworlds.engines.kernel.compiling import address_of
from allworlds.engines.kernel.engine import judge
from allworlds.engines.units import LevelUnit, Scope
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.explorers.loading import in_process_subject
from allworlds.judging.laws.law_table import LAWS
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass
from allworlds.maps.classes import Extent
from allworlds.maps.enumeration import prefixes
from allworlds.protocol.actions import Checkpoint

pytestmark = pytest.mark.usefixtures("compiled")

# ------------------------------------------------ each explorer twice: compiled, and in Python


def published(robot, answer):
    answer.sigma, answer.alpha = address_of(robot.sigma), address_of(robot.alpha)
    answer.darts, answer.here = robot.darts, robot.here


def turned_published(robot, answer):
    answer.sigma, answer.alpha = address_of(robot.sigma), address_of(robot.alpha)
    answer.darts, answer.here = robot.darts, robot.sigma[robot.here]


def exchanged_published(robot, answer):
    answer.sigma, answer.alpha = address_of(robot.alpha), address_of(robot.sigma)
    answer.darts, answer.here = robot.darts, robot.here


def turned(first):
    """Says that it faces the next dart."""
    walk, percept = algorithm1(first), None
    try:
        while True:
            action = walk.send(percept)
            if isinstance(action, Checkpoint):
                action = Checkpoint(action.sigma, action.alpha, action.sigma[action.here])
            percept = yield action
    except StopIteration as end:
        map_, here = end.value.map, end.value.here
        return Estimate(map_, map_.sigma[here])


def exchanged_start(robot, percept, told, action):
    robot.sigma[0], robot.sigma[1] = 1, 0
    robot.alpha[0], robot.alpha[1] = 0, 1
    robot.darts, robot.here = 2, 0
    action.kind = ANSWER_READY


def exchanged(first):
    """Takes what leads clockwise for what leads across."""
    yield from ()
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0)


def spinning_step(robot, percept, action):
    action.kind, action.motion = MOVE, -1


def spinning_start(robot, percept, told, action):
    action.kind, action.motion = MOVE, -1


def spinning(first):
    """Never ends."""
    while True:
        yield Move(-1)


def nonsense_start(robot, percept, told, action):
    action.kind = 9


def nonsense(first):
    """Does what nobody can do."""
    yield "nonsense"


def nowhere_start(robot, percept, told, action):
    guess(robot, 0, 1, 1, 0)
    robot.here = 2
    action.kind = ANSWER_READY


def nowhere(first):
    """Is at no dart of its map."""
    yield from ()
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 2)


def half_start(robot, percept, told, action):
    guess(robot, 0, 1, 0, 1)
    action.kind = ANSWER_READY


def half(first):
    """Answers with what is no map: its darts lead nowhere."""
    yield from ()
    return CombinatorialMap


def guess(robot, sigma_0, sigma_1, alpha_0, alpha_1):
    robot.sigma[0], robot.sigma[1] = sigma_0, sigma_1
    robot.alpha[0], robot.alpha[1] = alpha_0, alpha_1
    robot.darts, robot.here, robot.done = 2, 0, 0


def edge_start(robot, percept, told, action):
    guess(robot, 0, 1, 1, 0)
    action.kind = CHECKPOINT


def edge_step(robot, percept, action):
    robot.done += 1
    action.kind = CHECKPOINT if robot.done == 1 else ANSWER_READY


def edge(first):
    """Guesses one edge with two ends, shows it twice, and does not walk."""
    yield Checkpoint([0, 1], [1, 0], 0)
    yield Checkpoint([0, 1], [1, 0], 0)
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0)


def loop_start(robot, percept, told, action):
    guess(robot, 1, 0, 1, 0)
    action.kind, action.motion = MOVE, 0


def loop_step(robot, percept, action):
    robot.done += 1
    if robot.done == 1:
        action.kind = CHECKPOINT
    else:
        action.kind = ANSWER_READY


def loop(first):
    """Guesses a loop after one step."""
    yield Move(0)
    yield Checkpoint([1, 0], [1, 0], 0)
    return Estimate(CombinatorialMap([1, 0], [1, 0]), 0)


def one_sided_start(robot, percept, told, action):
    guess(robot, 0, 1, 1, 1)
    action.kind = CHECKPOINT


def one_sided_step(robot, percept, action):
    robot.alpha[1] = 0
    action.kind = ANSWER_READY


def one_sided(first):
    """Shows an edge that only one of its darts knows of."""
    yield Checkpoint([0, 1], [1, 1], 0)
    return Estimate(CombinatorialMap([0, 1], [1, 0]), 0)


@cache
def compiled_code(function, kinds):
    records = {"robot": ROBOT, "percept": PERCEPT, "action": ACTION, "answer": ANSWER}
    arguments = [types.int32 if kind == "told" else from_dtype(records[kind]) for kind in kinds]
    return cfunc(types.void(*arguments), error_model="numpy", _nrt=False)(function)


def addresses(start, step, answer):
    """Each function, or None for the one of Algorithm 1."""
    kinds = [("robot", "percept", "told", "action"), ("robot", "percept", "action")]
    return tuple(
        compiled_code(own, kind).address if own else builtin
        for own, kind, builtin in zip(
            (start, step, answer),
            (*kinds, ("robot", "answer")),
            explorer_addresses("algorithm1"),
            strict=True,
        )
    )


WRONG = {
    turned: (None, None, turned_published),
    exchanged: (exchanged_start, spinning_step, exchanged_published),
    spinning: (spinning_start, spinning_step, published),
    nonsense: (nonsense_start, spinning_step, published),
    nowhere: (nowhere_start, spinning_step, published),
    half: (half_start, spinning_step, published),
    edge: (edge_start, edge_step, published),
    loop: (loop_start, loop_step, published),
    one_sided: (one_sided_start, one_sided_step, published),
}
EDGES = (1, 2, 3)


@pytest.fixture(autouse=True, scope="module")
def guess_compiled():
    """Compile ``guess``, which only compiled code calls."""
    from numba import njit

    in_python = guess
    globals()["guess"] = njit(in_python)
    yield
    globals()["guess"] = in_python


def laws_of(monkeypatch, explore, only):
    """The laws that are broken, world by world, by both judges; only one is looked at, or all."""
    bound = "n - 1" if only in (None, "bound") else None
    rules = Rules(laws=None if only is None else (only,), bound=bound)
    wrong = addresses(*WRONG[explore])
    monkeypatch.setattr("allworlds.engines.kernel.engine.explorer_addresses", lambda _: wrong)
    subject = replace(in_process_subject(explore), explore=explore)
    for edges in EDGES:
        extent = Extent(MapClass.MAPS, edges)
        for prefix in prefixes(edges, depth=2 * edges):
            played = played_tally(Scope(extent, rules), subject, LevelUnit(edges, prefix))
            level = level_of("algorithm1", rules, extent, edges)
            judged = judge(level, prefix, keep=20).broken
            yield {found.law for found in played.findings}, {run.law for run in judged}


@pytest.mark.slowest
@pytest.mark.parametrize("only", [None, *LAWS])
@pytest.mark.parametrize("explore", WRONG, ids=lambda explore: explore.__name__)
def test_both_judges_find_the_same_law_broken(monkeypatch, explore, only):
    both = list(laws_of(monkeypatch, explore, only))
    assert [python for python, _ in both] == [compiled for _, compiled in both]


@pytest.mark.slowest
def test_every_law_is_broken_by_one_of_them(monkeypatch):
    found = set()
    for explore in WRONG:
        for only in (None, *LAWS):
            for _, compiled in laws_of(monkeypatch, explore, only):
                found |= compiled
    assert found >= {"illegal-action", "no-estimate", "budget", *LAWS}
