"""Explorers under test in the test suite of their authors.

``assert_explores``
    asserts that an explorer is right in every small world; fails with the text of the finding;
``assert_team``
    asserts that several robots reach their goal in every small world under every schedule;
``conformance``, ``assert_conforms``
    all tests that an explorer should pass, as parts with names, or in one call;
``assert_lighthouse``
    asserts that your own lighthouse is a function of the world;
``known_hard_maps``
    maps that have refuted explorers before.

With pytest the mark ``allworlds`` makes one test for each number of edges::

    @pytest.mark.allworlds(edges=4)
    def test_my_explorer_is_right(explores):
        explores(my_explorer)

This module does not need pytest.  If pytest runs, its cache keeps past findings, and a check tries
their worlds first.
"""

import inspect
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import partial
from typing import Any, TypeAlias

from allworlds import outcome, words
from allworlds.inputs.checks import did_you_mean
from allworlds.judging.findings.finding import Finding
from allworlds.maps import classes, enumeration
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.notations.given import GivenOptions
from allworlds.protocol.importing import signature_of
from allworlds.reports import formats, plain_text
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import CheckReport
from allworlds.studies.fuzz.given_maps import MapsRequest, refuted_in
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.studies.team.search_sweep import team
from allworlds.studies.team.team_report import TeamReport
from allworlds.world import named, selection
from allworlds.world.lighthouses.kinds import GivenLighthouse, lighthouse_kind

__all__ = [
    "AtLevel",
    "Part",
    "assert_conforms",
    "assert_explores",
    "assert_lighthouse",
    "assert_team",
    "conformance",
    "known_hard_maps",
    "levels_of",
]

EDGES = 4
"""The default bound: every world with at most this many edges takes about a second."""

LIGHTHOUSE_EDGES = 3
"""The default bound on edges for lighthouses."""

WIDTH = 100
PLUGIN = "_allworlds_pytest"

GIVEN = {field.name for field in fields(GivenOptions)}
"""The options that give worlds instead of a class."""

Explorer: TypeAlias = str | Callable[..., Any]
"""A generator function, or a name as on the command line."""


def assert_explores(explore: Explorer, *, edges: int | None = None, **options: Any) -> CheckReport:
    """Assert that the explorer keeps every law in every small world, and return the report.

    If pytest has a cache, past findings of the same test are tried first, and new ones are kept.

    Args:
        explore: a generator function, or a name as on the command line.
        edges: the largest number of edges (default: 4, unless another bound or worlds are given).
        options: the options of :func:`allworlds.check`; ``corpus=None`` keeps no findings.

    Raises:
        AssertionError: with the smallest finding and its picture; or with the reason, if
            the check was not complete, or vacuous.
        InputError: naming the offending option and what would be legal.
    """
    __tracebackhide__ = True
    report = _checked(explore, {"edges": edges, **options})
    _assert_holds(report)
    return report


def assert_team(*programs: Explorer, edges: int = 3, **options: Any) -> TeamReport:
    """Assert that no law is broken in any schedule of several robots, and return the report.

    Args:
        programs: one program for all robots, or one for each.
        edges: the largest number of edges.
        options: the options of :func:`allworlds.team`.

    Raises:
        AssertionError: with the run of the smallest finding, or a run that the budget cuts off.
        InputError: naming the offending option and what would be legal.
    """
    __tracebackhide__ = True
    bounds = {} if options.keys() & {"family", "world", "worlds", "graph"} else {"edges": edges}
    report = team(*programs, **bounds, **options)
    if report.verdict is not outcome.Verdict.HOLDS:
        raise AssertionError(f"\n{formats.text(report, WIDTH)}")
    return report


def levels_of(options: Mapping[str, Any]) -> Sequence[int]:
    """The numbers of edges of the maps that these options name, ascending.

    Raises:
        InputError: naming the offending option and what would be legal.
    """
    bounds = _bounds(options)
    map_class = classes.MapClass.named(options.get("map_class", classes.MapClass.MAPS.value))
    where = selection.a_condition(options.get("where"))
    given = GivenOptions(**{key: options[key] for key in GIVEN & options.keys()}).given
    extent = classes.Extent(map_class, bounds["edges"], bounds["vertices"], where, given)
    if given is not None:
        return extent.levels
    first, last = extent.levels[0], extent.levels[-1]
    while where is not None and first < last and not _any_map(extent, first):
        first += 1
    return range(first, last + 1)


