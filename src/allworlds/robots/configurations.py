"""Every schedule and every choice of the adversary in one world, as a graph of configurations.

A configuration is a state of the world, with one *mind* for each robot.  A mind is all that the
robot's program remembers, with the action that the robot has still to do.  Each configuration has a
number: its index in the order in which the search finds the configurations.  The search is breadth
first, so the first run that breaks a law is a shortest such run.  A *layer* holds the new
configurations that one more step reaches.  Schedules that differ only by the order of independent
steps lead to one configuration.

The *budget* is the largest number of activations of a robot whose program is a generator.  A run is
*cut off* if it could go on under a larger budget, or with more events in the given schedule.
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
from allworlds.robots.graph import MOST_ROBOTS, Broken, Graph
from allworlds.robots.minds import Ended, Minds, ProgramFault
from allworlds.robots.model import Assumption, ModelInMap, joined
from allworlds.robots.schedulers import Timing, bits_of

NO_ACTION = Wait, Watch, Ended, ProgramFault
"""The types of a robot's next action (:attr:`Minds.value`) that the model does not carry out."""


class Ends(Struct):
    """The ends of runs in a search.

    Attributes:
        count: the number of configurations in which a run ends.
        longest: the largest number of activations of a robot in a run that ends.
        cut_off: the number of configurations in which a run is cut off: by the budget, or at the
            end of the given schedule.
        shortest: the index of the first configuration in which a run is cut off; -1 if no run is
            cut off.
    """

    count: int = 0
    longest: int = 0
    cut_off: int = 0
    shortest: int = -1


PlannedTurn: TypeAlias = tuple[Any, int, bool]
"""The turn of a robot in a configuration, as three values.

The first is the robot's action, or the end or the fault of its program.  The second is the robot's
mind after the turn.  The third says whether the action is done in a later event.
"""


