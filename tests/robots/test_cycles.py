"""Fair cycles: against a second algorithm, and walked anew step by step."""

from dataclasses import dataclass
from itertools import product
from types import SimpleNamespace

import pytest

from allworlds.protocol.actions import Do, Move, Watch
from allworlds.protocol.turns import Automaton
from allworlds.robots.configurations import Search
from allworlds.robots.cycles import components
from allworlds.robots.minds import Minds
from allworlds.robots.model import SCHEDULERS, Assumption, Model, ModelInMap
from allworlds.robots.schedulers import Timing
from allworlds.robots.single_search import search, turns_of
from fair_runs import agree_on_cycles
from small import EDGE, PATH
from worlds_that_change import GATES, WORLDS, Lamp, Together, automata


def test_a_second_algorithm_for_fair_cycles_agrees():
    """On some of the automata, each with another world and another scheduler."""
    every = [*automata()]
    lassos = 0
    for number, (world, scheduler) in enumerate(product(WORLDS, SCHEDULERS)):
        for automaton in every[number % 23 :: 23]:
            lassos += agree_on_cycles(world, scheduler, automaton)
    assert lassos > 100


@pytest.mark.parametrize("scheduler", SCHEDULERS)
def test_a_second_algorithm_agrees_where_robots_watch(scheduler):
    for world in [*WORLDS[1::2], *GATES]:
        for automaton in [*automata(Watch())][3::29]:
            agree_on_cycles(world, scheduler, automaton)


@pytest.mark.slowest
@pytest.mark.parametrize("scheduler", SCHEDULERS)
@pytest.mark.parametrize("number", range(len(WORLDS)))
def test_a_second_algorithm_agrees_on_all_automata_of_two_states(number, scheduler):
    """With nine worlds and four schedulers 9,216 searches."""
    assert sum(1 for _ in automata()) == 256
    for automaton in automata():
        agree_on_cycles(WORLDS[number], scheduler, automaton)


# ---------------------------------------------------------------- runs of one scheduler in another


def searched(world, automaton, scheduler, minds):
    map_, starts, model = world
    made = Search(ModelInMap(model, map_, "model"), starts, [0, 0], minds, Timing(scheduler))
    made.begin()
    while made.going:
        made.plan()
        minds.ask()
        made.expand()
        minds.forget()
    made.finish()
    return made


def configurations(made):
    """By state and minds, the numbers."""
    return {made.configuration(number)[:2]: number for number in range(len(made))}


def after(made, number, group):
    """The configurations after a step of a group, by state and minds."""
    bits = sum(1 << robot for robot in group)
    steps = [step for step in made.graph.transitions(number) if made.graph.bits(step) == bits]
    return {made.configuration(made.graph.target(step))[:2] for step in steps}


def test_every_ssync_step_is_two_async_steps():
    """Look at once, then move at once: so whatever breaks in ssync breaks in async."""
    tried = 0
    for number, automaton in enumerate([*automata()][::5]):
        world = WORLDS[number % len(WORLDS)]
        minds = Minds([turns_of(automaton)])
        slow, fast = (searched(world, automaton, s, minds) for s in ("async", "ssync"))
        if slow.broken or fast.broken:
            assert slow.broken, "found in ssync, and not in async"
            if slow.broken.law == "never":
                continue
        numbers = configurations(slow)
        for at in range(len(fast)):
            before = numbers[fast.configuration(at)[:2]]
            for step in fast.graph.transitions(at):
                group = [robot for robot in (0, 1) if fast.graph.bits(step) >> robot & 1]
                (looked,) = after(slow, before, group)
                moving = [robot for robot in group if looked[1][robot] < 0]
                moved = after(slow, numbers[looked], moving) if moving else {looked}
                assert fast.configuration(fast.graph.target(step))[:2] in moved
                tried += 1
    assert tried > 1000


# ---------------------------------------------------------------- who is fair, and to whom


@dataclass(frozen=True)
class Bridge(Model):
    """A robot that wants to cross an edge, which the adversary may take away.

    Attributes:
        recurrent: whether it must be there again and again.
    """

    recurrent: bool = False

    def initial(self, map_, starts):
        yield starts[0]

    def sensed(self, map_, state, robot):
        return state

    def step(self, map_, state, acts):
        yield state, "gone"
        yield (map_.alpha[state] if acts else state), "there"

    def over(self, map_, state):
        return state == 1

    def assumes(self, map_):
        if self.recurrent:
            yield Assumption("the edge is there", lambda before, after, words: words == "there")


