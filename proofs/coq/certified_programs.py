"""The programs extracted from the Coq proofs, compared with the package's, in every world.

    python proofs/coq/certified.py [--edges 4] [--walked-edges 3] [--judged-edges 3]
                               [--checked-edges 3] [--folded-edges 3] [--shielded-edges 3]

The certified explorers, one for each lighthouse, are checked as any explorer is.  The traversals of
each must equal, row by row, those of the built-in Algorithm 1 in the Python engine and, if the
kernel has that explorer, in the kernel.  Under each policy, in every run, their transcripts and
answers must equal those of the built-in one: motion by motion, percept by percept, dart by dart.
The certified judge gets the answer of every mutant and of Algorithm 1 on every world, and must give
the Python judge's verdict.  The certified checker gets all of these explorers, and the certified
folding their logs (``certified_checker.py``, ``certified_folding.py``).  ``nox -s full`` goes to 5
edges for the costs and to 4 for the rest.  Exit code 1: they disagree; 2: a program is missing; 3:
they have not disagreed, and a comparison could not be made: a program has not ended well.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from allworlds.corpus.explorers import (
    EQUIVALENT_EXPLORERS,
    WRONG_EXPLORERS,
    WrongExplorer,
)
from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.explorers.loading import in_process_subject, load
from allworlds.judging.episode import Answered, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.law_table import Case
from allworlds.outcome import Verdict
from allworlds.protocol.choices import Choices, policy_named
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import CheckRow
from allworlds.world import worlds
from certified_checker import (
    CHECKER,
    agreement,
    answered_by,
    checkers_agree,
    finished,
    not_lost,
    outcome,
)
from certified_folding import FOLDING, foldings_agree
from certified_shield import shields_agree

HERE = Path(__file__).resolve().parent
EXPLORER, JUDGE = HERE / "explorer", HERE / "judge"
RUNS = HERE / "runs"
POLICIES = ("fifo", "lifo", "nearest")
"""Those that the certified explorers know."""


@dataclass(frozen=True, slots=True)
class Pair:
    """A certified explorer and the built-in one that it is held against.

    Attributes:
        name: of the certified explorer.
        built_in: the name of the other.
        lighthouse, map_class: where both are right.
        engines: those that run the built-in one.
        more: how many levels further to go, where there are few places for the lighthouse.
    """

    name: str
    built_in: str
    lighthouse: str
    map_class: str
    engines: tuple[str, ...]
    more: int = 0


PAIRS = (
    Pair("directional", "algorithm1", "directional", "maps", ("python", "kernel")),
    Pair("cluster", "algorithm1-cluster", "cluster:single=true", "maps", ("python",)),
    Pair("natural", "algorithm1-natural", "natural", "simple", ("python",), more=2),
)


def explorers_agree(pair: Pair, edges: int, workers: int) -> bool:
    """Whether the certified explorer holds, and walks as far as the Python one in every row."""
    checked = partial(
        check,
        edges=edges + pair.more,
        map_class=pair.map_class,
        lighthouse=pair.lighthouse,
        workers=workers,
    )
    start = time.monotonic()
    certified = finished(checked(f"exec:{EXPLORER} fifo {pair.name}").uninterrupted())
    for finding in certified.findings:
        not_lost("the certified explorer", finding)
    seconds = time.monotonic() - start
    agree = certified.verdict in (Verdict.HOLDS, Verdict.VACUOUS)
    print(
        f"certified explorer, {pair.name} lighthouse: {certified.verdict.value}, "
        f"{certified.runs:,} runs, {seconds:.0f} s"
    )
    for engine in pair.engines:
        built_in = finished(checked(pair.built_in, engine=engine).uninterrupted())
        same = _rows(certified.rows) == _rows(built_in.rows)
        agree = agree and same
        print(f"  traversals equal the {engine} engine's in every row: {'yes' if same else 'NO'}")
    tried = certified.verdict is not Verdict.VACUOUS and certified.runs > 0
    return agreement(agree, tried, f"the check of {certified.explorer} is vacuous")


def transcripts_agree(pair: Pair, policy: str, edges: int) -> bool:
    """Whether the certified explorer walks as the built-in one in every run, and says the same."""
    certified = load(f"exec:{EXPLORER} {policy} {pair.name}")
    players = load(pair.built_in).player(), certified.player()
    runs, apart = 0, []
    with certified.running():
        for world in worlds(
            edges=edges + pair.more,
            map_class=pair.map_class,
            lighthouse=pair.lighthouse,
            places="all",
        ):
            budget = 8 * paper_bound(world.map.vertex_count, world.map.edge_count) + 100
            built_in, extracted = (
                play(world, player, Choices(policy_named(policy)), budget) for player in players
            )
            runs += 1
            not_lost("the certified explorer", extracted.ending)
            # Two that run into the budget alike do not agree: neither has said anything.
            if (
                not isinstance(built_in.ending, Answered)
                or built_in.ending != extracted.ending
                or built_in.transcript != extracted.transcript
            ):
                apart.append(world)
    print(f"  {policy}: {runs:,} transcripts and answers, {len(apart)} of them different")
    for world in apart[:3]:
        print(f"    {json.dumps(world.to_json())}")
    return agreement(not apart, runs > 0, "there is no run")


def _rows(rows: Sequence[CheckRow]) -> list[tuple[int, ...]]:
    kept = ("edges", "vertices", "worlds", "runs", "traversals", "traversals_rooted", "max_cost")
    return [tuple(getattr(row, key) for key in kept) for row in rows]


def judges_agree(edges: int) -> bool:
    """Whether the certified judge gives the Python judge's verdict on every answer."""
    cases = list(_cases(edges))
    lines = [
        json.dumps(
            {
                "world": case.map.to_json(),
                "estimate": {**case.estimate.map.to_json(), "here": case.estimate.here},
                "end": case.walk.here,
            }
        )
        + "\n"
        for _, case in cases
    ]
    verdicts = [json.loads(line)["verdict"] for line in answered_by(JUDGE, lines)]
    told: Counter[str] = Counter(verdicts)
    wrong = [
        (name, case, verdict)
        for (name, case), verdict in zip(cases, verdicts, strict=True)
        if verdict != case.answer
    ]
    summary = ", ".join(f"{verdict} {count:,}" for verdict, count in sorted(told.items()))
    print(f"certified judge: {len(cases):,} answers ({summary}), {len(wrong)} disagreements")
    for name, case, verdict in wrong[:3]:
        print(f"  {name}: certified {verdict}, Python {case.answer}: {case.map.to_json()}")
    tried = set(told) == {"right", "pose", "map"}
    return agreement(not wrong, tried, "one of the three verdicts did not come up")


