"""A lane for searches: it takes a unit, and searches the worlds of the unit with two players.

A player is a process with a program of the team; each program has a first and a second player.
Unlike other lanes, this lane has no judge: the searches themselves find the broken laws.

Up to :data:`AT_ONCE` searches are run together, layer by layer.  A layer holds the configurations
that one more step reaches.  For each layer each first player gets one message, with the turns of
all these searches.  At the end of the unit each second player plays the same turns again.

unit --> searches --> layer --> first players --> next layer --> ... --> findings
end of the unit --> second players --> a finding if a reply differs
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any

from allworlds.engines.batch import FIRST, SECOND
from allworlds.engines.hash_seeds import seeds_of
from allworlds.engines.limits import Limits
from allworlds.engines.units import PartialResult
from allworlds.protocol.turns import BEGIN
from allworlds.robots.configurations import Search, in_lockstep
from allworlds.robots.graph import Broken
from allworlds.robots.minds import Minds
from allworlds.robots.model_checks import ensure_same_model
from allworlds.robots.program_player import Difference, ProgramPlayer, difference
from allworlds.robots.team import Team, TeamScope, TeamTally
from allworlds.robots.team_finding import finding_of

AT_ONCE = 2000
"""The number of searches that are run together, layer by layer."""

SAME_TO = 2
"""The largest number of edges of the maps in which the model is checked, see ``model_checks``."""


class SearchLane:
    """A lane for searches, which works on one unit at a time.

    The programs are played twice.  The first players take part in the searches; at the end of the
    unit the second players play the same turns again, and must give the same replies.

    Args:
        team: the programs.
        counter: the scope of all searches: the team, the model and the schedules.  Its methods make
            the searches of a unit, and an empty tally, in which their results are counted.
        limits: the limits of the time for an answer, and of memory.
        first_lane: not used; it is here because all lanes are made with the same arguments.
        deadline: the time, on the monotonic clock, after which the lane waits for no reply; or
            None.
    """

    keeps = False

    def __init__(
        self,
        team: Team,
        counter: TeamScope,
        limits: Limits,
        *,
        first_lane: bool = True,  # noqa: ARG002  # as other lanes have it
        deadline: float | None = None,
    ) -> None:
        self.counter = counter
        self._tally = counter.tally()
        self._players: list[list[ProgramPlayer]] = [[], []]
        for subject in team.subjects:
            for play, seed in zip((FIRST, SECOND), seeds_of(subject), strict=True):
                asked = ProgramPlayer(subject, limits, deadline, seed, self._remark)
                self._players[play].append(asked)
        self._units: list[Any] = []
        self._parts: Iterator[TeamTally] | None = None

    def offer(self, unit: Any) -> None:
        """Take a unit."""
        self._units.append(unit)

    @property
    def hungry(self) -> bool:
        """Whether the lane has no unit, and can take one."""
        return not self._units

    @property
    def busy(self) -> bool:
        """Whether the lane has a unit to work on."""
        return bool(self._units)

    def turn(self, others: Sequence[int] = ()) -> list[PartialResult]:  # noqa: ARG002  # they wait
        """Do the next part of the work on the unit, and return the result of this part.

        A part is up to :data:`AT_ONCE` searches.  After all searches one more part is the second
        play of the programs.  After all parts one more call returns a last result: its tally is
        empty, and its field ``last`` is True, which says that the unit is done.

        Args:
            others: not used here. Other lanes wait for messages, and stop waiting once one of these
                file descriptors can be read.

        Raises:
            InputError: if a program cannot be loaded, or the model has an error.
        """
        unit = self._units[0]
        self._parts = self._parts or self._parts_of(unit)
        part = next(self._parts, None)
        if part is not None:
            return [PartialResult(unit, part, last=False)]
        self._parts = None
        del self._units[0]
        return [PartialResult(unit, self.counter.tally(), last=True)]

    def end(self) -> TeamTally:
        """An empty tally, because no results are left at the end."""
        return self.counter.tally()

    def close(self) -> None:
        """End all players."""
        for players in self._players:
            for player in players:
                player.close()

    def _remark(self, text: str) -> None:
        self._tally.remarks[text] += 1

    def _parts_of(self, unit: Any) -> Iterator[TeamTally]:
        """Yield the parts of a unit's result.

        The last part has the findings for programs of which a second player gave another reply than
        the first player.
        """
        for player in (*self._players[FIRST], *self._players[SECOND]):
            player.begin_unit()
        minds = Minds(self._players[FIRST])
        every = self.counter.searches(unit, minds)
        while some := [*islice(every, AT_ONCE)]:
            searches = [search for _, search in some if isinstance(search, Search)]
            in_lockstep(searches, minds)
            for new, search in some:
                world = search.world if isinstance(search, Search) else search
                self._tally.row(world.map).maps += new
                if isinstance(search, Search):
                    self._count(search)
            yield self._taken()
        for program, again in enumerate(self._players[SECOND]):
            if found := difference(minds.dialogues[program], again):
                self._blame(unit, minds, program, found)
        yield self._taken()

    def _taken(self) -> TeamTally:
        """The tally of all searches since the last call of this method; a new tally begins."""
        taken, self._tally = self._tally, self.counter.tally()
        return taken

    def _count(self, search: Search) -> None:
        map_, tally = search.world.map, self._tally
        tally.row(map_).count(search)
        if search.broken and tally.wants(map_):
            tally.find(self._finding(search, search.broken))
        if search.ends.cut_off and tally.wants(map_, unfinished=True):
            most = self.counter.timing.budget
            seen = f"the run goes on after {most} activations of each robot"
            if self.counter.timing.schedule is not None:
                seen = "the schedule that was given ends here"
            cut = Broken("budget", seen, search.ends.shortest)
            tally.find(self._finding(search, cut), unfinished=True)
        if map_.edge_count <= SAME_TO:
            ensure_same_model(search)

    def _finding(self, search: Search, broken: Broken) -> Any:
        scope = self.counter
        return finding_of(search, broken, scope.model.name, scope.model.digest, scope.team.names)

    def _blame(self, unit: Any, minds: Minds, program: int, found: Difference) -> None:
        """Add a finding for the difference ``found`` between two plays of a program.

        The finding is in the first world of ``unit`` in which a robot has the turn that differs.
        ``program`` is the number of the program, and ``minds`` has the minds of the first play.
        """
        for _, search in self.counter.searches(unit, minds):
            if not isinstance(search, Search):
                continue
            in_lockstep([search], minds)
            if at := _where_sensed(search, program, found, minds):
                number, group, robot = at
                seen = f"{found.first} in one play, {found.second} in another"
                broken = Broken("nondeterministic", seen, number, group, robot=robot)
                self._tally.find(self._finding(search, broken))
                return


def _where_sensed(
    search: Search, program: int, found: Difference, minds: Minds
) -> tuple[int, tuple[int, ...], int] | None:
    """Find the first configuration in which a certain turn can be a robot's next turn.

    In this turn, that of ``found``, two plays of the program with the number ``program`` differ.
    Return what a finding needs to show the turn in a run: the number of the configuration, a group
    of robots that can be activated there together, and the number of the robot, which belongs to
    the group.  Return None if there is no such configuration.
    """
    _, before, sensed = found.turn
    planned = {number for number, _, _ in search.plans}
    for number in range(len(search)):
        _, of_robots, _ = search.configuration(number)
        # No program is asked where the run is over or cut off.
        asked = number in planned or search.graph.transitions(number)
        for robot, mind in enumerate(of_robots):
            if search.program_of[robot] != program or mind < 0:
                continue
            if before != BEGIN and not (asked and search.percept(number, robot) == sensed):
                continue
            if minds.precedes(mind, before):
                every = search.timing.groups(tuple(search.able(number)[0]))
                groups = [group for group, _ in every if robot in group]
                if groups:
                    return number, groups[0], robot
    return None
