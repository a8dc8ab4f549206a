"""One run: ``run`` plays it in one world, ``replay`` plays the run of a finding again.

A replayed finding may come from a corpus, which is a collection of findings.  In ``play`` the user
is the robot, in the terminal or in a web page; the user's cost is compared with that of Algorithm
1.  In Python, ``play`` takes a function of the user that chooses the actions.  The parameter of
``play`` for this function has the name ``player``; elsewhere a player is a process that runs an
explorer.
"""

import os
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import KW_ONLY
from typing import Annotated, Any, Literal, TypeAlias

from allworlds.documents import document as doc
from allworlds.documents.document import Natural, about, computed
from allworlds.documents.report import Report
from allworlds.engines import limits, single
from allworlds.explorers import loading, sources
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs import checks, requests
from allworlds.inputs.checks import InputError, an_integer, show
from allworlds.inputs.requests import RULES, SCOPE, Converted, Option, OptionGroup, answers
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.law_table import LawName
from allworlds.judging.rules import RuleOptions
from allworlds.judging.walk import Walk
from allworlds.outcome import Facts
from allworlds.protocol.actions import Action, IllegalAction, Percept, Transcript
from allworlds.robots.team_finding import TeamFinding
from allworlds.studies.check import hints
from allworlds.studies.findings import FindingOptions
from allworlds.studies.team.finding_reports import TeamReplay, replayed
from allworlds.world.lighthouses import kinds, marked
from allworlds.world.named import HOLES, LIGHTHOUSE, WORLD, WorldOptions, world_named
from allworlds.world.world import World


def index_list(text: str) -> tuple[int, ...]:
    """The indices in a text such as ``0,2,1``.

    Raises:
        InputError: if the text is no list of indices.
    """
    if not re.fullmatch(r"[0-9]{1,9}(,[0-9]{1,9})*", text):
        raise InputError(f"choices {show(text)} are not indices from 0 on with commas")
    return tuple(int(part) for part in text.split(","))


def _indices(choices: object) -> tuple[int, ...]:
    if isinstance(choices, str) or not isinstance(choices, Iterable):
        raise InputError(f"choices = {show(choices)} is not a list of indices")
    return tuple(an_integer(f"choices[{i}]", index) for i, index in enumerate(choices))


class RunOptions(limits.TimeoutOptions, RuleOptions, WorldOptions):
    """The part of a request about one run: the world, the choices, the rules and the time-outs."""

    choices: Annotated[
        Converted[Sequence[int], tuple[int, ...]],
        Option(
            RULES,
            "I,I,...",
            "The indices to take at the first choices; after these the policy chooses.",
            parse=index_list,
        ),
    ] = Converted(_indices, ())


class RunRequest(RunOptions, kw_only=False):
    """Request of ``run``: an explorer, a world and the rules."""

    explore: Annotated[str | Callable[..., Any], "a name or a generator function"]
    world: Annotated[
        World | str | None,
        "map, lighthouse and start; or what :func:`allworlds.world.named.world_named` reads; None: "
        "the world of ``family``",
    ] = None


class WorldNames(Report):
    """Report of 'run --list'.

    The names that a WORLD can have; a capital letter stands for a number.
    """

    maps: Annotated[tuple[doc.Text, ...], doc.about("small maps")]
    families: Annotated[tuple[doc.Text, ...], doc.about("families of maps, small or large")]
    corpus: Annotated[tuple[doc.Text, ...], doc.about("worlds of the corpus")]


@answers(RunRequest)
def run(request: RunRequest) -> single.SingleRun:
    """Run an explorer once, and judge the run.

    A user's explorer that another process can import is played in its own process, as in a check;
    any other explorer is played in this process. The explorer's process has the hash seed of the
    environment variable ``PYTHONHASHSEED``, if the variable is set.

    Raises:
        InputError: naming the offending option and what would be legal; or naming the first index
            of the option ``choices`` that the run did not use, because the explorer made fewer
            choices, or because there were fewer options at this choice.
    """
    limits = request.limits
    subject = single.subject_of(request.explore, limits)
    world = request.meant(request.world, subject.lighthouse)
    rules = request.rules_of(subject, kinds.kind_of(world.lighthouse))
    played = single.single_run(subject, world, rules, request.choices, limits, _asked_hash_seed())
    if unused := single.unused_choice(request.choices, played):
        raise InputError(unused)
    return _located(played, subject, limits)


