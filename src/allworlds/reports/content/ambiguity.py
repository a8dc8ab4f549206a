"""Content of reports about worlds that look alike: twins, classes, censuses and searches.

An *ambiguity class* holds all worlds with one rooted quotient.  The darts of such worlds are
divided into *classes of darts*: no motion tells two darts of the same class apart.  A *census*
counts the worlds that look like others.
"""

from collections.abc import Sequence
from string import ascii_lowercase

from msgspec import UNSET

from allworlds import words
from allworlds.documents import document as doc
from allworlds.judging.explanations.story import Walked
from allworlds.judging.walk import Walk
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.maps.quotient import Quotient
from allworlds.protocol import actions
from allworlds.reports import parts
from allworlds.reports.content.scope import finished, gate_facts, maps_in_words
from allworlds.studies.ambiguity import census_sweep, twin_search
from allworlds.studies.ambiguity.members import AmbiguityClass, ComparedWorlds, projection_of
from allworlds.world.lighthouses.marked import Position
from allworlds.world.world import World

FIRST_DIFFER = "by the first percepts, before any motion"
DRAWN = 6
"""The largest number of worlds of a class that are drawn."""

ALIKE = (
    "Darts with the same letter cannot be told apart: the robot senses the same at each of them, "
    "and every motion leads from them to darts that again have the same letter."
)
WHY_ALIKE = ". Darts of one class look alike, so no motion tells the worlds apart"
TOURED = (
    "So on this walk, which goes along every edge of each world, the robot senses the same in all "
    "these worlds, as on any other walk."
)


def twins_content(comparison: ComparedWorlds) -> parts.ReportContent:
    """The content for two worlds: the walk that tells them apart, or their common quotient."""
    worlds, classes = comparison.worlds, comparison.bisimulation
    blocks: list[parts.Block]
    if classes is UNSET:
        title = "The shortest walk that tells the worlds apart"
        sentence = "At the end of this walk the robot senses different things in A and in B."
        if comparison.told is not UNSET:
            sentence = "The robot knows which world it is in before it moves."
        scenes = [parts.scene_of(world) for world in worlds]
        blocks = [_walk("AB", worlds, scenes, comparison.motions or (), [sentence])]
    else:
        title = "Darts with the same letter look alike"
        blocks = [alike("AB", worlds, classes), *_quotient(projection_of(worlds[0]).quotient)]
    return parts.ReportContent(
        "allworlds ambiguity twins",
        "A and B",
        comparison,
        _answer(comparison),
        [parts.Section("walk-1", title, blocks)],
        rows=None if classes is UNSET else lambda: _rows(worlds, classes or ()),
    )


def _rows(worlds: Sequence[World], classes: Sequence[Sequence[int]]) -> parts.CsvRows:
    """A row for each dart of each world, with the class of the dart.

    No motion tells two darts of one class apart.  ``classes`` has for each world the class of each
    dart.
    """
    named = any(world.labels.vertices for world in worlds)
    rows: list[list[parts.CellValue]] = [
        [number, dart, v, of_world[dart], *([world.labels.vertex(v)] if named else [])]
        for number, (world, of_world) in enumerate(zip(worlds, classes, strict=True), 1)
        for dart, v in enumerate(world.map.vertex_of)
    ]
    columns: dict[str, type] = {"world": int, "dart": int, "vertex": int, "class": int}
    return parts.CsvRows(columns | ({"name": str} if named else {}), rows)


def _answer(comparison: ComparedWorlds) -> parts.Headline:
    if comparison.told is not UNSET:
        one, other = comparison.told
        said = f"by 0 motions: before the start the robot is told {one} in A, {other} in B"
        return parts.Headline("TOLD APART", said, "holds")
    if comparison.motions is not UNSET:
        count = words.plural(len(comparison.motions), "motion")
        motions = ", ".join(map(str, comparison.motions))
        said = f"by {count}, and by no fewer: {motions}" if motions else FIRST_DIFFER
        return parts.Headline("TOLD APART", said, "holds")
    word, what, why = {
        "same": ("SAME", "A and B are one world, with the same start", ""),
        "same-map": ("ALIKE", "one world, entered at two darts that look alike", WHY_ALIKE),
        "different": ("TWINS", "two different worlds", WHY_ALIKE),
    }[comparison.relation]
    covers = _covers([projection_of(world).quotient for world in comparison.worlds])
    return parts.Headline(word, f"{what}; {covers}{why}", "vacuous")


