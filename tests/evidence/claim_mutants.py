"""Of every claim a mutation, under which it must fail.

A mutation changes the program that the claim looks at, or makes a false cousin of its sentence
(of a sentence that must be refuted, a true one).  ``test_claim_mutants.py`` runs the table.
"""

from __future__ import annotations

import json
import lzma
import re
import shutil
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from math import factorial
from pathlib import Path
from random import Random
from types import SimpleNamespace
from typing import Any

from allworlds.evidence.claims import (
    algorithm,
    ambiguous,
    complexity,
    correctness,
    corridors,
    folds,
    lighthouses,
    limits,
    machine,
    model,
    passes,
    position,
)
from allworlds.evidence.claims.claim_types import Means
from allworlds.evidence.claims.manifest import manifest

from allworlds import Estimate
from allworlds.corpus import explorers as wrong
from allworlds.document import replace
from allworlds.explorers import BUILT_IN, Algorithm1
from allworlds.judging import paper_bound
from allworlds.maps import CombinatorialMap, CorridorShape, named_map, rooted_code
from allworlds.maps.corridor import corridor_skeleton
from allworlds.protocol import Choices, Move
from allworlds.studies.ambiguity import class_of, search
from allworlds.studies.ambiguity.smt import pair, twin_search
from allworlds.studies.check import check
from allworlds.studies.run import run
from allworlds.studies.worst import EverySchedule
from allworlds.world import Compass, Directional, Nothing, Position, World, worlds
from enumerators import map_doubled, mirror_images_merged

PROOFS = Path(__file__).parents[2] / "proofs"


@dataclass(frozen=True)
class Mutant:
    """A change, and the scope in which the claim is then checked.

    Attributes:
        claim: its id.
        what: the fault, in words.
        patches: (module or class, name, replacement).
        bounds: of the scope in which it is checked; if left out, those of the quick scope.
        changed: bounds of the false cousin that differ from these.
        folder: makes the folder of proofs, right or damaged.
        slow: takes more than a few seconds.
    """

    claim: str
    what: str
    patches: tuple[tuple[object, str, Any], ...] = ()
    bounds: Mapping[str, Any] | None = None
    changed: Mapping[str, Any] = field(default_factory=dict)
    folder: Callable[[Path], None] | None = None
    slow: bool = False


# ---------------------------------------------------------------- explorers that are wrong


def mirrored(name: str) -> Callable[..., Any]:
    """The built-in explorer, with the mirror image of its map as its answer."""
    explore = BUILT_IN[name].explore

    def mirror(*args: Any, **keywords: Any) -> Any:
        right = yield from explore(*args, **keywords)
        return Estimate(right.map.mirrored(), right.here)

    def told_mirror(first: Any, *, told: int) -> Any:
        return (yield from mirror(first, told=told))

    def untold_mirror(first: Any) -> Any:
        return (yield from mirror(first))

    return told_mirror if name == "algorithm1-natural" else untold_mirror


def lingering(name: str) -> Callable[..., Any]:
    """The built-in explorer, which walks its last edge many times before it answers."""
    explore = BUILT_IN[name].explore

    def linger(first: Any) -> Any:
        right = yield from explore(first)
        for _ in range(20 * right.map.edge_count):
            yield Move(0)
        return right

    return linger


def checked(explore: Callable[..., Any], **options: Any) -> Callable[..., Any]:
    """``check`` of this explorer, whichever was asked for."""

    def check_instead(name: str, **asked: Any) -> Any:
        lighthouse = BUILT_IN[name].lighthouse
        asked = {"lighthouse": lighthouse, **asked, **options}
        asked.pop("engine", None)
        return check(explore, **asked)

    return check_instead


def algorithm1_is(kind: type[Algorithm1]) -> Callable[..., Any]:
    """``check`` of a wrong Algorithm 1."""
    return checked(wrong.WrongExplorer(kind).explorer())


def runs(kind: type[Algorithm1]) -> Callable[..., Any]:
    """``run`` of a wrong Algorithm 1."""
    explore = wrong.WrongExplorer(kind).explorer()
    return lambda _name, world, **asked: run(explore, world, **asked)


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
    """Goes back and forth a thousand times in each pass."""

    def follow(self, goal: int) -> Any:
        percept = yield from super().follow(goal)
        for _ in range(60 * len(self.s.sigma)):
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

