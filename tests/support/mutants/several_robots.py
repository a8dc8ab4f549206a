"""Searches with a fault: a scheduler, a merge, a cycle or a budget that is wrong."""

from msgspec.structs import replace

from allworlds.protocol import turns
from allworlds.robots import configurations, cycles
from allworlds.robots.configurations import Search
from allworlds.robots.minds import Minds
from allworlds.robots.schedulers import Timing


def one_at_a_time(patch):
    """Under ``async`` and ``ssync`` nobody is activated together with others."""
    patch.setattr(Timing, "groups", lambda _, able: [((robot,), 1 << robot) for robot in able])


def never_all(patch):
    """A set of robots is never the whole team."""
    groups = Timing.groups

    def some(timing, able):
        every = [*groups(timing, able)]
        return every[:-1] if len(every) > 1 else every

    patch.setattr(Timing, "groups", some)


def moves_at_once(patch):
    """Under ``async`` a robot moves when it looks."""
    begin = Search.begin

    def begun(search):
        search._slow = False
        begin(search)

    patch.setattr(Search, "begin", begun)


def no_empty_rounds(patch):
    """The world makes no step in a round in which nobody acts."""
    following = Search.following

    def still(search, state, acts, due):
        return following(search, state, acts, due) if acts or due else [(state, "")]

    patch.setattr(Search, "following", still)


def dead_ones_move(patch):
    """A robot that is no more makes the motion that was due."""
    able = Search.able

    def with_the_dead(search, number):
        living, cut = able(search, number)
        _, held, _ = search.configuration(number)
        pending = [r for r, mind in enumerate(held) if mind < 0]
        return sorted({*living, *pending}), cut

    patch.setattr(Search, "able", with_the_dead)


def truth_is_one(patch):
    """Percepts are merged by equality in Python: 1 and true are one."""
    look, seen = Minds.look, {}

    def merged(self, mind, sensed):
        plain = turns.percept_of(sensed)
        return look(
            self, mind, seen.setdefault((id(self), repr(plain).replace("True", "1")), sensed)
        )

    patch.setattr(Minds, "look", merged)


def told_alike(patch):
    """Whatever robots are told, one mind stands for all at the start."""
    root = Minds.root
    patch.setattr(Minds, "root", lambda self, program, _: root(self, program, b"0"))


def states_alone(patch):
    """Configurations are merged by the state of the world; minds do not count."""
    meet = Search._number_of

    def by_state(search, state, held, extra, *came):
        known = search._state_ids.get(state)
        if known is not None:
            for number, key in enumerate(search._keys):
                if key[0] == known:
                    return number
        return meet(search, state, held, extra, *came)

    patch.setattr(Search, "_number_of", by_state)


def watched_forgotten(patch):
    """Who watches is activated again, whatever it senses."""

    def blind(self, mind):
        self.watches[mind] = False
        return mind

    after = Minds.after
    patch.setattr(Minds, "after", lambda self, mind: blind(self, after(self, mind)))


def unfair(patch):
    """A cycle counts in which a robot is never activated, though it is able."""
    patch.setattr(cycles, "_fairness", lambda *_: [])


def too_fair(patch):
    """A cycle counts only if each robot is activated in it, also one that never can be."""

    def each(search, _):
        for robot in range(len(search.program_of)):
            yield lambda _, step, bit=1 << robot: search.graph.bits(step) & bit

    patch.setattr(cycles, "_fairness", each)


def no_assumption(patch):
    """What the adversary must do is not looked at."""
    patch.setattr(Search, "assumed", lambda *_: True)


def progress_on_the_cycle(patch):
    """A cycle is found though the goal is reached on it."""
    patch.setattr(cycles, "_holds", lambda *_: False)


def endings_are_good(patch):
    """A run in which nobody is able breaks no condition."""
    patch.setattr(Search, "stopped", lambda *_: None)


def largest_part_alone(patch):
    """Of the strongly connected parts the first alone is looked at."""
    every = cycles.components
    patch.setattr(cycles, "components", lambda *args: [*every(*args)][:1])


def cut_off_is_an_end(patch):
    """A run that the budget cuts off is no unfinished one."""

    def quietly(search, able, cut, number):
        return bool(cut) and (not able or search.timing.scheduler == "fsync")

    patch.setattr(Search, "_cut_off", quietly)


def one_more(patch):
    """The budget is one activation larger."""
    init = Search.__init__

    def wider(search, world, starts, team, programs, timing):
        init(search, world, starts, team, programs, replace(timing, budget=timing.budget + 1))

    patch.setattr(Search, "__init__", wider)


def endless_beside_a_generator(patch):
    """Where a generator is cut off, what automata do for ever is a fault of theirs."""
    patch.setattr(Search, "unable", Search.unable_or_cut)


def mixed_teams_end(patch):
    """In a team with a generator no run goes on for ever."""
    patch.setattr(configurations, "cut_for_ever", lambda _: None)


SEARCHES = (
    *(one_at_a_time, never_all, moves_at_once, no_empty_rounds, dead_ones_move, truth_is_one),
    *(told_alike, states_alone, watched_forgotten, unfair, too_fair, no_assumption),
    *(progress_on_the_cycle, endings_are_good, largest_part_alone, cut_off_is_an_end, one_more),
    endless_beside_a_generator,
    mixed_teams_end,
)
"""All of them: functions of pytest's ``monkeypatch``."""
