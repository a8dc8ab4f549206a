"""How far a run directory is, also while somebody adds to it."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from allworlds.document import (
    Document,
    Figure,
    Natural,
    Positive,
    Report,
    Seconds,
    Text,
    WhichShard,
    about,
)
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
from allworlds.outcome import Exit

State: TypeAlias = Literal["running", "finished", "unfinished"]


class DoneOf(Document):
    """How many of how many."""

    done: Annotated[Natural, about("are finished")]
    all: Annotated[Natural, about("are to be done")]


class LargestCost(Document):
    """The largest cost so far, and the least size of a world in which it was met."""

    edges: Positive
    vertices: Positive
    cost: Annotated[Natural, about("traversals")]


class Standing(Report):
    """Report of 'status'.

    What a run directory holds.  Larger worlds take longer, so what is left is a guess.
    """

    exit_code: ClassVar[Exit] = Exit.ANSWERED

    verb: Annotated[Text, about("whose units these are")]
    version: Annotated[Text, about("of the program that does them")]
    explorer: Annotated[str, about("its name; empty where there is none")]
    shard: WhichShard
    parameters: Annotated[dict[str, Any], about("what else the result depends on")]
    state: Annotated[
        State,
        about("whether somebody adds to it now; if nobody does, whether anything is left to add"),
    ]
    units: Annotated[DoneOf, about("pieces of work")]
    worlds: Annotated[DoneOf, about("rooted maps; of a shard `all` is about its part")]
    rate: Annotated[
        Figure | None,
        about("worlds a second since somebody last began; null: none yet, or all are"),
    ]
    left_s: Annotated[
        Seconds | None,
        about("until the end at this rate: a guess; null where there is no rate"),
    ]
    worst: Annotated[LargestCost | None, about("the largest cost so far; null: there is none")]
    findings: Annotated[Natural, about("in the finished units")]


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
    all_worlds = size // shards_of(identity.portion)
    rate = recent / (until - began) if recent and until > began and not ended else None
    left = 0.0 if ended else max(0, all_worlds - worlds) / rate if rate else None
    return Standing(
        verb=identity.verb,
        version=identity.version,
        explorer=identity.explorer["name"],
        shard=str(identity.portion),
        parameters=dict(identity.parameters),
        state=state,
        units=DoneOf(done=units, all=sum(1 for level in expected for _ in level)),
        worlds=DoneOf(done=worlds, all=all_worlds),
        rate=None if rate is None else round(rate, 1),
        left_s=None if left is None else round(left, 1),
        worst=worst,
        findings=findings,
    )


def _extent(identity: Identity) -> Extent:
    told = identity.parameters
    return Extent(MapClass(told["class"]), told["edges"], told.get("vertices"))


def _costs(verb: str, result: Any) -> Iterator[LargestCost]:
    """The largest costs of a unit, where its verb has costs."""
    match verb:
        case "check":
            for edges, vertices, row in result["rows"]:
                yield LargestCost(edges=edges, vertices=vertices, cost=row["max_cost"])
        case "worst":
            for vertices, _, worst, *_, sigma, _ in result:
                yield LargestCost(edges=len(sigma) // 2, vertices=vertices, cost=worst)


def _findings(result: Any) -> int:
    return len(result["findings"]) if isinstance(result, dict) and "findings" in result else 0
