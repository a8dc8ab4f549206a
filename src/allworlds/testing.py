"""Explorers under test in the test suite of their authors.

``assert_explores``
    an explorer is right in every small world, or an assertion fails with the finding as text;
``conformance``, ``assert_conforms``
    all that an explorer is to be put through, as parts with names, or in one call;
``known_hard_maps``
    maps that have refuted explorers before.

With pytest the mark ``allworlds`` makes one test for each number of edges::

    @pytest.mark.allworlds(edges=4)
    def test_my_explorer_is_right(explores):
        explores(my_explorer)

Nothing here needs pytest.  Where it runs, past findings are kept in its cache and tried first.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias

from allworlds.judging import Finding
from allworlds.maps import CombinatorialMap, Extent, MapClass
from allworlds.outcome import Verdict
from allworlds.reports import brief, finding_in_words
from allworlds.studies.check import CheckReport, ManyRuns, check
from allworlds.studies.fuzz import refuted_in
from allworlds.words import plural
from allworlds.world import own_corpus

__all__ = [
    "AtLevel",
    "Part",
    "assert_conforms",
    "assert_explores",
    "conformance",
    "known_hard_maps",
    "levels_of",
]

EDGES = 4
"""The bound where none is named: every world with so many edges takes about a second."""

WIDTH = 100
PLUGIN = "_allworlds_pytest"

Explorer: TypeAlias = str | Callable[..., Any]
"""A generator function, or a name as on the command line."""


def assert_explores(explore: Explorer, *, edges: int | None = None, **options: Any) -> CheckReport:
    """Nothing but the report, if the explorer keeps every law in every small world.

    Past findings of the same test are tried first, and new ones kept, where pytest has a cache.

    Args:
        explore: a generator function, or a name as on the command line.
        edges: the largest number of edges (default: 4, where no other bound is named).
        options: those of :func:`allworlds.check`; ``corpus=None`` keeps no findings.

    Raises:
        AssertionError: with the smallest finding and its picture; or, if nothing can be said
            because the check was not complete or vacuous, with the reason.
        InputError: naming the offending option and what would be legal.
    """
    __tracebackhide__ = True
    report = _checked(explore, {"edges": edges, **options})
    _assert_holds(report)
    return report


def levels_of(options: Mapping[str, Any]) -> range:
    """The numbers of edges in the extent that these options name.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    bounds = _bounds(options)
    map_class = MapClass.named(options.get("map_class", MapClass.MAPS.value))
    levels = Extent(map_class, bounds["edges"], bounds.get("vertices")).levels
    return range(levels[0], levels[-1] + 1)


@dataclass(frozen=True, slots=True)
class AtLevel:
    """What the fixture ``explores`` is: :func:`assert_explores` at one number of edges.

    Worlds with fewer edges are tried on the way.  If one of them refutes the explorer already,
    that is told in a line, and in whole by the test of that number of edges.

    Attributes:
        edges: their number.
        options: of the mark.
    """

    edges: int
    options: Mapping[str, Any]

    def __call__(self, explore: Explorer, **options: Any) -> CheckReport:
        """As :func:`assert_explores`, with the options of the mark and these."""
        __tracebackhide__ = True
        report = _checked(explore, {**self.options, **options, "edges": self.edges})
        smaller = [found for found in report.findings if found.key[0] < self.edges]
        if smaller:
            edges = smaller[0].key[0]
            raise AssertionError(
                f"refuted already in a world with {plural(edges, 'edge')}, by the law "
                f"'{smaller[0].law}': see the test edges-{edges}"
            )
        _assert_holds(report)
        return report


@dataclass(frozen=True, slots=True)
class Part:
    """A part of the conformance kit; calling it asserts that the explorer passes.

    Attributes:
        name: stable, and fit for the id of a test.
        play: does it.
    """

    name: str
    play: Callable[[], object]

    def __call__(self) -> None:
        """Play it.

        Raises:
            AssertionError: with the finding and its picture.
        """
        __tracebackhide__ = True
        self.play()

    def __str__(self) -> str:
        return self.name


