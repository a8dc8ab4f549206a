"""Functions for test suites of users who have written an explorer, a lighthouse or a team.

``assert_explores``
    asserts that an explorer is right in every small world; fails with the text of the finding;
``assert_team``
    asserts that several robots reach their goal in every small world under every schedule;
``conformance``, ``assert_conforms``
    all tests that an explorer should pass: as parts with names, or in one call;
``assert_lighthouse``
    asserts that your own lighthouse gives equal percepts in equal worlds;
``known_hard_maps``
    maps that have refuted explorers before.

With pytest the mark ``allworlds`` makes one test for each number of edges::

    @pytest.mark.allworlds(edges=4)
    def test_my_explorer_is_right(explores):
        explores(my_explorer)

This module does not need pytest.  If pytest runs, the findings are kept in pytest's cache, and the
next check tries the worlds of these findings first.
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
"""The default bound on edges: a check of all worlds up to this bound takes about a second."""

LIGHTHOUSE_EDGES = 3
"""The default bound on edges for lighthouses."""

WIDTH = 100
PLUGIN = "_allworlds_pytest"

GIVEN = {field.name for field in fields(GivenOptions)}
"""The names of the options that give worlds instead of a class."""

Explorer: TypeAlias = str | Callable[..., Any]
"""A generator function, or a name as on the command line."""


def assert_explores(explore: Explorer, *, edges: int | None = None, **options: Any) -> CheckReport:
    """Assert that the explorer keeps every law in every small world, and return the report.

    If pytest has a cache, past findings of the same test are tried first, and new ones are kept.

    Args:
        explore: a generator function, or a name as on the command line.
        edges: the largest number of edges (default: 4, unless another bound or worlds are given).
        options: the options of :func:`allworlds.check`; with ``corpus=None`` no findings are kept.

    Raises:
        AssertionError: with the smallest finding and its picture; or with the reason why the check
            was not complete, or was vacuous.
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
        AssertionError: with the run of the smallest finding, or with a run that is longer than the
            budget allows.
        InputError: naming the offending option and what would be legal.
    """
    __tracebackhide__ = True
    bounds = {} if options.keys() & {"family", "world", "worlds", "graph"} else {"edges": edges}
    report = team(*programs, **bounds, **options)
    if report.verdict is not outcome.Verdict.HOLDS:
        raise AssertionError(f"\n{formats.text(report, WIDTH)}")
    return report


def levels_of(options: Mapping[str, Any]) -> Sequence[int]:
    """The numbers of edges that the maps of a check have, ascending; ``options`` are its options.

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
    """Words about the first of ``options`` that is no option of :func:`allworlds.check`.

    The text is empty if each of them is an option of that function.
    """
    known = inspect.signature(check).parameters.keys() - {"explore"}
    for name in options:
        if name not in known:
            return f"an unknown option {name!r}{did_you_mean(name, known)}"
    return ""


@dataclass(frozen=True, slots=True)
class AtLevel:
    """The value of pytest's fixture ``explores``: a call checks all worlds up to a number of edges.

    Worlds with fewer edges are tried first.  If one of them refutes the explorer, the failure says
    so in one line; the test for that smaller number of edges shows the finding.

    Attributes:
        edges: the number of edges.
        options: the options in the mark ``pytest.mark.allworlds``.
    """

    edges: int
    options: Mapping[str, Any]

    def __call__(self, explore: Explorer, **options: Any) -> CheckReport:
        """Do the same as :func:`assert_explores`, with the options in the mark and ``options``.

        If a world with fewer than ``edges`` edges refutes the explorer, the error is shorter: see
        the class.
        """
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
    """A part of the tests of :func:`conformance`; a call asserts that the explorer passes it.

    Attributes:
        name: a stable name that can be the id of a test.
        play: the function that asserts that the explorer passes.
    """

    name: str
    play: Callable[[], object]

    def __call__(self) -> None:
        """Try the explorer.

        Raises:
            AssertionError: with the finding and its picture, if the explorer does not pass.
        """
        __tracebackhide__ = True
        self.play()

    def __str__(self) -> str:
        return self.name


