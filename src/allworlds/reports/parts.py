"""The parts of the content of every report, and rows for files such as CSV.

A module of ``content`` makes the content of a verb's report.  ``plain_text``, ``web`` and the
formats show any content, and know only the parts in this module.  A *scene* is a map with
everything that a picture shows, for any lighthouse.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from msgspec import Struct, field

from allworlds import outcome, words
from allworlds.documents import document as doc
from allworlds.judging.belief import believed_walk
from allworlds.judging.laws.law_table import ASKED
from allworlds.judging.walk import Walk
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.world.labels import PlanePoint
from allworlds.world.lighthouses import own_kind
from allworlds.world.lighthouses.kinds import parts_of
from allworlds.world.world import World

if TYPE_CHECKING:
    from allworlds.judging.explanations.story import Walked


LONGEST_IN_LEGEND = 60
"""The largest number of characters of a vertex's name in a legend."""


class Scene(Struct, frozen=True):
    """The content of a picture; each form of picture draws as much of it as it can.

    Attributes:
        map: the map.
        start: the dart that the robot faced at the start; None if that is not known.
        robot: the dart where the robot is at the end of its walk; None without a robot.
        marks: the number of markers at each vertex with markers, by the vertex's index in
            ``map.vertices``.
        pointed: the pointed darts, to which bearings are counted.
        labels: a short text for each dart, such as the letter of its class in a bisimulation; None
            without such texts.
        walked: the darts by which the robot has arrived.
        ringed: a dart that is drawn with a ring; None without a ring. It is the robot's dart at the
            first step at which this walk diverges from the walk in another picture.
        darts: the names of the darts; empty if the names are their numbers.
        vertices: the names of the vertices; empty if the names are ``v0``, ``v1``, and so on.
        positions: the positions of the vertices; empty if these are not given.
        letters: marks that depend on the dart of arrival: a dictionary from a dart to the number of
            marks, not 0, that a robot senses if it arrives by this dart. The vertices of these
            darts are not in ``marks``.
    """

    map: CombinatorialMap
    start: Dart | None = 0
    robot: Dart | None = None
    marks: Mapping[int, int] = field(default_factory=dict)
    pointed: Collection[Dart] = ()
    labels: Sequence[str] | None = None
    walked: Collection[Dart] = ()
    ringed: Dart | None = None
    darts: Sequence[str] = ()
    vertices: Sequence[str] = ()
    positions: tuple[PlanePoint, ...] = ()
    letters: Mapping[Dart, int] = field(default_factory=dict)

    @property
    def root(self) -> Dart:
        """The dart where a picture begins: the start, or else the robot's dart."""
        return (self.robot or 0) if self.start is None else self.start

    @property
    def dart_names(self) -> Sequence[str]:
        """The name of each dart; by default its number."""
        return self.darts or [*map(str, self.map.darts)]

    @property
    def vertex_names(self) -> Sequence[str]:
        """The name of each vertex; by default ``v0``, ``v1``, and so on."""
        return self.vertices or [f"v{vertex}" for vertex in range(self.map.vertex_count)]

    def short_names(self, width: int) -> Sequence[str]:
        """The names of the vertices, in which each name longer than ``width`` is cut.

        A cut name ends in the vertex's number, so that names differ.
        """
        if not self.vertices:
            return self.vertex_names
        ends = (f"…{vertex}" for vertex in range(self.map.vertex_count))
        return [
            name if len(name) <= width else name[: max(width - len(end), 0)] + end
            for name, end in zip(self.vertices, ends, strict=True)
        ]

    def cut_names(self, width: int) -> list[str]:
        """A text such as ``ki…1 kitchen`` for each name that is cut to ``width``.

        The long name in the text may be cut, too, at :data:`LONGEST_IN_LEGEND`.
        """
        pairs = zip(self.short_names(width), self.short_names(LONGEST_IN_LEGEND), strict=True)
        return [f"{short} {name}" for short, name in pairs if short != name]

    @classmethod
    def sensed(
        cls,
        map_: CombinatorialMap,
        start: Dart,
        percepts: Iterable[tuple[Dart, Percept]],
        *,
        lasting: bool = False,
    ) -> Scene:
        """Return the scene of a map from percepts, each with the robot's dart of arrival.

        From each bearing follows a dart of ``pointed``, and from marks follows an entry of
        ``marks`` or ``letters``.  ``start`` is the dart that the robot faced at the start.
        ``lasting`` is True if no marks change between the percepts.  Then percepts with different
        marks at one vertex mean that the marks depend on the dart of arrival, and the marks go to
        ``letters``.  If ``lasting`` is False, the last percept at a vertex tells the vertex's
        marks.
        """
        known = list(percepts)
        # What is sensed last holds: markers can be taken away.
        marks = {map_.vertex_of[dart]: p.marks for dart, p in known}
        uneven = {map_.vertex_of[d] for d, p in known if p.marks != marks[map_.vertex_of[d]]}
        uneven = uneven if lasting else set()
        return cls(
            map_,
            start,
            marks={v: number for v, number in marks.items() if number and v not in uneven},
            letters={d: p.marks for d, p in known if p.marks and map_.vertex_of[d] in uneven},
            pointed=sorted({map_.turn(d, p.bearing) for d, p in known if p.bearing is not None}),
        )