def _located(run: single.SingleRun, subject: Any, limits: limits.Limits) -> single.SingleRun:
    """The run; its finding, if there is one, then names the lines of the explorer's code that ran.

    For this the explorer ``subject`` is run once more, within the ``limits`` of time and memory.
    The finding names the line at which each action was chosen.  The finding stays as it is if the
    explorer is not a user's Python code, or does not repeat the run.
    """
    found = run.finding and hints.located(run.finding, subject, limits)
    return doc.replace(run, finding=found)


def _asked_hash_seed() -> int | None:
    """The hash seed in the variable ``PYTHONHASHSEED``; None if the variable holds no number."""
    seed = os.environ.get(loading.HASH_SEED, "")
    return int(seed) if re.fullmatch("[0-9]{1,9}", seed) else None


class AnotherExplorer(sources.ProgramWords):
    """An explorer in place of the recorded explorer, by its name on the command line."""

    explorer: Annotated[
        str | None, Option(SCOPE, "EXPLORER", "In place of the recorded explorer.")
    ] = None

    def value(self) -> str | None:
        """The name of the explorer; None if no explorer is named."""
        return self.named(self.explorer)


class ReplayRequest(limits.TimeoutOptions, FindingOptions, kw_only=False):
    """Request of ``replay``: a finding, and another explorer if wanted."""

    explore: Annotated[
        str | Callable[..., Any] | None,
        OptionGroup(AnotherExplorer, "an explorer in place of the recorded one"),
    ] = None


TRIES = 8
"""The most runs that ``replay`` makes for a finding of the law ``nondeterministic``.

Each run is made in two fresh processes.  If no run breaks a law, the outcome is
``not-reproduced``.
"""


class Replay(Report):
    """Report of 'replay'.

    The result of running a finding again.

    ``notice`` is a sentence about the first recorded choice that the new run did not take. The text
    is empty if the run took all recorded choices, or if another explorer ran, which makes its own
    choices. ``users``: whether the explorer that ran is a user's, and not built in.
    """

    again: Annotated[single.SingleRun, doc.about("the new run")] = doc.key(name="run")
    recorded: doc.NotInDocument[Finding]
    notice: doc.NotInDocument[str] = ""
    users: doc.NotInDocument[bool] = False

    @doc.computed
    def explorer(self) -> doc.Text:
        """The name of the explorer that ran."""
        return self.again.explorer

    @doc.computed
    def law(self) -> LawName:
        """The law of the recorded finding."""
        return self.recorded.law

    @doc.computed
    def law_now(self) -> LawName | None:
        """The law that is broken now; null: none."""
        return self.again.finding.law if self.again.finding else None

    @doc.computed
    def outcome(self) -> Literal["reproduced", "fixed", "not-reproduced"]:
        """``reproduced``: a law is broken; ``fixed``: none is; ``not-reproduced``: undecided.

        Any broken law counts, not only the recorded one.  If no run breaks a law now, the outcome
        is undecided in one case: the recorded law is ``nondeterministic``, and the explorer is a
        user's.  Then a further run might break a law.
        """
        if self.again.finding:
            return "reproduced"
        open_ = self.users and self.recorded.law == "nondeterministic"
        return "not-reproduced" if open_ else "fixed"

    @property
    def facts(self) -> Facts:
        """The facts that decide the exit code: whether the finding is fixed, or left open."""
        outcome = self.outcome
        return Facts(fixed=outcome == "fixed", undecided=outcome == "not-reproduced")