def conformance(
    explore: Explorer, *, edges: int = EDGES, drawn: int = 50, drawn_edges: int = 10, **options: Any
) -> list[Part]:
    """The tests that an explorer should pass, as parts, from the cheapest to the most expensive.

    ``known-hard-maps``: the maps of :func:`known_hard_maps`; the explorer starts at every dart,
    with every place of the lighthouse.  ``edges-1``, ``edges-2``, ...: a check of all worlds with
    at most that many edges.  ``every-schedule``: all sequences of choices in worlds with at most 2
    edges; this part exists only if the explorer is a function with a parameter ``choices``.
    ``drawn-maps``: maps that the library Hypothesis draws, with every start and every place of the
    lighthouse.

    With a condition ``where`` Hypothesis is not used: in the part ``drawn-maps`` the function
    :func:`allworlds.fuzz` draws maps that meet the condition, and tries one random start and one
    random place in each.  If a map refutes the explorer, smaller maps are tried, too.

    A file of tests can contain::

        @pytest.mark.parametrize("part", conformance(my_explorer, edges=4), ids=str)
        def test_my_explorer_conforms(part):
            part()

    Args:
        explore: a generator function, or a name as on the command line.
        edges: the largest number of edges of the worlds that are all tried.
        drawn: the number of maps in the part ``drawn-maps``; every call draws the same maps.
        drawn_edges: the largest number of edges of these maps.
        options: class, lighthouse, rules and effort: options of :func:`allworlds.check`.
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
    """Assert that the explorer passes every part of :func:`conformance`, with the same arguments.

    Raises:
        AssertionError: naming the first part that the explorer does not pass, with the finding.
    """
    __tracebackhide__ = True
    for part in conformance(explore, edges=edges, **options):
        try:
            part()
        except AssertionError as error:
            raise AssertionError(f"{part}: {error}") from None


def assert_lighthouse(lighthouse: GivenLighthouse, *, edges: int = LIGHTHOUSE_EDGES) -> None:
    """Assert that a lighthouse depends on nothing but the world, in every small map.

    The following rules are tested.  No place occurs twice.  Two calls of a method return the same.
    If the darts get other names, the places, their order, the percepts, and the value told to the
    explorer stay the same.  The lighthouse gives marks and bearings only if its class says so.  If
    a lighthouse is written as JSON and read again, the result is an equal lighthouse.  The
    lighthouse has a place in at least one map with at most ``edges + 1`` edges.

    Args:
        lighthouse: a class, or a name as on the command line.
        edges: the largest number of edges.

    Raises:
        AssertionError: naming the map, the place, and what differs.
        InputError: if the argument is no lighthouse, or if one of its methods raises.
    """
    __tracebackhide__ = True
    kind = lighthouse_kind(lighthouse)
    for wrong in selection.flaws_of(kind, edges):
        raise AssertionError(wrong)


def known_hard_maps() -> list[CombinatorialMap]:
    """The maps of the corpus that comes with the package, each once.

    A map is in the corpus because it has refuted an explorer, because under some lighthouses it
    looks like another map, or because it is a well-known map, such as K4 or the cube.
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
    """Those of the ``options`` of a check, by name, that are fields of :class:`MapsRequest`.

    A :class:`MapsRequest` asks for runs in maps that are given one by one.  Other options, such as
    the bound ``edges``, have no meaning there, and are left out.
    """
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
    """Check an explorer, past findings first, and return the report.

    Past findings in pytest's cache that do not refute any more are deleted there.  ``options`` are
    the options of :func:`allworlds.check`.
    """
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
    """The bounds on edges and vertices in the options of a check.

    If the options have neither a bound nor given worlds, the bound is :data:`EDGES` edges.
    """
    edges, vertices = options.get("edges"), options.get("vertices")
    unbounded = edges is None and vertices is None and not GIVEN & options.keys()
    return {"edges": EDGES if unbounded else edges, "vertices": vertices}


def _said(report: CheckReport) -> str:
    """The message about a report whose verdict is not ``holds``."""
    verdict = formats.brief(report, WIDTH)
    findings = [plain_text.finding_in_words(finding, WIDTH) for finding in report.findings]
    return "\n\n".join([verdict, *findings])
