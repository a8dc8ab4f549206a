import itertools
import os
import signal

import pytest

from allworlds import log
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.inputs import checks
from allworlds.judging.episode import Answered, Fault, ending_of, followed, play
from allworlds.maps import CombinatorialMap, InvalidMap, from_cycles, rooted_maps
from allworlds.protocol.actions import (
    Ambiguous,
    Checkpoint,
    Drop,
    Estimate,
    ExplorerFault,
    IllegalAction,
    Move,
    Percept,
    Pick,
)
from allworlds.protocol.choices import Choices
from allworlds.protocol.playing import A_VALUE, FRAMES, MOST_DARTS, any_answer_entry
from allworlds.world import Directional, World
from interrupts import Unshown, interrupted_at_its_close
from small import EDGE, PATH

WORLD = World(PATH, Directional(0))
HUGE = 10**5000  # more digits than Python turns into text by default
BUDGET = 7


def run(explore, world=WORLD, budget=BUDGET, beat=None):
    return play(world, lambda first, _choices, _told: explore(first), Choices(), budget, beat)


def raising(error):
    def explore(first):
        yield Move(0)
        raise error

    return explore


def yielding(*messages):
    def explore(first):
        for message in messages:  # noqa: UP028  # a tuple cannot be sent the percepts
            yield message
        return Estimate(EDGE, 0)

    return explore


def returning(answer):
    def explore(first):
        yield Move(0)
        return answer

    return explore


def fault(explore, law, **options):
    """The fault of a run; by this law, in short sentences, and the beat is 0 again."""
    beat = [5, 9]
    escaped = ending = None
    try:
        ending = run(explore, beat=beat, **options).ending
    except BaseException as error:  # noqa: BLE001  # told below, without what an odd error says
        escaped = type(error).__name__
    assert escaped is None
    assert type(ending) is Fault
    assert ending.law == law, ending
    for sentence in (ending.expected, ending.seen):
        assert type(sentence) is str
        assert sentence
        assert len(sentence) < 1000
    assert beat == [5, 0]
    return ending


class Evil:
    """An object that raises whatever is done with it; tests keep it out of their arguments."""

    def __init__(self, error):
        self.error = error

    def _raise(self, *_):
        raise self.error

    __repr__ = __index__ = __iter__ = __len__ = __getitem__ = __eq__ = __lt__ = __bool__ = _raise
    __hash__ = None


class Wordy:
    def __repr__(self):
        return "x" * 10**6


class Number:
    """An integer like those of numpy: no ``int``, but an index."""

    def __init__(self, value):
        self.value = value

    def __index__(self):
        return self.value


EVILS = [ValueError("no"), TypeError("no"), SystemExit(3), GeneratorExit(), StopIteration(1)]
EVIL_IDS = [type(error).__name__ for error in EVILS]


# ---------------------------------------------------------------- what goes well


def test_an_episode_records_what_was_done_and_sensed():
    seen = []

    def explore(first):
        seen.append(first)
        seen.append((yield Move(0)))
        seen.append((yield Checkpoint([0], [0], 0)))
        seen.append((yield Move(1)))
        return Estimate(PATH, 3)

    beat = [1, 1]
    episode = run(explore, beat=beat)
    percepts = [Percept(1, 1, 0), Percept(2, 0, None), Percept(1, 0, None)]
    assert seen == [percepts[0], percepts[1], None, percepts[2]]
    assert episode.transcript.first == percepts[0]
    assert episode.transcript.steps == ((Move(0), percepts[1]), (Move(1), percepts[2]))
    assert episode.transcript.cost == 2
    assert episode.checkpoints == ((1, Checkpoint((0,), (0,), 0)),)
    assert episode.ending == Answered(Estimate(PATH, 3))
    assert beat == [1, 0]


def test_the_beat_grows_at_each_turn_of_the_explorer():
    beat = [0, 0]
    seen = []

    def explore(first):
        seen.append(beat[1])
        yield Move(0)
        seen.append(beat[1])
        yield Checkpoint([0], [0], 0)
        seen.append(beat[1])
        yield Move(0)
        seen.append(beat[1])
        return Estimate(EDGE, 0)

    run(explore, beat=beat)
    assert seen[0] > 0
    assert seen == sorted(set(seen))
    assert beat[1] == 0


