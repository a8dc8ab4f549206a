"""The parts of the content of every report, and rows for programs.

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
from allworlds.world.labels import Position
from allworlds.world.lighthouses import own_kind
from allworlds.world.lighthouses.kinds import parts_of
from allworlds.world.world import World

if TYPE_CHECKING:
    from allworlds.judging.explanations.story import Walked


LONGEST_IN_LEGEND = 60
"""Characters of a name of a vertex in a legend."""


class Scene(Struct, frozen=True):
    """Content of a picture; each form of picture draws as much of it as it can.

    Attributes:
        map: the map.
        start: the dart that the robot faced at the start; None where that is not known.
        robot: the dart where the robot is at the end of its walk; None where nobody walks.
        marks: the number of markers at each vertex that has any, by the vertex's index in
            ``map.vertices``.
        pointed: the darts to which a bearing is counted, at any number of vertices.
        labels: a short text for each dart, such as its class; None where there are none.
        walked: the darts by which the robot has arrived anywhere.
        ringed: the dart to look at; None where there is none.
        darts: their names, where these are not their numbers.
        vertices: likewise.
        positions: of the vertices, where these are given.
        letters: the marks that are sensed by single darts, where those of a vertex differ.
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
    positions: tuple[Position, ...] = ()
    letters: Mapping[Dart, int] = field(default_factory=dict)

    @property
    def root(self) -> Dart:
        """The dart where a picture begins: the start, else the robot's."""
        return (self.robot or 0) if self.start is None else self.start

    @property
    def dart_names(self) -> Sequence[str]:
        """The name of each dart."""
        return self.darts or [*map(str, self.map.darts)]

    @property
    def vertex_names(self) -> Sequence[str]:
        """The name of each vertex."""
        return self.vertices or [f"v{vertex}" for vertex in range(self.map.vertex_count)]

    def short_names(self, width: int) -> Sequence[str]:
        """The names of the vertices; longer ones are cut and numbered, so no two become one."""
        if not self.vertices:
            return self.vertex_names
        ends = (f"…{vertex}" for vertex in range(self.map.vertex_count))
        return [
            name if len(name) <= width else name[: max(width - len(end), 0)] + end
            for name, end in zip(self.vertices, ends, strict=True)
        ]

    def cut_names(self, width: int) -> list[str]:
        """For each name that :meth:`short_names` cuts: ``ki…1 kitchen``, itself cut if need be."""
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
        """Return the scene of a map in which percepts are known for arrival at some darts.

        The dart at bearing 0 is pointed along, and a vertex with marks is marked; if the marks of
        the darts are ``lasting`` and differ, its darts are.
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
    """The scene of a world, with everything that can be sensed in it.

    ``dropped`` holds the vertices at which the robot has dropped markers, one entry a marker.
    """
    map_, lying = world.map, Counter(dropped)
    percepts = ((d, p.marked(lying[map_.vertex_of[d]])) for d, p in enumerate(world.percepts))
    scene, labels = Scene.sensed(map_, world.start, percepts, lasting=True), world.labels
    scene = doc.replace(scene, vertices=_names(world), positions=labels.positions)
    return _without_labels(scene, world)


def _names(world: World) -> Sequence[str]:
    """The names of the vertices, with the fields of a user's lighthouse whose darts are there."""
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
    """The scene without marks, where these are labels of vertices and no markers."""
    return doc.replace(scene, marks={}) if world.lighthouse.labels_vertices else scene


def walk_in_world(walk: Walk) -> Scene:
    """The world with everything that is sensed, and the robot at the end of its walk."""
    scene = scene_of(walk.world, walk.states[-1].lying)
    return doc.replace(scene, robot=walk.here, walked=walk.arrivals)


def walk_in_answer(walk: Walk, answer: Estimate) -> Scene:
    """The answer with the percepts that it predicts, and the robot where the answer says."""
    world, belief = walk.world, believed_walk(walk, answer)
    # Where the answer has no place for the lighthouse it says nothing of markers.
    percepts = zip(belief.trail, belief.percepts or [], strict=False)
    lasting = not world.lighthouse.as_kind.leaves_marks
    scene = Scene.sensed(answer.map, belief.trail[0], percepts, lasting=lasting)
    scene = _without_labels(scene, world)
    steps = zip(belief.trail[1:], walk.actions, strict=True)
    arrivals = {dart for dart, action in steps if type(action) is Move}
    return doc.replace(scene, robot=answer.here, walked=arrivals)


