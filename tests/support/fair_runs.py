"""Infinite fair runs of automata by a greatest fixed point, without strongly connected parts.

A configuration is the state and for each robot (memory, the action that is due, the percept that
it watches, whether it has ended).  From the configurations in which a condition does not hold all
are taken out from which one cannot, inside, reach a step that each kind of fairness asks for; what
is left at the end are the runs that go on for ever, fairly, without the condition.
"""

from allworlds.protocol.actions import End, Wait, Watch
from one_by_one import groups


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
        """Each step: the group, whether somebody acts, the next configuration."""
        state, robots = configuration
        if self.model.over(self.map, state):
            return
        able = self.able(configuration)
        for group in groups(self.scheduler, able) if able else [()]:
            after, acts = [*robots], {}
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
                    after[r] = (memory, action, None, False)
                else:
                    acts[r] = action
            every = [state]
            if acts or self.rounds:
                every = [to for to, _ in self.model.step(self.map, state, acts)]
            for to in every:
                yield group, bool(acts), (to, tuple(after))

    def graph(self, starts):
        """All configurations that can be reached, with their steps."""
        found, queue = {}, self.first(starts)
        for configuration in queue:
            if configuration not in found:
                found[configuration] = [*self.steps(configuration)]
                queue += [step[2] for step in found[configuration]]
        return found

    def breaks(self, starts, condition, assumptions=()):
        """Whether an infinite fair run breaks the condition."""
        graph = self.graph(starts)
        wishes = [self.fair(r) for r in range(len(self.team))]
        wishes += [lambda b, s, a=a: a.holds(b[0], s[2][0], "") for a in assumptions]
        left = {*graph}
        if condition.holds is None:
            wishes.append(lambda _, step: step[1])
        elif condition.forever:
            wishes.append(lambda before, _: not condition.holds(before[0]))
        else:
            left = {each for each in graph if not condition.holds(each[0])}
        return bool(fixed_point(graph, left, wishes))

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


def walk_anew(team, starts, found):
    """Walk the events of a finding; return the configurations before each, and the last one."""
    at = team.first(starts)
    way = []
    for event in found.events:
        assert len(at) == 1
        way.append(at[0])
        group = tuple(turn.robot for turn in event.turns)
        assert {*group} <= {*team.able(at[0])}
        at = [to for who, _, to in team.steps(at[0]) if who == group and to[0] == event.state]
        moved = [turn for turn in event.turns if turn.sensed is None]
        assert all(way[-1][1][turn.robot][1] == turn.did for turn in moved)
    return [*way, *at]