def test_the_explorer_gets_the_choices_and_what_it_is_told():
    choices, got = Choices(), []

    def player(first, given, told):
        got.extend((first, given, told))
        return algorithm1(first, choices=given)

    play(WORLD, player, choices, 100)
    assert got[0] == WORLD.first
    assert got[1] is choices
    assert got[2] is None


@pytest.mark.parametrize("k", [0, 1, -1, 5, -5, 1000, HUGE, -HUGE - 1], ids=itertools.count())
def test_transcripts_hold_k_modulo_the_degree(k):
    for form in (k, Number(k)):
        steps = run(yielding(Move(0), Move(form))).transcript.steps
        assert [action for action, _ in steps] == [Move(0), Move(k % 2)]
        assert all(type(action.k) is int for action, _ in steps)


def test_numpy_integers_are_integers():
    numpy = pytest.importorskip("numpy")
    steps = run(yielding(Move(0), Move(numpy.int64(-1)))).transcript.steps
    assert steps[1][0] == Move(1)
    assert type(steps[1][0].k) is int
    checkpoint = Checkpoint(numpy.array([1, 0]), numpy.array([0, 1]), numpy.uint8(1))
    published = run(yielding(checkpoint)).checkpoints[0][1]
    assert published == Checkpoint((1, 0), (0, 1), 1)
    assert {type(d) for d in (*published.sigma, *published.alpha, published.here)} == {int}
    answer = run(returning(Estimate(EDGE, numpy.int32(1)))).ending
    assert type(answer.answer.here) is int


def test_degrees_beyond_the_prepared_moves_are_walked_too():
    degree = 80  # one vertex with forty loops
    sigma = [(d + 1) % degree for d in range(degree)]
    world = World(CombinatorialMap(sigma, [d ^ 1 for d in range(degree)]), Directional(0))
    steps = run(yielding(Move(62), Move(63), Move(64), Move(79)), world, 4).transcript.steps
    assert [action.k for action, _ in steps] == [62, 63, 64, 79]
    # From dart d motion k arrives by ((d + k) modulo 80) ^ 1.
    assert [percept.bearing for _, percept in steps] == [-d % degree for d in (63, 47, 30, 28)]


def test_an_explorer_may_answer_without_a_step():
    def explore(first):
        return Estimate(EDGE, 1)
        yield

    episode = run(explore, budget=0)
    assert episode.ending == Answered(Estimate(EDGE, 1))
    assert episode.transcript.steps == ()


def test_a_checkpoint_is_kept_as_it_was_when_it_was_published():
    sigma, alpha = [0], [0]

    def explore(first):
        yield Checkpoint(sigma, alpha, 0)
        sigma.append(9)
        yield Checkpoint(sigma, alpha, 0)
        return Estimate(EDGE, 0)

    assert [c.sigma for _, c in run(explore).checkpoints] == [(0,), (0, 9)]


def test_a_trusted_map_that_is_one_is_an_answer():
    assert run(returning(Estimate(CombinatorialMap.trusted([0, 1], [1, 0]), 1))).ending == Answered(
        Estimate(EDGE, 1)
    )


def test_algorithm_1_ends_with_an_answer_in_every_small_world():
    for m in (1, 2, 3):
        for map_ in rooted_maps(m):
            for place in Directional.places(map_, 0):
                episode = play(
                    World(map_, place),
                    lambda first, c, _: algorithm1(first, choices=c),
                    Choices(),
                    999,
                )
                assert type(episode.ending) is Answered
                assert len(episode.checkpoints) == m


def test_playing_twice_is_the_same_episode():
    def player(first, choices, _told):
        return algorithm1(first, choices=choices)

    for map_ in rooted_maps(3):
        world = World(map_, Directional(0))
        assert play(world, player, Choices(), 999) == play(world, player, Choices(), 999)


# ---------------------------------------------------------------- raising


class Own(BaseException):
    pass


class WordlessError(Exception):
    def __str__(self):
        raise RuntimeError


@pytest.mark.parametrize(
    ("error", "named"),
    [
        (Exception("boom"), "Exception: boom"),
        (Own("boom"), "Own: boom"),
        (SystemExit(3), "SystemExit: 3"),
        (GeneratorExit(), "GeneratorExit"),
        (StopIteration(3), "RuntimeError: generator raised StopIteration"),
        (RecursionError("deep"), "RecursionError: deep"),
        (MemoryError(), "MemoryError"),
        (WordlessError(), "WordlessError"),
        (ExceptionGroup("many", [ValueError("one")]), "many"),
        (SyntaxError("bad", ("file", 1, 1, "text")), "SyntaxError"),
    ],
    ids=lambda value: type(value).__name__,
)
def test_whatever_is_raised_is_a_crash(error, named):
    assert named in fault(raising(error), "crash").seen