def test_a_cycle_counts_only_if_the_adversary_keeps_what_is_assumed():
    cross = Automaton(None, lambda memory, percept: (memory, Move(0)))
    unfair = search(EDGE, (0,), Bridge(), [cross], "fsync")
    assert (unfair.law, unfair.loop) == ("progress", 1)
    assert unfair.events[-1].world == "gone"
    assert search(EDGE, (0,), Bridge(recurrent=True), [cross], "fsync").holds


@dataclass(frozen=True)
class TwoWays(Model):
    """The adversary chooses a side once; then the world blinks for ever, while nobody is able.

    Attributes:
        harmless: the side on which a robot may wait for ever.
    """

    harmless: int = 0

    def initial(self, map_, starts):
        yield 0, 0
        yield 1, 0

    def sensed(self, map_, state, robot):
        return "nothing"

    def step(self, map_, state, acts):
        yield (state[0], 1 - state[1]), ""

    def flaw(self, map_, state, answers):
        return "" if state[0] == self.harmless else "nobody waits here for ever"


@pytest.mark.parametrize("harmless", [0, 1, 2])
@pytest.mark.parametrize("scheduler", ["fsync", "ssync"])
def test_every_cycle_in_which_nobody_is_able_is_judged(harmless, scheduler):
    """The first one may be harmless."""
    still = Automaton(None, lambda memory, percept: (memory, Watch()))
    found = search(EDGE, (0,), TwoWays(harmless), [still], scheduler)
    assert found.law == "deadlock"
    assert found.events[-1].state[0] != harmless
    assert search(EDGE, (0,), Harmless(), [still], scheduler).holds


@dataclass(frozen=True)
class Harmless(TwoWays):
    """One may wait for ever on both sides."""

    def flaw(self, map_, state, answers):
        return ""


@dataclass(frozen=True)
class Nudges(Harmless):
    """While nobody is able the adversary does nothing for ever, or nudges the robot for ever."""

    def initial(self, map_, starts):
        yield 0, 0

    def sensed(self, map_, state, robot):
        return state[0]

    def step(self, map_, state, acts):
        yield (state[0], 1 - state[1]), "nothing"
        yield (1 - state[0], state[1]), "nudges"


def test_a_cycle_with_activations_is_found_beside_a_harmless_one():
    still = Automaton(None, lambda memory, percept: (memory, Watch()))
    found = search(EDGE, (0,), Nudges(), [still], "fsync")
    assert (found.law, found.seen) == ("progress", "the run goes on for ever without the goal")
    assert any(event.turns for event in found.events[-found.loop :])


def test_a_run_in_which_all_watch_repeats_itself_for_ever():
    for actions in ((Watch(),), (Move(1), Watch())):
        stops = Automaton(0, lambda at, _, a=actions: (min(at + 1, len(a) - 1), a[at]))
        found = search(PATH, (0, 3), Together(aim="FG"), [stops] * 2, "fsync")
        assert found.law == ("" if len(actions) > 1 else "progress")


def test_who_is_no_more_between_look_and_move_does_not_move():
    """Robot 1 has looked, and is shot before it moves."""

    def step(memory, percept):
        return memory, Do("shoot") if memory else Move(1)

    team = [Automaton(lambda told: told == 0, step)] * 2
    found = search(EDGE, (0, 1), Lamp(), team, "async")
    for number in range(len(found.search)):
        state, _, _ = found.search.configuration(number)
        able, _ = found.search.able(number)
        assert not {*state.gone} & {*able}


def test_components_are_each_found_once():
    """Whatever comes in its turn has often been met before."""
    graph = {0: [1], 1: [0, 2], 2: [2, 3], 3: [4], 4: [5], 5: [3, 6], 6: [], 7: [7, 0], 8: [9]}
    search = SimpleNamespace(graph=SimpleNamespace(targets=lambda found: found))
    found = [*components(search, sorted(graph), lambda at: graph[at])]
    assert found == [[0, 1], [2], [3, 4, 5], [7]]
