"""Every schedule and every choice of the adversary in one world, as a graph of configurations.

A configuration is the state of the world with one mind for each robot.  The search goes breadth
first, so the first finding is a shortest one; schedules that differ by the order of steps which do
not meet lead to one configuration.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Sequence
from itertools import product
from typing import Any

from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import IllegalAction, Wait, Watch
from allworlds.protocol.turns import Sensed
from allworlds.robots.cycles import broken_for_ever, cut_for_ever
from allworlds.robots.events import event_of
from allworlds.robots.graph import Broken, Graph, Step
from allworlds.robots.minds import Ended, Fault, Minds
from allworlds.robots.model import Assumption, Guarded, joined
from allworlds.robots.schedulers import Time

STILL = Wait, Watch, Ended, Fault
"""The values of minds that make no step of the world."""


class Search:
    """One search.

    Args:
        world: the model in its map.
        starts: a dart for each robot.
        team: for each robot the number of its program.
        minds: of the programs; may be shared with other searches.
        time: the schedules.

    Attributes:
        found: what is broken, once it is known.
        unfinished: the number of runs that the budget cuts off, and a shortest one.
        full: whether there are more configurations than are allowed.
        longest: the largest number of activations of a robot in a run that ends.
    """

    def __init__(
        self, world: Guarded, starts: Sequence[Dart], team: Sequence[int], minds: Minds, time: Time
    ) -> None:
        self.world, self.starts, self.team = world, starts, team
        self.minds, self.time, self.graph = minds, time, Graph()
        self.found: Broken | None = None
        self.unfinished, self.shortest, self.full = 0, -1, False
        self.ends = self.longest = 0
        self._robots = range(len(team))
        self._slow = time.scheduler == "async"
        self._limited = False
        self._keys: list[tuple[Any, ...]] = []
        self._ids: dict[tuple[Any, ...], int] = {}
        self._came = tuple(array("i") for _ in Step._fields)
        self.states: list[Any] = []
        self._state_ids: dict[Any, int] = {}
        self._sensed: list[list[Any]] = []
        self._layer: list[int] = []
        self._plans: list[tuple[int, tuple[int, ...], tuple[int, ...]]] = []

    def begin(self) -> None:
        """Make the first configurations."""
        told = [self.world.told(robot) for robot in self._robots]
        roots = [self.minds.root(program, told[robot]) for robot, program in enumerate(self.team)]
        self._limited = not self.minds.finite
        ahead = (0,) * len(roots) if self.time.lead is not None else ()
        delays: list[tuple[int, ...]] = [()]
        if self.time.start_delay:
            delays = [(delay,) for delay in range(self.time.start_delay + 1)]
        choices = product(self.world.initial(self.starts), delays)
        for index, (state, delay) in enumerate(choices):
            self._meet(state, roots, (*delay, *ahead), Step(-1, 0, index))
        for robot, root in enumerate(roots):
            if type(value := self.minds.value[root]) is Fault and self._layer:
                self.found = Broken(value.law, value.seen, 0, robot=robot)

    # ---------------------------------------------------------------- the search

    @property
    def going(self) -> bool:
        """Whether there is a layer to be searched."""
        return bool(self._layer) and self.found is None and not self.full

    def plan(self) -> None:
        """Plan all steps of this layer; what its robots do next is asked for in the minds."""
        for number in self._layer:
            state, minds, _ = self.configuration(number)
            if seen := self.world.bad(state):
                self.found = Broken("never", seen, number)
                break
            if self.world.over(state):
                self._end(minds)
                continue
            able, cut = self.able(number)
            if self._cut_off(able, cut, number):
                continue
            if not able:
                if self._goes_on(number):
                    self._plans.append((number, (), ()))
                else:
                    self._stop(number)
                continue
            for group in self.time.groups(able):
                self._plans.append((number, group, self._looks(number, minds, group)))
            if self.found:
                break

    def act(self) -> None:
        """Make every step that is planned; the configurations that are new are the next layer."""
        plans, self._plans, self._layer = self._plans, [], []
        if self.found:
            return
        for number, group, looks in plans:
            self._begin_steps(number)
            if not self._make(number, group, looks):
                return
            if len(self._keys) > self.time.configurations:
                self.full = True
                return

    def configuration(self, number: int) -> tuple[Any, tuple[int, ...], tuple[int, ...]]:
        """The state, the minds, and what the scheduler keeps."""
        key = self._keys[number]
        robots = len(self.team)
        return self.states[key[0]], key[1 : robots + 1], key[robots + 1 :]

    def state_number(self, number: int) -> int:
        """The number of the state of a configuration."""
        return self._keys[number][0]  # type: ignore[no-any-return]

    def percept(self, number: int, robot: int) -> Sensed | None:
        """What a robot would sense in a configuration."""
        return self._sensed_in(self._keys[number][0])[robot]  # type: ignore[no-any-return]

    def able(self, number: int) -> tuple[list[int], list[int]]:
        """The robots that can be activated, and those that the budget alone keeps from it."""
        key, able, cut = self._keys[number], [], []
        sensed = self._sensed_in(key[0])
        value, watches = self.minds.value, self.minds.watches
        for robot in self._robots:
            mind = key[robot + 1]
            if sensed[robot] is None:
                continue
            if mind >= 0:
                if type(value[mind]) is Ended:
                    continue
                if watches[mind] and sensed[robot] == self.minds.sensed[mind]:
                    continue
                if self._limited and self.minds.depth[mind] >= self.time.budget:
                    cut.append(robot)
                    continue
            able.append(robot)
        extra = key[len(self.team) + 1 :]
        return (self._allowed(able, key[1:], extra) if extra else able), cut

    def _allowed(self, able: list[int], minds: Sequence[int], extra: tuple[int, ...]) -> list[int]:
        """Those whom the scheduler lets go on: who has begun, and is not too far ahead.

        Who is between Look and Move is in an activation that is counted, and may finish it.
        """
        if self.time.start_delay:
            able = [robot for robot in able if robot != 1 or not extra[0]]
        if self.time.lead is None or not able:
            return able
        done = extra[-len(self.team) :]
        most = min(done[robot] for robot in able) + self.time.lead
        return [robot for robot in able if minds[robot] < 0 or done[robot] < most]

    def _goes_on(self, number: int) -> bool:
        """Whether something may change though nobody is able: a sleeper begins, or a round."""
        _, _, extra = self.configuration(number)
        if self.time.start_delay and extra[0]:
            return True
        return self.time.has_rounds and not self._all_ended(number)

    def _cut_off(self, able: Sequence[int], cut: Sequence[int], number: int) -> bool:
        """Whether a run ends here because of the budget."""
        if not cut or (able and self.time.scheduler != "fsync"):
            return False
        self._unfinished(number)
        return True

    def _unfinished(self, number: int) -> None:
        """Note a run that the budget cuts off in a configuration."""
        self.unfinished += 1
        self.shortest = number if self.shortest < 0 else self.shortest
        if self.time.within:
            most = self.time.budget
            seen = f"the goal is not reached within {most} activations of each robot"
            self.found = self.found or Broken("budget", seen, number)

    def _looks(self, number: int, minds: Sequence[int], group: Iterable[int]) -> tuple[int, ...]:
        """For each robot of a group its mind after the look; of one that moves what it was."""
        sensed = self._sensed_in(self._keys[number][0])
        look = self.minds.look
        return tuple([minds[r] if minds[r] < 0 else look(minds[r], sensed[r]) for r in group])

    def _make(self, number: int, group: tuple[int, ...], looks: tuple[int, ...]) -> bool:
        """Make the steps of a group; return False if they break a law."""
        state, minds, extra = self.configuration(number)
        after, acts, due = [*minds], dict[int, Any](), dict[int, Any]()
        for robot, look in zip(group, looks, strict=True):
            mind = ~look if minds[robot] < 0 else self.minds.settled(look)
            value = self.minds.value[mind]
            if type(value) is Fault:
                self.found = Broken(value.law, value.seen, number, group, robot=robot)
                return False
            if isinstance(value, STILL):
                after[robot] = self.minds.after(mind)
            elif self._slow and minds[robot] >= 0:
                due[robot], after[robot] = value, ~mind
            else:
                acts[robot], after[robot] = value, self.minds.after(mind)
        try:
            following = self.following(state, acts, due)
        except IllegalAction as error:
            whose = group[0] if len(group) == 1 else None
            self.found = Broken("illegal-action", str(error), number, group, robot=whose)
            return False
        bits = sum(1 << robot for robot in group)
        extra = self._passed(extra, group, minds) if extra else extra
        for index, (to, _) in enumerate(following):
            reached = self._meet(to, after, extra, Step(number, bits, index))
            if not group and reached == number and len(following) == 1:
                self._stop(number)  # nobody is able, and nothing changes any more
                return self.found is None
            self.graph.to.append(reached)
            self.graph.group.append(bits)
            self.graph.acts.append(bool(acts))
        return True

    @staticmethod
    def acts(value: object) -> bool:
        """Whether the value of a mind is an action in the world."""
        return not isinstance(value, STILL)

    def following(
        self, state: Any, acts: dict[int, Any], due: dict[int, Any]
    ) -> list[tuple[Any, str]]:
        """Each state after these actions, with the words of the adversary.

        Args:
            state: before.
            acts: the actions that are done, by robot.
            due: those of looks at the same time, which are done later.

        Raises:
            IllegalAction: of the model.
        """
        made = self.world.looked(state, due) if due else [(state, "")]
        if not acts and not self.time.has_rounds:
            return made
        following = []
        for each, words in made:
            for to, more in self.world.step(each, acts):
                following.append((to, joined(words, more)))
        return following

    def _passed(
        self, extra: tuple[int, ...], group: Iterable[int], minds: Sequence[int]
    ) -> tuple[int, ...]:
        """What the scheduler keeps after a step."""
        slept: tuple[int, ...] = ()
        if self.time.start_delay:
            slept = (max(0, extra[0] - 1),)
        if self.time.lead is None:
            return slept
        done = [*extra[-len(self.team) :]]
        for robot in group:
            done[robot] += minds[robot] >= 0
        # Who is further behind than the lead could not be activated; it is not behind any more.
        least, most = min(done), max(done)
        done = [
            max(each, most - self.time.lead) - max(least, most - self.time.lead) for each in done
        ]
        return (*slept, *done)

    def _meet(self, state: Any, minds: Sequence[int], extra: tuple[int, ...], came: Step) -> int:
        of = self._state_ids.setdefault(state, len(self.states))
        if of == len(self.states):
            self.states.append(state)
            self._sensed.append([])
        key = (of, *minds, *extra)
        number = self._ids.setdefault(key, len(self._keys))
        if number == len(self._keys):
            self._keys.append(key)
            for part, value in zip(self._came, came, strict=True):
                part.append(value)
            self._layer.append(number)
        return number

    def _begin_steps(self, number: int) -> None:
        while len(self.graph.first) <= number:
            self.graph.first.append(len(self.graph.to))

    def _sensed_in(self, of: int) -> list[Any]:
        """What every robot senses in a state; each is asked once."""
        found = self._sensed[of]
        if not found:
            state = self.states[of]
            found = [self.world.sensed(state, robot) for robot in self._robots]
            self._sensed[of] = found
        return found

    # ---------------------------------------------------------------- endings

    def _end(self, minds: Iterable[int]) -> None:
        self.ends += 1
        depths = [self.minds.depth[max(mind, ~mind)] for mind in minds]
        self.longest = max(self.longest, *depths)

    def _stop(self, number: int) -> None:
        """Note what is wrong in a configuration in which nobody is able, for ever."""
        if broken := self.stopped(number):
            self.found = self.found or broken
        _, minds, _ = self.configuration(number)
        self._end(minds)

    def _all_ended(self, number: int) -> bool:
        _, minds, _ = self.configuration(number)
        return all(
            self.percept(number, robot) is None or type(self.minds.value[mind]) is Ended
            for robot, mind in enumerate(minds)
        )

    def stopped(self, number: int) -> Broken | None:
        """What is wrong if the world stays for ever as it is in a configuration."""
        state, minds, _ = self.configuration(number)
        values = [self.minds.value[max(mind, ~mind)] for mind in minds]
        here = [self.percept(number, robot) is not None for robot in self._robots]
        waits = any(
            there and type(value) is not Ended for value, there in zip(values, here, strict=True)
        )
        law = "deadlock" if waits else "answer"
        if self.world.says_progress:
            for condition in self.world.progress():
                if condition.holds is not None and not self.world.holds(condition, state):
                    return Broken("progress", f"for ever without {condition.name}", number)
        answers = [value.answer if type(value) is Ended else None for value in values]
        seen = self.world.flaw(state, answers)
        return Broken(law, seen, number) if seen else None

    def finish(self) -> None:
        """Do what is left when all layers are searched: the runs that never end."""
        self._begin_steps(len(self._keys))
        if self.found or self.full:
            return
        self.found = broken_for_ever(self)
        if self.found or self.minds.finite or self.minds.histories:
            return
        endless = cut_for_ever(self)
        if endless is not None:
            self._unfinished(endless)

    def unable(self, number: int, robot: int) -> bool:
        """Whether a robot cannot be activated, whatever the budget."""
        return not any(robot in each for each in self.able(number))

    def unable_or_cut(self, number: int, robot: int) -> bool:
        """Whether a robot cannot be activated, or is kept from it by the budget alone."""
        return robot not in self.able(number)[0]

    # ---------------------------------------------------------------- what was searched

    def __len__(self) -> int:
        return len(self._keys)

    def way(self, number: int) -> list[int]:
        """The configurations on a shortest way to one of them."""
        way = []
        while number >= 0:
            way.append(number)
            number = self._came[0][number]
        return way[::-1]

    def assumed(self, assumption: Assumption, before: int, step: int) -> bool:
        """Whether a step of the graph is one of those that the adversary makes again and again."""
        state, after = self.states[self.state_number(before)], self.graph.to[step]
        following = self.states[self.state_number(after)]
        return assumption.holds(state, following, self.words(before, step))

    def words(self, number: int, step: int) -> str:
        """What the adversary does in a step of the graph, in words."""
        return event_of(self, self.step(number, step)).world

    def came(self, number: int) -> Step:
        """The step by which a configuration was met first."""
        return Step(*(part[number] for part in self._came))

    def step(self, number: int, step: int) -> Step:
        """A step of the graph, from a configuration."""
        group = self.graph.group[step]
        every = [each for each in self.graph.steps(number) if self.graph.group[each] == group]
        return Step(number, group, every.index(step))

    def schedules(self) -> int | None:
        """The number of maximal runs; None if there is a cycle, so that they have no number."""
        count, to = len(self._keys), self.graph.to
        entering = [0] * count
        for reached in to:
            entering[reached] += 1
        ways = [int(before < 0) for before in self._came[0]]
        queue = [number for number in range(count) if not entering[number]]
        ends = 0
        for number in queue:
            steps = self.graph.steps(number)
            ends += 0 if steps else ways[number]
            for step in steps:
                ways[to[step]] += ways[number]
                entering[to[step]] -= 1
                if not entering[to[step]]:
                    queue.append(to[step])
        return ends if len(queue) == count else None


def in_lockstep(searches: Sequence[Search], minds: Minds) -> None:
    """Do some searches at once, a layer at a time, so that a layer of all is one message."""
    for search in searches:
        search.begin()
    going = [search for search in searches if search.going]
    while going:
        for search in going:
            search.plan()
        minds.settle()
        for search in going:
            search.act()
        minds.forget()
        going = [search for search in going if search.going]
    for search in searches:
        search.finish()
