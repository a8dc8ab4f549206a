"""Hints for a finding from more plays of its explorer.

There are two kinds of hints: options with which the explorer breaks no law; and lines of the
explorer's code, those that ran at each step of the finding, and those that ran in the finding alone
and in no *right* run, a run that breaks no law.

Hints do not change the verdict.  An option is named only after runs in which it was tried.
"""

import linecache
import os
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import Any, TypeAlias

import msgspec

from allworlds.documents.document import replace
from allworlds.engines import players
from allworlds.engines.batch import Due
from allworlds.engines.engine_table import Job, players_for
from allworlds.engines.limits import Limits, TimeIsUp
from allworlds.engines.single import Plays
from allworlds.engines.tally import RunCounter
from allworlds.engines.units import GivenWorlds, Scope, numbered_runs, units_of_level
from allworlds.explorers.loading import Subject, is_library, is_program
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import CodeLines, Finding, place_of
from allworlds.judging.laws.bounds import NO_BOUND
from allworlds.protocol.actions import action_numbered
from allworlds.protocol.code_lines import NOWHERE, UserLine
from allworlds.world.lighthouses.options import InvalidWorld
from allworlds.world.world import World

MOST = 4000
"""The most runs of a trial, the runs in which an option is tried.

A level with which the trial would have more runs is not tried.
"""

SECONDS = 5.0
"""The most seconds of a trial; an option whose trial would take longer is not named."""

LARGER = 4
"""The factor by which the step budget of a trial exceeds the budget that was broken."""

WorldAtPlace: TypeAlias = tuple[World, int]
"""A world with the number of the lighthouse's place."""

RIGHT = 200
"""The most further runs whose lines of code are compared with the lines of a finding."""


def hinted(finding: Finding, subject: Subject, limits: Limits, scope: Scope) -> Finding:
    """The confirmed finding with both kinds of hints.

    For the hints with lines of code, the lines that ran in the finding are compared with those that
    ran in other worlds.  These are worlds of ``scope`` with at most as many edges as the finding's
    world; :func:`located` uses the first of them.
    """
    levels = (edges for edges in scope.extent.levels if edges <= finding.world.map.edge_count)
    others = (run for edges in levels for run in _runs(scope, edges))
    tried = tried_options(finding, subject, limits, scope)
    return located(replace(finding, tried=tried), subject, limits, others)


# ---------------------------------------------------------------- an option


def tried_options(finding: Finding, subject: Subject, limits: Limits, scope: Scope) -> str:
    """A text with options, as on the command line, with which the explorer breaks no law.

    The options are tried in the finding's world and in its mirror image; then in all worlds of the
    scope with at most M edges.  M is as large as possible: the worlds may need at most :data:`MOST`
    runs.  M is also in the text, as ``--edges M``, since the options were not tried in larger
    worlds.

    The text is empty if no such options are known, or if M is less than the number of edges of the
    finding's world.

    Args:
        finding: the confirmed finding.
        subject: the explorer.
        limits: the limits of the check.
        scope: the scope of the check.
    """
    rules, changes = finding.rules, dict[str, Any]()
    if finding.law == "budget" and rules.step_budget is None:
        changes["step_budget"] = LARGER * rules.budget(finding.world.map)
    if finding.law == "bound" or (changes and rules.the_bound != NO_BOUND):
        others = tuple(law for law in rules.laws or () if law != "bound")
        changes |= {"bound": NO_BOUND, "laws": others or None}
    stands = finding.confirmed or not subject.importable  # which cannot be confirmed
    if not (changes and stands) or rules.laws == ("bound",):
        return ""
    worlds, tried, least = list[WorldAtPlace](), 0, finding.world.map.edge_count
    for edges in scope.extent.levels:
        level = [*islice(_runs(scope, edges), MOST + 1 - len(worlds))]
        if len(worlds) + len(level) > MOST:
            break
        worlds, tried = worlds + level, edges
    if tried < least:
        return ""
    own = [(finding.world, finding.place)]
    with suppress(InvalidWorld):  # the lighthouse may be unable to stand there
        own.append((finding.world.mirrored(), place_of(finding.world.mirrored())))
    changed = replace(scope, rules=replace(rules, **changes))
    alone = replace(limits, workers=1, time_limit=None)
    job = Job(changed, subject, alone, 1, time.monotonic() + SECONDS, lambda _text: None)
    units = GivenWorlds(tuple(own)), GivenWorlds(tuple(worlds))
    try:
        with players_for(job) as transport:
            if any(each.result.findings for each in transport.map(RunCounter(changed, 1), units)):
                return ""
    except (TimeIsUp, InputError, players.Unsettled):
        return ""
    options = {"edges": tried, **changes}
    options.pop("laws", None)
    return " ".join(f"--{name.replace('_', '-')} {value}" for name, value in options.items())