class Search:
    """The search of one world, through all configurations that runs can reach.

    A configuration is a state of the world, with the minds of all robots.  In the methods
    ``number`` is the number of a configuration: its index in the order in which the search finds
    the configurations.

    Args:
        world: the model, in one map.
        starts: the dart of each robot at the start.
        program_of: for each robot the number of its program.
        minds: the minds of these programs, which several searches may share.
        timing: the schedules that are tried.

    Attributes:
        broken: the broken law; None if no broken law has been found so far.
        ends: the ends of runs.
        full: whether the search has reached more configurations than are allowed.
        plans: the planned transitions from the last layer: a configuration's number, the robots
            that can be activated there, and the mind of each of these robots after its look.
        states: the states of the world that the search has reached, by their numbers.
    """

    def __init__(
        self,
        world: ModelInMap,
        starts: Sequence[Dart],
        program_of: Sequence[int],
        minds: Minds,
        timing: Timing,
    ) -> None:
        self.world, self.starts, self.program_of = world, starts, program_of
        self.minds, self.timing, self.graph = minds, timing, Graph()
        self.broken: Broken | None = None
        self.ends, self.full = Ends(), False
        self._robots = range(len(program_of))
        self._slow = timing.scheduler == "async"
        self._limited, self._layers = False, 0
        self._keys: list[tuple[Any, ...]] = []
        self._ids: dict[tuple[Any, ...], int] = {}
        self.states: list[Any] = []
        self._state_ids: dict[Any, int] = {}
        self._sensed: list[list[Any]] = []
        self._layer: list[int] = []
        self.plans: list[tuple[int, Sequence[int], Sequence[int]]] = []

    def begin(self) -> None:
        """Make the first configurations, and note the broken law if a program fails at the start.

        There is one configuration for each pair of a state at the start and a delay.  The delay is
        the number of rounds, from 0 to ``timing.start_delay``, that robot 1 begins later than the
        other robots.

        Raises:
            InputError: if there are too many robots. Also if ``timing.within`` asks that each run
                ends within the budget, and all programs are automata: a budget counts activations,
                which are not counted for automata.
        """
        if len(self.program_of) > MOST_ROBOTS:
            most = f"more than {MOST_ROBOTS}, the most of a search"
            raise InputError(f"robots = {len(self.program_of)} are {most}")
        told = [self.world.told(robot) for robot in self._robots]
        roots = [*map(self.minds.root, self.program_of, told)]
        self._limited = not self.minds.finite
        if self.timing.within and not self._limited:
            raise InputError(
                f"within = {self.timing.budget} has no effect on automata, whose activations are "
                "not counted; legal is a memory that counts them, and ends"
            )
        ahead = (0,) * len(roots) if self.timing.lead is not None else ()
        delays: list[tuple[int, ...]] = [()]
        if self.timing.start_delay:
            delays = [(delay,) for delay in range(self.timing.start_delay + 1)]
        choices = product(self.world.initial(self.starts), delays)
        for index, (state, delay) in enumerate(choices):
            self._number_of(state, roots, (*delay, *ahead), -1, 0, index)
        for robot, root in enumerate(roots):
            if type(value := self.minds.value[root]) is ProgramFault and self._layer:
                self.broken = Broken(value.law, value.seen, 0, robot=robot)

    # ---------------------------------------------------------------- the search

    @property
    def going(self) -> bool:
        """Whether the search goes on.

        It goes on if its last step has reached new configurations, no law is broken, and no limit
        is reached.
        """
        return bool(self._layer) and self.broken is None and not self.full

    def plan(self) -> None:
        """Plan the transitions from the last layer, which holds the newest configurations.

        The next messages to the programs then ask for the actions of the robots in these
        transitions.  Two things are noted, too: the runs that end or are cut off in this layer; and
        the law ``never``, if the model says that the state of a configuration must never be
        reached.
        """
        self.plans = []
        for number in self._layer:
            state = self.states[self._keys[number][0]]
            if self.world.says_bad and (seen := self.world.bad(state)):
                self.broken = Broken("never", seen, number)
                break
            if self.world.says_over and self.world.over(state):
                self._end(number)
                continue
            able, cut = self.able(number)
            if self._cut_off(able, cut, number):
                continue
            if self.timing.schedule is not None and self._layers == len(self.timing.schedule):
                self._note_cut_off(number)
                continue
            if not able:
                if self._goes_on(number):
                    self.plans.append((number, (), ()))
                else:
                    self._stop(number)
                continue
            self.plans.append((number, able, self._looks(number, able)))

    def expand(self) -> None:
        """Make all planned transitions; the new configurations are the next layer."""
        self._layer = []
        if self.broken:
            return
        for number, able, looks in self.plans:
            self.graph.begin(number)
            at, turns = self.configuration(number), self._turns(number, able, looks)
            for group, bits in self._groups(number, able):
                if not self._make(number, at, group, bits, turns):
                    return
            if len(self._keys) > self.timing.configurations:
                self.full = True
                return
        self._layers += 1

    def configuration(self, number: int) -> tuple[Any, tuple[int, ...], tuple[int, ...]]:
        """The state of the world, the minds of the robots, and the scheduler's counts.

        A mind is a number, see :class:`Minds`.  If a robot is between Look and Move, ``~mind``,
        which is below 0, stands in place of its mind.

        The scheduler's counts are one tuple.  If ``timing.start_delay`` is not 0, the tuple begins
        with the number of rounds until robot 1 begins.  If ``timing.lead`` is given, which limits
        how far a robot may be ahead, the tuple then has a number for each robot: by how many
        activations this robot is ahead of the robot with the fewest activations.
        """
        key = self._keys[number]
        robots = len(self.program_of)
        return self.states[key[0]], key[1 : robots + 1], key[robots + 1 :]

    def state_number(self, number: int) -> int:
        """The number of a configuration's state of the world: its index in :attr:`states`."""
        return self._keys[number][0]  # type: ignore[no-any-return]

    def percept(self, number: int, robot: int) -> Sensed | None:
        """The percept of a robot that looks in a configuration; None if the robot is gone."""
        return self._sensed_in(self._keys[number][0])[robot]  # type: ignore[no-any-return]

    def sensed_first(self, state: int, robot: int) -> Sensed | None:
        """The percept of a robot in the state of the world with this number in :attr:`states`.

        Return None if the robot is gone, or if the model was not asked about this state yet.
        """
        return self._sensed[state][robot] if self._sensed[state] else None

    def able(self, number: int) -> tuple[list[int], list[int]]:
        """The robots that can be activated in a configuration, and those that have no budget left.

        A robot is in neither list if it is gone, if its program has ended, or if it watches and
        senses no change.  Of the other robots, the second list has those that have used up the
        budget of activations.  The first list has the rest, as far as the scheduler allows to
        activate them now.
        """
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
                if self._limited and self.minds.depth[mind] >= self.timing.budget:
                    cut.append(robot)
                    continue
            able.append(robot)
        robots = len(self.program_of)
        if len(key) > robots + 1:
            able = self._allowed(able, key[1:], key[robots + 1 :])
        return able, cut

    def _allowed(self, able: list[int], minds: Sequence[int], counts: tuple[int, ...]) -> list[int]:
        """Those of the robots ``able`` that the scheduler allows.

        The scheduler allows a robot if two conditions hold.  First: the robot has begun.  Second,
        if ``timing.lead`` is given: among the robots in ``able`` let k be the smallest number of
        activations; then the robot has had fewer than k + ``timing.lead`` activations.  A robot
        between Look and Move needs only the first condition, since its present activation was
        counted at the look.  ``minds`` and ``counts`` are the minds of the robots and the
        scheduler's counts, see :meth:`configuration`.
        """
        if self.timing.start_delay:
            able = [robot for robot in able if robot != 1 or not counts[0]]
        if self.timing.lead is None or not able:
            return able
        done = counts[-len(self.program_of) :]
        most = min(done[robot] for robot in able) + self.timing.lead
        return [robot for robot in able if minds[robot] < 0 or done[robot] < most]

    def _goes_on(self, number: int) -> bool:
        """Whether a run goes on although no robot can be activated.

        The run goes on if robot 1 has not begun yet.  The run also goes on if the world makes a
        step in each round, and not all programs have ended.
        """
        _, _, counts = self.configuration(number)
        if self.timing.start_delay and counts[0]:
            return True
        return self.timing.has_rounds and not self._all_ended(number)

    def _cut_off(self, able: Sequence[int], cut: Sequence[int], number: int) -> bool:
        """Whether the budget cuts a run off in a configuration; if so, note the end of the run.

        ``able`` and ``cut`` are the two lists of :meth:`able`.  A robot at the end of the budget
        cuts the run off if no other robot can be activated; under ``fsync`` always, because there
        all robots are activated at once.
        """
        if not cut or (able and self.timing.scheduler != "fsync"):
            return False
        self._unfinished(number)
        return True

    def _unfinished(self, number: int) -> None:
        """Note a run that the budget cuts off in a configuration.

        If ``timing.within`` is set, such a run breaks the law ``budget``.
        """
        self._note_cut_off(number)
        if self.timing.within:
            most = self.timing.budget
            seen = f"the goal is not reached within {most} activations of each robot"
            self.broken = self.broken or Broken("budget", seen, number)

    def _note_cut_off(self, number: int) -> None:
        self.ends.cut_off += 1
        self.ends.shortest = number if self.ends.shortest < 0 else self.ends.shortest

    def _groups(self, number: int, able: Sequence[int]) -> Iterable[tuple[tuple[int, ...], int]]:
        """The sets of robots that may be activated, each also as a bit set.

        ``able`` has the robots that can be activated.  If a schedule is given, the only set is that
        of the schedule's next event.

        Raises:
            InputError: if the schedule names a robot that cannot be activated.
        """
        if self.timing.schedule is None:
            return self.timing.groups(tuple(able))
        event = self.timing.schedule[self._layers]
        for robot, phase in event.phases.items():
            if robot not in able:
                raise InputError(f"schedule: in event {self._layers + 1} robot {robot} cannot act")
            moves = self._keys[number][robot + 1] < 0
            if phase and moves != (phase == "M"):
                does = "moves" if moves else "looks"
                raise InputError(f"schedule: in event {self._layers + 1} robot {robot} {does}")
        return ((event.group, bits_of(event.group)),)

    def _chosen(self, following: Sequence[Any]) -> Iterable[tuple[int, Any]]:
        """Those of the states ``following`` that are tried, each with its index.

        If a schedule is given, only the state is tried that the schedule's next event chooses.

        Raises:
            InputError: if the schedule chooses an index that does not exist.
        """
        if self.timing.schedule is None:
            return enumerate(following)
        index = self.timing.schedule[self._layers].adversary
        if index >= len(following):
            raise InputError(
                f"schedule: event {self._layers + 1} has {len(following)} ways of the adversary; "
                f"legal are 0 to {len(following) - 1}, not {index}"
            )
        return ((index, following[index]),)

    def _looks(self, number: int, able: Iterable[int]) -> list[int]:
        """For each able robot its mind after the look, or a promise of this mind.

        A promise is a number below 0.  It stands for a mind that is not known before the program
        has replied, see :meth:`Minds.look`.  A robot that has looked in an earlier step moves now,
        and does not look again.  Its entry is ``~mind``, as in :meth:`configuration`, which is also
        below 0, but no promise; :meth:`_turns` sees in the configuration which robots move.
        """
        key = self._keys[number]
        sensed, look = self._sensed_in(key[0]), self.minds.look
        minds = [(robot, key[robot + 1]) for robot in able]
        return [mind if mind < 0 else look(mind, sensed[robot]) for robot, mind in minds]

    def _turns(
        self, number: int, able: Iterable[int], looks: Iterable[int]
    ) -> dict[int, PlannedTurn]:
        """The planned turn of each able robot, by the number of the robot.

        ``looks`` is the result of :meth:`_looks`.  A robot's turn does not depend on the turns of
        the other robots.
        """
        key, minds, turns = self._keys[number], self.minds, dict[int, PlannedTurn]()
        for robot, look in zip(able, looks, strict=True):
            moves = key[robot + 1] < 0
            mind = ~look if moves else minds.resolved(look)
            value = minds.value[mind]
            later = self._slow and not moves and not isinstance(value, NO_ACTION)
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
        """Make the transitions from a configuration in which a group of robots is activated.

        Return False if a law is broken.  ``at`` is the result of :meth:`configuration`, ``bits``
        the group as a bit set, ``turns`` the result of :meth:`_turns`.
        """
        state, minds, counts = at
        after, acts, due = [*minds], dict[int, Any](), dict[int, Any]()
        for robot in group:
            value, after[robot], later = turns[robot]
            if later:
                due[robot] = value
            elif not isinstance(value, NO_ACTION):
                acts[robot] = value
            elif type(value) is ProgramFault:
                self.broken = Broken(value.law, value.seen, number, group, robot=robot)
                return False
        try:
            following = self.following(state, acts, due)
        except IllegalAction as error:
            whose = group[0] if len(group) == 1 else None
            self.broken = Broken("illegal-action", str(error), number, group, robot=whose)
            return False
        counts = self._passed(counts, group, minds) if counts else counts
        for index, (to, _) in self._chosen(following):
            reached = self._number_of(to, after, counts, number, bits, index)
            if not group and reached == number and len(following) == 1:
                self._stop(number)  # nobody is able, and nothing changes any more
                return self.broken is None
            self.graph.add(reached, bits, has_action=bool(acts))
        return True

    @staticmethod
    def is_action(value: object) -> bool:
        """Whether a robot's next action (:attr:`Minds.value`) is one that the model carries out.

        Wait, Watch, and the end or the fault of a program are no such actions.
        """
        return not isinstance(value, NO_ACTION)

    def following(
        self, state: Any, acts: dict[int, Any], due: dict[int, Any]
    ) -> list[tuple[Any, str]]:
        """Each state that can follow, with the adversary's choice in words.

        Args:
            state: the state before.
            acts: the actions that are done now, by robot.
            due: the actions that robots choose now, at a look, and will do later, by robot. They
                change the state now only if the model has a method ``looked``.

        Raises:
            IllegalAction: if the model refuses an action.
        """
        made = [(state, "")]
        if due and self.world.decides_at_looks:
            made = self.world.looked(state, due)
        elif acts:
            return self.world.step(state, acts)
        if not acts and not self.timing.has_rounds:
            return made
        following = []
        for each, words in made:
            for to, more in self.world.step(each, acts):
                following.append((to, joined(words, more)))
        return following

    def _passed(
        self, counts: tuple[int, ...], group: Iterable[int], minds: Sequence[int]
    ) -> tuple[int, ...]:
        """The scheduler's counts after a group was activated; see :meth:`configuration`.

        ``counts`` and ``minds`` are the scheduler's counts and the minds before.
        """
        slept: tuple[int, ...] = ()
        if self.timing.start_delay:
            slept = (max(0, counts[0] - 1),)
        if self.timing.lead is None:
            return slept
        done = [*counts[-len(self.program_of) :]]
        for robot in group:
            done[robot] += minds[robot] >= 0
        # A robot further behind than the lead could not be activated: it counts as less behind.
        furthest_behind = max(done) - self.timing.lead
        least = max(min(done), furthest_behind)
        return (*slept, *(max(each, furthest_behind) - least for each in done))

    def _number_of(
        self,
        state: Any,
        minds: Sequence[int],
        counts: tuple[int, ...],
        before: int,
        bits: int,
        adversary: int,
    ) -> int:
        """The number of a configuration; if the configuration is new, it is added first.

        ``before``, ``bits`` and ``adversary`` are the parts of the transition that leads to the
        configuration, see :class:`allworlds.robots.graph.Transition`.
        """
        state_id = self._state_ids.setdefault(state, len(self.states))
        if state_id == len(self.states):
            self.states.append(state)
            self._sensed.append([])
        key = (state_id, *minds, *counts)
        if self.timing.schedule is not None:
            self._ids.pop(key, None)  # an equal configuration later is another one
        number = self._ids.setdefault(key, len(self._keys))
        if number == len(self._keys):
            self._keys.append(key)
            self.graph.discover(before, bits, adversary)
            self._layer.append(number)
        return number

    def _sensed_in(self, state_id: int) -> list[Any]:
        """The percepts of all robots in the state with this number; the model is asked once."""
        found = self._sensed[state_id]
        if not found:
            state = self.states[state_id]
            found = [self.world.sensed(state, robot) for robot in self._robots]
            self._sensed[state_id] = found
        return found

    # ---------------------------------------------------------------- endings

    def _end(self, number: int) -> None:
        self.ends.count += 1
        minds = self._keys[number][1 : len(self.program_of) + 1]
        depths = [self.minds.depth[max(mind, ~mind)] for mind in minds]
        self.ends.longest = max(self.ends.longest, *depths)

    def _stop(self, number: int) -> None:
        """Record that a run ends in this configuration, because nothing can change any more.

        If the run breaks a law by ending here, record the law, too.
        """
        if broken := self.stopped(number):
            self.broken = self.broken or broken
        self._end(number)

    def _all_ended(self, number: int) -> bool:
        _, minds, _ = self.configuration(number)
        return all(
            self.percept(number, robot) is None or type(self.minds.value[mind]) is Ended
            for robot, mind in enumerate(minds)
        )

    def stopped(self, number: int) -> Broken | None:
        """The law that a run breaks if it stays in a configuration for ever; None for no law."""
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
                    words = f"the run goes on for ever without {condition.name}"
                    return Broken("progress", words, number)
        answers = [value.answer if type(value) is Ended else None for value in values]
        seen = self.world.flaw(state, answers)
        return Broken(law, seen, number) if seen else None

    def finish(self) -> None:
        """After the last layer, look for runs that never end."""
        self.graph.begin(len(self._keys))
        if self.broken or self.full or self.timing.schedule is not None:
            return
        self.broken = broken_for_ever(self)
        if self.broken or self.minds.finite or self.minds.histories:
            return
        endless = cut_for_ever(self)
        if endless is not None:
            self._unfinished(endless)

    def unable(self, number: int) -> int:
        """The robots that cannot be activated in a configuration, as a bit set.

        A robot at the end of the budget is not in the set; :meth:`unable_or_cut` includes it.
        """
        able, cut = self.able(number)
        return bits_of(self._robots) & ~bits_of(able) & ~bits_of(cut)

    def unable_or_cut(self, number: int) -> int:
        """The robots that cannot be activated in a configuration, as a bit set.

        A robot at the end of the budget is in the set; :meth:`unable` leaves it out.
        """
        return bits_of(self._robots) & ~bits_of(self.able(number)[0])

    # ---------------------------------------------------------------- what was searched

    def __len__(self) -> int:
        return len(self._keys)

    def way(self, number: int) -> list[int]:
        """The numbers of the configurations on a shortest way to a configuration.

        The list begins with a configuration at the start, and ends with ``number``.
        """
        way = []
        while number >= 0:
            way.append(number)
            number = self.graph.discovery(number).before
        return way[::-1]

    def assumed(self, assumption: Assumption, before: int, index: int) -> bool:
        """Whether the adversary's choice in a transition is of the kind that an assumption names.

        The assumption says that the adversary makes choices of this kind again and again.  The
        transition is the one with the number ``index`` in :attr:`graph`, and leads from the
        configuration ``before``.
        """
        state, after = self.states[self.state_number(before)], self.graph.target(index)
        following = self.states[self.state_number(after)]
        words = event_of(self, self.graph.transition(before, index)).world
        return bool(assumption.holds(state, following, words))

    def schedules(self) -> int | None:
        """The number of complete runs: those that cannot be continued; None if there is a cycle.

        With a cycle there are infinitely many runs.
        """
        count, graph = len(self._keys), self.graph
        entering = [0] * count
        for index in range(len(graph)):
            entering[graph.target(index)] += 1
        ways = [int(graph.discovery(number).before < 0) for number in range(count)]
        queue = [number for number in range(count) if not entering[number]]
        ends = 0
        for number in queue:
            indices = graph.transitions(number)
            ends += 0 if indices else ways[number]
            for index in indices:
                reached = graph.target(index)
                ways[reached] += ways[number]
                entering[reached] -= 1
                if not entering[reached]:
                    queue.append(reached)
        return ends if len(queue) == count else None


def in_lockstep(searches: Sequence[Search], minds: Minds) -> None:
    """Run several searches together, layer by layer; all of them share ``minds``.

    For each layer a program gets one message with the turns of all these searches.
    """
    for search in searches:
        search.begin()
    going = [search for search in searches if search.going]
    while going:
        for search in going:
            search.plan()
        minds.ask()
        for search in going:
            search.expand()
        minds.forget()
        going = [search for search in going if search.going]
    for search in searches:
        search.finish()