def scene_of(world: World, dropped: Collection[int] = ()) -> Scene:
    """The scene of a world, with everything that a robot can sense there.

    ``dropped`` holds the vertices at which the robot has dropped markers, an entry for each marker.
    """
    map_, lying = world.map, Counter(dropped)
    percepts = ((d, p.marked(lying[map_.vertex_of[d]])) for d, p in enumerate(world.percepts))
    scene, labels = Scene.sensed(map_, world.start, percepts, lasting=True), world.labels
    scene = doc.replace(scene, vertices=_names(world), positions=labels.positions)
    return _without_labels(scene, world)


def _names(world: World) -> Sequence[str]:
    """The names of the vertices, each followed by what a user's lighthouse has there.

    A user's lighthouse may have fields that hold darts.  The name of such a field is added to the
    name of the vertex at which the dart is.
    """
    map_, labels = world.map, world.labels
    named = [
        one
        for part in parts_of(world.lighthouse)
        for one in own_kind.named_darts(part, map_).items()
    ]
    if not named:
        return labels.vertices
    names = [[labels.vertex(vertex)] for vertex in range(map_.vertex_count)]
    for field_, darts in named:
        for vertex in sorted({map_.vertex_of[dart] for dart in darts}):
            names[vertex].append(field_)
    return [" ".join(each) for each in names]


def _without_labels(scene: Scene, world: World) -> Scene:
    """The scene ``scene`` of a world, without marks if the world's marks are labels of vertices."""
    return doc.replace(scene, marks={}) if world.lighthouse.labels_vertices else scene


def walk_in_world(walk: Walk) -> Scene:
    """The scene of a walk's world, with all its percepts, and with the robot at the walk's end."""
    scene = scene_of(walk.world, walk.states[-1].lying)
    return doc.replace(scene, robot=walk.here, walked=walk.arrivals)


def walk_in_answer(walk: Walk, answer: Estimate) -> Scene:
    """The scene of an answer's map, with the percepts that the answer predicts on the walk.

    The robot is at the dart ``here`` of the answer.
    """
    world, belief = walk.world, believed_walk(walk, answer)
    # Where the answer has no place for the lighthouse it says nothing of markers.
    percepts = zip(belief.trail, belief.percepts or [], strict=False)
    lasting = not world.lighthouse.as_kind.leaves_marks
    scene = Scene.sensed(answer.map, belief.trail[0], percepts, lasting=lasting)
    scene = _without_labels(scene, world)
    steps = zip(belief.trail[1:], walk.actions, strict=True)
    arrivals = {dart for dart, action in steps if type(action) is Move}
    return doc.replace(scene, robot=answer.here, walked=arrivals)


