"""How far a run directory is, also while somebody adds to it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from allworlds.engines import (
    ENDED,
    Identity,
    cells_of_level,
    in_use,
    reading,
    shards_of,
    units_of_level,
)
from allworlds.inputs import a_path
from allworlds.maps import Extent, MapClass
from allworlds.outcome import SCHEMA, Exit

if TYPE_CHECKING:
    from allworlds import documents

State: TypeAlias = Literal["running", "finished", "unfinished"]


@dataclass(frozen=True, slots=True)
class LargestCost:
    """The largest cost so far, and the least size of a world in which it was met."""

    edges: int
    vertices: int
    cost: int

    def to_json(self) -> documents.MostExpensiveSoFar:
        """Its three numbers."""
        return {"edges": self.edges, "vertices": self.vertices, "cost": self.cost}


@dataclass(frozen=True, slots=True)
class Standing:
    """What a run directory holds.

    Attributes:
        identity: what it is of.
        state: whether somebody adds to it, and whether anything is left to add.
        units: how many are finished, and of how many.
        worlds: the same; of a shard the second number is about its part.
        rate: worlds a second since somebody last began; None before the first, and at the end.
        worst: the largest cost so far; None where there is none.
        findings: in the finished units.
    """

    identity: Identity
    state: State
    units: tuple[int, int]
    worlds: tuple[int, int]
    rate: float | None
    worst: LargestCost | None
    findings: int

    @property
    def exit_code(self) -> Exit:
        """0: the question was answered."""
        return Exit.ANSWERED

    @property
    def left(self) -> float | None:
        """Seconds until the end at this rate: a guess, since larger worlds take longer."""
        if self.state == "finished":
            return 0.0
        done, all_ = self.worlds
        return max(0, all_ - done) / self.rate if self.rate else None

    def to_json(self) -> documents.StatusDocument:
        """The document of ``status --json``."""
        done = dict(zip(("done", "all"), self.units, strict=True))
        worlds = dict(zip(("done", "all"), self.worlds, strict=True))
        return {
            "schema": SCHEMA,
            "verb": self.identity.verb,
            "version": self.identity.version,
            "explorer": self.identity.explorer["name"],
            "shard": self.identity.shard,
            "parameters": dict(self.identity.parameters),
            "state": self.state,
            "units": {"done": done["done"], "all": done["all"]},
            "worlds": {"done": worlds["done"], "all": worlds["all"]},
            "rate": None if self.rate is None else round(self.rate, 1),
            "left_s": None if self.left is None else round(self.left, 1),
            "worst": self.worst.to_json() if self.worst else None,
            "findings": self.findings,
        }


def status(run: str | Path) -> Standing:
    """How far a run directory is; every unit in it is looked at.

    Raises:
        InputError: if it is none, or is damaged.
    """
    path = a_path("run", run)
    running = in_use(path)
    with reading(path) as database:
        identity = database.identity
        ended = database.recall("ended") == ENDED
        began = database.last_session()
        units = worlds = recent = findings = 0
        last = began
        costs: list[LargestCost] = []
        for _, met, finished, result in database.rows():
            units, worlds = units + 1, worlds + met
            if finished >= began:
                recent, last = recent + met, max(last, finished)
            costs += _costs(identity.verb, result)
            findings += _findings(result)
    until = time.time() if running and not ended else last
    worst = min(costs, key=lambda d: (-d.cost, d.edges, d.vertices), default=None)
    state: State = "running" if running and not ended else "finished" if ended else "unfinished"
    extent = _extent(identity)
    expected = [units_of_level(extent, edges, identity.portion) for edges in extent.levels]
    size = sum(sum(cells_of_level(extent, edges).values()) for edges in extent.levels)
    return Standing(
        identity,
        state,
        (units, sum(1 for level in expected for _ in level)),
        (worlds, size // shards_of(identity.portion)),
        recent / (until - began) if recent and until > began and not ended else None,
        worst,
        findings,
    )


def _extent(identity: Identity) -> Extent:
    told = identity.parameters
    return Extent(MapClass(told["class"]), told["edges"], told.get("vertices"))


def _costs(verb: str, result: Any) -> Iterator[LargestCost]:
    """The largest costs of a unit, where its verb has costs."""
    match verb:
        case "check":
            for edges, vertices, *row in result["rows"]:
                yield LargestCost(edges, vertices, row[5])
        case "worst":
            for vertices, _, worst, *_, sigma, _ in result:
                yield LargestCost(len(sigma) // 2, vertices, worst)


def _findings(result: Any) -> int:
    return len(result["findings"]) if isinstance(result, dict) and "findings" in result else 0