def class_content(found: AmbiguityClass) -> parts.ReportContent:
    """The content for an ambiguity class: its size, some of its worlds, and their quotient."""
    worlds = found.worlds[:DRAWN]
    names = ["The given world", *(f"World {i}" for i in range(2, len(worlds) + 1))]
    classes = [projection_of(world).classes for world in found.worlds]
    quotient = _quotient(projection_of(found.world).quotient)
    blocks: list[parts.Block] = [alike(names, worlds, classes[:DRAWN])]
    if len(found.worlds) > DRAWN:
        left = words.number(len(found.worlds) - DRAWN)
        blocks.append(parts.Paragraph(f"{left} more worlds: --json lists them."))
    if found.notice:
        blocks.append(parts.Paragraph(f"{found.notice}."))
    poses = f"{words.number(found.poses)}: pairs of a world and a dart where the robot may be"
    return parts.ReportContent(
        "allworlds ambiguity class",
        "one world",
        found,
        _size_of(found),
        [
            parts.Section(
                "walk-1", "Worlds that look alike", [*blocks, parts.fact("poses", poses), *quotient]
            )
        ],
        rows=lambda: _rows(found.worlds, classes),
    )


def _size_of(found: AmbiguityClass) -> parts.Headline:
    universe = f"in the class '{found.map_class}'"
    if found.size == 1:
        text = f"no other world {universe} has the same quotient: a robot can map this world"
        return parts.Headline("ALONE", text, "holds")
    why = _covers([projection_of(found.world).quotient]) + WHY_ALIKE
    worlds = f"{words.plural(found.size, 'world')} {universe}"
    text = f"{worlds} look alike, the given one included; {why}"
    return parts.Headline("AMBIGUOUS", text, "vacuous")


def alike(
    names: Sequence[str], worlds: Sequence[World], classes: Sequence[Sequence[int]]
) -> parts.ShownWalk:
    """A walk along every edge of worlds that no motion tells apart.

    The pictures show the class of each dart as a letter.  ``names`` has a name for each world;
    ``classes`` has for each world the class of each dart.
    """
    scenes = [
        doc.replace(parts.scene_of(world), labels=[letters(q) for q in of_world])
        for world, of_world in zip(worlds, classes, strict=True)
    ]
    sentences = [ALIKE, TOURED] if len(worlds) > 1 else ["The walk goes along every edge."]
    return _walk(names, worlds, scenes, tour(worlds), sentences)


def _walk(
    names: Sequence[str],
    worlds: Sequence[World],
    scenes: Sequence[parts.Scene],
    motions: Sequence[int],
    sentences: Sequence[str],
) -> parts.ShownWalk:
    """A walk with the same motions in each of the worlds, and a picture of each world.

    Args:
        names: the name of each world, which is the title of its picture.
        worlds: the worlds.
        scenes: the picture of each world.
        motions: the motions.
        sentences: sentences about the walk.
    """
    walks = [Walk.of(world, map(actions.Move, motions)) for world in worlds]
    views = [
        parts.View(
            letters(i),
            f"World {name}" if len(name) == 1 else name,
            scene,
            walk.darts,
            f"genus {walk.world.map.genus}",
        )
        for i, (name, scene, walk) in enumerate(zip(names, scenes, walks, strict=True))
    ]
    sensed = [walk.percepts for walk in walks]
    apart = next((percepts for percepts in sensed if percepts != sensed[0]), None)
    elsewhere = parts.Elsewhere("sensed in B", apart) if apart else None
    walked = Walked(walks[0])
    return parts.ShownWalk("One walk", walked, views, sentences, elsewhere, tour=not apart)


def _covers(quotients: Sequence[Quotient]) -> str:
    """The words that say: the worlds are covers of one quotient.

    The quotients of the worlds must be equal, except for the numbers of sheets.
    """
    sheets = [quotient.sheets for quotient in quotients]
    if len({*sheets}) > 1:
        who = f"A is a cover with {words.plural(sheets[0], 'sheet')} and B with {sheets[1]}, both"
    else:
        some = "all" if len(sheets) == 1 else "both"
        who = f"{some} are covers with {words.plural(sheets[0], 'sheet')}"
    size = words.plural(len(quotients[0].sigma), "class", "classes")
    return f"{who} of the same quotient, which has {size} of darts"