def conformance(
    explore: Explorer,
    *,
    edges: int = EDGES,
    drawn: int = 50,
    drawn_edges: int = 10,
    **options: Any,
) -> list[Part]:
    """All that an explorer is to be put through, in the order from cheap to dear.

    ``known-hard-maps``: every start and marker in the maps that have refuted explorers before.
    ``edges-1``, ``edges-2``, ...: every world with so many edges, under every law that applies.
    ``every-schedule``: all sequences of choices with at most 2 edges, for a function that takes
    ``choices``.  ``drawn-maps``: every start and marker in maps that Hypothesis draws; what
    refutes is shrunk.  As tests::

        @pytest.mark.parametrize("part", conformance(my_explorer, edges=4), ids=str)
        def test_my_explorer_conforms(part):
            part()

    Args:
        explore: a generator function, or a name as on the command line.
        edges: the largest number of edges of the worlds that are all tried.
        drawn: how many maps are drawn, the same every time.
        drawn_edges: the largest number of edges of these.
        options: class, lighthouse, rules and effort, as :func:`allworlds.check` takes them.
    """
    levels = levels_of({**options, "edges": edges})
    parts = [Part("known-hard-maps", partial(_known, explore, options))]
    parts += [Part(f"edges-{level}", partial(AtLevel(level, options), explore)) for level in levels]
    if callable(explore) and "choices" in inspect.signature(explore).parameters:
        every = {**options, "edges": min(edges, 2), "schedules": "all"}
        parts.append(Part("every-schedule", partial(assert_explores, explore, **every)))
    parts.append(Part("drawn-maps", partial(_drawn, explore, drawn, drawn_edges, options)))
    return parts


def assert_conforms(explore: Explorer, *, edges: int = EDGES, **options: Any) -> None:
    """Nothing, if the explorer passes every part of :func:`conformance`, which takes the same.

    Raises:
        AssertionError: naming the first part that it does not pass, with the finding.
    """
    __tracebackhide__ = True
    for part in conformance(explore, edges=edges, **options):
        try:
            part()
        except AssertionError as error:
            raise AssertionError(f"{part}: {error}") from None


def known_hard_maps() -> list[CombinatorialMap]:
    """The maps of the corpus that comes with the package, each once.

    They have refuted explorers, look like another map to some of them, or are the smallest of
    their kind.
    """
    corpus = own_corpus()
    documents = [corpus.document(entry) for entry in corpus.of_kind("world")]
    documents += [corpus.document(entry)["world"] for entry in corpus.of_kind("finding")]
    for entry in corpus.of_kind("pair"):
        documents += corpus.document(entry)["worlds"]
    return [*{CombinatorialMap(world["sigma"], world["alpha"]): None for world in documents}]


def _known(explore: Explorer, options: Mapping[str, Any]) -> None:
    __tracebackhide__ = True
    _assert_no(refuted_in(known_hard_maps(), _many_runs(explore, options)))


def _drawn(explore: Explorer, count: int, edges: int, options: Mapping[str, Any]) -> None:
    __tracebackhide__ = True
    from allworlds.strategies import sampled_maps

    map_class = options.get("map_class", MapClass.MAPS.value)
    _assert_no(refuted_in(sampled_maps(map_class, edges, count), _many_runs(explore, options)))


def _many_runs(explore: Explorer, options: Mapping[str, Any]) -> ManyRuns:
    """Those of the options that are not of an exhaustive check alone."""
    named = {field.name for field in fields(ManyRuns)}
    return ManyRuns(explore, **{key: options[key] for key in options if key in named})


# Raised, not asserted: pytest rewrites the assertions of a package that has a plugin, and would
# indent what is told.


def _assert_no(finding: Finding | None) -> None:
    __tracebackhide__ = True
    if finding is not None:
        raise AssertionError("\n" + finding_in_words(finding, WIDTH))


def _assert_holds(report: CheckReport) -> None:
    __tracebackhide__ = True
    if report.verdict is not Verdict.HOLDS:
        raise AssertionError(_said(report))


def _checked(explore: Explorer, options: Mapping[str, Any]) -> CheckReport:
    """The report of a check, after past findings; those that are fixed are forgotten."""
    given = {**options, **_bounds(options)}
    if "corpus" not in given and "run" not in given:
        given["corpus"] = _corpus_of_test()
    report = check(explore, **given).uninterrupted()
    if report.past and "corpus" not in options:
        for name in report.past.fixed:
            (report.past.directory / name).unlink(missing_ok=True)
    return report


def _bounds(options: Mapping[str, Any]) -> dict[str, Any]:
    """The edges and vertices of a check; a bound of our own where it has none."""
    edges, vertices = options.get("edges"), options.get("vertices")
    return {"edges": EDGES if edges is None and vertices is None else edges, "vertices": vertices}


def _corpus_of_test() -> Path | None:
    """Where pytest's cache keeps past findings of the running test, if pytest runs one."""
    plugin = sys.modules.get(PLUGIN)
    return None if plugin is None else plugin.corpus_of_test()


def _said(report: CheckReport) -> str:
    """What is told of a report that is no good news."""
    verdict = brief("check", report, WIDTH)
    return "\n" + "\n\n".join(
        [*(finding_in_words(finding, WIDTH) for finding in report.findings), verdict]
    )
