"""The search for twins in the order of their sizes, so that the first pair is a smallest pair."""

import json
import shutil
import tempfile
from pathlib import Path
from time import monotonic
from typing import Annotated, Any, TypeAlias

from msgspec import Struct, field
from typing_extensions import override

from allworlds.documents import document as doc
from allworlds.engines.limits import deadline_after
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import INSTALL, InputError, a_path, at_most, show
from allworlds.inputs.requests import answers
from allworlds.maps.classes import MapClass
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.outcome import COMPLETED, Disagreement, Ending, ended
from allworlds.studies.ambiguity import formulas
from allworlds.studies.ambiguity.clauses import Atoms, Formula, read_dimacs
from allworlds.studies.ambiguity.one_world import OneWorld
from allworlds.studies.ambiguity.proofs import ProofRefused, check_lrat, lrat_of_drat, write_lrat
from allworlds.studies.ambiguity.question import (
    SEARCHED,
    Question,
    SearchRequest,
    Sizes,
    question_of,
)
from allworlds.studies.ambiguity.solvers import (
    LONGEST_WAIT,
    ExternalSolver,
    SolverAnswer,
    Status,
    python_sat_is_installed,
    solve_with_python_sat,
    solve_with_z3,
)
from allworlds.studies.reports import EndedReport
from allworlds.world.bisimulation import flaw, same_world_from, sensed
from allworlds.world.lighthouses.base import Where
from allworlds.world.world import World

PROOF_LIMIT = 10_000_000
"""The most bytes of DRAT that this package checks, which takes a minute or two."""

Classes: TypeAlias = doc.Pair[Annotated[tuple[doc.Natural, ...], doc.narrowed(minItems=2)]]


class Twins(doc.Document):
    """Two worlds that no motion tells apart, and the bisimulation that proves this."""

    pair: doc.Pair[World]
    bisimulation: Classes


class Searched(doc.Document):
    """One level of a search: a formula about two worlds of given sizes, and the solver's answer.

    ``seconds`` is the time for writing and solving. ``same_map`` holds pairs that turned out to be
    one map with two starts; ``twins`` holds the two different worlds that were found, or None.
    """

    status: Annotated[Status, doc.about("the solver's answer to this formula")]
    formula: Annotated[Path, doc.about("the path of the DIMACS file")]
    proof: Annotated[Path | None, doc.about("the path of the LRAT proof; null: there is none")]
    sizes: doc.NotInDocument[Sizes]
    seconds: doc.NotInDocument[float]
    same_map: doc.NotInDocument[tuple[Twins, ...]] = ()
    twins: doc.NotInDocument[Twins | None] = None

    @doc.computed
    def edges(self) -> doc.Pair[doc.Positive]:
        """The number of edges of each world."""
        return tuple(size.edges for size in self.sizes)

    @doc.computed
    def vertices(self) -> doc.Pair[doc.Pair[doc.Positive]]:
        """For each world the fewest and the most vertices."""
        return tuple((size.fewest, size.most) for size in self.sizes)


class SearchResult(EndedReport, kw_only=True):
    """Report of 'search'.

    The status is `sat` if twins were found, also if the user then interrupted the search. It is
    `unsat` if there are no twins within the bounds. It is `unknown` if the search ended without an
    answer: at the time limit, by an interruption, or because the solver gave none, or a proof that
    was refused.
    """

    status: Annotated[Status, doc.about("`sat`: a pair; `unsat`: there is none in the bounds")]
    pair: Annotated[
        doc.Pair[World] | None, doc.about("two worlds that look alike; null unless `sat`")
    ] = None
    bisimulation: Annotated[
        Classes | None, doc.about("for each of them the class of each dart; null unless `sat`")
    ] = None
    certificate: Annotated[
        Path | None,
        doc.about("the path of the certificate; null: see [answers](ambiguity.md#answers)"),
    ] = None
    vacuous: Annotated[bool, doc.about("not even one world exists within the bounds")] = False
    directory: Annotated[Path, doc.about("the directory of the formulas")]
    levels: Annotated[tuple[Searched, ...], doc.about("in the order of the search")]
    notices: Annotated[tuple[doc.Text, ...], doc.about("sentences for the reader")]
    question: doc.NotInDocument[Question]

    @doc.computed
    def lighthouse(self) -> doc.Text:
        """The kind of the lighthouse."""
        return self.question.lighthouse

    @doc.computed
    def map_class(self) -> MapClass:
        """The class of maps to which both worlds must belong."""
        return self.question.map_class

    @doc.computed
    def vertices(self) -> doc.Positive:
        """The largest number of vertices of a world."""
        return self.question.vertices

    @doc.computed
    def edges(self) -> doc.Positive:
        """The largest number of edges of a world."""
        return self.question.edges

    @doc.computed
    def same_map(self) -> tuple[doc.Pair[World], ...]:
        """Pairs of worlds that look alike, but are one map with two starts."""
        return tuple(same.pair for level in self.levels for same in level.same_map)

    @property
    @override
    def undecided(self) -> bool:
        return self.status == "unknown"

    @property
    @override
    def empty(self) -> bool:
        return self.vacuous

    @property
    @override
    def seconds_by_part(self) -> dict[str, list[float]]:
        return {"level_seconds": [level.seconds for level in self.levels]}