def _cases(edges: int) -> Iterator[tuple[str, Case]]:
    """Every answer of every explorer, with the world and the walk it belongs to."""
    everyone = (WrongExplorer(Algorithm1), *WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS)
    players = [(mutant.name, in_process_subject(mutant.explorer()).player()) for mutant in everyone]
    for world in worlds(edges=edges):
        budget = 8 * paper_bound(world.map.vertex_count, world.map.edge_count) + 100
        for name, player in players:
            episode = play(world, player, Choices(), budget)
            if isinstance(episode.ending, Answered):
                yield (
                    name,
                    Case(episode.walk, episode.checkpoints, episode.ending.answer),
                )


def missing() -> list[Path]:
    """The programs that are not there; each is named on stderr."""
    programs = [p for p in (EXPLORER, JUDGE, CHECKER, FOLDING, RUNS) if not p.exists()]
    for program in programs:
        print(f"{program} is missing: make -C proofs/coq explorer", file=sys.stderr)
    return programs


def main() -> int:
    """Compare."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--edges", type=int, default=4, help="for the explorers' costs")
    parser.add_argument("--walked-edges", type=int, default=3, help="for their transcripts")
    parser.add_argument("--judged-edges", type=int, default=3, help="for the judge")
    parser.add_argument("--checked-edges", type=int, default=3, help="for the checker")
    parser.add_argument("--folded-edges", type=int, default=3, help="for the folding")
    parser.add_argument("--shielded-edges", type=int, default=3, help="for the shield")
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()
    if missing():
        return 2
    comparisons: list[Callable[[], bool]] = []
    for pair in PAIRS:
        comparisons.append(partial(explorers_agree, pair, options.edges, options.workers))
        comparisons += [
            partial(transcripts_agree, pair, policy, options.walked_edges) for policy in POLICIES
        ]
    return outcome(
        *comparisons,
        partial(judges_agree, options.judged_edges),
        partial(checkers_agree, options.checked_edges),
        partial(foldings_agree, options.folded_edges),
        partial(shields_agree, options.shielded_edges),
    )


if __name__ == "__main__":
    sys.exit(main())
