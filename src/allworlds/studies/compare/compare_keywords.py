"""The keywords of ``compare`` for type checkers, made from the fields of its request.

Types have no other way to describe keywords beside a list of explorers of any length.
``python tests/schemas/generate.py`` writes this module.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TypedDict

from allworlds.engines import Listener, Portion
from allworlds.judging import Bound, Judge, Task
from allworlds.maps import Condition
from allworlds.world import GivenLighthouse, Predicate


class SameWorldsKeywords(TypedDict, total=False):
    """The fields of a request but the explorers, for worlds that do not grow."""

    edges: int | None
    vertices: int | None
    map_class: str
    where: str | Predicate | Condition | Sequence[str | Predicate | Condition] | None
    family: str | Sequence[str] | None
    holes: str | None
    seed: int | None
    shard: tuple[int, int] | Portion | None
    lighthouse: GivenLighthouse | None
    task: str | Judge | Task
    policy: str
    bound: str | int | Bound | None
    laws: Iterable[str] | None
    step_budget: int | None
    answer_timeout: float
    start_timeout: float
    workers: int
    time_limit: float | None
    memory: int | None
    listener: Listener | None
    dask: str | None
    dask_timeout: float
    run: str | Path | None
    by: str | None


class CompareKeywords(SameWorldsKeywords, total=False):
    """All fields of a request but the explorers."""

    to: int | None
    worlds: int | None
    places: int | None