def test_an_error_before_the_first_action_is_a_crash():
    def explore(first):
        raise ValueError("at once")
        yield

    assert "at once" in fault(explore, "crash").seen


def test_a_player_that_makes_no_generator_is_a_crash():
    fault(lambda first: None, "crash")
    fault(lambda first: 1 / 0, "crash")
    fault(lambda first: iter([Move(0)]), "crash")


def test_an_explorer_that_runs_itself_is_a_crash():
    own = []

    def explore(first):
        yield Move(0)
        own[0].send(None)

    def player(first):
        own.append(explore(first))
        return own[0]

    assert "already executing" in fault(player, "crash").seen


def test_the_traceback_begins_in_the_explorer():
    detail = fault(raising(ValueError("boom")), "crash").detail
    assert "in explore" in detail
    assert "ValueError: boom" in detail
    assert 'episode.py", line' not in detail.replace("test_episode.py", "")


def test_what_was_walked_before_a_crash_is_kept():
    episode = run(raising(ValueError("boom")))
    assert [action for action, _ in episode.transcript.steps] == [Move(0)]


def test_an_interrupt_is_the_explorers_where_interrupts_are_the_owners_business(monkeypatch):
    monkeypatch.setattr(checks._Interrupts, "of_owner", True)
    assert "KeyboardInterrupt" in fault(raising(KeyboardInterrupt()), "crash").seen


@pytest.mark.parametrize("handler", [signal.SIG_IGN, signal.SIG_DFL, signal.default_int_handler])
def test_an_interrupt_is_the_users_anywhere_else_whatever_becomes_of_sigint(handler):
    before, beat = signal.signal(signal.SIGINT, handler), [0, 1]
    try:
        with pytest.raises(KeyboardInterrupt):
            run(raising(KeyboardInterrupt()), beat=beat)
    finally:
        signal.signal(signal.SIGINT, before)
    assert beat[1] == 0


def test_an_interrupt_while_something_is_shown_is_the_users_too():
    with pytest.raises(KeyboardInterrupt):
        run(yielding(Evil(KeyboardInterrupt())))


class Unlisted(dict):
    """It cannot be looked through."""

    def items(self):
        raise KeyboardInterrupt


def test_an_interrupt_while_what_is_said_is_read_is_the_users_too():
    class Interrupted:
        def __index__(self):
            raise KeyboardInterrupt

        def __iter__(self):
            raise KeyboardInterrupt

    for said in (Move(Interrupted()), Checkpoint(Interrupted(), (1, 0), 0)):
        with pytest.raises(KeyboardInterrupt):
            run(yielding(said))
    answer = Ambiguous((0,), (0,), Interrupted(), (1,), 0)
    with pytest.raises(KeyboardInterrupt):
        run(returning(answer))
    with pytest.raises(KeyboardInterrupt):
        any_answer_entry(Unlisted(a=1))
    with pytest.raises(KeyboardInterrupt):
        run(raising(Unshown()))


def test_an_interrupt_while_an_explorer_is_closed_is_the_users_too():
    with pytest.raises(KeyboardInterrupt):
        run(interrupted_at_its_close, budget=3)


def test_the_percepts_of_the_log_are_not_those_that_the_explorer_holds():
    held = []

    def explore(first):
        held.append(first)
        for _ in range(3):
            held.append((yield Move(0)))

    transcript = run(explore).transcript
    logged = [transcript.first, *(percept for _, percept in transcript.steps)]
    assert held == logged
    assert not {*map(id, held)} & {*map(id, logged)}


def test_a_real_interrupt_during_the_explorers_turn_goes_through():
    def explore(first):
        os.kill(os.getpid(), signal.SIGINT)
        while True:
            yield Move(0)

    with pytest.raises(KeyboardInterrupt):
        run(explore, budget=10**6)


@pytest.mark.parametrize("law", ["crash", "timeout", "illegal-action", "no-estimate"])
def test_an_adapters_fault_keeps_its_law_and_words(law):
    ending = run(raising(ExplorerFault(law, "what was seen", "the tail"))).ending
    assert (ending.law, ending.seen, ending.detail) == (law, "what was seen", "the tail")