def _quotient(quotient: Quotient) -> tuple[parts.Paragraph, parts.Table]:
    """A sentence, and a table with a row for each vertex of the quotient.

    The table has three columns: the classes of darts at the vertex, clockwise, each with the class
    to which alpha takes it; the percept at the vertex; and the cone index, the number of times that
    these classes repeat round a vertex of the world.
    """
    rows: list[list[parts.Cell]] = []
    for vertex, cone in zip(quotient.vertices, quotient.cone_indices, strict=True):
        leads = ((q, quotient.alpha[q]) for q in vertex)
        around = " ".join(
            f"{letters(q)}↺" if other == q else f"{letters(q)}→{letters(other)}"
            for q, other in leads
        )
        labels = [quotient.labels[q] for q in vertex]
        uneven = len({getattr(label, "marks", 0) for label in labels}) > 1
        rows.append([around, "; ".join(map(str, labels if uneven else labels[:1])), cone])
    header = ["classes clockwise", "sensed there", "times round a vertex"]
    said = "The quotient. a→b: alpha takes class a to class b; a↺: alpha takes class a to itself."
    return parts.Paragraph(said), parts.Table(header, rows)


def census_content(census: census_sweep.AmbiguityCensus) -> parts.ReportContent:
    """The content for a census: how many worlds look like others, and the smallest two that do.

    One table has a row for each number of edges.  A second table, and the CSV file, have a row for
    each pair of a number of edges and a number of vertices.  Each row has four numbers: the worlds;
    the worlds that look like another world; the ambiguity classes with two or more worlds; and the
    worlds in the largest of these classes.
    """
    header = ["marked worlds", "ambiguous", "groups of lookalikes", "largest group"]
    rows = [[row.edges, *_counts(row)] for row in census.rows]
    cells = [[cell.edges, cell.vertices, *_counts(cell)] for cell in census.by_vertices]
    kind = str(census.request.lighthouse)
    marked = "with one marked vertex" if kind == Position.kind else f"under the lighthouse {kind}"
    scope = (
        f"{maps_in_words(census, 'every map')}, {marked}, up to isomorphism; a world is ambiguous "
        "if no motion tells it from some other world in the scope"
    )
    facts = [("scope", scope), ("places", census.places)]
    if not census.whole:
        text = (
            f"{census.portion}: a shard may hold only some of the worlds that look alike; the "
            "merge of all shards gives the groups and the counts"
        )
        facts.append(("shard", text))
    if census.agrees:
        facts += gate_facts(census, "rooted map", is_compared=bool(rows))
    tables = [
        parts.Table(["edges", *header], rows, "Marked worlds by edges"),
        parts.Table(["edges", "vertices", *header], cells, "By edges and vertices", keys=2),
    ]
    sections = [parts.Section("seen", "", [*tables, parts.FactList(facts)])]
    if census.pair:
        title = "The smallest worlds that no motion tells apart"
        sections.append(
            parts.Section("pair", title, [alike("AB", census.pair, census.bisimulation)])
        )
    columns = {"edges": int, "vertices": int, "marked_worlds": int}
    columns |= {"ambiguous_worlds": int, "classes": int, "largest_class": int}
    return parts.ReportContent(
        "allworlds ambiguity census",
        f"class {census.extent.map_class}",
        census,
        _counted(census),
        sections,
        rows=lambda: parts.CsvRows.of(census.by_vertices, **columns),
    )


def _counts(row: census_sweep.CensusRow | census_sweep.CensusCell) -> list[parts.Cell]:
    return [row.marked_worlds, row.ambiguous_worlds, row.classes, row.largest_class or None]


def _counted(census: census_sweep.AmbiguityCensus) -> parts.Headline | None:
    if not census.agrees:
        wrong = [
            f"the enumeration found {words.plural(row.rooted, 'rooted map')} with "
            f"{words.plural(row.edges, 'edge')}, but the independent count ({census.source}) is "
            f"{row.counted}"
            for row in census.rows
            if not row.agrees(whole=census.whole)
        ]
        return parts.Headline("MISMATCH", "; ".join(wrong), "error")
    if not census.rows:
        return parts.so_far(census, None)
    worlds = words.plural(sum(row.marked_worlds for row in census.rows), "marked world")
    scope = finished(census, census.rows[-1].edges)
    if census.places:
        scope += f" ({census.places})"
    ambiguous = sum(row.ambiguous_worlds or 0 for row in census.rows)
    if not census.whole:
        done = parts.Headline("SHARD", f"{worlds} {scope}, in the shard {census.portion}")
    elif census.empty:
        done = parts.Headline("VACUOUS", f"there is no world {scope}", "vacuous")
    elif ambiguous:
        done = parts.Headline("AMBIGUOUS", f"{words.number(ambiguous)} of {worlds} {scope}")
    else:
        done = parts.Headline("TOLD APART", f"no two of {worlds} {scope} look alike")
    return parts.so_far(census, done)


