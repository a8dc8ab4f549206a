"""The search for twins by growing sizes, so that the first pair found is a smallest one."""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from time import monotonic
from typing import Any

from msgspec import Struct, field

from allworlds.document.struct import replace
from allworlds.engines.progress import Listener, Silent
from allworlds.inputs.checks import INSTALL, InputError, a_path, at_most, show
from allworlds.inputs.requests import answers
from allworlds.outcome import COMPLETED, Completed, Ending, ended
from allworlds.studies.ambiguity.ambiguity_requests import SearchRequest
from allworlds.studies.ambiguity.smt.decode import decoded, same_world_from
from allworlds.studies.ambiguity.smt.formula import Formula, read_dimacs
from allworlds.studies.ambiguity.smt.lrat import check_lrat
from allworlds.studies.ambiguity.smt.one_world import Size
from allworlds.studies.ambiguity.smt.pair import forbid_other_start, pair_formula, world_formula
from allworlds.studies.ambiguity.smt.question import Question, Sizes, question_of
from allworlds.studies.ambiguity.smt.result import Searched, SearchResult, Twins
from allworlds.studies.ambiguity.smt.rup import ProofRefused, lrat_of_drat, write_lrat
from allworlds.studies.ambiguity.smt.solvers import (
    LONGEST_WAIT,
    Clock,
    ExternalSolver,
    SolverAnswer,
    SolversDisagree,
    Status,
    python_sat_is_installed,
    solve_with_python_sat,
    solve_with_z3,
)

PROOF_LIMIT = 10_000_000
"""Bytes of DRAT that the checker of this package accepts: a minute or two."""


