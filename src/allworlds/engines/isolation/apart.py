"""Single runs of a user's explorer, apart from any check."""

from __future__ import annotations

import secrets
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from random import Random

from allworlds.document import replace
from allworlds.engines.isolation.fresh_process import logs_of, record_of, traced
from allworlds.engines.isolation.jobs import PlayerSetup, Trace
from allworlds.engines.isolation.overheard import Overheard
from allworlds.engines.isolation.player_pair import PlayerPair
from allworlds.engines.isolation.process import guardian
from allworlds.engines.python.examiner import Outcome
from allworlds.engines.python.in_process import InProcessPlayers
from allworlds.engines.python.players import SEEDS, OneRun, Players
from allworlds.engines.python.python_engine import PythonEngine
from allworlds.engines.python.runs_of_unit import GivenWorlds
from allworlds.engines.python.scope import Scope
from allworlds.engines.python.second_play import PlayedTwice
from allworlds.engines.units.effort import Limits
from allworlds.explorers import Subject
from allworlds.judging import Episode, LostRun, Rules, Violation, canonical_world, place_of
from allworlds.maps import Extent, MapClass
from allworlds.world import World


def examine_apart(
    subject: Subject,
    rules: Rules,
    world: World,
    script: tuple[int, ...],
    limits: Limits,
    hash_seed: int | None = None,
) -> Outcome:
    """The judged run of a user's explorer, played twice, as in a check.

    Both players have the hash seed, if one is given.
    """
    engine, unit = _of_these(rules, (world,))
    ((canonical, place),) = unit.worlds
    with _players(subject, limits, hash_seed) as players:
        twice = PlayedTwice(engine, subject.name, players)
        placed = {0: OneRun(0, place, canonical)}
        # What is wrong with another hash seed comes last.
        *_, (_, outcome) = twice.outcomes(unit, placed, given=script)
    if isinstance(outcome, Outcome) and not subject.importable:
        record = record_of(rules, canonical, outcome.episode.transcript, outcome.choices)
        return replace(outcome, output=InProcessPlayers(subject).printed(record, rules.policy))
    with Overheard() as heard:
        setup = PlayerSetup.of(subject, limits, heard.path)
        if isinstance(outcome, Outcome):
            record = record_of(rules, canonical, outcome.episode.transcript, outcome.choices)
            logs_of((record,), rules.policy, setup, hash_seed)
        else:
            told = traced(Trace(rules, canonical, "one", script), setup, hash_seed)
            outcome = Outcome(
                Episode(told.transcript, (), outcome),
                Violation(outcome.law, outcome.expected, outcome.seen),
                "",
                told.choices,
                rules.the_bound.of(world.map, world.start),
                hash_seed,
            )
    return replace(outcome, output=heard.text)


def outcomes_apart(
    subject: Subject,
    rules: Rules,
    worlds: Sequence[World],
    limits: Limits,
    hash_seed: int | None = None,
) -> Iterator[tuple[World, Outcome | LostRun]]:
    """The judged runs of an explorer in these worlds, each played once, in any order."""
    engine, unit = _of_these(rules, worlds)
    with _players(subject, limits, hash_seed) as players:
        once = PlayedTwice(engine, subject.name, players)
        for one, outcome in once.played_once(unit, [*engine.runs(unit)]):
            yield one.world, outcome


def _of_these(rules: Rules, worlds: Sequence[World]) -> tuple[PythonEngine, GivenWorlds]:
    """An engine that judges by these rules, and these worlds as its unit."""
    most = max(world.map.edge_count for world in worlds)
    engine = PythonEngine(Scope(Extent(MapClass.MAPS, most), rules), keep=1)
    return engine, GivenWorlds(tuple((canonical_world(w), place_of(w)) for w in worlds))


@contextmanager
def _players(subject: Subject, limits: Limits, hash_seed: int | None) -> Iterator[Players]:
    if not subject.importable:
        yield InProcessPlayers(subject)
        return
    order = Random(secrets.randbits(64))  # noqa: S311  # drawn from the system
    seeds = SEEDS if hash_seed is None else (hash_seed, hash_seed)
    pair = PlayerPair(guardian(), PlayerSetup.of(subject, limits), order, seeds=seeds)
    try:
        yield pair
    finally:
        pair.close()
