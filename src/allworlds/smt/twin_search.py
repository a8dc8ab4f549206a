"""The search for twins: level by level, so that a pair that is found is a smallest one."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from time import monotonic
from typing import Any

from allworlds.inputs import InputError, a_path, show
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.outcome import SCHEMA, Exit
from allworlds.smt.formula import Block, Clause, Formula
from allworlds.smt.lrat import check_lrat
from allworlds.smt.one_world import OneWorld, Size
from allworlds.smt.pair import Pair, forbid_other_start, pair_formula, world_formula
from allworlds.smt.question import Level, Question, question
from allworlds.smt.rup import ProofRefused, lrat_of_drat, write_lrat
from allworlds.smt.solvers import (
    Clock,
    ExternalSolver,
    Solved,
    Status,
    python_sat_is_installed,
    solve_with_python_sat,
    solve_with_z3,
)
from allworlds.smt.witness import MarkedMap, bisimulation, same_world_from, senses

PROOF_LIMIT = 10_000_000
"""Bytes of DRAT that our own checker takes on: a minute or two."""

Twins = tuple[MarkedMap, MarkedMap]


@dataclass(frozen=True, slots=True)
class Searched:
    """One level, decided.

    Attributes:
        level: the sizes of the two worlds.
        status: of the level's formula.
        formula: the DIMACS file.
        seconds: for writing and solving it.
        proof: the checked LRAT proof, where there is one.
        same_map: pairs that look alike but are one world with two starts, met on the way.
        pair: the decoded worlds, where the formula has a model.
    """

    level: Level
    status: Status
    formula: Path
    seconds: float
    proof: Path | None = None
    same_map: tuple[Twins, ...] = ()
    pair: Twins | None = None

    def to_json(self) -> dict[str, Any]:
        """One row of the document."""
        return {
            "edges": [size.edges for size in self.level],
            "vertices": [[size.fewest, size.most] for size in self.level],
            "status": self.status,
            "formula": str(self.formula),
            "proof": None if self.proof is None else str(self.proof),
            "seconds": round(self.seconds, 3),
        }


@dataclass(frozen=True, slots=True)
class SearchResult:
    """The answer.

    Attributes:
        question: what was asked.
        status: ``sat``: the pair; ``unsat``: none within the bounds; ``unknown``.
        pair: two different worlds that no motion tells apart, re-verified.
        classes: a bisimulation: the class of each dart of either world.
        certificate: for sat the file with the pair and its bisimulation; for unsat the
            directory with a formula and a checked LRAT proof for every level; else None.
        directory: where the formulas are.
        levels: in the order in which they were decided.
        vacuous: unsat, because not even one world exists within the bounds.
        notices: sentences for the reader.
    """

    question: Question
    status: Status
    pair: Twins | None
    classes: tuple[list[int], list[int]] | None
    certificate: Path | None
    directory: Path
    levels: tuple[Searched, ...]
    vacuous: bool
    notices: tuple[str, ...]

    @property
    def exit_code(self) -> Exit:
        """0 answered, 3 unknown, 4 no world within the bounds."""
        if self.status == "unknown":
            return Exit.INCONCLUSIVE
        return Exit.VACUOUS if self.vacuous else Exit.ANSWERED

    def to_json(self) -> dict[str, Any]:
        """The document of ``search --json``."""
        same = [twins for searched in self.levels for twins in searched.same_map]
        asked = self.question
        return {
            "schema": SCHEMA,
            "status": self.status,
            "exit_code": self.exit_code,
            "pair": None if self.pair is None else [world.to_json() for world in self.pair],
            "bisimulation": None if self.classes is None else list(self.classes),
            "certificate": None if self.certificate is None else str(self.certificate),
            "vacuous": self.vacuous,
            "lighthouse": asked.lighthouse,
            "class": asked.map_class.value,
            "vertices": asked.vertices,
            "edges": asked.edges,
            "directory": str(self.directory),
            "levels": [searched.to_json() for searched in self.levels],
            "same_map": [[world.to_json() for world in twins] for twins in same],
            "notices": list(self.notices),
        }


def search(
    *,
    lighthouse: str,
    vertices: int,
    edges: int,
    map_class: str = "maps",
    degree_marked: int | None = None,
    degree_others: int | None = None,
    motions: Sequence[int] = (),
    percepts: Sequence[str] = (),
    solver: str | None = None,
    out: str | Path | None = None,
    time_limit: float | None = None,
) -> SearchResult:
    """Two different worlds that no motion separates, or that there are none, by z3.

    Worlds are different if no isomorphism of the maps carries the marks of one to those of
    the other; where they start does not count.

    Args:
        lighthouse: ``none``, ``position``, ``compass`` or ``directional``.
        vertices: the largest number of vertices of each of the two worlds.
        edges: the largest number of edges.
        map_class: ``maps``, ``simple``, ``planar`` or ``planar-simple``.
        degree_marked: the degree of the start's vertex (with ``position``: the marked one).
        degree_others: the degree of every other vertex.
        motions: a walk from the start, in both worlds.
        percepts: what it senses, ``3A`` or ``4P`` after each motion.
        solver: the path of a CaDiCaL 2 or later, in place of z3.
        out: the directory for formulas and proofs; a new temporary one where it is missing.
        time_limit: seconds for everything; when they are over the answer is unknown.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    asked = question(
        lighthouse,
        map_class,
        vertices,
        edges,
        degree_marked=degree_marked,
        degree_others=degree_others,
        motions=motions,
        percepts=percepts,
    )
    if time_limit is not None and (not isinstance(time_limit, int | float) or not time_limit > 0):
        raise InputError(f"time-limit = {show(time_limit)}, but it must be more than 0 seconds")
    external = None if solver is None else ExternalSolver(str(a_path("solver", solver)))
    hunt = _Search(asked, external, _directory(out), Clock(time_limit))
    return hunt.run()


