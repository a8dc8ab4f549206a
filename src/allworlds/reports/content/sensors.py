"""Content of reports about sensors: lighthouses side by side, and the weakest sensors.

Each lighthouse is a *sensor*; a coarsening of its letters is another one.  A sensor *suffices* if
it tells all different worlds of the scope apart.  A sensor *tells at least as much* as another one
if it tells apart all worlds that the other one tells apart.
"""

from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap

from allworlds import words
from allworlds.maps.classes import Extent
from allworlds.reports import parts
from allworlds.reports.content.ambiguity import alike
from allworlds.reports.content.scope import each_of, of_the_class
from allworlds.studies.ambiguity.coarsenings import AmbiguityWeakest
from allworlds.studies.ambiguity.side_by_side import AlikePair, AmbiguitySensors

Pairs = Sequence[Sequence[str]]


WIDTH = 90
"""The width, in columns, of the text that shows the order of sensors."""


def sensors_content(found: AmbiguitySensors) -> parts.ReportContent:
    """The content for sensors: a row for each sensor, the order of sensors, the smallest twins.

    In the order, a sensor stands above each sensor that tells less.  Two sensors are compared only
    if their lighthouses can stand at the same places.
    """
    enough = [row.lighthouse for row in found.rows if row.sufficient]
    header = ["sensor", "suffices", "minimal", "edges of least twins", "lookalikes there"]
    rows: list[list[parts.Cell]] = [
        [
            row.lighthouse,
            {True: "yes", False: "no", None: "no world"}[row.sufficient],
            "yes" if row.lighthouse in found.minimal else "",
            row.first,
            row.ambiguous or None,
        ]
        for row in found.rows
    ]
    order = "\n".join(_drawn(found.dominates, [row.lighthouse for row in found.rows]))
    said = (
        "A sensor that tells less stands lower: worlds that look alike under the upper sensor also "
        "look alike under the lower one. Sensors joined by '=' tell the same in the end, but one "
        "of them may need more steps."
    )
    blocks: list[parts.Block] = [
        parts.Table(header, rows, "Sensors"),
        parts.fact("scope", _scope(found.extent)),
        parts.FactList([(row.lighthouse, row.tried or "") for row in found.rows]),
    ]
    ordered: list[parts.Block] = [parts.Paragraph(said), parts.Quote("order", "The order", order)]
    if less := [*_less_at_a_step(found)]:
        ordered.append(parts.FactList([("steps", sentence) for sentence in less]))
    sections = [parts.Section("seen", "", blocks)]
    sections += [parts.Section("order", "Which tells more", ordered)] if order else []
    named = [(row.lighthouse, row.twins) for row in found.rows if row.twins]
    said_enough = (
        f"{len(enough)} of {words.plural(len(found.rows), 'sensor')} suffice in every world "
        f"{of_the_class(found.extent)}"
    )
    return parts.ReportContent(
        "allworlds ambiguity sensors",
        words.plural(len(found.rows), "sensor"),
        found,
        parts.Headline("SENSORS", f"{said_enough}{': ' * bool(enough)}{', '.join(enough)}"),
        [*sections, *_pictures(named)],
        rows=lambda: parts.CsvRows.of(
            found.rows, lighthouse=str, sufficient=bool, first=int, ambiguous=int, worlds=int
        ),
    )


def _scope(extent: Extent) -> str:
    maps = "every start in each rooted map" if extent.given is None else each_of(extent.given)
    return (
        f"{maps} {of_the_class(extent)}, every place of the lighthouse; a sensor suffices if no "
        "two different worlds look alike: neither two maps, nor one map with two starts"
    )