def _any_map(extent: classes.Extent, edges: int) -> bool:
    found = enumeration.rooted_maps(edges, extent.map_class, extent.vertices, where=extent.where)
    return next(found, None) is not None


def unknown_option(options: Mapping[str, Any]) -> str:
    """The first option that :func:`allworlds.check` does not take; empty if it takes all."""
    known = inspect.signature(check).parameters.keys() - {"explore"}
    for name in options:
        if name not in known:
            return f"an unknown option {name!r}{did_you_mean(name, known)}"
    return ""


@dataclass(frozen=True, slots=True)
class AtLevel:
    """The value of the fixture ``explores``: :func:`assert_explores` at one number of edges.

    Worlds with fewer edges are tried first.  If one of them refutes the explorer, the failure says
    so in a line; the test of that number of edges shows the finding.

    Attributes:
        edges: the number of edges.
        options: the options of the mark.
    """

    edges: int
    options: Mapping[str, Any]

    def __call__(self, explore: Explorer, **options: Any) -> CheckReport:
        """Call :func:`assert_explores` with the options of the mark and these."""
        __tracebackhide__ = True
        report = _checked(explore, {**self.options, **options, "edges": self.edges})
        smaller = [found for found in report.findings if found.key[0] < self.edges]
        if smaller:
            edges = smaller[0].key[0]
            raise AssertionError(
                f"REFUTED: law {smaller[0].law} is broken already in a world with "
                f"{words.plural(edges, 'edge')}: see the test edges-{edges}"
            )
        _assert_holds(report)
        return report