def _directory(out: str | Path | None) -> Path:
    if out is None:
        return Path(tempfile.mkdtemp(prefix="allworlds-search-"))
    directory = a_path("out", out)
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"directory {str(out)!r} cannot be made: {error.strerror}") from None
    return directory


@dataclass
class _Search:
    """One search under way."""

    question: Question
    external: ExternalSolver | None
    directory: Path
    clock: Clock
    done: list[Searched] = field(default_factory=list)
    notices: list[str] = field(default_factory=list)

    def run(self) -> SearchResult:
        for level in self.question.levels():
            found = self._decide(level)
            if found.status == "sat":
                return self._found(self._fewer_vertices(found))
            if found.status == "unknown":
                return self._result("unknown")
        if not self._some_world_exists():
            self.notices.append("vacuous: no world at all exists within these bounds")
            return replace(self._result("unsat"), vacuous=True)
        self.done = [self._proved(searched) for searched in self.done]
        complete = all(searched.proof for searched in self.done)
        self._remark_on_one_map()
        return self._result("unsat", certificate=self.directory if complete else None)

    def _decide(self, level: Level) -> Searched:
        """Solve one level; pairs that are one world started twice are excluded as they come."""
        began = monotonic()
        formula, pair = pair_formula(self.question, level)
        path = self.directory / f"{level.name}.cnf"
        same: list[Twins] = []
        while True:
            formula.write(path)
            solved = self._solve(path)
            twins = _decoded(pair, solved) if solved.status == "sat" else None
            start = None if twins is None else same_world_from(*twins)
            if twins is None or start is None:
                break
            same.append(twins)
            forbid_other_start(formula, pair, start)
        proof = path.with_suffix(".lrat") if self.external and solved.status == "unsat" else None
        status = solved.status
        if proof and not self._accepts(formula, proof):
            status, proof = "unknown", None
        searched = Searched(level, status, path, monotonic() - began, proof, tuple(same), twins)
        self.done.append(searched)
        return searched

    def _solve(self, path: Path) -> Solved:
        if self.external:
            return self.external.solve(path, path.with_suffix(".lrat"), self.clock)
        return solve_with_z3(path, self.clock)

    def _accepts(self, formula: Formula, proof: Path) -> bool:
        try:
            with proof.open(encoding="ascii", errors="replace") as lines:
                check_lrat(formula.clauses, lines)
        except (ProofRefused, OSError) as error:
            self.notices.append(f"the solver's proof {proof} is refused: {error}")
            return False
        return True

    def _fewer_vertices(self, found: Searched) -> Searched:
        """Among the pairs with these numbers of edges one with the fewest vertices."""
        while True:
            assert found.pair is not None
            counts = [world.map.vertex_count for world in found.pair]
            one, two = (replace(size, most=n) for size, n in zip(found.level, counts, strict=True))
            if self.question.sensing.marks_v0:
                smaller = [(_less(one), _less(two))]
            else:
                smaller = [(one, _less(two)), (_less(one), two)]
            for first, second in smaller:
                if first and second:
                    again = self._decide(Level(first, second))
                    if again.status == "sat":
                        found = again
                        break
                    if again.status == "unknown":
                        self.notices.append("the time was over before fewer vertices were tried")
                        return found
            else:
                return found

    def _found(self, found: Searched) -> SearchResult:
        assert found.pair is not None
        classes = bisimulation(*found.pair)
        assert classes is not None, "checked when it was decoded"
        certificate = self.directory / "pair.json"
        document = {
            "pair": [world.to_json() for world in found.pair],
            "bisimulation": list(classes),
        }
        certificate.write_text(json.dumps(document) + "\n", encoding="ascii")
        return self._result("sat", pair=found.pair, classes=classes, certificate=certificate)

    def _result(self, status: Status, **answer: Any) -> SearchResult:
        unanswered = {"pair": None, "classes": None, "certificate": None}
        if status == "unknown":
            last = self.done[-1]
            self.notices.append(f"level {last.level.name} is undecided; no answer follows from it")
        return SearchResult(
            question=self.question,
            status=status,
            directory=self.directory,
            levels=tuple(self.done),
            vacuous=False,
            notices=tuple(self.notices),
            **{**unanswered, **answer},
        )

    def _some_world_exists(self) -> bool:
        """Whether the bounds and the walk leave any world; small formulas, solved by z3."""
        path = self.directory / "one-world.cnf"
        for level in self.question.levels():
            if level.one == level.two:
                formula, _ = world_formula(self.question, level)
                formula.write(path)
                if solve_with_z3(path, self.clock).status != "unsat":
                    return True
        path.unlink(missing_ok=True)
        return False

    def _remark_on_one_map(self) -> None:
        met = sum(len(searched.same_map) for searched in self.done)
        if met:
            self.notices.append(
                f"{met} pairs were met that are one world with two starts which look alike: "
                "the map can be told, the robot's place in it cannot"
            )

    def _proved(self, searched: Searched) -> Searched:
        """The level with an LRAT proof from python-sat's DRAT, checked here, if that can be."""
        if searched.proof:
            return searched
        reason = self._write_proof(searched.formula)
        if reason:
            self.notices.append(f"no certificate for {searched.formula.name}: {reason}")
            return searched
        return replace(searched, proof=searched.formula.with_suffix(".lrat"))

    def _write_proof(self, formula: Path) -> str | None:
        """None, or the reason why there is no proof."""
        if not python_sat_is_installed():
            return "install allworlds[proofs], or name a CaDiCaL 2 with --solver"
        drat = formula.with_suffix(".drat")
        solved = solve_with_python_sat(formula, drat, self.clock)
        if solved.status == "sat":
            raise RuntimeError(f"z3 and CaDiCaL disagree on {formula}")
        if solved.status == "unknown":
            return "the time was over"
        size = drat.stat().st_size
        if size > PROOF_LIMIT:
            return (
                f"its DRAT proof ({drat}) has {size:,} bytes, and our checker takes up to "
                f"{PROOF_LIMIT:,}; a CaDiCaL 2 named with --solver writes LRAT"
            )
        variables, clauses = read_dimacs(formula)
        with drat.open(encoding="ascii") as lines:
            write_lrat(lrat_of_drat(variables, clauses, lines), formula.with_suffix(".lrat"))
        drat.unlink()
        return None