class HollowFault(ExplorerFault):
    def __init__(self):
        pass


class OddModuleError(Exception):
    __module__ = 5


class OddTracebackError(Exception):
    __traceback__ = property(lambda _: 1 / 0)


class OddNotesError(Exception):
    __notes__ = property(lambda _: 1 / 0)


ODD_ERRORS = {
    "hollow ExplorerFault": HollowFault(),
    "odd module": OddModuleError(),
    "odd traceback": OddTracebackError(),
    "odd notes": OddNotesError(),
    "odd SyntaxError": SyntaxError("bad", ("file", 1, 1, 5)),
}


@pytest.mark.parametrize("kind", ODD_ERRORS)
def test_an_error_that_cannot_be_formatted_is_a_crash_all_the_same(kind):
    fault(raising(ODD_ERRORS[kind]), "crash")


def test_a_crash_names_the_error_and_not_a_note_on_it():
    error = ValueError("boom")
    error.add_note("a note")
    assert "ValueError: boom" in fault(raising(error), "crash").seen


def recursing(depth):
    return recursing_too(depth)


def recursing_too(depth):
    try:
        return recursing(depth + 1)
    except RecursionError:
        raise ValueError("in its stead")  # noqa: B904  # a chain is wanted


def deeper(depth):
    return deepest(depth + 1)


def deepest(depth):
    return deeper(depth + 1)


@pytest.mark.parametrize("function", [recursing, deeper])
def test_a_recursion_without_an_end_is_told_in_few_frames_and_without_its_chain(function):
    def explore(first):
        yield Move(0)
        function(0)

    found = fault(explore, "crash")
    assert found.detail.count("  File ") <= FRAMES
    assert found.detail.count("Traceback") == 1
    assert found.detail.rstrip().endswith(found.seen)


def test_a_crash_with_a_huge_message_is_told_in_a_sentence():
    assert "ValueError" in fault(raising(ValueError("x" * 10**6)), "crash").seen


# ---------------------------------------------------------------- illegal actions


class Jump(Move):
    pass


class Point(Checkpoint):
    pass


ILLEGAL = [
    None,
    0,
    1,
    "move",
    b"1",
    2.5,
    (),
    Move,
    Jump(0),
    Point([0], [0], 0),
    Percept(1),
    Estimate(EDGE, 0),
    Move(True),  # noqa: FBT003
    Move("x"),
    Move("1"),
    Move(1.5),
    Move(1.0),
    Move(None),
    Move([1]),
    Move(1j),
    Drop(),
    Pick(),
    Drop,
    Wordy(),
    Move(Wordy()),
    *[Evil(error) for error in EVILS],
    *[Move(Evil(error)) for error in EVILS],
    Move(Number("x")),
    Checkpoint(None, [0], 0),
    Checkpoint([0], 3, 0),
    Checkpoint([0], [0], None),
    Checkpoint([0], [0], "0"),
    Checkpoint([0], [0], True),  # noqa: FBT003
    Checkpoint([0], [0], 0.0),
    Checkpoint([0.0], [0], 0),
    Checkpoint([0], [True], 0),
    Checkpoint(["0"], [0], 0),
    Checkpoint("0", [0], 0),
    Checkpoint([Wordy()], [0], 0),
    Checkpoint([Number("x")], [0], 0),
]


@pytest.mark.parametrize("i", range(len(ILLEGAL)))
def test_whatever_else_is_yielded_is_an_illegal_action(i):
    message = ILLEGAL[i]
    ending = fault(yielding(Move(0), message, Move(0)), "illegal-action")
    assert len(ending.seen) <= 200
    assert len(run(yielding(Move(0), message, Move(0))).transcript.steps) == 1


@pytest.mark.parametrize("error", EVILS, ids=EVIL_IDS)
@pytest.mark.parametrize("where", ["sigma", "alpha", "here", "entry"])
def test_a_checkpoint_whose_parts_raise_is_an_illegal_action(where, error):
    parts = {"sigma": [0], "alpha": [0], "here": 0}
    if where == "entry":
        parts["sigma"] = [Evil(error)]
    else:
        parts[where] = Evil(error)
    fault(yielding(Checkpoint(**parts)), "illegal-action")


def test_a_checkpoint_without_its_parts_is_an_illegal_action():
    fault(yielding(Checkpoint.__new__(Checkpoint)), "illegal-action")


