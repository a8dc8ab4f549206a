"""Of every claim a mutation under which it must fail; ``test_claim_mutants.py`` runs the table.

A mutation changes the program that the claim looks at, or makes a false cousin of its sentence
(of a sentence that must be refuted, a true one).
"""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import algorithm
import beyond
import complexity
import correctness
import measured
import passes
import position
import readings
import two_vertices
import worlds_and_motions
from allworlds import CombinatorialMap, Move, World, ambiguity, check, worlds
from allworlds.claims import Algorithm1
from allworlds.corpus import explorers as wrong
from allworlds.documents.document import replace
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.maps import named_map, rooted_code
from allworlds.protocol.choices import Choices
from allworlds.studies.ambiguity import formulas
from allworlds.studies.worst.every_schedule import EverySchedule
from allworlds.world import Compass
from formulas import paper_bound
from paper_claims import (
    BY_NAME,
    Mutant,
    algorithm1_is,
    checked,
    damaged,
    exchanged,
    half,
    lingering,
    lit,
    longer_retracing,
    mirrored,
    runs,
    unproved,
    without_an_assertion,
)

PRUDENT = Path(__file__).parents[2] / "lower_bounds" / "explorers.py:prudent"

# ---------------------------------------------------------------- explorers that are wrong


class RetracesTwice(Algorithm1):
    """Line 15: having undone the motions, it walks there and back once more."""

    def retrace(self, motions: list[int]) -> Any:
        yield from super().retrace(motions)
        for _ in range(2 * len(motions)):
            yield Move(0)


class WatchedRetracesTwice(passes.Watched, RetracesTwice):
    """``RetracesTwice`` with its passes watched."""


class WatchedWasteful(passes.Watched):
    """Goes back and forth once more in its first pass."""

    def follow(self, goal: int) -> Any:
        percept = yield from super().follow(goal)
        if len(self.begun) == 1:
            yield Move(0)
            percept = yield Move(0)
        return percept


class WatchedLingering(passes.Watched):
    """Goes back and forth many times in each pass."""

    def follow(self, goal: int) -> Any:
        percept = yield from super().follow(goal)
        for _ in range(10 * len(self.s.sigma)):
            percept = yield Move(0)
        return percept


class WatchedDoubting(passes.Watched):
    """Counts every hypothesis five times."""

    def hypotheses(self, goal: int, percept: Any) -> list[int]:
        told = super().hypotheses(goal, percept)
        self.begun[-1].hypotheses *= 5
        return told


class WatchedForgetful(passes.Watched):
    """Takes the other end of a loop for a vertex that is new."""

    def hypotheses(self, goal: int, percept: Any) -> list[int]:
        vertex = self.s.vertex
        told = super().hypotheses(goal, percept)
        return [d for d in told if vertex[d] != vertex[goal] or vertex[d] == 0]


class BeginsWithLess(Algorithm1):
    """Line 1: U has one edge of v0 only."""

    def __init__(self, first: Any, choices: Choices) -> None:
        super().__init__(replace(first, degree=1, bearing=0), choices)


# ---------------------------------------------------------------- searches that are wrong


def bearing_ignored(self: Any, dart: int) -> tuple[int, None]:
    """The percept without its direction."""
    return self._map.degree_at[dart], None


def a_step_less(self: Any) -> int:
    """The cheapest schedule, the step to its last vertex not counted."""
    return int(self._best(frozenset(), self._v0)) - 1


right_rows, right_paths = algorithm.worst_rows, algorithm._simple_paths
right_parts, right_map_of = measured.parts_of_gap, measured.map_of
LIMITS = BY_NAME["gap-parts"].quick.bounds["percent"]


def beyond_v0(map_: CombinatorialMap, explored: Any, *rest: Any) -> Any:
    """Simple paths to v0, and behind each of them an edge of v0, out and back."""
    for path in right_paths(map_, explored, *rest):
        yield path
        doors = [dart for dart in map_.vertices[0] if dart in explored]
        yield from ((*path, dart, map_.alpha[dart]) for dart in doors)


