"""Of every claim a mutation under which it must fail; ``test_claim_mutants.py`` runs the table.

A mutation changes the program that the claim looks at, or makes a false cousin of its sentence
(of a sentence that must be refuted, a true one).
"""

from __future__ import annotations

from collections.abc import Iterator
from math import factorial
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

import explorers
import logs
import lookalikes
import optima
import testers
import twins_and_markers
from allworlds import CombinatorialMap, World, ambiguity
from allworlds.corpus import explorers as wrong
from allworlds.documents.document import replace
from allworlds.maps import families, family, named_map
from allworlds.maps.quotient import pose_count
from allworlds.studies.worst.every_schedule import EverySchedule
from enumerators import map_doubled, mirror_images_merged
from minimax import StrategyLeaf
from paper_claims import (
    Mutant,
    algorithm1_is,
    checked,
    damaged,
    half,
    lingering,
    lit,
    longer_retracing,
    mirrored,
    runs,
    unproved,
)

# ---------------------------------------------------------------- searches that are wrong

right_census, right_class_of = ambiguity.census, ambiguity.class_of
right_minimax, right_fewest = optima.minimax, optima.fewest_traversals


def census_of(map_class: str, edges: int) -> Any:
    """The census of this class, whichever was asked for."""
    return lambda **_asked: right_census(edges=edges, map_class=map_class)


def one_more(*asked: Any) -> int:
    """The optimum and a traversal more."""
    return right_fewest(*asked) + 1


def one_less(*asked: Any) -> Any:
    """What minimax finds, but a traversal less."""
    solved = right_minimax(*asked)
    return replace(solved, traversals=solved.traversals - 1)


def answers_mirrored(*asked: Any) -> Any:
    """What minimax finds, with a strategy that answers with mirror images."""
    solved = right_minimax(*asked)
    nodes = tuple(
        node._replace(answer=replace(node.answer, map=node.answer.map.mirrored()))
        if isinstance(node, StrategyLeaf)
        else node
        for node in solved.strategy.nodes
    )
    return replace(solved, strategy=solved.strategy._replace(nodes=nodes))


def a_member_less(world: World) -> Any:
    """The class of the world without its last member."""
    made = right_class_of(world)
    return SimpleNamespace(worlds=made.worlds[:-1], size=made.size)


def poses_without_symmetries(world: World) -> Any:
    """The class of the world, its poses that differ by a symmetry counted once."""
    return SimpleNamespace(poses=right_class_of(world).size)


def said_before(quotient: Any) -> bool:
    """The sentence without its exception."""
    turned = quotient.semi_edges or any(b > 1 for b in quotient.cone_indices[1:])
    return quotient.sheets >= 2 and bool(quotient.beta1 or turned)


def featureless(_labelled: Any) -> Any:
    """One quotient for every world."""
    return SimpleNamespace(quotient=SimpleNamespace(sigma=0, alpha=0, degree=0))