def test_the_illegal_action_is_named():
    assert fault(yielding(Move("x")), "illegal-action").seen == "Move(k='x')"
    assert fault(yielding("go"), "illegal-action").seen == "'go'"
    ending = fault(yielding(Drop()), "illegal-action")
    assert ending.expected == "the directional lighthouse gives no markers"
    assert ending.seen == "Drop()"
    evil = fault(yielding(Evil(SystemExit())), "illegal-action")
    assert evil.seen == "an object of type Evil whose repr fails"


class Twisted(str):
    __slots__ = ()

    def __len__(self):
        raise ValueError


class Twister:
    def __repr__(self):
        return Twisted("x")


def test_a_repr_that_is_an_odd_string_is_an_illegal_action():
    fault(yielding(Twister()), "illegal-action")


# ---------------------------------------------------------------- budgets


def forever(message):
    def explore(first):
        while True:
            yield message

    return explore


@pytest.mark.parametrize("budget", [0, 1, 2, 7])
def test_the_step_budget_may_be_reached_and_not_passed(budget):
    episode = run(yielding(*[Move(0)] * budget), budget=budget)
    assert type(episode.ending) is Answered
    assert episode.transcript.cost == budget

    fault(yielding(*[Move(0)] * (budget + 1)), "budget", budget=budget)
    ending = fault(forever(Move(0)), "budget", budget=budget)
    assert ending.seen == f"traversal {budget + 1}"
    assert run(forever(Move(0)), budget=budget).transcript.cost == budget


@pytest.mark.parametrize("budget", [0, 1, 7])
def test_endless_checkpoints_pass_the_budget(budget):
    ending = fault(forever(Checkpoint([0], [0], 0)), "budget", budget=budget)
    published = len(run(forever(Checkpoint([0], [0], 0)), budget=budget).checkpoints)
    assert published == budget + 1  # one for each traversal, and one before the first
    assert ending.seen == f"checkpoint {published + 1}"


def test_an_illegal_move_is_illegal_even_where_the_budget_is_spent():
    fault(yielding(Move(0), Move("x")), "illegal-action", budget=1)
    fault(yielding(Move(0), Drop()), "illegal-action", budget=1)


# ---------------------------------------------------------------- generators that stay


def test_the_generator_is_closed_when_the_run_is_decided():
    closed = []

    def explore(first):
        try:
            yield "illegal"
        finally:
            closed.append(True)

    fault(explore, "illegal-action")
    assert closed == [True]


@pytest.mark.parametrize("error", EVILS, ids=lambda e: type(e).__name__)
def test_an_explorer_that_raises_while_it_is_closed_changes_nothing(error):
    def explore(first):
        try:
            yield "illegal"
        finally:
            raise error

    assert fault(explore, "illegal-action").seen == "'illegal'"


def test_an_explorer_that_refuses_to_close_changes_nothing():
    def explore(first):
        for message in ("illegal", Move(0)):
            try:
                yield message
            except GeneratorExit:
                continue

    assert fault(explore, "illegal-action").seen == "'illegal'"


def test_an_explorer_without_a_close_is_judged_like_any_other():
    class Machine:
        def send(self, reply):
            return "illegal"

    assert fault(lambda first: Machine(), "illegal-action").seen == "'illegal'"


# ---------------------------------------------------------------- answers


def tampered(sigma, alpha=(1, 0)):
    map_ = CombinatorialMap.trusted((0, 1), (1, 0))
    object.__setattr__(map_, "sigma", sigma)
    object.__setattr__(map_, "alpha", alpha)
    return map_


class Guess(Estimate):
    pass


class Liar:
    """Says that it is a map."""

    __class__ = CombinatorialMap


class Unasked:
    @property
    def __class__(self):
        raise RuntimeError


