"""The telling of one run, and of its map."""

from __future__ import annotations

import json

from allworlds.document.struct import replace
from allworlds.engines.single import SingleRun
from allworlds.judging.episode import Answered, Over, Said, Undecided
from allworlds.judging.explanations.story import Walked
from allworlds.judging.findings.walks import believed_walk, true_trail
from allworlds.judging.laws.laws import BrokenInvariant, embed
from allworlds.protocol.answers import Ambiguous
from allworlds.reports.rows import CsvRows, rows_of_walk
from allworlds.reports.scenes import walk_in_world
from allworlds.reports.telling import (
    Block,
    Headline,
    Section,
    ShownMap,
    ToldFacts,
    ToldResult,
    ToldTable,
    ToldWalk,
    View,
    Words,
    fact,
)
from allworlds.reports.tellings.finding import (
    answer_view,
    finding_section,
    nothing_checked,
    printed,
)
from allworlds.studies.replay import Replay
from allworlds.studies.run import WorldNames
from allworlds.words import number, plural


def known(run: SingleRun) -> ShownMap | None:
    """The map from a run's checkpoints; None if there is none, or if S is not embedded."""
    episode, world = run.outcome.episode, run.world
    if not episode.checkpoints:
        return None
    trail = true_trail(world, episode.transcript)
    seen = ShownMap({}, {})
    for step, checkpoint in episode.checkpoints:
        place = embed(world.map, trail[step], checkpoint)
        if isinstance(place, BrokenInvariant):
            return None
        for dart, other in enumerate(checkpoint.alpha):
            seen.darts.setdefault(place[dart], step)
            if other != dart:
                seen.edges.setdefault(place[dart], step)
    return seen


def run_telling(run: SingleRun | WorldNames) -> ToldResult:
    """One run, with its finding if it breaks a law; or the list of worlds."""
    if isinstance(run, WorldNames):
        named = (("maps", run.maps), ("families", run.families), ("corpus", run.corpus))
        facts = ToldFacts([(kind, ", ".join(names)) for kind, names in named])
        rows = CsvRows(
            {"kind": str, "name": str}, [[kind, one] for kind, of in named for one in of]
        )
        section = Section("names", "", [facts])
        return ToldResult("allworlds run", "names", run, None, [section], rows=lambda: rows)
    headline = Headline(run.verdict.value.upper(), _said(run), run.verdict.value)
    told = ToldResult(
        "allworlds run", run.explorer, run, headline, [_section(run)], apart=frozenset({"finding"})
    )
    if run.shows_walk or run.finding:
        return told
    walk = next(b for b in run_section(run, "walk-1").blocks if isinstance(b, ToldWalk))
    return replace(told, rows=lambda: rows_of_walk(walk))


def _said(run: SingleRun) -> str:
    """The result in a sentence: the first thing that is wrong, or that nothing is."""
    if run.finding:
        return f"law {run.finding.law} is broken"
    if not run.checked_laws:
        return f"{nothing_checked(run.rules)}; {cost_words(run)}"
    return f"{cost_words(run)}: no law is broken"


def replay_telling(replay: Replay) -> ToldResult:
    """The run of today. If it breaks no law, only a page shows it, with the recorded run."""
    recorded, run = replay.recorded, replay.again
    again = run.finding
    if again is None:
        said = Headline(
            "FIXED", f"{run.explorer} now keeps every law in the recorded world", "holds"
        )
        if replay.outcome == "not-reproduced":
            text = f"{run.explorer} did the same each time; only a check can show that it is mended"
            said = Headline("NOT REPRODUCED", text, "inconclusive")
    else:
        text = f"law '{again.law}' is broken again"
        if again.law != recorded.law:
            text = f"law '{again.law}' is broken now, where '{recorded.law}' was recorded"
        said = Headline("REPRODUCED", text, "refuted")
    section = _section(run)
    (walk,) = (block for block in section.blocks if isinstance(block, ToldWalk))
    return ToldResult(
        "allworlds replay",
        run.explorer,
        replay,
        said,
        [section] if again else [],
        more=lambda: (
            [] if again else [section, finding_section(recorded, title="The recorded finding")]
        ),
        rows=lambda: rows_of_walk(walk),
        apart=frozenset({"run"}),
    )


def cost_words(run: SingleRun) -> str:
    """The cost of the run, and the bound on it."""
    bound = "" if run.outcome.bound is None else f" of at most {number(run.outcome.bound)}"
    return f"{plural(run.outcome.cost, 'traversal')}{bound}"


def _section(run: SingleRun) -> Section:
    if run.finding:
        return finding_section(run.finding, checked=False)
    told = run_section(run, "walk-1")
    if not run.shows_walk:
        told = replace(told, blocks=[b for b in told.blocks if not isinstance(b, ToldWalk)])
    laws = fact("laws", ", ".join(run.checked_laws) or nothing_checked(run.rules))
    return replace(told, blocks=[*told.blocks, *printed(run.outcome.output), laws])


def run_section(run: SingleRun, name: str, title: str = "") -> Section:
    """A run that breaks no law: its pictures and its walk, and an answer that is no map."""
    world, episode = run.world, run.outcome.episode
    transcript, ending = episode.transcript, episode.ending
    walked = Walked(world, transcript)
    views = [View("world", "The world", walk_in_world(world, transcript), walked.walked)]
    agreement, blocks = None, list[Block]()
    seen = known(run)
    if seen is not None:
        title_of_s = "What the explorer knows (S)"
        views.append(View("known", title_of_s, views[0].scene, walked.walked, known=seen))
    if isinstance(ending, Answered):
        belief = believed_walk(world, ending.estimate, transcript)
        answer = answer_view(world, ending.estimate, transcript, belief.trail)
        views.append(replace(answer, still=seen is not None))
        agreement = belief.agreement
    if isinstance(ending, Undecided):
        blocks += _quotient(ending.quotient)
    if isinstance(ending, Said):
        blocks.append(fact("answer", json.dumps(ending.value)))
    if isinstance(ending, Over):
        blocks.append(fact("over", f"all is done: {run.rules.task.asks}"))
    walk = ToldWalk(f"The walk of {run.explorer}", walked, views, agreement=agreement)
    return Section(name, title, [walk, *blocks])


def _quotient(answer: Ambiguous) -> list[Block]:
    """An answer that names no map: the quotient that all worlds with equal percepts share."""
    header = ["dart", "sigma", "alpha", "degree", "marks", ""]
    columns = (range(len(answer.sigma)), answer.sigma, answer.alpha, answer.degree, answer.marks)
    rows = [[*row, "here" if row[0] == answer.here else ""] for row in zip(*columns, strict=True)]
    said = "The answer: several worlds look alike, and this is their quotient."
    return [Words(said), ToldTable(header, rows)]