def less_walk(world: World, met: Any) -> tuple[int, ...]:
    """The parts of the gap, with the walks to known ends a traversal less."""
    *others, walks = right_parts(world, met)
    return *others, walks - 1


def cycles_for_k6(text: str, **asked: Any) -> CombinatorialMap:
    """The graphs of a family, but cycles in the place of the smallest dense ones."""
    return right_map_of("cycle:9") if text == "dense:6" else right_map_of(text, **asked)


def a_quarter(means: Any, edges: int) -> Any:
    """The rows of the exact search with a quarter of the cost."""
    return SimpleNamespace(
        rows=[
            SimpleNamespace(edges=r.edges, vertices=r.vertices, worst=r.worst // 4, world=r.world)
            for r in right_rows(means, edges).rows
        ]
    )


right_pair_formula, right_search, right_compare = (
    formulas.pair_formula,
    ambiguity.search,
    complexity.compare,
)


def contradictory(*asked: Any) -> Any:
    """The formula of a pair with a contradiction in it."""
    formula, pair = right_pair_formula(*asked)
    formula.add(1)
    formula.add(-1)
    return formula, pair


def contradictory_if_directional(question: Any, sizes: Any) -> Any:
    """The wrong formula of a question with a direction, the right one of any other."""
    asked = contradictory if question.sensing.bearing else right_pair_formula
    return asked(question, sizes)


def in_section(write: Any) -> Any:
    """A function like ``write`` that adds a contradiction if worlds have directions."""

    def wrong(formula: Any, *asked: Any) -> Any:
        written = write(formula, *asked)
        if any(block.name.startswith("pointed") for block in formula.blocks):
            formula.add(1)
            formula.add(-1)
        return written

    return wrong


def given(**options: str) -> Any:
    """``worlds`` with these options, whatever else was asked for."""
    return lambda **asked: worlds(**{**asked, **options})


# ---------------------------------------------------------------- maps that are wrong

right_turn, right_marked, right_north = CombinatorialMap.turn, position.marked, position._north


def turned_over(name: str) -> CombinatorialMap:
    """The named map, at the right graph of Fig. 1 with one vertex turned over."""
    map_ = named_map(name)
    if name != "fig1-right":
        return map_
    sigma = list(map_.sigma)
    vertex = next(v for v in map_.vertices if len(v) >= 3 and 0 not in v)
    for dart, previous in zip(vertex, (vertex[-1], *vertex[:-1]), strict=True):
        sigma[dart] = previous
    return CombinatorialMap(sigma, map_.alpha)


def one_reversed(n: int) -> World:
    """A cycle with directions, one of which points back."""
    north = right_north(n)
    first, *others = north.lighthouse.darts
    return World(north.map, Compass(tuple(sorted((north.map.sigma[first], *others)))))


def undirected(map_: CombinatorialMap, _kind: str, dart: int, start: int) -> World:
    """A marked world, its direction left out."""
    return right_marked(map_, "position", dart, start)


def one_world_twice(_name: str) -> tuple[World, World]:
    """A pair that is none."""
    world = World(named_map("two-loops-plane"), "position")
    return world, world


def less(n: int, m: int) -> int:
    """(1)+(2), a traversal less."""
    return paper_bound(n, m) - 1


ONE_POLICY = {"edges": 3, "policies": ["fifo"]}

beyond_of_power, own_sensor, side_by_side = beyond.of_power, beyond.own, beyond.sensors


def primitive_by_halves(word: str) -> bool:
    """Whether it is not blank, and no square."""
    half_of = len(word) // 2
    return word != word[:half_of] * 2 and set(word) != {"0"}


def without_blanks(word: str) -> bool:
    """Whether it is no power, or blank."""
    return set(word) == {"0"} or not any(
        word == word[:p] * (len(word) // p) for p in range(1, len(word))
    )


def in_place_of(**others: str) -> Any:
    """``sensors`` with other lighthouses in place of some."""
    return lambda *names, **asked: side_by_side(*(others.get(n, n) for n in names), **asked)


MUTANTS = (
    # II
    Mutant("motions-undone", "turning back is turning on",
           ((CombinatorialMap, "turn", lambda self, d, k=1: right_turn(self, d, abs(k))),),
           {"edges": 2, "length": 2}),
    Mutant("orders-are-shifts", "from every other dart the edges come anticlockwise",
           ((CombinatorialMap, "turn",
             lambda self, d, k=1: right_turn(self, d, -k if d % 2 else k)),), {"edges": 2}),
    Mutant("marker-tells-entry", "the direction is not sensed",
           ((worlds_and_motions, "World", lit(directional="position")),),
           {"edges": 2}),
    Mutant("marker-tells-entry", "a plain marker has a direction",
           ((worlds_and_motions, "World", lit(position="directional")),), {"edges": 2}),
    # III
    Mutant("cycles", "a marker is sensed",
           ((position, "World", lit(none="position")),), {"length": 5}),
    Mutant("two-door-rooms", "a marker is sensed", ((position, "World", lit(none="position")),),
           {"length": 5}),
    Mutant("fig1", "one vertex of the right graph is turned over",
           ((position, "named_map", turned_over),)),
    Mutant("fig1-different", "one graph twice",
           ((position, "FIGURE_1", ("fig1-left", "fig1-left")),)),
    Mutant("fig1-caption", "motions that the caption does not name",
           ((position, "CAPTION", (1, 1, 2, 1, 1)),)),
    Mutant("position-tells-cycles", "the marker is not sensed",
           ((position, "World", lit(position="none")),),
           {"length": 5}),
    Mutant("position-not-enough", "the pair is one world twice",
           ((position, "pair_of_corpus", one_world_twice),)),
    Mutant("orientation-alone", "one direction points back", ((position, "_north", one_reversed),),
           {"length": 5}),
    Mutant("elsewhere", "nobody looks for v0",
           ((position, "check", lambda _, **asked: check("algorithm1", **asked)),), {"edges": 2}),
    Mutant("movable-marker", "the answer is mirrored",
           ((position, "check", checked(mirrored("dudek91"))),), {"edges": 6}),
    Mutant("movable-marker-multigraphs", "worlds are simple",
           ((position, "check",
             lambda name, **asked: check(name, map_class="simple", **asked)),)),
    # IV
    Mutant("lighthouse-suffices", "the pose is forgotten",
           ((algorithm, "check", algorithm1_is(wrong.PoseLost)),), {"edges": 3}),
    Mutant("every-schedule", "the pose is forgotten",
           ((algorithm, "check", algorithm1_is(wrong.PoseLost)),),
           {"edges": 2, "most_expensive": 2}),
    Mutant("every-schedule", "longer retracing",
           ((algorithm, "run", runs(RetracesTwice)),), slow=True),
    Mutant("three-cases", "a test that matches at its first step is believed",
           ((algorithm, "check", algorithm1_is(wrong.ConfirmedTooEarly)),),
           {"edges": 4}, slow=True),
    Mutant("signature-readings", "the direction is not compared at v0",
           ((readings.WithoutDirection, "agrees", lambda *_: True),),
           {"edges": 2, "policies": ["fifo"]}),
    Mutant("marker-on-the-way", "paths go on from v0, out and back",
           ((algorithm, "_simple_paths", beyond_v0),), {"edges": 3}),
    Mutant("tests-decide", "the direction is not compared",
           ((EverySchedule, "_sensed", bearing_ignored),), {"edges": 3}),
    Mutant("not-both", "the direction is not sensed",
           ((algorithm, "World", lit(directional="position")),),
           {"edges": 4}),
    Mutant("direction-needed", "the direction is not sensed",
           ((algorithm, "marked", undirected),)),
    Mutant("no-twins-with-direction", "the direction is not sensed",
           ((algorithm, "worlds", given(lighthouse="position")),), {"edges": 2}),
    Mutant("no-twins-smt", "each formula has a contradiction",
           ((formulas, "pair_formula", contradictory),)),
    Mutant("no-twins-smt", "a contradiction where there is a direction, at the end",
           ((formulas, "pair_formula", contradictory_if_directional),)),
    Mutant("no-twins-smt", "a contradiction where there is a direction, in 'alike'",
           ((formulas, "_sense_the_same", in_section(formulas._sense_the_same)),)),
    Mutant("no-twins-smt", "a contradiction where there is a direction, in 'different'",
           ((formulas, "_smaller_code", in_section(formulas._smaller_code)),)),
    Mutant("no-twins-smt", "a contradiction where there is a direction, in one world",
           ((formulas, "_reference_darts", in_section(formulas._reference_darts)),)),
    Mutant("no-twins-smt", "the direction is not sensed",
           ((ambiguity, "search",
             lambda **asked: right_search(**{**asked, "lighthouse": "position"})),)),
    # V
    Mutant("invariant-at-start", "U begins with one edge",
           ((correctness, "Algorithm1", BeginsWithLess),), {"edges": 2}),
    Mutant("invariant-kept", "the partner stays in U",
           ((correctness, "check", algorithm1_is(wrong.PartnerShownInU)),), {"edges": 2}),
    Mutant("augmentations", "the partner stays in U",
           ((correctness, "run", runs(wrong.PartnerShownInU)),), {"edges": 2}),
    Mutant("variant-falls", "each S is shown twice",
           ((correctness, "check", algorithm1_is(wrong.PassWithoutProgress)),), {"edges": 2}),
    Mutant("empty-U", "the partner stays in U",
           ((correctness, "run", runs(wrong.PartnerShownInU)),), {"edges": 2}),
    Mutant("edge-index", "one map with two roots has two codes",
           ((correctness, "unrooted_code", lambda map_: rooted_code(map_.sigma, map_.alpha, 0)),),
           {"edges": 2}),
    # VI
    Mutant("every-edge-walked", "a step is not counted",
           ((EverySchedule, "best", property(a_step_less)),), {"edges": 2}),
    Mutant("every-edge-walked", "the direction is not compared",
           ((EverySchedule, "_sensed", bearing_ignored),), {"edges": 3}),
    Mutant("dfs-2m", "lingers at its last edge",
           ((complexity, "check", checked(lingering(BUILT_IN["dfs"].explore))),), {"edges": 2}),
    Mutant("lower-bound-2m", "the most expensive schedule in place of the cheapest",
           ((EverySchedule, "best", property(lambda self: 2 * self._map.edge_count)),)),
    Mutant("pass-walk", "one pass goes back and forth", ((passes, "Watched", WatchedWasteful),),
           ONE_POLICY),
    Mutant("pass-tests", "longer retracing", ((passes, "Watched", WatchedRetracesTwice),),
           {"edges": 4, "policies": ["fifo"]}),
    Mutant("pass-hypotheses", "more hypotheses", ((passes, "Watched", WatchedDoubting),),
           ONE_POLICY),
    Mutant("pass-cost", "one pass goes back and forth", ((passes, "Watched", WatchedWasteful),),
           ONE_POLICY),
    Mutant("pass-cost-all-schedules", "longer retracing",
           ((EverySchedule, "_tests", longer_retracing),)),
    Mutant("pass-cost-all-schedules", "the direction is not compared",
           ((EverySchedule, "_sensed", bearing_ignored),), {"edges": 3}),
    Mutant("pass-kinds", "a loop is taken for a new vertex",
           ((passes, "Watched", WatchedForgetful),), ONE_POLICY),
    Mutant("vertices-first", "a bound that is less", ((complexity, "paper_bound", less),),
           {"edges": 3}),
    Mutant("bound", "a bound that is less", ((complexity, "paper_bound", less),), {"edges": 3}),
    Mutant("bound-polynomial", "a bound that is less", ((complexity, "paper_bound", less),)),
    Mutant("printed-3", "nothing is left out of (3)",
           ((complexity, "printed_bound", paper_bound),)),
    Mutant("terms-left-out", "a coefficient of 5mn that is 4",
           ((complexity, "polynomial",
             lambda n, m: complexity.Fraction(paper_bound(n, m) - m * n)),),
           {"edges": 3}),
    Mutant("printed-limit-of-2", "runs that cost a quarter",
           ((complexity, "worst_rows", a_quarter),)),
    Mutant("bound-order", "a bound of another order",
           ((complexity, "paper_bound", lambda n, m: m**3 * n),)),
    Mutant("order-reached", "an explorer that does not test on long ways",
           ((complexity, "compare",
             lambda _, **asked: right_compare(str(PRUDENT), **asked)),)),
    # VII
    Mutant("below-bound", "goes back and forth in each pass",
           ((passes, "Watched", WatchedLingering),),
           {"families": ["lattice:3x3"], "seeds": 1, "share": 0.25}),
    Mutant("gap-parts", "half of the gap is shorter walks",
           changed={"percent": {**LIMITS, "walks to ends": [50, 100]}}),
    Mutant("gap-parts", "a walk is charged once too often",
           ((measured, "parts_of_gap", less_walk),)),
    Mutant("means-above-2m", "the line is 4m", changed={"times": 4}),
    Mutant("means-above-2m", "a cycle among the graphs", ((measured, "map_of", cycles_for_k6),)),
    # VIII
    Mutant("cluster", "the answer is mirrored",
           ((two_vertices, "check", checked(mirrored("algorithm1-cluster"))),)),
    Mutant("cluster-multigraphs", "one edge joins v0 and v1",
           ((two_vertices, "worlds", given(lighthouse="cluster:single=true")),)),
    Mutant("natural", "the answer is mirrored",
           ((two_vertices, "check", checked(mirrored("algorithm1-natural"))),)),
    Mutant("natural", "the answer of the explorer in Python is mirrored",
           ((two_vertices, "check",
             lambda name, *, engine, **asked: (
                 checked(mirrored(name)) if engine == "python" else check)(name, **asked)),)),
    Mutant("natural-multigraphs", "worlds are simple",
           ((two_vertices, "worlds", given(map_class="simple")),)),
    Mutant("two-vertices-order", "a bound of another order",
           ((two_vertices, "two_vertices_bound", lambda n, m, _: 5 * m * m * n),)),
    # beyond the paper
    Mutant("primitive-words", "a power of three is taken for primitive",
           ((beyond, "suffices", primitive_by_halves),), {"degree": 3, "edges": 3},
           slow=True),
    Mutant("primitive-words", "a blank word is taken to suffice",
           ((beyond, "suffices", without_blanks),), {"degree": 1, "edges": 4}),
    Mutant("powers-have-twins", "one vertex is joined to itself in both",
           ((beyond, "of_power", lambda k, p, joined: beyond_of_power(k, p, joined=False)),),
           {"powers": [[2, 1]]}),
    Mutant("door-suffices", "every door but the marked one is sensed",
           ((beyond, "sensors", in_place_of(door="word:01*")),), {"edges": 4}),
    Mutant("directional-not-minimal", "the whole vertex is sensed in place of the door",
           ((beyond, "sensors", in_place_of(door="word:1")),), {"edges": 2}),
    Mutant("door-minimal", "twins of the degree are larger",
           (), {"edges": 2, "degrees": [2]}, changed={"degrees": [2, 3]}),
    Mutant("weakest-sensors", "vertices are sensed, and no doors",
           ((beyond, "own", lambda _: own_sensor("Rooms")),), {"edges": 3}),
    # certificates and proofs
    Mutant("cert-fig1", "two numbers of a bisimulation have changed places",
           damage=damaged("fig1/pairs.json", exchanged), slow=True),
    Mutant("cert-cycles", "an assertion is missing",
           damage=damaged("cycles/2-sigma.smt2", without_an_assertion)),
    Mutant("cert-no-twins-directional", "half a proof",
           damage=damaged("no-twins-directional/m2.lrat.xz", half), slow=True),
    Mutant("cert-natural-lighthouse", "two numbers of a bisimulation have changed places",
           damage=damaged("natural-lighthouse/pair.json", exchanged)),
    *unproved(),
)  # fmt: skip