def _runs(scope: Scope, edges: int) -> Iterator[WorldAtPlace]:
    """Yield all worlds with this number of edges, each with the number of its lighthouse's place.

    The class of maps and the lighthouse are those of ``scope``.  If the check is a shard, it tries
    only a part of the worlds; here all worlds are yielded.
    """
    for unit in units_of_level(scope.extent, edges):
        for run in numbered_runs(unit, scope.extent, scope.rules.kind):
            if run.lighthouse is not None:
                yield World(run.map, run.lighthouse, 0), run.place


# ---------------------------------------------------------------- lines


Trace: TypeAlias = list[tuple[bool, UserLine]]
"""The turns of a play: for each turn whether it is a checkpoint, and the line of code."""


def located(
    finding: Finding, subject: Subject, limits: Limits, others: Iterable[WorldAtPlace] = ()
) -> Finding:
    """The finding, with its field ``code``: lines of the explorer's code.

    There are three groups of lines.  First: for each action and each checkpoint the line at which
    the explorer was.  Second: every line that ran in the finding and in no right run; if there is
    no right run, there is no such line.  Third, only under the law ``budget``: the lines that ran
    most often at the end of the run.

    The finding is returned unchanged in three cases.  First: the explorer is built in, or is not in
    Python.  Second: the law is ``timeout`` or ``nondeterministic``.  Third: the explorer is run
    again, and does not repeat the actions of the finding.

    Args:
        finding: the finding.
        subject: the explorer.
        limits: the limits of the time for an answer, and of memory.
        others: further worlds, each with the number of its lighthouse's place.  The explorer is
            also run in the first :data:`RIGHT` of these worlds.  If such a run breaks no law, it is
            a right run.

    Cost: that of the runs, each some ten times slower than a run whose lines are not traced.
    """
    other_language = is_program(subject.name) or is_library(subject.name)
    if other_language or not subject.from_user or finding.law in ("timeout", "nondeterministic"):
        return finding
    plays = Plays(subject, finding.rules, finding.world, limits)
    due = [Due(0, finding.place, finding.world, finding.choices)]
    due += [Due(i, place, world) for i, (world, place) in enumerate(islice(others, RIGHT), 1)]
    try:
        *logs, lines = plays.traced(due)
        traced = msgspec.json.decode(lines, type=list[tuple[Trace, set[UserLine], list[UserLine]]])
        judged = [plays.judge.judged(one, log) for one, log in zip(due, logs, strict=True)]
    except (InputError, msgspec.MsgspecError, ValueError):  # it may do something else now
        return finding
    walk = tuple(map(action_numbered, judged[0].log.actions))
    if walk[: len(finding.transcript.steps)] != finding.transcript.actions:
        return finding
    (turns, ran, busiest), *plays_of_others = traced
    pairs = zip(plays_of_others, judged[1:], strict=True)
    right = [lines for (_, lines, _), one in pairs if one.outcome.violation is None]
    alone = ran.difference(*right) if right else set[UserLine]()
    busy = busiest if finding.law == "budget" else []
    return replace(finding, code=_code(turns, sorted(alone), len(right), busy))


def _code(turns: Trace, alone: list[UserLine], right: int, busy: list[UserLine]) -> CodeLines:
    shown = {where for _, where in turns} | {*alone, *busy} - {NOWHERE}
    sources = ((where, linecache.getline(*where).strip()) for where in sorted(shown))
    return CodeLines(
        steps=tuple(_named(where) for is_checkpoint, where in turns if not is_checkpoint),
        checkpoints=tuple(_named(where) for is_checkpoint, where in turns if is_checkpoint),
        alone=tuple(map(_named, alone)),
        right=right,
        busy=tuple(map(_named, busy)),
        sources=tuple(f"{_named(where)}: {text}" for where, text in sources if text),
    )


def _named(where: UserLine) -> str:
    """The text ``FILE:LINE``, relative to the current folder if the file is in it.

    For code in a notebook's cell, or typed at a prompt, FILE is ``input``.  The text is empty for
    a line that is not the user's.
    """
    file, line = where
    if file and not Path(file).is_file():
        return f"input:{line}"
    return f"{file.removeprefix(f'{Path.cwd()}{os.sep}')}:{line}" if file else ""