def _drawn(dominates: Pairs, names: Sequence[str]) -> Iterator[str]:
    """Yield the lines of a text in which a sensor that tells less stands lower.

    Sensors that tell the same worlds apart share a line, joined by ``=``.  Below this line, farther
    to the right, stand the sensors that tell less.  A sensor may stand below several others.  A
    sensor that is in no pair of ``dominates`` is left out.  A long line is wrapped.

    Args:
        dominates: pairs of sensors; the first one tells at least as much as the second one.
        names: the names of all sensors.
    """
    above = {name: {a for a, b in dominates if b == name} for name in names}
    below = {name: {b for a, b in dominates if a == name} for name in names}
    first = [
        name
        for i, name in enumerate(names)
        if above[name] | below[name] and not {*names[:i]} & above[name] & below[name]
    ]

    def lines(name: str, depth: int) -> Iterator[str]:
        same = [each for each in names if each == name or each in above[name] & below[name]]
        begin = "   " * depth
        yield from wrap(
            " = ".join(same), WIDTH, initial_indent=begin, subsequent_indent=f"{begin} = "
        )
        under = [each for each in first if each in below[name] - above[name]]
        for each in under:
            if not any(each in below[other] - above[other] for other in under):
                yield from lines(each, depth + 1)

    for name in first:
        if not above[name] - below[name]:
            yield from lines(name, 0)


def _less_at_a_step(found: AmbiguitySensors) -> Iterator[str]:
    """Yield a sentence for each sensor that senses less at once, but in the end tells as much.

    Sensor A senses less than sensor B if, at each dart, the percept of A follows from that of B,
    while the percept of B does not always follow from that of A.  A tells as much as B if all
    worlds that B tells apart by any number of motions are told apart by A, too.
    """
    for row in found.rows:
        less = row.lighthouse
        more = [b for a, b in found.coarser if a == less and (b, a) not in found.coarser]
        more = [each for each in more if (less, each) in found.dominates]
        if more:
            yield f"in one step {less} tells less than {words.listed(more)}, after many as much"


def _pictures(named: Iterable[tuple[str, AlikePair]]) -> Iterator[parts.Section]:
    """Yield a section for each pair of worlds; its title names sensors under which they look alike.

    ``named`` holds pairs of a sensor's name and the two worlds.
    """
    groups: dict[tuple[object, ...], tuple[AlikePair, list[str]]] = {}
    for name, pair in named:
        key = (*((world.map, world.start) for world in pair.worlds), pair.bisimulation)
        groups.setdefault(key, (pair, []))[1].append(name)
    for number, (pair, names) in enumerate(groups.values(), 1):
        walk = alike("AB", pair.shown, pair.bisimulation)
        title = f"Worlds that look alike under {' and '.join(map(repr, names))}"
        yield parts.Section(f"walk-{number}", title, [walk])


def weakest_content(found: AmbiguityWeakest) -> parts.ReportContent:
    """The content for the weakest sensors: minimal coarsenings, and twins under coarser sensors.

    A coarsening is made from a finer sensor: some letters of the finer sensor become one letter.  A
    coarsening is minimal if it suffices, but no longer suffices after any two of its own letters
    become one.  For each such pair of letters, the report shows twins that look alike then.
    """
    rows: list[list[parts.Cell]] = [
        [
            len(one.letters),
            _letters(one.letters),
            ", ".join(str(found.refuted[number].edges) for number in one.below),
        ]
        for one in found.minimal
    ]
    said = (
        f"{found.sufficient} of {words.plural(found.coarsenings, 'coarsening')} suffice, "
        f"in every world {of_the_class(found.extent)}, {len(found.minimal)} of them minimal"
    )
    header = ["letters", "their features, parted by |", "edges of these twins"]
    table = parts.Table(header, rows, "Minimal sensors: if two letters become one, twins exist")
    seen = parts.Section("seen", "", [table, parts.fact("scope", _scope(found.extent))])
    return parts.ReportContent(
        "allworlds ambiguity weakest",
        found.scope.finest,
        found,
        parts.Headline("WEAKEST", said),
        [seen, *_pictures((_letters(one.letters), one.twins) for one in found.refuted)],
        rows=lambda: parts.CsvRows(
            {"letters": int, "features": str},
            [[len(one.letters), _letters(one.letters)] for one in found.minimal],
        ),
    )


def _letters(blocks: Sequence[Sequence[str]]) -> str:
    return " | ".join(" ".join(block) for block in blocks)
