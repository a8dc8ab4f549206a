"""Every schedule and every choice of the adversary in one world, as a graph of configurations.

A configuration is the state of the world with one mind for each robot.  The search goes breadth
first, so the first finding is a shortest one; schedules that differ by the order of steps which do
not meet lead to one configuration.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import product
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.inputs.checks import InputError
from allworlds.maps.combinatorial import Dart
from allworlds.protocol.actions import IllegalAction, Wait, Watch
from allworlds.protocol.turns import Sensed
from allworlds.robots.cycles import broken_for_ever, cut_for_ever
from allworlds.robots.events import event_of
from allworlds.robots.graph import Broken, Graph
from allworlds.robots.minds import Ended, Minds, ProgramFault
from allworlds.robots.model import Assumption, Guarded, joined
from allworlds.robots.schedulers import Time, bits_of

STILL = Wait, Watch, Ended, ProgramFault
"""The values of minds that make no step of the world."""


class Ends(Struct):
    """The ends of runs in a search.

    Attributes:
        count: configurations in which a run ends.
        longest: the largest number of activations of a robot in one of them.
        cut_off: configurations in which the budget cuts a run off.
        shortest: the first of them; -1 without one.
    """

    count: int = 0
    longest: int = 0
    cut_off: int = 0
    shortest: int = -1


PlannedTurn: TypeAlias = tuple[Any, int, bool]
"""The turn of a robot in a configuration: the action, or the end, of its program; the mind after
it; and whether the action is done in a later event."""


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
        ends: of runs.
        full: whether there are more configurations than are allowed.
    """

    def __init__(
        self, world: Guarded, starts: Sequence[Dart], team: Sequence[int], minds: Minds, time: Time
    ) -> None:
        self.world, self.starts, self.team = world, starts, team
        self.minds, self.time, self.graph = minds, time, Graph()
        self.found: Broken | None = None
        self.ends, self.full = Ends(), False
        self._robots = range(len(team))
        self._slow = time.scheduler == "async"
        self._limited, self._layers = False, 0
        self._keys: list[tuple[Any, ...]] = []
        self._ids: dict[tuple[Any, ...], int] = {}
        self.states: list[Any] = []
        self._state_ids: dict[Any, int] = {}
        self._sensed: list[list[Any]] = []
        self._layer: list[int] = []
        self._plans: list[tuple[int, Sequence[int], Sequence[int]]] = []

    def begin(self) -> None:
        """Make the first configurations.

        Raises:
            InputError: if a bound on activations is asked for, and all programs are automata.
        """
        told = [self.world.told(robot) for robot in self._robots]
        roots = [self.minds.root(program, told[robot]) for robot, program in enumerate(self.team)]
        self._limited = not self.minds.finite
        if self.time.within and not self._limited:
            raise InputError(
                f"within = {self.time.budget} has no effect on automata, whose activations are not "
                "counted; legal is a memory that counts them, and ends"
            )
        ahead = (0,) * len(roots) if self.time.lead is not None else ()
        delays: list[tuple[int, ...]] = [()]
        if self.time.start_delay:
            delays = [(delay,) for delay in range(self.time.start_delay + 1)]
        choices = product(self.world.initial(self.starts), delays)
        for index, (state, delay) in enumerate(choices):
            self._meet(state, roots, (*delay, *ahead), -1, 0, index)
        for robot, root in enumerate(roots):
            if type(value := self.minds.value[root]) is ProgramFault and self._layer:
                self.found = Broken(value.law, value.seen, 0, robot=robot)

    # ---------------------------------------------------------------- the search

    @property
    def going(self) -> bool:
        """Whether there is a layer to be searched."""
        return bool(self._layer) and self.found is None and not self.full

    def plan(self) -> None:
        """Plan all steps of this layer; what its robots do next is asked for in the minds."""
        for number in self._layer:
            state = self.states[self._keys[number][0]]
            if self.world.says_bad and (seen := self.world.bad(state)):
                self.found = Broken("never", seen, number)
                break
            if self.world.says_over and self.world.over(state):
                self._end(number)
                continue
            able, cut = self.able(number)
            if self._cut_off(able, cut, number):
                continue
            if self.time.schedule is not None and self._layers == len(self.time.schedule):
                self._note_cut_off(number)
                continue
            if not able:
                if self._goes_on(number):
                    self._plans.append((number, (), ()))
                else:
                    self._stop(number)
                continue
            self._plans.append((number, able, self._looks(number, able)))

    def act(self) -> None:
        """Make every step that is planned; the configurations that are new are the next layer."""
        plans, self._plans, self._layer = self._plans, [], []
        if self.found:
            return
        for number, able, looks in plans:
            self.graph.begin(number)
            at, turns = self.configuration(number), self._turns(number, able, looks)
            for group, bits in self._groups(number, able):
                if not self._make(number, at, group, bits, turns):
                    return
            if len(self._keys) > self.time.configurations:
                self.full = True
                return
        self._layers += 1

    def configuration(self, number: int) -> tuple[Any, tuple[int, ...], tuple[int, ...]]:
        """The state, the minds, and what the scheduler keeps."""
        key = self._keys[number]
        robots = len(self.team)
        return self.states[key[0]], key[1 : robots + 1], key[robots + 1 :]

    def state_number(self, number: int) -> int:
        """The number of the state of a configuration."""
        return self._keys[number][0]  # type: ignore[no-any-return]

    def percept(self, number: int, robot: int) -> Sensed | None:
        """The percept of a robot that looks in a configuration."""
        return self._sensed_in(self._keys[number][0])[robot]  # type: ignore[no-any-return]

    def sensed_first(self, of: int, robot: int) -> Sensed | None:
        """The percept of a robot in the state of that number, if it was asked for."""
        return self._sensed[of][robot] if self._sensed[of] else None

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
        robots = len(self.team)
        if len(key) > robots + 1:
            able = self._allowed(able, key[1:], key[robots + 1 :])
        return able, cut

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
        self._note_cut_off(number)
        if self.time.within:
            most = self.time.budget
            seen = f"the goal is not reached within {most} activations of each robot"
            self.found = self.found or Broken("budget", seen, number)

    def _note_cut_off(self, number: int) -> None:
        self.ends.cut_off += 1
        self.ends.shortest = number if self.ends.shortest < 0 else self.ends.shortest

    def _groups(self, number: int, able: Sequence[int]) -> Iterable[tuple[tuple[int, ...], int]]:
        """The sets of robots that are activated; of a given schedule the next one.

        Raises:
            InputError: if one of these cannot be activated.
        """
        if self.time.schedule is None:
            return self.time.groups(tuple(able))
        event = self.time.schedule[self._layers]
        for robot, phase in event.phases.items():
            if robot not in able:
                raise InputError(f"schedule: in event {self._layers + 1} robot {robot} cannot act")
            moves = self._keys[number][robot + 1] < 0
            if phase and moves != (phase == "M"):
                does = "moves" if moves else "looks"
                raise InputError(f"schedule: in event {self._layers + 1} robot {robot} {does}")
        return ((event.group, bits_of(event.group)),)

    def _chosen(self, following: Sequence[Any]) -> Iterable[tuple[int, Any]]:
        """The states that follow, each with its index; of a given schedule that one alone.

        Raises:
            InputError: if there is none of that index.
        """
        if self.time.schedule is None:
            return enumerate(following)
        index = self.time.schedule[self._layers].adversary
        if index >= len(following):
            raise InputError(
                f"schedule: event {self._layers + 1} has {len(following)} ways of the adversary; "
                f"legal are 0 to {len(following) - 1}, not {index}"
            )
        return ((index, following[index]),)

    def _looks(self, number: int, able: Iterable[int]) -> list[int]:
        """For each robot its mind after the look; of one that moves what it was."""
        key = self._keys[number]
        sensed, look = self._sensed_in(key[0]), self.minds.look
        minds = [(robot, key[robot + 1]) for robot in able]
        return [mind if mind < 0 else look(mind, sensed[robot]) for robot, mind in minds]

    def _turns(
        self, number: int, able: Iterable[int], looks: Iterable[int]
    ) -> dict[int, PlannedTurn]:
        """The turn of each robot, whatever the others do."""
        key, minds, turns = self._keys[number], self.minds, dict[int, PlannedTurn]()
        for robot, look in zip(able, looks, strict=True):
            moves = key[robot + 1] < 0
            mind = ~look if moves else minds.settled(look)
            value = minds.value[mind]
            later = self._slow and not moves and not isinstance(value, STILL)
            turns[robot] = value, ~mind if later else minds.after(mind), later
        return turns

    def _make(
        self,
        number: int,
        at: tuple[Any, tuple[int, ...], tuple[int, ...]],
        group: tuple[int, ...],
        bits: int,
        turns: Mapping[int, PlannedTurn],
    ) -> bool:
        """Make the steps of a group in a configuration; return False if they break a law."""
        state, minds, extra = at
        after, acts, due = [*minds], dict[int, Any](), dict[int, Any]()
        for robot in group:
            value, after[robot], later = turns[robot]
            if later:
                due[robot] = value
            elif not isinstance(value, STILL):
                acts[robot] = value
            elif type(value) is ProgramFault:
                self.found = Broken(value.law, value.seen, number, group, robot=robot)
                return False
        try:
            following = self.following(state, acts, due)
        except IllegalAction as error:
            whose = group[0] if len(group) == 1 else None
            self.found = Broken("illegal-action", str(error), number, group, robot=whose)
            return False
        extra = self._passed(extra, group, minds) if extra else extra
        for index, (to, _) in self._chosen(following):
            reached = self._meet(to, after, extra, number, bits, index)
            if not group and reached == number and len(following) == 1:
                self._stop(number)  # nobody is able, and nothing changes any more
                return self.found is None
            self.graph.add(reached, bits, acts=bool(acts))
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
        made = [(state, "")]
        if due and self.world.decides_at_looks:
            made = self.world.looked(state, due)
        elif acts:
            return self.world.step(state, acts)
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
        """The part of a configuration that the scheduler keeps after a step."""
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

    def _meet(
        self,
        state: Any,
        minds: Sequence[int],
        extra: tuple[int, ...],
        before: int,
        bits: int,
        adversary: int,
    ) -> int:
        """The number of a configuration, which is a new one if it was not met before."""
        of = self._state_ids.setdefault(state, len(self.states))
        if of == len(self.states):
            self.states.append(state)
            self._sensed.append([])
        key = (of, *minds, *extra)
        if self.time.schedule is not None:
            self._ids.pop(key, None)  # the same again is a later event
        number = self._ids.setdefault(key, len(self._keys))
        if number == len(self._keys):
            self._keys.append(key)
            self.graph.meet(before, bits, adversary)
            self._layer.append(number)
        return number

    def _sensed_in(self, of: int) -> list[Any]:
        """The percepts of all robots in a state; each is asked once."""
        found = self._sensed[of]
        if not found:
            state = self.states[of]
            found = [self.world.sensed(state, robot) for robot in self._robots]
            self._sensed[of] = found
        return found

    # ---------------------------------------------------------------- endings

    def _end(self, number: int) -> None:
        self.ends.count += 1
        minds = self._keys[number][1 : len(self.team) + 1]
        depths = [self.minds.depth[max(mind, ~mind)] for mind in minds]
        self.ends.longest = max(self.ends.longest, *depths)

    def _stop(self, number: int) -> None:
        """Note what is wrong in a configuration in which nobody is able, for ever."""
        if broken := self.stopped(number):
            self.found = self.found or broken
        self._end(number)

    def _all_ended(self, number: int) -> bool:
        _, minds, _ = self.configuration(number)
        return all(
            self.percept(number, robot) is None or type(self.minds.value[mind]) is Ended
            for robot, mind in enumerate(minds)
        )

    def stopped(self, number: int) -> Broken | None:
        """The law that is broken if the world stays for ever as it is in a configuration."""
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
        self.graph.begin(len(self._keys))
        if self.found or self.full or self.time.schedule is not None:
            return
        self.found = broken_for_ever(self)
        if self.found or self.minds.finite or self.minds.histories:
            return
        endless = cut_for_ever(self)
        if endless is not None:
            self._unfinished(endless)

    def unable(self, number: int) -> int:
        """The robots that cannot be activated, whatever the budget, as bits."""
        able, cut = self.able(number)
        return bits_of(self._robots) & ~bits_of(able) & ~bits_of(cut)

    def unable_or_cut(self, number: int) -> int:
        """Those that cannot be activated, or are kept from it by the budget alone, as bits."""
        return bits_of(self._robots) & ~bits_of(self.able(number)[0])

    # ---------------------------------------------------------------- what was searched

    def __len__(self) -> int:
        return len(self._keys)

    def way(self, number: int) -> list[int]:
        """The configurations on a shortest way to one of them."""
        way = []
        while number >= 0:
            way.append(number)
            number = self.graph.came(number).before
        return way[::-1]

    def assumed(self, assumption: Assumption, before: int, step: int) -> bool:
        """Whether a step of the graph is one of those that the adversary makes again and again."""
        state, after = self.states[self.state_number(before)], self.graph.to(step)
        following = self.states[self.state_number(after)]
        words = event_of(self, self.graph.step(before, step)).world
        return bool(assumption.holds(state, following, words))

    def schedules(self) -> int | None:
        """The number of maximal runs; None if there is a cycle, so that they have no number."""
        count, graph = len(self._keys), self.graph
        entering = [0] * count
        for step in range(len(graph)):
            entering[graph.to(step)] += 1
        ways = [int(graph.came(number).before < 0) for number in range(count)]
        queue = [number for number in range(count) if not entering[number]]
        ends = 0
        for number in queue:
            steps = graph.steps(number)
            ends += 0 if steps else ways[number]
            for step in steps:
                reached = graph.to(step)
                ways[reached] += ways[number]
                entering[reached] -= 1
                if not entering[reached]:
                    queue.append(reached)
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