def _less(size: Size) -> Size | None:
    return replace(size, most=size.most - 1) if size.most > size.fewest else None


def _decoded(pair: Pair, solved: Solved) -> Twins:
    """The two worlds of a model, after every check that does not need the formula.

    Raises:
        RuntimeError: if they are not what was asked for; then the encoder is wrong.
    """
    asked = pair.question
    pointed = pair.pointed or (None, None)
    one, two = (
        _decoded_world(asked, world, block, solved.model)
        for world, block in zip((pair.one, pair.two), pointed, strict=True)
    )
    walks = [
        [(seen[0], bool(seen[1])) for seen in senses(world, asked.walk.motions)]
        for world in (one, two)
    ]
    lawful = (
        bisimulation(one, two) is not None
        and one.code != two.code
        and all(asked.map_class.includes(world.map) for world in (one, two))
        and walks == [[tuple(percept) for percept in asked.walk.percepts]] * 2
        and all(_fits(world, asked) for world in (one, two))
    )
    if not lawful:
        raise RuntimeError(f"the solver's pair {one}, {two} does not answer: {asked}")
    return one, two


def _fits(world: MarkedMap, asked: Question) -> bool:
    map_, home = world.map, world.map.vertex_of[world.start]
    root, others = asked.degrees.root, asked.degrees.others
    return (
        map_.vertex_count <= asked.vertices
        and map_.edge_count <= asked.edges
        and (root is None or map_.degrees[home] == root)
        and (others is None or all(d == others for v, d in enumerate(map_.degrees) if v != home))
    )


def _decoded_world(
    asked: Question, world: OneWorld, pointed: Block | None, model: frozenset[int]
) -> MarkedMap:
    sigma, alpha = (
        [next(y for y, variable in enumerate(row) if variable in model) for row in block.rows()]
        for block in (world.sigma, world.alpha)
    )
    if pointed is not None:
        darts = tuple(x for x, variable in enumerate(pointed.variables) if variable in model)
    else:
        darts = (0,) if asked.sensing.marks_v0 else ()
    return MarkedMap(asked.lighthouse, CombinatorialMap(sigma, alpha), 0, darts)


def read_dimacs(path: Path) -> tuple[int, list[Clause]]:
    """The number of variables and the clauses of a DIMACS file that :class:`Formula` wrote."""
    variables, clauses = 0, []
    for line in path.read_text(encoding="ascii").splitlines():
        if line.startswith("p cnf "):
            variables = int(line.split()[2])
        elif not line.startswith("c"):
            clauses.append(tuple(map(int, line.split()[:-1])))
    return variables, clauses
