"""Infinite fair runs of automata by a greatest fixed point, without strongly connected parts.

A configuration is the state and for each robot (memory, the action that is due, the percept that
it watches, whether it has ended).  From the configurations in which a condition does not hold all
are taken out from which one cannot, inside, reach a step that each kind of fairness asks for; what
is left at the end are the runs that go on for ever, fairly, without the condition.
"""

from allworlds.protocol.actions import End, Move, Wait, Watch
from allworlds.robots.single_search import search
from one_by_one import after_looks, groups


class Automata:
    """A team of automata in a model and a map."""

    def __init__(self, map_, model, team, scheduler):
        self.map, self.model, self.team, self.scheduler = map_, model, team, scheduler
        self.rounds = scheduler in ("fsync", "ssync")

    def first(self, starts):
        robots = tuple((p.begun(self.model.told(self.map, r)), None, None, False)
                       for r, p in enumerate(self.team))  # fmt: skip
        return [(state, robots) for state in self.model.initial(self.map, starts)]

    def able(self, configuration):
        state, robots = configuration
        found = []
        for r, (_, due, watched, ended) in enumerate(robots):
            percept = self.model.sensed(self.map, state, r)
            if percept is not None and not ended and (due or watched is None or percept != watched):
                found.append(r)
        return found

    def steps(self, configuration):
        """Each step: the group, whether somebody acts, the next configuration, the words.

        No words: the world stands still, and no adversary is asked.
        """
        state, robots = configuration
        if self.model.over(self.map, state):
            return
        able = self.able(configuration)
        for group in groups(self.scheduler, able) if able else [()]:
            after, acts, looks = [*robots], {}, {}
            for r in group:
                memory, due, _, _ = robots[r]
                if due:
                    acts[r], after[r] = due, (memory, None, None, False)
                    continue
                percept = self.model.sensed(self.map, state, r)
                memory, action = self.team[r].step(memory, percept)
                watched = percept if type(action) is Watch else None
                after[r] = (memory, None, watched, type(action) is End)
                if type(action) in (End, Wait, Watch):
                    continue
                if self.scheduler == "async":
                    looks[r], after[r] = action, (memory, action, None, False)
                else:
                    acts[r] = action
            every = [(to, None) for to, _ in after_looks(self.map, self.model, state, looks)]
            if acts or self.rounds:
                every = [end for to, _ in every for end in self.model.step(self.map, to, acts)]
            for to, words in every:
                yield group, bool(acts), (to, tuple(after)), words

    def graph(self, starts):
        """All configurations that can be reached, with their steps."""
        found, queue = {}, self.first(starts)
        for configuration in queue:
            if configuration not in found:
                found[configuration] = [*self.steps(configuration)]
                queue += [step[2] for step in found[configuration]]
        return found

    def breaks(self, starts, condition, assumptions=()):
        """Whether an infinite fair run breaks the condition.

        Where the world makes no step at all the adversary keeps what is assumed.
        """
        graph = self.graph(starts)
        wishes = [self.fair(r) for r in range(len(self.team))]
        left = {*graph}
        if condition.holds is None:
            wishes.append(lambda _, step: step[1])
        elif condition.forever:
            wishes.append(lambda before, _: not condition.holds(before[0]))
        else:
            left = {each for each in graph if not condition.holds(each[0])}
        still = {at: [step for step in steps if step[3] is None] for at, steps in graph.items()}
        kept = [lambda b, s, a=a: a.holds(b[0], s[2][0], s[3]) for a in assumptions]
        return bool(fixed_point(graph, left, wishes + kept) or fixed_point(still, left, wishes))

    def fair(self, robot):
        return lambda before, step: robot in step[0] or robot not in self.able(before)


def fixed_point(graph, left, wishes):
    while True:
        before = len(left)
        for wish in wishes:
            met = {c for c in left if any(s[2] in left and wish(c, s) for s in graph[c])}
            left = can_reach(graph, left, met)
        if len(left) == before:
            return left


def can_reach(graph, inside, aims):
    found, grown = {*aims}, True
    while grown:
        new = {c for c in inside - found if any(s[2] in found for s in graph[c])}
        found |= new
        grown = bool(new)
    return found


def told(words, event):
    return words is None or event.world.endswith(words)


def walk_anew(team, starts, found):
    """Walk the events of a finding; return the configurations before each, and the last one."""
    at = team.first(starts)
    way = []
    for event in found.events:
        assert len(at) == 1
        way.append(at[0])
        group = tuple(turn.robot for turn in event.turns)
        assert {*group} <= {*team.able(at[0])}
        steps = [step for step in team.steps(at[0]) if step[0] == group]
        at = [to for _, _, to, words in steps if told(words, event) and to[0] == event.state]
        moved = [turn for turn in event.turns if turn.sensed is None]
        assert all(way[-1][1][turn.robot][1] == turn.did for turn in moved)
    return [*way, *at]


def agree_on_cycles(world, scheduler, automaton):
    """Compare both algorithms; walk a lasso; return whether there is one."""
    map_, starts, model = world
    team = Automata(map_, model, [automaton] * 2, scheduler)
    found = search(map_, starts, model, team.team, scheduler)
    (condition,) = model.progress(map_)
    assert bool(found.law) == team.breaks(starts, condition, [*model.assumes(map_)])
    if not found.law:
        return False
    way = walk_anew(team, starts, found)
    loop = way[len(way) - 1 - found.loop :]
    if not found.loop:
        assert not team.able(way[-1])
        return False
    assert loop[0] == loop[-1]
    events = found.events[-found.loop :]
    for robot in (0, 1):
        acting = any(turn.robot == robot for event in events for turn in event.turns)
        assert acting or any(robot not in team.able(at) for at in loop)
    if condition.holds is None:
        assert any(type(turn.did) is Move for event in events for turn in event.turns)
    else:
        assert not all(condition.holds(state) for state, _ in loop)
    return True