CellValue: TypeAlias = int | float | str | bool | None
"""A value of a row; None stands for no value."""


class CsvRows(Struct, frozen=True):
    """The rows of a report in files for other programs: CSV, Parquet and LaTeX.

    Attributes:
        columns: the type of each column, ``int``, ``float``, ``str`` or ``bool``, by its name.
        rows: the rows, each with a value for each column.
    """

    columns: Mapping[str, type]
    rows: Sequence[Sequence[CellValue]]

    @classmethod
    def of(cls, results: Iterable[Any], **columns: type) -> CsvRows:
        """Make a row of each result; ``columns`` has the type of each column by the column's name.

        Each column holds the attribute of the results that has the column's name.
        """
        return cls(columns, [[getattr(result, name) for name in columns] for result in results])

    @property
    def records(self) -> list[dict[str, CellValue]]:
        """The rows as dictionaries, by the names of the columns."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]


class RightText(Struct, frozen=True):
    """A text in a table that stands at the right of its column, like a number."""

    text: str


Cell: TypeAlias = float | str | RightText | None
"""A cell of a table; None stands for no value."""


class Headline(Struct, frozen=True):
    """The first line of a report.

    Attributes:
        word: the answer in a word.
        text: the answer in a sentence.
        verdict: the name of the verdict, which decides the colour; empty without a verdict.
    """

    word: str
    text: str
    verdict: str = ""

    @property
    def line(self) -> str:
        """The word and the sentence in one line."""
        return " ".join(f"{self.word}: {self.text}".split())


class Paragraph(Struct, frozen=True):
    """A paragraph of plain text."""

    text: str


class FactList(Struct, frozen=True):
    """Named sentences, as pairs of a name and a sentence.

    A sentence whose name is empty continues the fact before it.  Empty sentences are not shown.
    """

    given: Sequence[tuple[str, str]]

    @property
    def entries(self) -> list[tuple[str, str]]:
        """The facts whose sentence is not empty."""
        return [(name, text) for name, text in self.given if text]


class Table(Struct, frozen=True):
    """A table.

    Attributes:
        header: a name for each column.
        rows: the rows, each with a cell for each column.
        caption: the caption of the table.
        keys: the number of columns, from the first one on, whose cells identify a row.
    """

    header: Sequence[str]
    rows: Sequence[Sequence[Cell]]
    caption: str = ""
    keys: int = 1

    @property
    def texts(self) -> list[list[str]]:
        """The rows with each cell as text."""
        return [[_text(cell) for cell in row] for row in self.rows]

    @property
    def right(self) -> str:
        """A letter for each column, in one text: ``l`` if the column holds a text, else ``r``."""
        columns = ([row[i] for row in self.rows] for i in range(len(self.header)))
        return "".join("l" if any(isinstance(c, str) for c in cells) else "r" for cells in columns)


def _text(cell: Cell) -> str:
    match cell:
        case None:
            return "-"
        case RightText():
            return cell.text
        case str():
            return cell
        case int():
            return words.number(cell)
        case _:
            return f"{cell:,.2f}"


class Curve(Struct, frozen=True):
    """Values by the size of maps, all positive; only pages and pictures show a curve.

    Attributes:
        title: the title of the values.
        across: the title of the sizes.
        lines: for each line its name and its points: size, value, and the lower and the upper end
            of the value's confidence interval; without an interval both are the value.
    """

    title: str
    across: str
    lines: Sequence[tuple[str, Sequence[tuple[float, float, float, float]]]]


class MapPictures(Struct, frozen=True):
    """Pictures of maps side by side, each a caption and a scene."""

    entries: Sequence[tuple[str, Scene]]


class ShownMap(Struct, frozen=True):
    """The part of the world that checkpoints show, with the first step of each dart and edge.

    Attributes:
        darts: for each dart in S the first step at which S has the dart.
        edges: the first step at which S has both ends of an edge, by each of the edge's darts.
    """

    darts: dict[Dart, int]
    edges: dict[Dart, int]


class View(Struct, frozen=True):
    """A picture in which a walk can be followed.

    Attributes:
        name: a word of letters, unique among the views of the walk.
        title: the title of the picture.
        scene: the picture at the end of the walk.
        trail: the robot's dart at the start and after each step.
        note: a remark, which texts show beside the title; may be empty.
        known: None if the picture shows the whole map at every step. Else the picture grows: at
            each step it shows the part of the map that the explorer knows then. ``known`` tells at
            which step each dart and each edge appears.
        still: whether only texts show this view. Pages show another view of the same map instead,
            whose picture grows; texts do not show that other view.
    """

    name: str
    title: str
    scene: Scene
    trail: Sequence[Dart]
    note: str = ""
    known: ShownMap | None = None
    still: bool = False


class Elsewhere(Struct, frozen=True):
    """The percepts that the motions of a walk would yield in another map.

    Attributes:
        where: the heading of these percepts.
        percepts: the percepts in the other map, one for each percept of the walk.
    """

    where: str
    percepts: Sequence[Percept]


class ShownWalk(Struct, frozen=True):
    """A walk, step by step, with the pictures in which it can be followed.

    Attributes:
        title: the title of the walk.
        walked: the walk; the first view shows its world.
        views: the pictures.
        sentences: sentences about the walk.
        elsewhere: the percepts of the same motions in another map; None if nothing is compared.
        agreement: the number of the first step at which the walks in the first two views diverge;
            the start is step 0. Before this step the two trails lead through darts that belong
            together, and a page gives them, and all that follows from them, the same names in both
            maps. If the two maps are equal or mirror images, the second map also gets the positions
            of the first. None if the names of the two maps have nothing to do with each other.
        parting: the step at which the explorer is first seen to be wrong, because the walk in its
            answer contradicts the world, or because its checkpoint is wrong; else None.
        tour: whether the walk has the only purpose to go along every edge; then a text shows only
            the maps, without the sentences and the steps.
        lines: the line of the user's code for each step, as ``FILE:LINE``; empty if unknown.
    """

    title: str
    walked: Walked
    views: Sequence[View]
    sentences: Sequence[str] = ()
    elsewhere: Elsewhere | None = None
    agreement: int | None = None
    parting: int | None = None
    tour: bool = False
    lines: Sequence[str] = ()

    @property
    def table(self) -> Table:
        """A table with a row for each step.

        If all lines of the user's code are in one file, the table does not show the file's name.
        """
        walked, elsewhere = self.walked, self.elsewhere
        header = ["step", "motion", "arrives at", "sensed"]
        motions = ["start", *map(str, walked.walk.actions)]
        rows: list[list[Cell]] = [
            [i, motion, walked.arrival(i), walked.in_words(percept)]
            for i, (motion, percept) in enumerate(zip(motions, walked.sensed, strict=True))
        ]
        if elsewhere:
            header += ["", elsewhere.where]
            for row, here, there in zip(rows, walked.sensed, elsewhere.percepts, strict=True):
                row += ["=" if here == there else "≠", walked.in_words(there)]
        if any(self.lines):
            files = {line.rpartition(":")[0] for line in self.lines}
            header.append("line")
            for row, line in zip(rows, ["", *self.lines], strict=False):
                row.append(line.rpartition(":")[2] if len(files) == 1 else line)
        return Table(header, rows)


class RunRow(Struct, frozen=True):
    """An event of a run of several robots.

    Attributes:
        name: the event as it is written in a schedule, such as ``0M+1L``; empty for the start.
        robots: a sentence for each robot that is activated.
        world: words about the adversary's choice and about the robots that moved; may be empty.
        darts: the dart of each robot after the event; None for a robot that is gone.
        moved: the darts by which robots have arrived in the event.
        vertices: the texts at vertices after the event, by the number of the vertex.
        edges: the texts at edges after the event, by the smaller dart of the edge.
        repeats: whether the event is in the part of the run that repeats for ever.
    """

    name: str
    robots: Sequence[str]
    world: str
    darts: Sequence[Dart | None]
    moved: Sequence[Dart] = ()
    vertices: Mapping[int, str] = field(default_factory=dict)
    edges: Mapping[int, str] = field(default_factory=dict)
    repeats: bool = False


class ShownRun(Struct, frozen=True):
    """A run of several robots: a page steps through it beside its map; a text shows a diagram.

    Attributes:
        title: the title of the picture.
        scene: the map.
        rows: the start, then each event.
        diagram: the lines of the space-time diagram.
    """

    title: str
    scene: Scene
    rows: Sequence[RunRow]
    diagram: Sequence[str]


class Quote(Struct, frozen=True):
    """Lines that are shown unchanged.

    Attributes:
        name: a word, unique among the quotations of the section.
        title: the title of the lines.
        text: the lines.
        command: whether the lines are a command to copy and run.
        prefix: the text before each line in a plain text.
    """

    name: str
    title: str
    text: str
    command: bool = False
    prefix: str = ""


class DataRecord(Struct, frozen=True):
    """JSON data for other programs, beside the text for people.

    Attributes:
        title: the title of the data.
        document: a JSON object.
    """

    title: str
    document: Mapping[str, Any]


Block: TypeAlias = (
    Paragraph | FactList | Table | Curve | MapPictures | ShownWalk | ShownRun | Quote | DataRecord
)
"""A part of a section: one of the classes above."""


class Section(Struct, frozen=True):
    """Blocks under a title.

    Attributes:
        name: a word, unique among the sections of the content.
        title: the title; empty if the blocks follow the headline directly.
        blocks: the blocks of the section.
    """

    name: str
    title: str
    blocks: Sequence[Block]


class SuiteCase(Struct, frozen=True):
    """A test case in the sense of test runners: a part of the report with a result.

    Attributes:
        name: the name of the case.
        result: the result; ``failure`` for example if a law is broken, ``error`` for a fault of
            this program.
        kind: a word for the kind of failure or error, such as the broken law; else empty.
        message: a line about the result, for example the reason why the case was skipped.
        sections: the sections of the report about a failure or an error.
        seconds: the duration.
    """

    name: str
    result: Literal["passed", "failure", "error", "skipped"] = "passed"
    kind: str = ""
    message: str = ""
    sections: Sequence[Section] = ()
    seconds: float = 0


class ReportContent(Struct, frozen=True):
    """The content of a report, for every form.

    Attributes:
        done: the command, such as ``allworlds check``.
        subject: the subject of the command, for example the explorer's name.
        result: the result of the verb.
        headline: the answer in a sentence; None if the content consists of sections alone.
        sections: the sections, in the order of reading.
        whole: further sections, which a terminal shows only under the option ``-v``. Empty if there
            are facts in ``short``.
        more: a function that makes sections with walks to step through, for pages alone; it may
            play runs again.
        rows: a function that makes the rows of a CSV file; None: the steps of the first walk.
        cases: a function that makes the cases for test runners; None without cases.
        command: the arguments of the command line on which the result depends. The name of each
            case in a file for test runners begins with these arguments, so that the cases of two
            reports have different names.
        page: a function that makes the page; None if the page consists of the sections of this
            content.
        apart: some keys of the result's JSON document. A page holds a copy of the document without
            these keys, because the sections on the page hold their values (:class:`DataRecord`).
        short: facts in short, as pairs of a name and a sentence of one line. Without the option
            ``-v`` a terminal shows them in place of the last section, which tells the same facts at
            length. Empty if there are sections in ``whole``.
        laws: a dictionary from the name of each law that a finding may break to a sentence about
            what the law requires.
    """

    done: str
    subject: str
    result: outcome.Result
    headline: Headline | None
    sections: Sequence[Section]
    whole: Sequence[Section] = ()
    more: Callable[[], Iterable[Section]] = field(default=tuple)
    rows: Callable[[], CsvRows] | None = None
    cases: Callable[[], Sequence[SuiteCase]] | None = None
    command: str = ""
    page: Callable[[], str] | None = None
    apart: frozenset[str] = frozenset()
    short: Sequence[tuple[str, str]] = ()
    laws: Mapping[str, str] = field(default_factory=lambda: ASKED)


def fact(name: str, text: str) -> FactList:
    """A list of facts that has one named sentence."""
    return FactList([(name, text)])


def so_far(report: Any, headline: Headline | None) -> Headline | None:
    """The headline of a report; if the job ended early, the headline has the reason.

    Args:
        report: the report; ``report.complete`` says whether the job did all its work, and
            ``report.ending`` has the reason why it did not.
        headline: the headline about the finished part of the job; None if no part was finished.

    Returns:
        For a complete job the argument ``headline``, which may be None. For any other job a new
            headline: it keeps the word and the verdict of ``headline`` if the verdict is
            ``refuted`` or ``error``; else its word is INCONCLUSIVE, and it has no verdict.
    """
    if report.complete:
        return headline
    why = report.ending.reason
    if headline is None or not headline.text:
        return Headline("INCONCLUSIVE", f"{why}; before that nothing was finished")
    if headline.verdict in ("refuted", "error"):
        return doc.replace(headline, text=f"{headline.text}; {why}, and the rest was not tried")
    return Headline("INCONCLUSIVE", f"{why}; before that: {headline.text}")


_SENSED = ("degree", "marks", "bearing")


def rows_of_walk(walk: ShownWalk) -> CsvRows:
    """A row for the start and for each step of a walk.

    The column ``action`` has the name of the action, such as ``move`` or ``write``, and ``number``
    the number k of a motion or the number that the robot writes.  ``vertex`` and ``dart`` tell
    where the robot is in the world after the action; ``name``, only if the vertices have names, is
    the name of this vertex.  ``degree``, ``marks`` and ``bearing`` are the percept.  If the walk is
    compared with another map, the columns ``other_degree`` and so on have the percept in this map.
    """
    walked, others = walk.walked, walk.elsewhere.percepts if walk.elsewhere else ()
    named = walked.world.labels.vertices
    columns = {"step": int, "action": str, "number": int, "vertex": int, "dart": int}
    columns |= dict.fromkeys(_SENSED, int) | ({"name": str} if named else {})
    if walk.elsewhere:
        columns |= {f"other_{name}": int for name in _SENSED}
    rows = []
    actions = ["start", *map(str, walked.walk.actions)]
    for step, (action, dart, percept, other) in enumerate(
        zip_longest(actions, walked.walk.darts, walked.sensed, others)
    ):
        word, _, argument = action.partition(" ")
        row = [step, word, int(argument) if argument else None, walked.map.vertex_of[dart], dart]
        row += [getattr(percept, name) for name in _SENSED]
        row += [walked.vertex(dart)] if named else []
        if walk.elsewhere:
            row += [getattr(other, name, None) for name in _SENSED]
        rows.append(row)
    return CsvRows(columns, rows)


def rows_of(content: ReportContent) -> CsvRows:
    """The rows of a CSV file: those of ``content.rows``, or else the steps of the first walk.

    If the content has no walk either, the file has no columns.
    """
    if content.rows:
        return content.rows()
    blocks = (block for section in content.sections for block in section.blocks)
    walk = next((block for block in blocks if isinstance(block, ShownWalk)), None)
    return rows_of_walk(walk) if walk else CsvRows({}, [])