@dataclass(frozen=True, slots=True)
class Part:
    """A part of the conformance kit; calling it asserts that the explorer passes.

    Attributes:
        name: a stable name that can be the id of a test.
        play: the function that asserts it.
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
    explore: Explorer, *, edges: int = EDGES, drawn: int = 50, drawn_edges: int = 10, **options: Any
) -> list[Part]:
    """The parts of the conformance kit, from the cheapest to the most expensive.

    ``known-hard-maps``: every start and marker in the maps that have refuted explorers before.
    ``edges-1``, ``edges-2``, ...: every world with that many edges, under every law that applies.
    ``every-schedule``: all sequences of choices with at most 2 edges, for a function that takes
    ``choices``.  ``drawn-maps``: every start and marker in maps that Hypothesis draws, or under
    a condition a start and a marker in random maps of which it is true; a refuting map is shrunk.
    As tests::

        @pytest.mark.parametrize("part", conformance(my_explorer, edges=4), ids=str)
        def test_my_explorer_conforms(part):
            part()

    Args:
        explore: a generator function, or a name as on the command line.
        edges: the largest number of edges of the worlds that are all tried.
        drawn: the number of maps that are drawn, equal in each run.
        drawn_edges: the largest number of edges of these.
        options: class, lighthouse, rules and effort, as :func:`allworlds.check` takes them.
    """
    levels = levels_of({**options, "edges": edges})
    parts = [Part("known-hard-maps", partial(_known, explore, options))]
    parts += [Part(f"edges-{level}", partial(AtLevel(level, options), explore)) for level in levels]
    if callable(explore) and "choices" in signature_of(explore).parameters:
        every = {**options, "edges": min(edges, 2), "schedules": "all"}
        parts.append(Part("every-schedule", partial(assert_explores, explore, **every)))
    parts.append(Part("drawn-maps", partial(_drawn, explore, drawn, drawn_edges, options)))
    return parts


def assert_conforms(explore: Explorer, *, edges: int = EDGES, **options: Any) -> None:
    """Assert that the explorer passes every part of :func:`conformance`; the arguments are equal.

    Raises:
        AssertionError: naming the first part that it does not pass, with the finding.
    """
    __tracebackhide__ = True
    for part in conformance(explore, edges=edges, **options):
        try:
            part()
        except AssertionError as error:
            raise AssertionError(f"{part}: {error}") from None


def assert_lighthouse(lighthouse: GivenLighthouse, *, edges: int = LIGHTHOUSE_EDGES) -> None:
    """Assert that a lighthouse is a function of the world in every small map.

    Each place is there once. Asked twice it senses and tells the same. Under other names of the
    darts there are the same places in the same order, and the same is sensed and told there. The
    lighthouse gives marks and bearings only if it says so. It is read again as it was written, and
    has a place in some map with one edge more at most.

    Args:
        lighthouse: a class, or a name as on the command line.
        edges: the largest number of edges.

    Raises:
        AssertionError: naming the map, the place, and what differs.
        InputError: if it is no lighthouse, or a method of it raises.
    """
    __tracebackhide__ = True
    kind = lighthouse_kind(lighthouse)
    for wrong in selection.flaws_of(kind, edges):
        raise AssertionError(wrong)


def known_hard_maps() -> list[CombinatorialMap]:
    """The maps of the corpus that comes with the package, each once.

    They have refuted explorers, look like another map to some of them, or are the smallest of
    their kind.
    """
    corpus = named.own_corpus()
    documents = [corpus.document(entry) for entry in corpus.of_kind("world")]
    documents += [corpus.document(entry)["world"] for entry in corpus.of_kind("finding")]
    for entry in corpus.of_kind("pair"):
        documents += corpus.document(entry)["worlds"]
    return [*{CombinatorialMap(world["sigma"], world["alpha"]): None for world in documents}]


def _known(explore: Explorer, options: Mapping[str, Any]) -> None:
    __tracebackhide__ = True
    _assert_no(refuted_in(known_hard_maps(), MapsRequest(explore, **_of_maps(options))))


def _drawn(explore: Explorer, count: int, edges: int, options: Mapping[str, Any]) -> None:
    __tracebackhide__ = True
    from allworlds.strategies import sampled_maps

    named = _of_maps(options)
    if named.get("where") is not None:
        report = fuzz(explore, edges=edges, runs=count, **named).uninterrupted()
        if report.verdict is not outcome.Verdict.NOT_REFUTED:
            raise AssertionError(_said(report))
        return
    map_class = options.get("map_class", classes.MapClass.MAPS.value)
    maps = sampled_maps(map_class, edges, count)
    _assert_no(refuted_in(maps, MapsRequest(explore, **named)))


def _of_maps(options: Mapping[str, Any]) -> dict[str, Any]:
    """The options that are not of an exhaustive check alone."""
    named = {field.name for field in fields(MapsRequest)}
    return {key: options[key] for key in options if key in named}


# Raised, not asserted: pytest rewrites the assertions of a package that has a plugin, and would
# indent the message.


def _assert_no(finding: Finding | None) -> None:
    __tracebackhide__ = True
    if finding is not None:
        text = plain_text.finding_in_words(finding, WIDTH)
        raise AssertionError(f"REFUTED: law {finding.law} is broken\n\n{text}")


def _assert_holds(report: CheckReport) -> None:
    __tracebackhide__ = True
    if report.verdict is not outcome.Verdict.HOLDS:
        raise AssertionError(_said(report))


def _checked(explore: Explorer, options: Mapping[str, Any]) -> CheckReport:
    """The report of a check, after past findings; those that are fixed are forgotten."""
    given = {**options, **_bounds(options)}
    if "corpus" not in given and "run" not in given:
        plugin = sys.modules.get(PLUGIN)
        given["corpus"] = plugin and plugin.corpus_of_test()
    report = check(explore, **given).uninterrupted()
    if report.past and "corpus" not in options:
        for name in report.past.files["fixed"]:
            (report.past.directory / name).unlink(missing_ok=True)
    return report


def _bounds(options: Mapping[str, Any]) -> dict[str, Any]:
    """The edges and vertices of a check; the default bound if it has none, and no worlds."""
    edges, vertices = options.get("edges"), options.get("vertices")
    unbounded = edges is None and vertices is None and not GIVEN & options.keys()
    return {"edges": EDGES if unbounded else edges, "vertices": vertices}


def _said(report: CheckReport) -> str:
    """The text about a report whose verdict is not that the laws hold."""
    verdict = formats.brief(report, WIDTH)
    findings = [plain_text.finding_in_words(finding, WIDTH) for finding in report.findings]
    return "\n\n".join([verdict, *findings])