# ---------------------------------------------------------------- a model, decoded and checked


def bisimulation(a: World, b: World) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """The classes of the darts of ``a`` and of ``b``, numbered in the order of the darts of ``a``.

    The classes are the finest ones such that the starts share a class, and sigma and alpha map
    classes to classes.  It is not checked that the darts of a class have equal percepts.

    Cost: O(m^2).  Source: Hopcroft and Karp, Cornell 71-114 (1971), with darts as states.
    """
    ones, twos = [*a.map.darts], [~y for y in b.map.darts]
    todo = [(a.start, b.start)]
    for x, y in todo:
        kept, merged = ones[x], twos[y]
        if kept != merged:
            ones, twos = ([kept if q == merged else q for q in side] for side in (ones, twos))
            todo += (a.map.sigma[x], b.map.sigma[y]), (a.map.alpha[x], b.map.alpha[y])
    # Every dart of b is met, for its map is connected.
    names = {one: i for i, one in enumerate(dict.fromkeys(ones))}
    return tuple(names[x] for x in ones), tuple(names[y] for y in twos)


def decoded(pair: formulas.PairVariables, model: frozenset[int]) -> Twins:
    """The two worlds of a model of a formula, with the bisimulation between their darts.

    ``pair`` has the variables of the formula; ``model`` is the set of the variables that are true.

    Raises:
        RuntimeError: if the worlds do not fit the question, so that the formula or the solver is
            wrong.
    """
    question, pointed = pair.question, pair.pointed or (None, None)
    try:
        one = _world(question, pair.one, pointed[0], model)
        two = _world(question, pair.two, pointed[1], model)
    except InputError as error:
        raise RuntimeError(f"the solver's model is no pair of worlds: {error}") from None
    classes = bisimulation(one, two)
    if (
        flaw((one, two), classes)
        or same_world_from(one, two) == two.start
        or not all(_fits(world, question) for world in (one, two))
    ):
        raise RuntimeError(f"the solver's pair {one}, {two} does not answer: {question}")
    return Twins(pair=(one, two), bisimulation=classes)


def _world(question: Question, world: OneWorld, at: Atoms | None, model: frozenset[int]) -> World:
    sigma, alpha = (
        [_only([y for y, v in enumerate(row) if v in model]) for row in block.slices()]
        for block in (world.sigma, world.alpha)
    )
    variables = at.variables if at else ()
    references = [x for x, variable in enumerate(variables) if variable in model]
    if at and question.sensing.where is Where.AT_V0:
        _only(references)
    map_ = CombinatorialMap(sigma, alpha)
    if question.words:
        return World(map_, question.kind.usual(map_, 0), 0)
    return World(map_, SEARCHED[question.lighthouse](references), 0)


def _only(darts: list[Dart]) -> Dart:
    if len(darts) != 1:
        raise InputError(f"the darts {darts}, where there is exactly one")
    return darts[0]


def _fits(world: World, question: Question) -> bool:
    """Whether the world has the properties that the question of the search asks for.

    These properties are class, size, degrees, and percepts on the walk.
    """
    map_, home = world.map, world.map.vertex_of[world.start]
    seen = sensed(world, [step.motion for step in question.walk])[1:]
    others = {degree for v, degree in enumerate(map_.degrees) if v != home}
    return (
        question.map_class.includes(map_)
        and map_.vertex_count <= question.vertices
        and map_.edge_count <= question.edges
        and question.degree_marked in (None, map_.degrees[home])
        and (question.degree_others is None or others <= {question.degree_others})
        and [(percept.degree, percept.marks > 0) for percept in seen]
        == [(step.degree, step.present) for step in question.walk]
    )


# ---------------------------------------------------------------- the search