NO_ESTIMATES = [
    None,
    (EDGE, 0),
    EDGE,
    {"map": EDGE, "here": 0},
    Ambiguous((0,), (0,), (1,), (1, 1), 0),
    Ambiguous((), (), (), (), 0),
    Ambiguous((0,), (0,), (1,), (1,), Evil(ValueError("no"))),
    Ambiguous,
    Estimate,
    Guess(EDGE, 0),
    Estimate(None, 0),
    Estimate("map", 0),
    Estimate(EDGE.to_json(), 0),
    Estimate(Liar(), 0),
    Estimate(Wordy(), 0),
    Estimate(EDGE, 2),
    Estimate(EDGE, -1),
    Estimate(EDGE, True),  # noqa: FBT003
    Estimate(EDGE, 0.0),
    Estimate(EDGE, "0"),
    Estimate(EDGE, None),
    Estimate(EDGE, Wordy()),
    Estimate(EDGE, Number("x")),
    Estimate(CombinatorialMap.trusted((), ()), 0),
    Estimate(CombinatorialMap.trusted((0, 1), (0, 1)), 0),
    Estimate(CombinatorialMap.trusted((0, 0), (1, 0)), 0),
    Estimate(CombinatorialMap.trusted((0, 1), (1,)), 0),
    Estimate(CombinatorialMap.trusted((0, 1, 2, 3), (1, 0, 3, 2)), 0),
    Estimate(tampered(None), 0),
    Estimate(tampered(5), 0),
    Estimate(tampered((0.0, 1)), 0),
    Estimate(tampered((0, 1), "10"), 0),
    Wordy(),
    Evil(ValueError("no")),
    Evil(SystemExit()),
    Estimate(Evil(ValueError("no")), 0),
    Estimate(EDGE, Evil(ValueError("no"))),
    Estimate(tampered(Evil(ValueError("no"))), 0),
    Estimate(tampered((0, Evil(ValueError("no")))), 0),
]


@pytest.mark.parametrize("i", range(len(NO_ESTIMATES)))
def test_whatever_else_is_returned_is_no_estimate(i):
    answer = NO_ESTIMATES[i]
    fault(returning(answer), "no-estimate")


def test_an_estimate_whose_here_is_no_dart_says_which_are():
    seen = fault(returning(Estimate(PATH, 4)), "no-estimate").seen
    assert seen == "here = 4, but the darts are 0..3"


def test_an_estimate_of_an_invalid_map_says_why():
    answer = Estimate(CombinatorialMap.trusted((0, 1), (0, 1)), 0)
    assert "alpha[0] = 0" in fault(returning(answer), "no-estimate").seen


@pytest.mark.parametrize("sign", [1, -1])
def test_a_here_of_thousands_of_digits_is_no_estimate(sign):
    fault(returning(Estimate(EDGE, sign * HUGE)), "no-estimate")


def test_a_map_with_an_entry_of_thousands_of_digits_is_blamed_and_not_here():
    assert "here" not in fault(returning(Estimate(tampered((HUGE, 1)), 0)), "no-estimate").seen


def test_a_map_with_a_wordy_entry_is_told_in_a_sentence():
    fault(returning(Estimate(tampered((Wordy(), 1)), 0)), "no-estimate")


def endless():
    """As long as anyone asks."""
    return itertools.repeat(0)


@pytest.mark.parametrize(
    "answer",
    [
        Estimate(CombinatorialMap.trusted((0,) * (MOST_DARTS + 1), (0,)), 0),
        Ambiguous((0,), (0,), endless(), (0,), 0),
        Ambiguous((0,), (0,), (0,), endless(), 0),
    ],
    ids=["long", "degree", "marks"],
)
def test_of_an_answer_no_more_is_looked_at_than_a_world_can_have(answer):
    assert fault(returning(answer), "no-estimate").seen == "more than 200,000 darts"


def test_nor_of_a_map_without_end():
    answer = Estimate(tampered(endless()), 0)
    assert fault(returning(answer), "no-estimate").seen == "more than 200,000 darts"


@pytest.mark.parametrize("part", ["sigma", "alpha"])
def test_nor_of_a_checkpoint(part):
    parts = {"sigma": (0, 1), "alpha": (1, 0), part: endless()}
    told = fault(yielding(Checkpoint(**parts, here=0)), "illegal-action")
    assert told.seen == "more than 200,000 darts"