@answers(SearchRequest)
def search(request: SearchRequest) -> SearchResult:
    """Search by z3 for two different worlds that no motion separates, or show that there are none.

    Worlds are different if no isomorphism of the maps carries the marks of one to those of
    the other; where they start does not count.

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    asked, time_limit, solver = question_of(request), request.time_limit, request.solver
    if time_limit is not None and (not isinstance(time_limit, int | float) or not time_limit > 0):
        raise InputError(f"time-limit = {show(time_limit)}, but it must be more than 0 seconds")
    at_most("time-limit", time_limit or 0, LONGEST_WAIT)
    external = None
    if solver is not None:
        a_path("solver", solver)
        # As it was given: of ./solver a Path would leave a name that is looked for on PATH.
        external = ExternalSolver(solver)
    with _directory(request.out) as directory:
        clock, heard = Clock(time_limit), request.listener
        found = _TwinsSearch(asked, external, directory, clock, listener=heard).run()
    for notice in found.notices:
        heard.notice(notice)
    return found


@contextmanager
def _directory(out: str | Path | None) -> Iterator[Path]:
    """The directory that is named, else a temporary one, which stays if the result refers to it."""
    if out is None:
        temporary = Path(tempfile.mkdtemp(prefix="allworlds-search-"))
        try:
            yield temporary
        except BaseException:
            shutil.rmtree(temporary)
            raise
        return
    directory = a_path("out", out)
    try:
        directory.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"directory {show(str(out))} cannot be made: {error.strerror}") from None
    yield directory


class _TwinsSearch(Struct):
    """The state of one search."""

    question: Question
    external: ExternalSolver | None
    directory: Path
    clock: Clock
    done: list[Searched] = field(default_factory=list)
    notices: list[str] = field(default_factory=list)
    unproved: dict[str, list[str]] = field(default_factory=dict)
    best: Twins | None = None
    listener: Listener = field(default_factory=Silent)

    def run(self) -> SearchResult:
        results: list[SearchResult] = []

        def answer() -> Ending:
            results.append(self._answer())
            return Completed()

        ending = ended(answer)
        if results:
            return results[0]
        if self.best:
            self.notices.append("interrupted before fewer vertices were tried")
            return self._found(self.best, ending)
        self.notices.append("interrupted; no answer follows from the sizes that are decided")
        return self._result("unknown", ending)

    def _answer(self) -> SearchResult:
        every = list(self.question.sizes())
        self.listener.stage("search", len(every), "sizes; these grow, so the time left is a guess")
        for sizes in every:
            found = self._decide(sizes)
            self.listener.progress(1)
            if found.twins:
                return self._found(self._fewer_vertices(sizes, found.twins))
            if found.status == "unknown":
                undecided = found.sizes.name
                self.notices.append(
                    f"the sizes {undecided} are undecided; no answer follows from them"
                )
                return self._result("unknown")
        if not self._some_world_exists():
            self.notices.append("vacuous: no world at all exists within these bounds")
            return self._result("unsat", vacuous=True)
        self.done = [self._proved(searched) for searched in self.done]
        self._remark_on_missing_proofs()
        complete = all(searched.proof for searched in self.done)
        self._remark_on_one_map()
        return self._result("unsat", certificate=self.directory if complete else None)

    def _decide(self, sizes: Sizes) -> Searched:
        """Solve for two sizes. Pairs that are one world started twice are excluded one by one."""
        began = monotonic()
        formula, pair = pair_formula(self.question, sizes)
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
            forbid_other_start(formula, pair, start)
        proof = path.with_suffix(".lrat") if self.external and solved.status == "unsat" else None
        status = solved.status
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

    def _fewer_vertices(self, sizes: Sizes, twins: Twins) -> Twins:
        """Among the pairs with these numbers of edges one with the fewest vertices."""
        counts = [world.map.vertex_count for world in twins.pair]
        one, two = (replace(size, most=n) for size, n in zip(sizes, counts, strict=True))
        if self.question.sensing.marks_v0:
            smaller = [(_less(one), _less(two))]
        else:
            smaller = [(one, _less(two)), (_less(one), two)]
        for first, second in smaller:
            if first and second:
                again = self._decide(Sizes(first, second))
                if again.twins:
                    return self._fewer_vertices(again.sizes, again.twins)
                if again.status == "unknown":
                    self.notices.append("the time was over before fewer vertices were tried")
                    return twins
        return twins

    def _found(self, twins: Twins, ending: Ending = COMPLETED) -> SearchResult:
        """The pair, written to a file with its bisimulation."""
        file = self.directory / "pair.json"
        file.write_text(json.dumps(twins.to_json()) + "\n", encoding="ascii")
        return self._result(
            "sat",
            ending,
            certificate=file,
            pair=twins.pair,
            bisimulation=twins.bisimulation,
        )

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
        """Whether the bounds and the walk allow any world, by small formulas for z3."""
        path = self.directory / "one-world.cnf"
        for sizes in self.question.sizes():
            if sizes.one == sizes.two:
                formula, _ = world_formula(self.question, sizes)
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
        """The sizes with an LRAT proof from python-sat's DRAT, checked here, if that can be."""
        if searched.proof:
            return searched
        reason = self._write_proof(searched.formula)
        if reason:
            self.unproved.setdefault(reason, []).append(searched.formula.name)
            return searched
        return replace(searched, proof=searched.formula.with_suffix(".lrat"))

    def _remark_on_missing_proofs(self) -> None:
        """Tell each reason once, with the formulas that have no certificate for it."""
        for reason, names in self.unproved.items():
            more = f" and {len(names) - 1} more" if len(names) > 1 else ""
            self.notices.append(f"no certificate for {names[0]}{more}: {reason}")

    def _write_proof(self, formula: Path) -> str | None:
        """The reason why there is no proof; None if one was written."""
        if not python_sat_is_installed():
            return f"{INSTALL.format('proofs')}, or name a CaDiCaL 2 with --solver"
        drat = formula.with_suffix(".drat")
        solved = solve_with_python_sat(formula, drat, self.clock)
        if solved.status == "sat":
            raise SolversDisagree(f"z3 and CaDiCaL disagree on {formula}")
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
        return None


def _less(size: Size) -> Size | None:
    return replace(size, most=size.most - 1) if size.most > size.fewest else None