@answers(SearchRequest)
def search(request: SearchRequest) -> SearchResult:
    """Search for two different worlds that no motion tells apart, or show that there are none.

    Two worlds are different if no isomorphism of their maps preserves the percept at every dart.
    The starts of the worlds are not compared.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    question, time_limit, external = question_of(request), request.time_limit, None
    at_most("time-limit", time_limit or 0, LONGEST_WAIT)
    if request.solver is not None:
        a_path("solver", request.solver)
        # As it was given: of ./solver a Path would leave a name that is looked for on PATH.
        external = ExternalSolver(request.solver)
    directory, deadline = _directory(request.out), deadline_after(time_limit)
    try:
        found = _TwinsSearch(question, external, directory, deadline, request.listener).run()
    except BaseException:
        if request.out is None:
            shutil.rmtree(directory)
        raise
    for notice in found.notices:
        request.listener.notice(notice)
    return found


def _directory(out: str | Path | None) -> Path:
    """The directory ``out``, made if it is missing; a new temporary one if ``out`` is None."""
    if out is None:
        return Path(tempfile.mkdtemp(prefix="allworlds-search-"))
    directory = a_path("out", out)
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"directory {show(str(out))} cannot be made: {error.strerror}") from None
    return directory


class _TwinsSearch(Struct):
    """The state of one search.

    Attributes:
        external: the solver that the user named; None: z3.
        done: the solved formulas.
        notices: sentences for the reader.
        best: the smallest twins so far.
        result: the result, once the search has ended.
    """

    question: Question
    external: ExternalSolver | None
    directory: Path
    deadline: float | None
    listener: Listener
    done: list[Searched] = field(default_factory=list)
    notices: list[str] = field(default_factory=list)
    best: Twins | None = None
    result: SearchResult | None = None

    def run(self) -> SearchResult:
        ending = ended(self._answer)
        if self.result:
            return self.result
        if self.best:
            self.notices.append("interrupted before fewer vertices were tried")
            return self._found(self.best, ending)
        self.notices.append("interrupted; no answer follows from the sizes that are decided")
        return self._result("unknown", ending)

    def _answer(self) -> Ending:
        self.result = self._searched()
        return COMPLETED

    def _searched(self) -> SearchResult:
        every = list(self.question.sizes())
        self.listener.stage("search", len(every), "sizes; these grow, so the time left is a guess")
        for sizes in every:
            found = self._decide(sizes)
            self.listener.progress(1)
            if found.twins:
                return self._found(self._fewer_vertices(sizes, found.twins))
            if found.status == "unknown":
                self.notices.append(
                    f"the sizes {sizes.name} are undecided; no answer follows from them"
                )
                return self._result("unknown")
        if not self._some_world_exists():
            self.notices.append("vacuous: no world at all exists within these bounds")
            return self._result("unsat", vacuous=True)
        complete = self._prove()
        if met := sum(len(searched.same_map) for searched in self.done):
            self.notices.append(
                f"{met} pairs were met that are one world with two starts which look alike: "
                "the map can be told, the robot's place in it cannot"
            )
        return self._result("unsat", certificate=self.directory if complete else None)

    def _decide(self, sizes: Sizes) -> Searched:
        """Solve the formula of two sizes; return the formula with the solver's answer.

        The two worlds of a solution may be one map with two starts: the second world is the first
        one entered at another dart.  Such worlds are no twins.  Then clauses that forbid this dart
        (:func:`formulas.forbid_other_start`) are added, and the formula is solved again.
        """
        began = monotonic()
        formula, pair = formulas.pair_formula(self.question, sizes)
        path = self.directory / f"{sizes.name}.cnf"
        same: list[Twins] = []
        while True:
            formula.write(path)
            solved = self._solve(path)
            twins = decoded(pair, solved.model) if solved.status == "sat" else None
            start = same_world_from(*twins.pair) if twins else None
            if twins is None or start is None:
                break
            same.append(twins)
            formulas.forbid_other_start(formula, pair, start)
        status = solved.status
        proof = path.with_suffix(".lrat") if self.external and status == "unsat" else None
        if proof and not self._accepts(formula, proof):
            status, proof = "unknown", None
        searched = Searched(
            sizes=sizes,
            status=status,
            formula=path,
            proof=proof,
            seconds=monotonic() - began,
            same_map=tuple(same),
            twins=twins,
        )
        self.done.append(searched)
        self.best = twins or self.best
        return searched

    def _solve(self, path: Path) -> SolverAnswer:
        if self.external:
            return self.external.solve(path, path.with_suffix(".lrat"), self.deadline)
        return solve_with_z3(path, self.deadline)

    def _accepts(self, formula: Formula, proof: Path) -> bool:
        try:
            with proof.open(encoding="ascii", errors="replace") as lines:
                check_lrat(formula.clauses, lines)
        except (ProofRefused, OSError) as error:
            self.notices.append(f"the solver's proof {proof} is refused: {error}")
            return False
        return True

    def _fewer_vertices(self, sizes: Sizes, twins: Twins) -> Twins:
        """Twins with as many edges as ``twins``, and with as few vertices as were found.

        New twins are searched for.  Each of their worlds has as many edges as the corresponding
        world of ``twins``.  If a marker shows v0, both worlds must have fewer vertices.  Otherwise
        one world must have fewer vertices, and the other one must not have more.  If new twins are
        found, the search goes on from them.  It ends if there are none, or if the solver does not
        decide a formula, for example at the time limit.  The last twins are returned.

        Args:
            sizes: the sizes in the formula whose solution is ``twins``.
            twins: the twins from which the search begins.
        """
        counts = [world.map.vertex_count for world in twins.pair]
        one, two = (doc.replace(size, most=n) for size, n in zip(sizes, counts, strict=True))
        less, less_too = (doc.replace(size, most=size.most - 1) for size in (one, two))
        marked = self.question.sensing.marks_v0
        for smaller in (
            [Sizes(less, less_too)] if marked else [Sizes(one, less_too), Sizes(less, two)]
        ):
            if all(size.fewest <= size.most for size in smaller):
                again = self._decide(smaller)
                if again.twins:
                    return self._fewer_vertices(smaller, again.twins)
                if again.status == "unknown":
                    self.notices.append("the time was over before fewer vertices were tried")
                    return twins
        return twins

    def _found(self, twins: Twins, ending: Ending = COMPLETED) -> SearchResult:
        """The result ``sat`` with these twins, which are also written to the file ``pair.json``.

        ``ending`` says whether the user interrupted the search.
        """
        file = self.directory / "pair.json"
        file.write_text(json.dumps(twins.to_json()) + "\n", encoding="ascii")
        found = {"pair": twins.pair, "bisimulation": twins.bisimulation}
        return self._result("sat", ending, certificate=file, **found)

    def _result(self, status: Status, ending: Ending = COMPLETED, **more: Any) -> SearchResult:
        return SearchResult(
            ending=ending,
            question=self.question,
            status=status,
            directory=self.directory,
            levels=tuple(self.done),
            notices=tuple(self.notices),
            **more,
        )

    def _some_world_exists(self) -> bool:
        """Whether a world fits the bounds and the walk, decided by z3 on small formulas.

        The answer is also yes if z3 reaches the deadline without an answer.
        """
        path = self.directory / "one-world.cnf"
        for sizes in self.question.sizes():
            if sizes.one == sizes.two:
                formulas.world_formula(self.question, sizes).write(path)
                if solve_with_z3(path, self.deadline).status != "unsat":
                    return True
        path.unlink(missing_ok=True)
        return False

    def _prove(self) -> bool:
        """Write a checked proof that no formula has a solution; return whether none is missing.

        LRAT and DRAT are two forms of such proofs: a solver writes DRAT, and the LRAT proof is made
        from it.  If proofs are missing, there is one notice for each reason, with the name of a
        formula without a proof.
        """
        missing: dict[str, list[str]] = {}
        for number, searched in enumerate(self.done):
            formula = searched.formula
            if searched.proof is None and (reason := self._write_proof(formula)):
                missing.setdefault(reason, []).append(formula.name)
            else:
                self.done[number] = doc.replace(searched, proof=formula.with_suffix(".lrat"))
        for reason, names in missing.items():
            more = f" and {len(names) - 1} more" if len(names) > 1 else ""
            self.notices.append(f"no certificate for {names[0]}{more}: {reason}")
        return not missing

    def _write_proof(self, formula: Path) -> str:
        """Write a checked LRAT proof for the formula in a file.

        Return the reason why there is no proof; an empty text if there is one.
        """
        if not python_sat_is_installed():
            return f"{INSTALL.format('proofs')}, or name a CaDiCaL 2 with --solver"
        drat = formula.with_suffix(".drat")
        solved = solve_with_python_sat(formula, drat, self.deadline)
        if solved.status == "sat":
            raise Disagreement(f"z3 and CaDiCaL disagree on {formula}")
        if solved.status == "unknown":
            return "the time was over"
        size = drat.stat().st_size
        if size > PROOF_LIMIT:
            return (
                f"its DRAT proof ({drat}) has {size:,} bytes, and the checker of "
                f"this package accepts {PROOF_LIMIT:,}; a CaDiCaL 2 named with --solver writes LRAT"
            )
        variables, clauses = read_dimacs(formula)
        with drat.open(encoding="ascii") as lines:
            write_lrat(lrat_of_drat(variables, clauses, lines), formula.with_suffix(".lrat"))
        drat.unlink()
        return ""