def test_whoever_may_walk_farther_may_publish_more():
    def explore(_):
        yield Checkpoint(range(MOST_DARTS + 2), (0,), 0)

    told = run(explore, budget=MOST_DARTS // 2 + 1)
    assert [len(published.sigma) for _, published in told.checkpoints] == [MOST_DARTS + 2]


@pytest.mark.parametrize("name", ["degree", "marks"])
def test_a_quotient_with_a_number_of_thousands_of_digits_is_none(name):
    parts = {"sigma": (0,), "alpha": (0,), "degree": (1,), "marks": (1,), "here": 0, name: (HUGE,)}
    assert f"{name} holds an object" in fault(returning(Ambiguous(**parts)), "no-estimate").seen


def test_an_estimate_without_its_parts_is_no_estimate():
    fault(returning(Estimate.__new__(Estimate)), "no-estimate")


@pytest.mark.parametrize(
    "error", [SystemExit(3), GeneratorExit(), Own()], ids=["exit", "gen", "own"]
)
@pytest.mark.parametrize("where", ["here", "sigma", "entry"])
def test_an_estimate_whose_parts_raise_anything_is_no_estimate(where, error):
    evil = Evil(error)
    answer = {
        "here": Estimate(EDGE, evil),
        "sigma": Estimate(tampered(evil), 0),
        "entry": Estimate(tampered((0, evil)), 0),
    }[where]
    fault(returning(answer), "no-estimate")


LIES = {"repr": Twister(), "class": Estimate(Unasked(), 0)}


@pytest.mark.parametrize("kind", LIES)
def test_answers_that_lie_about_themselves_are_no_estimate(kind):
    fault(returning(LIES[kind]), "no-estimate")


def trying(sigma, alpha):
    def explore(first):
        yield Move(0)
        return Estimate(CombinatorialMap(sigma, alpha), 0)

    return explore


def test_an_answer_that_is_no_map_is_no_estimate_and_is_shown():
    ended = fault(trying([1, 0, 3, 3], [1, 0, 3, 2]), "no-estimate")
    assert ended.seen == "no map: sigma[2] = sigma[3] = 3, but sigma must be a permutation"
    assert "sigma [1, 0, 3, 3]" in ended.detail
    assert ended.seen.removeprefix("no map: ") not in ended.detail
    assert "in explore: return Estimate(CombinatorialMap(sigma, alpha), 0)" in ended.detail


def test_an_invalid_map_on_the_way_is_no_estimate_too():
    def explore(first):
        yield Move(0)
        CombinatorialMap([0, 0], [1, 0])
        yield Move(0)

    assert fault(explore, "no-estimate").seen.startswith("no map: sigma[0] = sigma[1] = 0")


def test_an_invalid_map_out_of_a_builder_names_the_explorers_line():
    def explore(first):
        yield Move(0)
        return Estimate(from_cycles([["a"], ["b"]]), 0)

    assert "from_cycles([[" in fault(explore, "no-estimate").detail


def test_an_invalid_map_that_raises_when_it_is_looked_at_is_a_crash():
    class Odd(InvalidMap):
        @property
        def tried(self):
            raise ZeroDivisionError

    assert fault(raising(Odd("odd")), "crash").seen == "Odd, which cannot be shown"


# ---------------------------------------------------------------- logs that nobody has played


@pytest.mark.parametrize(
    "entries",
    [(log.DROP, 0, log.OVER), (log.DROP, 0, log.REFUSED), (log.DROP, log.PICK, log.FREE_TOO_OFTEN)],
)
def test_a_log_that_goes_on_after_an_illegal_action_is_no_walk(entries):
    with pytest.raises(IllegalAction) as error:
        followed(log.Log(bytes(entries)), WORLD, BUDGET)
    assert "markers" in str(error.value)


def test_a_log_may_end_with_an_illegal_action_or_with_one_that_is_one_too_many():
    illegal = followed(log.Log(bytes((0, log.DROP, log.REFUSED))), WORLD, BUDGET)
    assert (illegal.ending.law, illegal.ending.seen) == ("illegal-action", "Drop()")
    too_many = followed(log.Log(bytes((0, log.DROP, log.FREE_TOO_OFTEN))), WORLD, BUDGET)
    assert too_many.ending.law == "budget"
    for episode in (illegal, too_many):
        assert episode.transcript.actions == (Move(0),)


@pytest.mark.parametrize("text", ["{", "", "[" * 100_000])
def test_a_value_that_is_no_json_is_no_answer(text):
    episode = followed(log.Log(log.value(text)), WORLD, BUDGET)
    assert episode.ending == Fault("no-estimate", A_VALUE, checks.show(text))
    assert followed(log.Log(log.value("[1]")), WORLD, BUDGET).ending == Answered([1])


@pytest.mark.parametrize(
    ("code", "legal"),
    [(log.BEYOND, "nothing: the record ends here"), (log.REFUSED, "a legal action")],
)
def test_an_action_after_the_end_of_a_record_and_one_that_is_refused_have_other_words(code, legal):
    ending = ending_of(log.Log(bytes((0, 0, code))))
    assert ending == Fault("illegal-action", legal, "Move(k=0)")
