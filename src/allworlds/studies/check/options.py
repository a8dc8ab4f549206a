"""The options that ``run``, ``check``, ``fuzz`` and ``compare`` share, beside the rules."""

from __future__ import annotations

from typing import Any

from allworlds.engines import EffortOptions
from allworlds.explorers import Subject
from allworlds.judging import LAWS, Rules, RulesOptions, make_rules
from allworlds.maps import DEFAULT_EDGES, FORMS, MapClass
from allworlds.protocol import ANSWER_TIMEOUT, DEFAULT_POLICY, POLICIES, SEEDED
from allworlds.world import LIGHTHOUSES

LEGAL: dict[str, tuple[str, ...]] = {
    "map_class": tuple(MapClass),
    "lighthouse": tuple(LIGHTHOUSES),
    "policy": (*POLICIES, SEEDED),
    "laws": tuple(LAWS),
    "family": tuple(FORMS.split(", ")),
}
"""The legal names of each option that takes one of a few."""

DEFAULTS: dict[str, Any] = {
    "edges": DEFAULT_EDGES,
    "policy": DEFAULT_POLICY,
    "answer_timeout": ANSWER_TIMEOUT,
}
"""The value of each option that is left out."""


class RunOptions(RulesOptions, total=False):
    """What ``run`` takes beside the rules.

    Attributes:
        answer_timeout: seconds of silence after which the explorer is killed (default 10).
    """

    answer_timeout: float


class ManyRunsOptions(RulesOptions, EffortOptions, total=False):
    """What ``check`` and ``fuzz`` take beside the rules and the effort.

    Attributes:
        map_class: one of :class:`~allworlds.maps.classes.MapClass` (default ``maps``).
        lighthouse: ``KIND[:key=value,...]``; None (default) takes the explorer's own, which is
            ``directional`` unless a built-in explorer is written for another.
    """

    map_class: str
    lighthouse: str | None


class CheckOptions(ManyRunsOptions, total=False):
    """What says which check is meant, and with what effort: that is done, or its time guessed.

    Attributes:
        edges: the largest number of edges; None (default) for one that takes seconds, unless
            the vertices are bounded.
        vertices: the largest number of vertices; None (default) for any.
        schedules: ``one`` (default) or ``all``.
        shard: ``(K, N)``: only the K-th of N parts of about equal weight, from 0; None
            (default) for the whole.
        engine: ``auto`` (default), ``python`` or ``kernel``.
        dask: the address of a Dask scheduler, or ``local``; None (default) for this machine.
    """

    edges: int | None
    vertices: int | None
    schedules: str
    shard: tuple[int, int] | None
    engine: str
    dask: str | None


def refuse_others(function: str, options: object, legal: type) -> None:
    """Nothing, if these keywords are all legal; Python lets every one pass where they are packed.

    Raises:
        TypeError: as Python does, naming the first that is none.
    """
    assert isinstance(options, dict)
    for key in options:
        if key not in legal.__annotations__:
            raise TypeError(f"{function}() got an unexpected keyword argument {key!r}")


def rules_for(subject: Subject, options: ManyRunsOptions) -> tuple[MapClass, Rules]:
    """The class of maps, and the rules under which the explorer is run in it.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    map_class = MapClass.named(options.get("map_class", "maps"))
    lighthouse = options.get("lighthouse")
    if lighthouse is None:
        lighthouse = subject.lighthouse
    return map_class, own_rules(subject, options, lighthouse, promised=map_class.promises)


def own_rules(
    subject: Subject, options: RulesOptions, lighthouse: str, *, promised: bool = False
) -> Rules:
    """The rules of a verb's options, with the bound and the budget that the explorer brings."""
    given = options
    if options.get("step_budget") is None and subject.step_budget is not None:
        given = {**options, "step_budget": subject.step_budget}
    return make_rules(given, lighthouse, subject.bound_under(lighthouse), promised=promised)