Value: TypeAlias = int | float | str | bool | None
"""A value of a row; None where there is none."""


class CsvRows(Struct, frozen=True):
    """Rows for programs.

    Attributes:
        columns: the type of each column, ``int``, ``float``, ``str`` or ``bool``, by its name.
        rows: a value for each column.
    """

    columns: Mapping[str, type]
    rows: Sequence[Sequence[Value]]

    @classmethod
    def of(cls, results: Iterable[Any], **columns: type) -> CsvRows:
        """A row for each result, whose columns are attributes of these names."""
        return cls(columns, [[getattr(result, name) for name in columns] for result in results])

    @property
    def records(self) -> list[dict[str, Value]]:
        """The rows, each by the names of its columns."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]


class RightText(Struct, frozen=True):
    """A text in a table that is flushed right like a number."""

    text: str


Cell: TypeAlias = float | str | RightText | None
"""A cell of a table; None where there is no value."""


class Headline(Struct, frozen=True):
    """The first line.

    Attributes:
        word: the answer in a word.
        text: the answer in a sentence.
        verdict: the name of the verdict, which has its colour; empty where the answer is none.
    """

    word: str
    text: str
    verdict: str = ""

    @property
    def line(self) -> str:
        """Word and sentence in one line."""
        return " ".join(f"{self.word}: {self.text}".split())


class Paragraph(Struct, frozen=True):
    """A paragraph of plain text."""

    text: str


class FactList(Struct, frozen=True):
    """Named sentences; one without a name goes on with the fact before.

    Those that are empty are not shown.
    """

    given: Sequence[tuple[str, str]]

    @property
    def entries(self) -> list[tuple[str, str]]:
        """Those that are not."""
        return [(name, text) for name, text in self.given if text]


class Table(Struct, frozen=True):
    """A table.

    Attributes:
        header: a name for each column.
        rows: a cell for each column.
        caption: what the rows are.
        keys: the number of the first columns by which rows are told apart.
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
        """``r`` for each column of numbers, ``l`` for each of words."""
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
    """Values by size, all positive; only pages and pictures show it.

    Attributes:
        title: of the values.
        across: of the sizes.
        lines: by its name each line's points: size, value, and the ends of its interval.
    """

    title: str
    across: str
    lines: Sequence[tuple[str, Sequence[tuple[float, float, float, float]]]]


class MapPictures(Struct, frozen=True):
    """Pictures of maps, each with its caption, side by side."""

    entries: Sequence[tuple[str, Scene]]


class ShownMap(Struct, frozen=True):
    """The part of the world that an explorer has shown, each dart and edge with its first step.

    Attributes:
        darts: those in S.
        edges: those of which S knows both ends, by each of their darts.
    """

    darts: dict[Dart, int]
    edges: dict[Dart, int]


class View(Struct, frozen=True):
    """A picture in which a walk can be followed.

    Attributes:
        name: a word of letters; no other view of the walk has it.
        title: what is drawn.
        scene: the picture, as it is at the end.
        trail: where the robot is in it at the start and after each step.
        note: what else is to be known of a picture without motion.
        known: in a picture that grows, when each part comes.
        still: whether it is for texts alone; a page shows the same by motion in another view.
    """

    name: str
    title: str
    scene: Scene
    trail: Sequence[Dart]
    note: str = ""
    known: ShownMap | None = None
    still: bool = False


class Elsewhere(Struct, frozen=True):
    """The percepts of the same motions in another map.

    Attributes:
        where: the heading.
        percepts: one for each that was sensed.
    """

    where: str
    percepts: Sequence[Percept]


