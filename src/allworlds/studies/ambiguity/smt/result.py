"""What a search has found, as values."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from allworlds.outcome import SCHEMA, Exit
from allworlds.studies.ambiguity.smt.question import Question, Sizes
from allworlds.studies.ambiguity.smt.solvers import Status
from allworlds.world import World

if TYPE_CHECKING:
    from allworlds import documents

Classes: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]
"""For each of two worlds the class of each dart."""


class Twins(NamedTuple):
    """Two worlds that no motion tells apart, and the bisimulation that proves it."""

    worlds: tuple[World, World]
    classes: Classes


@dataclass(frozen=True, slots=True)
class Searched:
    """One pair of sizes, decided.

    Attributes:
        sizes: of the two worlds.
        status: of the formula.
        formula: the DIMACS file.
        seconds: for writing and solving it.
        proof: the checked LRAT proof, where there is one.
        same_map: twins that are one world with two starts, met on the way.
        twins: the decoded worlds, where the formula has a model.
    """

    sizes: Sizes
    status: Status
    formula: Path
    seconds: float
    proof: Path | None = None
    same_map: tuple[Twins, ...] = ()
    twins: Twins | None = None

    def to_json(self) -> documents.SearchLevel:
        """One row of the document."""
        return {
            "edges": [size.edges for size in self.sizes],
            "vertices": [[size.fewest, size.most] for size in self.sizes],
            "status": self.status,
            "formula": str(self.formula),
            "proof": None if self.proof is None else str(self.proof),
        }


@dataclass(frozen=True, slots=True)
class SearchResult:
    """The answer.

    Attributes:
        question: what was asked.
        status: ``sat``: the twins; ``unsat``: none within the bounds; ``unknown``.
        twins: two different worlds that no motion tells apart, re-verified.
        certificate: for sat the file with the pair and its bisimulation; for unsat the
            directory with a formula and a checked LRAT proof for all sizes; else None.
        directory: where the formulas are.
        searched: in the order in which they were decided.
        vacuous: unsat, because not even one world exists within the bounds.
        notices: sentences for the reader.
        interrupted: by the user; the status is ``unknown``, or twins had been found before.
    """

    question: Question
    status: Status
    twins: Twins | None
    certificate: Path | None
    directory: Path
    searched: tuple[Searched, ...]
    vacuous: bool
    notices: tuple[str, ...]
    interrupted: bool = False

    @property
    def pair(self) -> tuple[World, World] | None:
        """The two worlds, if any."""
        return self.twins.worlds if self.twins else None

    @property
    def classes(self) -> Classes | None:
        """Their bisimulation, if any."""
        return self.twins.classes if self.twins else None

    @property
    def exit_code(self) -> Exit:
        """0 answered, 3 unknown, 4 no world within the bounds, 130 interrupted."""
        if self.interrupted:
            return Exit.INTERRUPTED
        if self.status == "unknown":
            return Exit.INCONCLUSIVE
        return Exit.VACUOUS if self.vacuous else Exit.ANSWERED

    def to_json(self) -> documents.SearchDocument:
        """The document of ``search --json``."""
        same = [twins.worlds for searched in self.searched for twins in searched.same_map]
        asked = self.question
        return {
            "schema": SCHEMA,
            "status": self.status,
            "exit_code": self.exit_code,
            "pair": None if self.pair is None else [world.to_json() for world in self.pair],
            "bisimulation": None if self.classes is None else [list(c) for c in self.classes],
            "certificate": None if self.certificate is None else str(self.certificate),
            "vacuous": self.vacuous,
            "lighthouse": asked.lighthouse,
            "class": asked.map_class.value,
            "vertices": asked.vertices,
            "edges": asked.edges,
            "directory": str(self.directory),
            "levels": [searched.to_json() for searched in self.searched],
            "same_map": [[world.to_json() for world in worlds] for worlds in same],
            "notices": list(self.notices),
        }