def shorter(vertices: int, length: int) -> CombinatorialMap:
    """The world of the claim with a quarter of the path."""
    return right_path(vertices, length // 4 or 1)


right_path, right_choices = logs.complete_behind_a_path, lookalikes._choices

# ---------------------------------------------------------------- corridors

right_against, right_corridors, right_walk = testers.against, testers._corridors, testers._walked


def excluding_none(*asked: Any) -> Any:
    """A play against an adversary that had to exclude no pair: one of no tester."""
    return right_against(*asked)._replace(deciding=SimpleNamespace(excluded=0))


def not_apart(_text: str, *, seed: int) -> CombinatorialMap:
    """A corridor in which two out-darts lie side by side, as the in-darts do."""
    with patch.object(families, "out_darts", lambda kind: (-4 * kind, -4 * kind - 1)):
        return family("corridor:1", seed=seed)


def first_twice(skeleton: Any) -> Iterator[World]:
    """The corridors without the last one, and the first one once more."""
    every = [*right_corridors(skeleton)]
    yield from [*every[:-1], every[0]] if len(skeleton.free) == 6 else every


def timeless(name: str, world: World) -> Any:
    """A walk whose far returns all have the same time."""
    sensed, far = right_walk(name, world)
    return sensed, tuple((0, bearing) for _, bearing in far)


MUTANTS = (
    # Lower bounds
    Mutant("exact-worst", "longer retracing", ((EverySchedule, "_tests", longer_retracing),)),
    Mutant("optimum", "a traversal more in each row", ((optima, "fewest_traversals", one_more),),
           {"edges": 2}),
    Mutant("optimum", "a traversal less than the strategy needs", ((optima, "minimax", one_less),),
           {"edges": 2}),
    Mutant("optimum", "a strategy that answers wrongly", ((optima, "minimax", answers_mirrored),),
           {"edges": 3}),
    Mutant("order-exact", "said of an explorer for which no pair must be excluded",
           ((testers, "against", excluding_none),)),
    Mutant("order-exact", "a bound that is not (1)+(2)",
           ((testers, "paper_bound", lambda n, m: m * n),)),
    Mutant("order-exact", "the motions from out-darts to in-darts are not all different",
           ((testers, "family", not_apart),)),
    Mutant("every-explorer-mn-log", "one world comes twice, and another one is missing",
           ((testers, "_corridors", first_twice),)),
    Mutant("every-explorer-mn-log", "returns are told without their times",
           ((testers, "_walked", timeless),)),
    Mutant("bouquet-minimax", "a traversal more in each row",
           ((optima, "fewest_traversals", one_more),), {"loops": 3}),
    Mutant("bouquet-minimax", "counting that promises too much",
           ((optima, "bound_of_information", lambda worlds: worlds),), {"loops": 3}),
    # Explorers that never forget
    Mutant("remembering-never-more", "said of greedy", changed={"one": "greedy"}),
    Mutant("greedy-never-more", "said of remembering", changed={"one": "remembering"}),
    Mutant("never-forgetting-in-bound", "lingers at its last edge",
           ((optima, "check", checked(lingering(explorers.greedy))),),
           {"edges": 2, "explorers": ["greedy"]}),
    # What a log says
    Mutant("logs-fold", "guesses the last edge",
           ((logs, "check", algorithm1_is(wrong.LuckyGuess)),), {"edges": 3}),
    Mutant("folding-explores", "the answer is mirrored",
           ((logs, "check", checked(mirrored("folding-oldest"))),)),
    Mutant("open-before-the-end", "no dart of a folded log is open",
           ((logs, "_open_darts", lambda _: False),), {"edges": 2}),
    Mutant("entries-of-v0", "guesses the last edge",
           ((logs, "run_here", runs(wrong.LuckyGuess)),),
           {"edges": 2, "explorers": ["algorithm1"]}),
    Mutant("path-lower-bound", "a path that is shorter",
           ((logs, "complete_behind_a_path", shorter),)),
    # Worlds that look alike
    *(
        Mutant(claim, "the smallest worlds are sought in another class",
               ((ambiguity, "census", census_of("planar-simple", 8)),), slow=True)
        for claim in ("smallest-twins", "smallest-simple-twins")
    ),
    Mutant("smallest-planar-simple-twins", "the worlds need not be planar",
           ((ambiguity, "census", census_of("simple", 6)),), slow=True),
    Mutant("criterion", "the sentence without its exception at k = 2",
           ((lookalikes, "_said", said_before),)),
    Mutant("criterion", "the program without its exception",
           ((lookalikes, "is_ambiguous", said_before),)),
    Mutant("class-sizes", "worlds that differ by their pose are counted apart",
           ((lookalikes, "class_size", pose_count),)),
    Mutant("mass-formula", "poses that differ by a symmetry are counted once",
           ((ambiguity, "class_of", poses_without_symmetries),)),
    Mutant("mass-formula", "the formula without k!",
           ((lookalikes, "_choices",
             lambda q: right_choices(q) // factorial(q.sheets) ** q.beta1),)),
    Mutant("two-sheets", "a member is missing", ((ambiguity, "class_of", a_member_less),)),
    Mutant("lookalikes-one-size", "the marker is not sensed",
           ((lookalikes, "World", lit(position="none")),), {"edges": 2}),
    Mutant("counts", "of a map and its mirror image one comes",
           ((lookalikes, "rooted_maps", mirror_images_merged),), {"edges": 3}),
    Mutant("counts", "one map comes twice", ((lookalikes, "rooted_maps", map_doubled),),
           {"edges": 3}),
    # Less than a direction
    Mutant("cycle-needs-information", "a marker is sensed",
           ((twins_and_markers, "World", lit(none="position")),), {"edges": 2}),
    Mutant("trees-need-none", "degrees are not sensed",
           ((twins_and_markers, "project", featureless),), {"edges": 2}),
    Mutant("markers-at-one-vertex", "the two worlds are one",
           ((twins_and_markers, "named_map", lambda _: named_map("two-loops-plane")),),
           {"markers": 1, "actions": 2}),
    Mutant("position-robot", "doubts for no reason",
           ((twins_and_markers, "check", checked(wrong.WRONG_LEARNERS[0].explorer())),),
           {"edges": 2}),
    # Proofs for every size
    Mutant("cert-smallest-pairs", "half a proof",
           damage=damaged("smallest-pairs/planar-simple-m2.lrat.xz", half), slow=True),
    *unproved(),
)  # fmt: skip