def search_content(result: twin_search.SearchResult) -> parts.ReportContent:
    """The content for a search for twins: the answer, the twins if any, and the searched sizes.

    Named facts tell the folder of the search's files, and the *certificate* if there is one: the
    file with the twins, or the folder with the proof that there are none.
    """
    pair = []
    if result.pair and result.bisimulation:
        walk = alike("AB", result.pair, result.bisimulation)
        pair.append(parts.Section("walk-1", "Darts with the same letter look alike", [walk]))
    headline, facts = _found(result)
    facts.append(("files", str(result.directory)))
    columns = {"sizes": str, "status": str, "seconds": float, "formula": str, "proof": str}
    rows = [
        [
            *(one.sizes.name, one.status, round(one.seconds, 6), one.formula.name),
            None if one.proof is None else one.proof.name,
        ]
        for one in result.levels
    ]
    caption = "The sizes tried (m4n2to5: 4 edges, 2 to 5 vertices; sat: twins; unsat: no twins)"
    table = parts.Table([*columns], rows, caption)
    return parts.ReportContent(
        "allworlds ambiguity search",
        f"{result.lighthouse} lighthouse, class {result.map_class.value}",
        result,
        headline,
        [*pair, parts.Section("seen", "What was searched", [parts.FactList(facts), table])],
        rows=lambda: parts.CsvRows(columns, rows),
    )


def _found(result: twin_search.SearchResult) -> tuple[parts.Headline, list[tuple[str, str]]]:
    """The answer of a search for twins, and facts about the proof of this answer.

    If twins were found, the facts name the file with the twins; if not, the folder with the proof.
    """
    asked = result.question.describes
    if result.status == "unknown":
        return parts.Headline("UNKNOWN", f"{asked}: undecided.", "inconclusive"), []
    if result.vacuous:
        return parts.Headline("VACUOUS", f"{asked}: there is no world at all.", "vacuous"), []
    if result.status == "sat":
        pair = [] if result.certificate is None else [("pair", str(result.certificate))]
        return parts.Headline("FOUND", f"{asked}.", "vacuous"), [("why", ALIKE), *pair]
    proof = "not every size has a checked proof; the notices on stderr say why"
    if result.certificate is not None:
        proof = (
            f"{result.certificate} holds a formula and an LRAT proof for each size; a separate "
            "proof checker has accepted each proof"
        )
    none = f"there are no {asked[0].lower()}{asked[1:]}."
    return parts.Headline("NONE", none, "holds"), [("proof", proof)]


def tour(worlds: Sequence[World]) -> list[int]:
    """Motions with which a robot goes along every edge, whichever of the worlds it is in.

    The worlds must look alike.  The walk takes the nearest new edge of the first world; of equally
    near edges it takes the first one clockwise.  If no edge is left in this world, the walk goes on
    with the edges of the next world.

    Cost: the edges of all worlds, times the darts of one world.
    """
    motions: list[int] = []
    for world in worlds:
        map_, dart, left = world.map, world.start, set(world.map.darts)
        ahead = [*motions]
        while ahead or left:
            if not ahead:
                ahead = _nearest(map_, dart, left)
                motions += ahead
            dart = map_.move(dart, ahead.pop(0))
            left -= {dart, map_.alpha[dart]}
    return motions


def _nearest(map_: CombinatorialMap, start: Dart, left: set[Dart]) -> list[int]:
    """A shortest list of motions that lead a robot from ``start`` to one of the darts ``left``."""
    ways: dict[Dart, list[int]] = {start: []}
    queue = [start]
    for dart in queue:
        for k in range(map_.degree_at[dart]):
            reached = map_.move(dart, k)
            if reached in left:
                return [*ways[dart], k]
            if reached not in ways:
                ways[reached] = [*ways[dart], k]
                queue.append(reached)
    raise AssertionError("the map is connected")


def letters(number: int) -> str:
    """The letters for a number: ``a`` to ``z``, then ``aa``, ``ab``, and so on."""
    rest, last = divmod(number, len(ascii_lowercase))
    return (letters(rest - 1) if rest else "") + ascii_lowercase[last]