right_tests = EverySchedule._tests


def bearing_ignored(self: Any, dart: int) -> tuple[int, None]:
    """The percept without its direction."""
    return self._map.degree_at[dart], None


def longer_retracing(self: Any, explored: Any, hypothesis: int, entry: int) -> Any:
    """Tests of false hypotheses that cost half as much again."""
    tests = right_tests(self, explored, hypothesis, entry)
    if hypothesis == entry:
        return tests
    return [replace(test, cost=test.cost * 3 // 2) for test in tests]


def a_step_less(self: Any) -> int:
    """The cheapest schedule, the step to its last vertex not counted."""
    return int(self._best(frozenset(), self._v0)) - 1


def a_quarter(means: Any, edges: int) -> Any:
    """The rows of the exact search with a quarter of the cost."""
    rows = algorithm.worst_rows(means, edges).rows
    return SimpleNamespace(
        rows=[
            SimpleNamespace(edges=r.edges, vertices=r.vertices, worst=r.worst // 4, world=r.world)
            for r in rows
        ]
    )


right_pair_formula = twin_search.pair_formula


def contradictory(*asked: Any) -> Any:
    """The formula of a pair with a contradiction in it."""
    formula, pair = right_pair_formula(*asked)
    formula.add(1)
    formula.add(-1)
    return formula, pair


def directional(wrong: Callable[..., Any], right: Callable[..., Any]) -> Callable[..., Any]:
    """The wrong formula of a question with a direction, the right one of any other."""
    return lambda question, sizes: (wrong if question.sensing.bearing else right)(question, sizes)


def in_section(write: Callable[..., Any]) -> Callable[..., Any]:
    """A function like ``write`` that adds a contradiction if worlds have directions."""

    def wrong(formula: Any, *asked: Any) -> Any:
        written = write(formula, *asked)
        if any(name.startswith("pointed") for name in formula.blocks):
            formula.add(1)
            formula.add(-1)
        return written

    return wrong


def marked_everywhere(lighthouse: str) -> Callable[..., Any]:
    """``worlds`` under another lighthouse."""
    return lambda **asked: worlds(**{**asked, "lighthouse": lighthouse})


right_census, right_compare, right_optimum = position.census, complexity.compare, limits.optimum


def excluding_none(name: str, adversary: Any) -> Any:
    """A run against an adversary that had to exclude no pair: one of no tester."""
    told = run(name, adversary)
    made = SimpleNamespace(cost=told.adversary.cost, same=told.adversary.same, excluded=0)
    return SimpleNamespace(adversary=made, finding=told.finding)


def one_more(**asked: Any) -> Any:
    """The optimum with a traversal more in each row."""
    report = right_optimum(**asked).uninterrupted()
    keys = ("edges", "runs", "information", "cautious")
    rows = [
        SimpleNamespace(optimum=row.optimum + 1, **{key: getattr(row, key) for key in keys})
        for row in report.rows
    ]
    wrong = SimpleNamespace(exit_code=report.exit_code, rows=rows)
    wrong.uninterrupted = lambda: wrong
    return wrong


right_corridors, right_walk = corridors._corridors, corridors._walked


def not_apart(_text: str, _holes: None, seed: int) -> CombinatorialMap:
    """A corridor in which two out-darts lie side by side, as the in-darts do."""
    outs = corridor_skeleton(CorridorShape(1, 18), Random(seed), lambda c: (-4 * c, -4 * c - 1))
    return outs.matched(list(zip(outs.free[::2], outs.free[1::2], strict=True)))


def first_twice(skeleton: Any) -> Iterator[World]:
    """The corridors without the last one, and the first one once more."""
    every = [*right_corridors(skeleton)]
    yield from [*every[:-1], every[0]] if len(skeleton.free) == 6 else every


def timeless(name: str, world: World) -> Any:
    """A walk whose far returns all have the same time."""
    sensed, far = right_walk(name, world)
    return sensed, tuple((0, bearing) for _, bearing in far)


# ---------------------------------------------------------------- maps and sentences that are wrong

right_turn = CombinatorialMap.turn


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


right_north = position._north


def nowhere(*_dart: int) -> Nothing:
    """No marker."""
    return Nothing()


def marked(*_dart: int) -> Position:
    """A marker at v0."""
    return Position(0)


def shorter(vertices: int, length: int) -> CombinatorialMap:
    """The world of the claim with half the path."""
    return right_path(vertices, length // 4 or 1)


right_path = folds.complete_behind_a_path


def said_before(quotient: Any) -> bool:
    """The sentence without its exception."""
    turned = quotient.semi_edges or any(b > 1 for b in quotient.cone_indices[1:])
    return quotient.sheets >= 2 and bool(quotient.beta1 or turned)


def a_member_less(world: World) -> Any:
    """The class of the world without its last member."""
    made = class_of(world)
    return SimpleNamespace(worlds=made.worlds[:-1], size=made.size)


def one_world_twice(_name: str) -> tuple[World, World]:
    """A pair that is none."""
    world = World(named_map("two-loops-plane"), Position(0))
    return world, world


def less(n: int, m: int) -> int:
    """(1)+(2), a traversal less."""
    return paper_bound(n, m) - 1


# ---------------------------------------------------------------- certificates and theorems


def damaged(name: str, damage: Callable[[bytes], bytes]) -> Callable[[Path], None]:
    """A folder of proofs in which one file says something else, and the manifest has its digest."""

    def damage_in(folder: Path) -> None:
        path = folder / name
        right = path.read_bytes()
        path.write_bytes(damage(right))
        assert path.read_bytes() != right
        known = json.loads((folder / "manifest.json").read_text())
        if name in known:
            known[name] = sha256(path.read_bytes()).hexdigest()
            (folder / "manifest.json").write_text(json.dumps(known))

    return damage_in


def copied(folder: Path) -> None:
    """The proofs as they are, but for those in Coq."""
    shutil.copytree(
        PROOFS, folder, ignore=shutil.ignore_patterns("coq", "__pycache__"), dirs_exist_ok=True
    )


def half(data: bytes) -> bytes:
    """A compressed text without its second half."""
    lines = lzma.decompress(data).splitlines(keepends=True)
    return lzma.compress(b"".join(lines[: len(lines) // 2]))


def exchanged(data: bytes) -> bytes:
    """A bisimulation in which two neighbouring numbers that differ have changed places."""
    before, key, classes = data.partition(b'"bisimulation"')
    return before + key + re.sub(rb"\b(\d+),(\s*)(?!\1\b)(\d+)\b", rb"\3,\2\1", classes, count=1)


def without_an_assertion(data: bytes) -> bytes:
    """A formula without its last assertion."""
    lines = data.splitlines(keepends=True)
    last = max(i for i, line in enumerate(lines) if line.startswith(b"(assert"))
    end = next(i for i in range(last + 1, len(lines)) if lines[i].startswith(b"("))
    return b"".join(lines[:last] + lines[end:])


Proved = dict[str, str]
"""By theorem what Coq prints that it rests on."""


def rests_on_an_axiom(name: str, proved: Proved) -> Proved:
    """The theorem says what it should, and rests on an axiom."""
    return {**proved, name: "Axioms:"}


def is_missing(name: str, proved: Proved) -> Proved:
    """There is no such theorem."""
    return {other: told for other, told in proved.items() if other != name}


WRONG_PROOFS = {
    "a theorem that rests on an axiom": rests_on_an_axiom,
    "a theorem that is missing": is_missing,
}
"""What may be wrong with a theorem, and how Coq's answer changes."""


def without(claim: str, what: str) -> Mutant:
    """The claim, with that wrong with its last theorem."""
    name = theorems(claim)["names"][-1]
    told = WRONG_PROOFS[what](name, as_claimed(Path()))
    return Mutant(claim, what, ((machine, "_assumptions", lambda _: told),))


def theorems(claim: str) -> dict[str, Any]:
    """The bounds of a claim that rests on Coq."""
    return next(c.quick.bounds for c in manifest() if c.id == claim)


def as_claimed(_sources: Path) -> Proved:
    """All theorems that the ledger names, proved."""
    claims = [claim for claim in manifest() if claim.id.startswith("coq-")]
    return {name: machine.CLOSED for claim in claims for name in claim.quick.bounds["names"]}


ONE_POLICY = {"edges": 3, "policies": ["fifo"]}

MUTANTS = (
    # II
    Mutant("motions-undone", "turning back is turning on",
           ((CombinatorialMap, "turn", lambda self, d, k=1: right_turn(self, d, abs(k))),),
           {"edges": 2, "length": 2}),
    Mutant("orders-are-shifts", "from every other dart the edges come anticlockwise",
           ((CombinatorialMap, "turn",
             lambda self, d, k=1: right_turn(self, d, -k if d % 2 else k)),), {"edges": 2}),
    Mutant("marker-tells-entry", "the direction is not sensed", ((model, "Directional", marked),),
           {"edges": 2}),
    Mutant("marker-tells-entry", "a plain marker has a direction",
           ((model, "Position", Directional),), {"edges": 2}),
    # III
    Mutant("cycles", "a marker is sensed", ((position, "Nothing", marked),), {"length": 5}),
    Mutant("two-door-rooms", "a marker is sensed", ((position, "Nothing", marked),),
           {"length": 5}),
    Mutant("fig1", "one vertex of the right graph is turned over",
           ((position, "named_map", turned_over),)),
    Mutant("fig1-different", "one graph twice",
           ((position, "FIGURE_1", ("fig1-left", "fig1-left")),)),
    Mutant("fig1-caption", "motions that the caption does not name",
           ((position, "CAPTION", (1, 1, 2, 1, 1)),)),
    Mutant("position-tells-cycles", "the marker is not sensed", ((position, "Position", nowhere),),
           {"length": 5}),
    Mutant("position-not-enough", "the pair is one world twice",
           ((position, "pair_of_corpus", one_world_twice),)),
    Mutant("orientation-alone", "one direction points back", ((position, "_north", one_reversed),),
           {"length": 5}),
    Mutant("movable-marker", "the answer is mirrored",
           ((position, "check", checked(mirrored("dudek91"))),), {"edges": 6}, slow=True),
    Mutant("movable-marker-multigraphs", "worlds are simple",
           ((position, "check",
             lambda name, **asked: check(name, map_class="simple", **asked)),), slow=True),
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
    Mutant("tests-decide", "the direction is not compared",
           ((EverySchedule, "_sensed", bearing_ignored),), {"edges": 3}, slow=True),
    Mutant("not-both", "the direction is not sensed", ((algorithm, "Directional", marked),),
           {"edges": 4}, slow=True),
    Mutant("direction-needed", "the direction is not sensed",
           ((algorithm, "Directional", Position),)),
    Mutant("no-twins-with-direction", "the direction is not sensed",
           ((algorithm, "worlds", marked_everywhere("position")),), {"edges": 2}),
    Mutant("no-twins-smt", "each formula has a contradiction",
           ((twin_search, "pair_formula", contradictory),), slow=True),
    Mutant("no-twins-smt", "a contradiction where there is a direction, at the end",
           ((twin_search, "pair_formula", directional(contradictory, right_pair_formula)),),
           slow=True),
    Mutant("no-twins-smt", "a contradiction where there is a direction, in 'alike'",
           ((pair, "_sense_the_same", in_section(pair._sense_the_same)),), slow=True),
    Mutant("no-twins-smt", "a contradiction where there is a direction, in 'different'",
           ((pair, "_smaller_code", in_section(pair._smaller_code)),), slow=True),
    Mutant("no-twins-smt", "a contradiction where there is a direction, in one world",
           ((pair, "_reference_darts", in_section(pair._reference_darts)),), slow=True),
    Mutant("no-twins-smt", "the direction is not sensed",
           ((algorithm, "search", lambda **asked: search(**{**asked, "lighthouse": "position"})),),
           slow=True),
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
           ((complexity, "check", checked(lingering("dfs"))),), {"edges": 2}),
    Mutant("lower-bound-2m", "the most expensive schedule in place of the cheapest",
           ((EverySchedule, "best", property(lambda self: 2 * self._map.edge_count)),)),
    Mutant("pass-walk", "one pass goes back and forth", ((passes, "Watched", WatchedWasteful),),
           ONE_POLICY),
    Mutant("pass-tests", "longer retracing", ((passes, "Watched", WatchedRetracesTwice),),
           {"edges": 4, "policies": ["fifo"]}, slow=True),
    Mutant("pass-hypotheses", "more hypotheses", ((passes, "Watched", WatchedDoubting),),
           ONE_POLICY),
    Mutant("pass-cost", "one pass goes back and forth", ((passes, "Watched", WatchedWasteful),),
           ONE_POLICY),
    Mutant("pass-cost-all-schedules", "longer retracing",
           ((EverySchedule, "_tests", longer_retracing),), slow=True),
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
           {"edges": 3}, slow=True),
    Mutant("printed-limit-of-2", "runs that cost a quarter",
           ((complexity, "worst_rows", a_quarter),)),
    Mutant("bound-order", "a bound of another order",
           ((complexity, "paper_bound", lambda n, m: m**3 * n),)),
    Mutant("order-reached", "an explorer that does not test on long ways",
           ((complexity, "compare",
             lambda _, **asked: right_compare("prudent", **asked)),), slow=True),
    Mutant("exact-worst", "longer retracing", ((EverySchedule, "_tests", longer_retracing),)),
    # VII
    Mutant("below-bound", "goes back and forth in each pass",
           ((passes, "Watched", WatchedLingering),),
           {"families": ["lattice:3x3"], "seeds": 1, "share": 0.25}),
    Mutant("transit-explains", "a share of half a per cent is an explanation",
           changed={"share": 0.005}, slow=True),
    # VIII
    Mutant("cluster", "the answer is mirrored",
           ((lighthouses, "check", checked(mirrored("algorithm1-cluster"))),), slow=True),
    Mutant("cluster-multigraphs", "one edge joins v0 and v1",
           ((lighthouses, "worlds", marked_everywhere("cluster:single=true")),)),
    Mutant("natural", "the answer is mirrored",
           ((lighthouses, "check", checked(mirrored("algorithm1-natural"))),), slow=True),
    Mutant("natural", "the answer of the explorer in Python is mirrored",
           ((lighthouses, "check",
             lambda name, *, engine, **asked: (
                 checked(mirrored(name)) if engine == "python" else check)(name, **asked)),),
           slow=True),
    Mutant("natural-multigraphs", "worlds are simple",
           ((lighthouses, "worlds", lambda **asked: worlds(**{**asked, "map_class": "simple"})),)),
    Mutant("two-vertices-order", "a bound of another order",
           ((lighthouses, "bound_named",
             lambda _: SimpleNamespace(value=lambda n, m, *_: 5 * m * m * n)),)),
    # ours
    *(
        Mutant(claim, "the smallest worlds are sought in another class",
               ((position, "census",
                 lambda *, edges, map_class, other=other: right_census(edges=8, map_class=other)),),
               slow=True)
        for claim, other in (
            ("smallest-twins", "planar-simple"),
            ("smallest-simple-twins", "planar-simple"),
        )
    ),
    Mutant("smallest-planar-simple-twins", "the worlds need not be planar",
           ((position, "census",
             lambda *, edges, map_class: right_census(edges=6, map_class="simple")),), slow=True),
    Mutant("cycle-needs-information", "a marker is sensed", ((position, "Nothing", marked),),
           {"edges": 2}),
    Mutant("trees-need-none", "degrees are not sensed",
           ((position, "project",
             lambda _: SimpleNamespace(quotient=SimpleNamespace(sigma=0, alpha=0, degree=0))),),
           {"edges": 2}),
    Mutant("markers-at-one-vertex", "the two worlds are one",
           ((position, "named_map", lambda _: named_map("two-loops-plane")),),
           {"markers": 1, "actions": 2}),
    Mutant("position-robot", "doubts for no reason",
           ((position, "check", checked(wrong.WRONG_LEARNERS[0].explorer())),), {"edges": 2}),
    Mutant("criterion", "the sentence without its exception at k = 2",
           ((ambiguous, "_said", said_before),)),
    Mutant("criterion", "the program without its exception",
           ((ambiguous, "is_ambiguous", said_before),)),
    Mutant("class-sizes", "worlds that differ by their pose are counted apart",
           ((ambiguous, "class_size", ambiguous.pose_count),)),
    Mutant("mass-formula", "poses that differ by a symmetry are counted once",
           ((ambiguous, "pose_count", ambiguous.class_size),)),
    Mutant("mass-formula", "the formula without k!",
           ((ambiguous, "_choices",
             lambda q, right=ambiguous._choices: right(q) // factorial(q.sheets) ** q.beta1),)),
    Mutant("two-sheets", "a member is missing", ((ambiguous, "class_of", a_member_less),)),
    Mutant("lookalikes-one-size", "the marker is not sensed",
           ((ambiguous, "Position", nowhere),), {"edges": 2}),
    Mutant("logs-fold", "guesses the last edge",
           ((folds, "check", algorithm1_is(wrong.LuckyGuess)),), {"edges": 3}),
    Mutant("folding-explores", "the answer is mirrored",
           ((folds, "check", checked(mirrored("folding-oldest"))),), slow=True),
    Mutant("open-before-the-end", "no dart of a folded log is open",
           ((folds, "fold", lambda _: SimpleNamespace(open_darts=0)),), {"edges": 2}),
    Mutant("entries-of-v0", "guesses the last edge",
           ((folds, "run", runs(wrong.LuckyGuess)),), {"edges": 2, "explorers": ["algorithm1"]}),
    Mutant("path-lower-bound", "a path that is shorter",
           ((folds, "complete_behind_a_path", shorter),)),
    Mutant("optimum", "a traversal more in each row", ((limits, "optimum", one_more),), slow=True),
    Mutant("order-exact", "said of an explorer for which no pair must be excluded",
           ((corridors, "run", excluding_none),)),
    Mutant("order-exact", "a bound that is not (1)+(2)",
           ((corridors, "paper_bound", lambda n, m: m * n),)),
    Mutant("order-exact", "the motions from out-darts to in-darts are not all different",
           ((corridors, "map_of_family", not_apart),)),
    Mutant("every-explorer-mn-log", "one world comes twice, and another one is missing",
           ((corridors, "_corridors", first_twice),)),
    Mutant("every-explorer-mn-log", "returns are told without their times",
           ((corridors, "_walked", timeless),)),
    Mutant("bouquet-minimax", "a traversal more in each row",
           ((corridors, "optimum", one_more),)),
    Mutant("remembering-never-more", "said of greedy", changed={"one": "greedy"}),
    Mutant("greedy-never-more", "said of remembering", changed={"one": "remembering"}),
    Mutant("never-forgetting-in-bound", "lingers at its last edge",
           ((limits, "check", checked(lingering("greedy"))),),
           {"edges": 2, "explorers": ["greedy"]}),
    Mutant("counts", "of a map and its mirror image one comes",
           ((ambiguous, "rooted_maps", lambda m, _: mirror_images_merged(m)),), {"edges": 3}),
    Mutant("counts", "one map comes twice",
           ((ambiguous, "rooted_maps", lambda m, _: map_doubled(m)),), {"edges": 3}),
    # certificates and proofs
    Mutant("cert-fig1", "two numbers of a bisimulation have changed places",
           folder=damaged("fig1/pairs.json", exchanged), slow=True),
    Mutant("cert-cycles", "an assertion is missing",
           folder=damaged("cycles/2-sigma.smt2", without_an_assertion), slow=True),
    Mutant("cert-no-twins-directional", "half a proof",
           folder=damaged("no-twins-directional/m2.lrat.xz", half), slow=True),
    Mutant("cert-smallest-pairs", "half a proof",
           folder=damaged("smallest-pairs/planar-simple-m2.lrat.xz", half), slow=True),
    Mutant("cert-natural-lighthouse", "two numbers of a bisimulation have changed places",
           folder=damaged("natural-lighthouse/pair.json", exchanged), slow=True),
    *(
        without(claim.id, what)
        for claim in manifest()
        if claim.id.startswith("coq-")
        for what in WRONG_PROOFS
    ),
)  # fmt: skip


def means_of(mutant: Mutant, folder: Path) -> Means:
    """With what the claim is looked at."""
    if mutant.folder:
        copied(folder)
        return Means(proofs=folder)
    if mutant.claim.startswith("coq-"):
        return Means(proofs=PROOFS, budget="full")
    return Means()


__all__ = ["MUTANTS", "Mutant", "as_claimed", "means_of"]