class ShownWalk(Struct, frozen=True):
    """A walk, step by step, with the pictures in which it can be followed.

    Attributes:
        title: whose walk it is.
        walked: the walk; the first view shows its world.
        views: the pictures.
        sentences: what there is to say of it.
        elsewhere: what is sensed in another map, where that is to be compared.
        agreement: the number of steps, the start included, for which the first two views show the
            same, which are then drawn alike; None where each is drawn by itself.
        parting: the step at which belief and truth part.
        tour: it only leads along every edge: its steps say nothing by themselves.
        lines: the place in the user's code of each step, as ``FILE:LINE``.
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
        """A row for each step; the lines of one file by their numbers alone."""
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
        name: of the event, as a schedule has it; empty for the start.
        robots: of each robot that is activated a sentence.
        world: of all else.
        darts: where each robot is after it; None of one that is no more.
        moved: the darts by which robots have arrived in it.
        vertices: words at vertices after it.
        edges: words at edges, by the smaller dart.
        repeats: whether it is one of those that repeat for ever.
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
    """A run of several robots: on a page step by step beside its map, in a text a diagram.

    Attributes:
        title: of the picture.
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
        name: a word, which no other quotation of the section has.
        title: what they are.
        text: the lines.
        command: they are to be copied and run.
        prefix: what each line begins with in a plain text.
    """

    name: str
    title: str
    text: str
    command: bool = False
    prefix: str = ""


class DataRecord(Struct, frozen=True):
    """Data for programs, beside the text for people.

    Attributes:
        title: what can be copied.
        document: a JSON object.
    """

    title: str
    document: Mapping[str, Any]


Block: TypeAlias = (
    Paragraph | FactList | Table | Curve | MapPictures | ShownWalk | ShownRun | Quote | DataRecord
)
"""A part of a section."""


class Section(Struct, frozen=True):
    """Blocks under a title.

    Attributes:
        name: a word, which no other section of the content has.
        title: what it is about; empty where the blocks follow the headline without one.
        blocks: what stands in it.
    """

    name: str
    title: str
    blocks: Sequence[Block]


class SuiteCase(Struct, frozen=True):
    """One of the cases that were tried, as test runners count them."""

    name: str
    result: Literal["passed", "failure", "error", "skipped"] = "passed"
    kind: str = ""
    message: str = ""
    sections: Sequence[Section] = ()
    seconds: float = 0


class ReportContent(Struct, frozen=True):
    """Everything that a result says.

    Attributes:
        done: what was done.
        subject: to whom or what.
        result: whose content it is.
        headline: the answer; None where there is nothing to say but the sections.
        sections: the rest, in the order in which it is read.
        whole: those that a terminal shows only if all is asked for.
        more: walks to be stepped through, which only a page has room for; they may have to be
            played again, and so are made when they are asked for.
        rows: makes the rows for programs, where these are not the steps of the first walk.
        cases: makes the cases, where there are any.
        command: the words of the command line that say to whom the cases belong: beside those of
            another report no name occurs twice.
        page: makes the page, where it is not of these sections.
        apart: the keys of the result's document that sections hold as records.
        short: facts of a line each, which on a terminal stand in place of the last section.
        laws: those that a finding may break, with what each asks.
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
    """Facts with one named sentence."""
    return FactList([(name, text)])


def so_far(report: Any, headline: Headline | None) -> Headline | None:
    """The headline of a report with rows; if the job ended early, it begins with the reason.

    Args:
        report: says whether it is complete, and has the ending.
        headline: of what was finished; None where nothing was.
    """
    if report.complete:
        return headline
    why = report.ending.reason
    if headline is None or not headline.text:
        return Headline("INCONCLUSIVE", f"{why}; nothing was finished before")
    if headline.verdict in ("refuted", "error"):
        return doc.replace(headline, text=f"{headline.text}; {why}, and the rest was not tried")
    return Headline("INCONCLUSIVE", f"{why}; finished before: {headline.text}")


_SENSED = ("degree", "marks", "bearing")


def rows_of_walk(walk: ShownWalk) -> CsvRows:
    """A row for each step.

    The number is that of a motion, or what was written; vertex and dart are those of the world at
    which the robot has arrived; the name is that of the vertex, where it has one. Where a walk is
    compared, columns ``other_...`` hold what is sensed elsewhere.
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
    """The rows for programs, by default those of the first walk; no columns if there is none."""
    if content.rows:
        return content.rows()
    blocks = (block for section in content.sections for block in section.blocks)
    walk = next((block for block in blocks if isinstance(block, ShownWalk)), None)
    return rows_of_walk(walk) if walk else CsvRows({}, [])
