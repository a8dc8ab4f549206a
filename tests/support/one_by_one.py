"""Every schedule of some robots, one by one: nothing is merged, each robot is a fresh generator."""

from itertools import combinations

from allworlds.protocol.actions import IllegalAction, Wait, Watch
from allworlds.robots.single_search import search


class Robot:
    """A robot after some percepts: its program is played anew each time."""

    def __init__(self, program, told, percepts=(), due=None):
        self.program, self.told, self.percepts, self.due = program, told, percepts, due
        self.says, self.ended, self.raised = None, None, False
        if not percepts:
            return
        run = program(percepts[0], told=told)
        try:
            self.says = next(run)
            for percept in percepts[1:]:
                self.says = run.send(percept)
        except StopIteration as stop:
            self.says, self.ended = None, (stop.value,)
        except ZeroDivisionError:
            self.says, self.raised = None, True

    def after_look(self, percept):
        return Robot(self.program, self.told, (*self.percepts, percept))

    def moving(self, due):
        return Robot(self.program, self.told, self.percepts, due)

    def can_look(self, percept):
        return not (type(self.says) is Watch and alike(percept, self.percepts[-1]))


def alike(one, other):
    return repr(one) == repr(other)


def groups(scheduler, able):
    if scheduler == "fsync":
        return [tuple(able)]
    if scheduler == "central":
        return [(robot,) for robot in able]
    return [group for size in range(1, len(able) + 1) for group in combinations(able, size)]


def after_looks(map_, model, state, due):
    """The states after some looks, one after the other."""
    every = [(state, "")]
    for robot, action in due.items():
        every = [to for before, _ in every for to in model.looked(map_, before, robot, action)]
    return every


class Schedules:
    """All maximal schedules in one world; each is its length, and the law that is broken or ''."""

    def __init__(self, map_, model, team, scheduler, budget=20, lead=None):
        self.map, self.model, self.team, self.scheduler = map_, model, team, scheduler
        self.budget, self.lead = budget, lead
        self.rounds = scheduler in ("fsync", "ssync")

    def ends(self, starts):
        robots = [Robot(p, self.model.told(self.map, r)) for r, p in enumerate(self.team)]
        for state in self.model.initial(self.map, starts):
            yield from self.onward(state, robots, [0] * len(robots), 0)

    def onward(self, state, robots, ahead, length):
        sensed = [self.model.sensed(self.map, state, r) for r in range(len(robots))]
        if self.model.bad(self.map, state):
            yield length, "never"
            return
        if self.model.over(self.map, state):
            yield length, ""
            return
        able, cut = [], []
        for r, robot in enumerate(robots):
            if sensed[r] is None or robot.ended or not (robot.due or robot.can_look(sensed[r])):
                continue
            spent = len(robot.percepts) >= self.budget and not robot.due
            (cut if spent else able).append(r)
        if self.lead is not None and able:
            least = min(ahead[r] for r in able)
            able = [r for r in able if robots[r].due or ahead[r] < least + self.lead]
        if cut and (not able or self.scheduler == "fsync"):
            yield length, "cut"
            return
        if not able:
            yield from self.stop(state, robots, sensed, ahead, length)
            return
        for group in groups(self.scheduler, able):
            yield from self.together(group, state, robots, sensed, ahead, length)

    def together(self, group, state, robots, sensed, ahead, length):
        after, acts, count, due = [*robots], {}, [*ahead], {}
        for r in group:
            if robots[r].due:
                acts[r], after[r] = robots[r].due, robots[r].moving(None)
                continue
            count[r] += 1
            after[r] = robots[r].after_look(sensed[r])
            if after[r].raised:
                yield length + 1, "crash"
                return
            if after[r].ended or type(after[r].says) in (Wait, Watch):
                continue
            if self.scheduler == "async":
                due[r] = after[r].says
                after[r] = after[r].moving(due[r])
            else:
                acts[r] = after[r].says
        try:
            every = [*after_looks(self.map, self.model, state, due)]
            if acts or self.rounds:
                every = [to for s, *_ in every for to in self.model.step(self.map, s, acts)]
        except IllegalAction:
            yield length + 1, "illegal-action"
            return
        if self.lead is not None:
            count = [max(each, max(count) - self.lead) for each in count]
        for to, *_ in every:
            yield from self.onward(to, after, count, length + 1)

    def stop(self, state, robots, sensed, ahead, length):
        """The end of a run in which nobody is able, unless the world changes."""
        gone = all(s is None or r.ended for s, r in zip(sensed, robots, strict=True))
        every = [state]
        if self.rounds and not gone:
            every = [to for to, _ in self.model.step(self.map, state, {})]
        if every != [state]:
            for to in every:
                yield from self.onward(to, robots, ahead, length + 1)
            return
        answers = [robot.ended[0] if robot.ended else None for robot in robots]
        law = "answer" if gone else "deadlock"
        if self.model.says_progress:
            for condition in self.model.progress(self.map):
                if condition.holds and not condition.holds(state):
                    yield length, "progress"
                    return
        yield length, law if self.model.flaw(self.map, state, answers) else ""


def agree(map_, starts, model, team, scheduler, budget=4, lead=None):
    """Compare both; return the number of schedules."""
    found = search(map_, starts, model, team, scheduler, budget=budget, lead=lead)
    ends = [*Schedules(map_, model, team, scheduler, budget, lead).ends(starts)]
    broken = [end for end in ends if end[1] not in ("", "cut")]
    least = min(length for length, _ in broken) if broken else 0
    laws = {law for length, law in broken if length == least} or {""}
    assert found.law in laws
    if broken:
        assert len(found.events) == least
        return len(ends)
    assert bool(found.unfinished) == any(law == "cut" for _, law in ends)
    if found.holds:
        assert found.schedules == len(ends)
    return len(ends)