@answers(ReplayRequest)
def replay(request: ReplayRequest) -> Replay | TeamReplay:
    """Run an explorer again in the world of a finding, under the rules of the finding.

    If there is no ``explore``, or if it names the recorded explorer, the recorded explorer runs;
    its code may have changed.  At each choice it gets the option with the recorded index; if there
    are fewer options now, the recorded policy chooses.  If ``explore`` is another explorer, the
    recorded policy makes all choices.  For a finding of the law ``nondeterministic`` the run is
    made up to :data:`TRIES` times.  For a finding of a team of robots, the world of the finding is
    searched again.

    If the finding has choices, but the function of the recorded explorer has no parameter
    ``choices`` any more, this explorer cannot repeat the run.  Without ``explore`` this is an
    error.  If ``explore`` names the recorded explorer, it runs, and makes no choices.

    Raises:
        InputError: if the explorer cannot be found; if the finding's transcript is no walk in the
            finding's world; or, without ``explore``, if the recorded explorer has no parameter
            ``choices`` for the choices of the finding.
    """
    finding, explore = request.finding, request.explore
    if isinstance(finding, TeamFinding):
        return replayed(finding, explore, request)
    if not isinstance(finding, Finding):
        raise InputError(f"finding = {show(finding)} is no Finding; Finding.from_json makes one")
    limits = request.limits
    Walk.recorded(finding.world, finding.transcript)
    same = explore is None or explore == finding.explorer
    subject = single.subject_of(finding.explorer if explore is None else explore, limits)
    if explore is None and finding.choices and not subject.takes_choices:
        raise InputError(
            f"the finding records the choices {show(list(finding.choices))}, but "
            f"{finding.explorer} takes no choices; to run it without them, name it as the "
            "explorer, too"
        )
    kind = finding.world.lighthouse.kind
    rules = doc.replace(
        finding.rules,
        own_bound=loading.own_bound(subject.name, kind),
        bound=finding.rules.the_bound,
        laws=finding.rules.applying or None,
    )
    script = finding.choices if same else ()
    for _ in range(TRIES if finding.law == "nondeterministic" else 1):
        again = single.single_run(
            subject, finding.world, rules, script, limits, finding.hash_seed, finding.earlier
        )
        if again.finding:
            break
    notice = single.unused_choice(finding.choices, again) if same else ""
    if notice:
        notice = f"the recorded {notice}; choices are repeated as far as they fit"
    again = _located(again, subject, limits)
    return Replay(again=again, recorded=finding, notice=notice, users=subject.from_user)


LARGEST = 200
"""The most edges of a world in which ``play`` also runs Algorithm 1, for some seconds at most."""

VARIANTS = {
    BUILT_IN[name].lighthouse: name
    for name in ("algorithm1", "algorithm1-cluster", "algorithm1-natural", "algorithm1-door")
}
"""The name of the variant of Algorithm 1 for each lighthouse for which there is a variant."""


def _cost_of_algorithm1(world: World) -> int | None:
    """The cost of Algorithm 1 in the world; None if Algorithm 1 is not run there.

    Algorithm 1 is run in worlds with at most :data:`LARGEST` edges whose lighthouse is in
    :data:`VARIANTS`.

    Cost: seconds at most.
    """
    kind = world.lighthouse.written
    if world.map.edge_count > LARGEST or kind not in VARIANTS:
        return None
    subject = single.subject_of(VARIANTS[kind], limits.Limits())
    rules = RuleOptions().rules_of(subject, kinds.kind_of(world.lighthouse))
    return single.single_run(subject, world, rules, (), limits.Limits()).cost


GamePlayer: TypeAlias = Callable[[Percept, str], Action | None]
"""A function that plays the robot: in ``play`` such a function is called the player.

Its arguments are the percept, and the reason why the last action was refused; this text is empty if
the action was legal.  It returns the next action, or None to end the game.
"""


class Play(Report, kw_only=True):
    """Report of 'play'.

    A world, and a walk in this world.  The user, or the user's function, was the robot.  If the
    user plays in a page, the report does not have the user's walk: ``transcript`` has only the
    start.
    """

    path: Annotated[str | None, about("the page for playing; null: played in the terminal")] = None
    world: World
    transcript: Annotated[Transcript, about("the actions and percepts; for a page only the start")]

    @computed
    def algorithm1(self) -> Natural | None:
        """The traversals of Algorithm 1 in the same world; null: Algorithm 1 is not run there."""
        return _cost_of_algorithm1(self.world)


class PlayRequest(requests.Request, kw_only=False):
    """Request of ``play``: a world, and the function ``player`` that plays the robot there."""

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
        GamePlayer,
        "takes a percept and the fault of the last action, and returns the next action, or None to "
        "end the game; by default it ends the game at once",
    ] = lambda *_: None


@requests.answers(PlayRequest)
def play(request: PlayRequest) -> Play:
    """Let the function ``player`` play the robot in a world, and report the walk.

    The function is called with each percept, and returns the next action, until it returns None.
    On the command line the function asks the user in the terminal; if the user plays in a page, the
    reported walk has only the start.

    Raises:
        InputError: if ``world`` is a text that names no world.
    """
    world = world_named(request.world, request.lighthouse, request.seed, request.holes)
    player, walk = request.player, Walk.begin(world)
    percept, refused = world.first, ""
    while (action := player(percept, refused)) is not None:
        refused = ""
        try:
            percept = walk.step(action)
        except IllegalAction as error:
            refused = str(error)
    return Play(world=world, transcript=walk.transcript)
