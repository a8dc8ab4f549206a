"""A page in which the reader is the robot, with costs beside the player's."""

from collections.abc import Callable, Iterator
from dataclasses import KW_ONLY
from enum import StrEnum
from typing import Annotated, TypeAlias

from allworlds.document import Document, Natural, Report, about, computed
from allworlds.engines import limits, single
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs import checks, requests
from allworlds.judging.findings.rules import RuleOptions
from allworlds.maps.build import covering_walk
from allworlds.protocol.actions import Action, Percept
from allworlds.protocol.player import IllegalAction
from allworlds.protocol.transcript import Transcript
from allworlds.world.lighthouses import kinds, marked
from allworlds.world.named import HOLES, LIGHTHOUSE, WORLD, world_named
from allworlds.world.world import World

LARGEST = 200
"""The most edges for which Algorithm 1 takes no more than some seconds."""

VARIANTS = {
    BUILT_IN[name].lighthouse: name
    for name in ("algorithm1", "algorithm1-cluster", "algorithm1-natural")
}
"""Algorithm 1 for each lighthouse that it is written for."""


class Walker(StrEnum):
    """Whose cost it is."""

    ALGORITHM_1 = "algorithm1"
    EVERY_EDGE = "every-edge"


class CostBeside(Document):
    """The cost of somebody else in the world that is played."""

    who: Annotated[
        Walker,
        about(
            "`algorithm1`; `every-edge`: the shortest walk from the start along every edge, for "
            "which one must know the map"
        ),
    ]
    cost: Annotated[Natural, about("traversals")]


def _costs(world: World) -> Iterator[CostBeside]:
    """The costs of Algorithm 1, where it is known, and of the shortest walk along every edge.

    Cost: seconds at most; larger worlds do not have the first.
    """
    kind = world.lighthouse.kind
    if world.map.edge_count <= LARGEST and kind in VARIANTS:
        subject = single.subject_of(VARIANTS[kind], limits.Limits())
        rules = RuleOptions().rules_of(subject, kinds.kind_of(world.lighthouse))
        cost = single.single_run(subject, world, rules, (), limits.Limits()).cost
        yield CostBeside(who=Walker.ALGORITHM_1, cost=cost)
    yield CostBeside(who=Walker.EVERY_EDGE, cost=covering_walk(world.map, world.start))


Player: TypeAlias = Callable[[Percept, str], Action | None]
"""A player: given the percept, and the fault of the last action (empty if there is none),
it returns the next action; None ends the game."""


class Play(Report, kw_only=True):
    """Report of 'play'.

    A world and a walk in it.
    """

    path: Annotated[str | None, about("the page for playing; null: played in the terminal")] = None
    world: World
    transcript: Annotated[Transcript, about("the actions and percepts; for a page only the start")]

    @computed
    def costs(self) -> tuple[CostBeside, ...]:
        """Of others in the same world."""
        return tuple(_costs(self.world))

    @property
    def not_compared(self) -> str:
        """A sentence that says whose cost is not compared, and why; empty if each is."""
        edges, kind = self.world.map.edge_count, self.world.lighthouse.kind
        if kind not in VARIANTS:
            return f"Algorithm 1 is not for the {kind} lighthouse."
        if edges > LARGEST:
            return f"Algorithm 1 is not run in worlds with more than {LARGEST} edges."
        return ""


class PlayRequest(requests.Request, kw_only=False):
    """Request of ``play``: a world, and who walks in it."""

    world: Annotated[World | str, WORLD]
    _: KW_ONLY
    lighthouse: Annotated[kinds.GivenLighthouse, LIGHTHOUSE] = marked.Directional.kind
    seed: Annotated[
        int | None,
        requests.Option(
            requests.SCOPE,
            "S",
            "Seed for families that are drawn at random: with it, everybody gets the same world.",
            parse=checks.integer_of,
        ),
    ] = None
    holes: Annotated[str | None, HOLES] = None
    player: Annotated[
        Player,
        "takes a percept and the fault of the last action, and returns the next action, or None to "
        "end the game; by default it ends the game at once",
    ] = lambda *_: None


@requests.answers(PlayRequest)
def play(request: PlayRequest) -> Play:
    """Let a player walk in the world, action by action.

    Raises:
        InputError: if there is no such world.
    """
    world = world_named(request.world, request.lighthouse, request.seed, request.holes)
    player = request.player
    state, percept, steps, refused = world.initial, world.first, [], ""
    while (action := player(percept, refused)) is not None:
        try:
            state, percept = world.step(state, action)
        except IllegalAction as error:
            refused = str(error)
        else:
            refused = ""
            steps.append((action, percept))
    return Play(world=world, transcript=Transcript(world.first, tuple(steps)))
