"""Results of a search, as values."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeAlias

from typing_extensions import override

from allworlds.document.struct import (
    EXIT_CODE,
    Aside,
    Document,
    ExitCode,
    Natural,
    Pair,
    Positive,
    Text,
    about,
    computed,
    narrowed,
    one_of,
)
from allworlds.engines.swept_report import EndedReport
from allworlds.maps.classes import MapClass
from allworlds.outcome import Exit
from allworlds.studies.ambiguity.smt.question import SEARCHED, Question, Sizes
from allworlds.studies.ambiguity.smt.solvers import Status
from allworlds.world.world import World

Classes: TypeAlias = Pair[Annotated[tuple[Natural, ...], narrowed(minItems=2)]]


class Twins(Document):
    """Two worlds that no motion tells apart, and the bisimulation that proves it."""

    pair: Pair[World]
    bisimulation: Classes


class Searched(Document):
    """One level of a search.

    Writing and solving took ``seconds``. ``same_map`` holds twins that turned out to be one world
    with two starts; ``twins`` holds the decoded worlds, if the formula has a model.
    """

    edges: Annotated[Pair[Positive], about("of each world")] = computed(
        lambda level: tuple(size.edges for size in level.sizes)
    )
    vertices: Annotated[Pair[Pair[Positive]], about("for each world the fewest and the most")] = (
        computed(lambda level: tuple((size.fewest, size.most) for size in level.sizes))
    )
    status: Annotated[Status, about("the solver's answer to this formula")]
    formula: Annotated[Path, about("the path of the DIMACS file")]
    proof: Annotated[Path | None, about("the path of the LRAT proof; null: there is none")]
    sizes: Aside[Sizes]
    seconds: Aside[float]
    same_map: Aside[tuple[Twins, ...]] = ()
    twins: Aside[Twins | None] = None


class SearchResult(EndedReport):
    """Report of 'search'.

    If it was interrupted by the user, the status is `unknown`, or twins had been found before.
    """

    status: Annotated[Status, about("`sat`: a pair; `unsat`: there is none in the bounds")]
    exit_code: Annotated[
        ExitCode, one_of(Exit.ANSWERED, Exit.INCONCLUSIVE, Exit.VACUOUS, Exit.INTERRUPTED)
    ] = EXIT_CODE
    pair: Annotated[Pair[World] | None, about("two worlds that look alike; null unless `sat`")] = (
        None
    )
    bisimulation: Annotated[
        Classes | None, about("for each of them the class of each dart; null unless `sat`")
    ] = None
    certificate: Annotated[
        Path | None,
        about("the path of the certificate; null: see [answers](ambiguity.md#answers)"),
    ] = None
    vacuous: Annotated[bool, about("not even one world exists within the bounds")] = False
    lighthouse: Annotated[str, one_of(*SEARCHED), about("its kind")] = computed(
        lambda r: r.question.lighthouse
    )
    map_class: Annotated[MapClass, about("the class of maps")] = computed(
        lambda result: result.question.map_class, name="class"
    )
    vertices: Annotated[Positive, about("at most so many")] = computed(
        lambda result: result.question.vertices
    )
    edges: Annotated[Positive, about("at most so many")] = computed(
        lambda result: result.question.edges
    )
    directory: Annotated[Path, about("the directory of the formulas")]
    levels: Annotated[tuple[Searched, ...], about("in the order of the search")]
    same_map: Annotated[
        tuple[Pair[World], ...], about("pairs that look alike but are one map with two starts")
    ] = computed(lambda r: tuple(same.pair for level in r.levels for same in level.same_map))
    notices: Annotated[tuple[Text, ...], about("sentences for the reader")]
    question: Aside[Question]

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
