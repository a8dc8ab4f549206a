"""Tellings: the content of a result in parts that every form of a report can show.

A module of ``tellings`` makes the telling of a verb's result.  ``plain_text`` and the ``formats``
show any telling, and know the parts below alone; those of findings and costs read the result, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

from msgspec import Struct, field

from allworlds.document.struct import replace
from allworlds.words import number

if TYPE_CHECKING:
    from allworlds.judging.explanations.story import Spending, Walked
    from allworlds.maps.combinatorial import Dart
    from allworlds.outcome import Result
    from allworlds.protocol.actions import Percept
    from allworlds.reports.drawing.scene import Scene
    from allworlds.reports.rows import CsvRows


class Shown(Struct, frozen=True):
    """A value of a table with a text of its own, flushed right like a number."""

    value: int | float | str
    text: str


Cell: TypeAlias = int | str | Shown | None
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


class Words(Struct, frozen=True):
    """A paragraph of plain text."""

    text: str


class ToldFacts(Struct, frozen=True):
    """Named sentences; one without a name goes on with the fact before."""

    entries: Sequence[tuple[str, str]]


class ToldTable(Struct, frozen=True):
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
        case Shown():
            return cell.text
        case str():
            return cell
        case _:
            return number(cell)


class ToldPicture(Struct, frozen=True):
    """A picture of a map, with a caption."""

    title: str
    scene: Scene


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


class ToldWalk(Struct, frozen=True):
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
    """

    title: str
    walked: Walked
    views: Sequence[View]
    sentences: Sequence[str] = ()
    elsewhere: Elsewhere | None = None
    agreement: int | None = None
    parting: int | None = None
    tour: bool = False

    @property
    def table(self) -> ToldTable:
        """A row for each step."""
        walked, told = self.walked, self.elsewhere
        header = ["step", "motion", "arrives at", "sensed", *(["", told.where] if told else [])]
        motions = ["start", *map(str, walked.transcript.actions)]
        rows: list[list[Cell]] = [
            [i, motion, walked.place(dart), str(percept)]
            for i, (motion, dart, percept) in enumerate(
                zip(motions, walked.walked, walked.sensed, strict=True)
            )
        ]
        for row, here, there in zip(
            rows, walked.sensed, told.percepts if told else (), strict=False
        ):
            row += ["=" if here == there else "≠", str(there)]
        return ToldTable(header, rows)


class SizeCost(NamedTuple):
    """The cost of runs in the worlds of one size.

    Attributes:
        edges, vertices: the size.
        cost: the largest cost.
        bound: the largest bound; None without a bound.
    """

    edges: int
    vertices: int
    cost: int
    bound: int | None


class Costs(Struct, frozen=True):
    """A column for each size: the largest cost beside the bound."""

    cells: Sequence[SizeCost]


class Curve(Struct, frozen=True):
    """Traversals against the edges that they found."""

    spent: Spending


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


class ToldRecord(Struct, frozen=True):
    """Data for programs, beside the text for people.

    Attributes:
        title: what can be copied.
        document: a JSON object.
        log: what it holds, line by line.
    """

    title: str
    document: Mapping[str, Any]
    log: str


Block: TypeAlias = (
    Words | ToldFacts | ToldTable | ToldPicture | ToldWalk | Costs | Curve | Quote | ToldRecord
)
"""A part of a section."""


class Section(Struct, frozen=True):
    """Blocks under a title.

    Attributes:
        name: a word, which no other section of the telling has.
        title: what it is about; empty where the blocks follow the headline without one.
        blocks: what stands in it.
        runs: sections that are opened one at a time; the last matters most.
    """

    name: str
    title: str
    blocks: Sequence[Block]
    runs: Sequence[Section] = ()


class ToldCase(Struct, frozen=True):
    """One of the cases that were tried, as test runners count them."""

    name: str
    result: Literal["passed", "failure", "error", "skipped"] = "passed"
    kind: str = ""
    message: str = ""
    sections: Sequence[Section] = ()


class Suite(Struct, frozen=True):
    """All cases, with named remarks."""

    verb: str
    name: str
    properties: Mapping[str, object]
    cases: Sequence[ToldCase]


class ToldResult(Struct, frozen=True):
    """Everything that a result says.

    Attributes:
        done: what was done.
        subject: to whom or what.
        result: what is told.
        headline: the answer; None where there is nothing to say but the sections.
        sections: the rest, in the order in which it is read.
        more: walks to be stepped through, which only a page has room for; they may have to be
            played again, and so are made when they are asked for.
        rows: makes the rows for programs, where these are not the steps of the first walk.
        suite: makes the cases, where there are any.
        page: makes the page, where it is not of these sections.
        apart: the keys of the result's document that sections hold as records.
        short: facts of a line each, which on a terminal stand in place of the last section.
    """

    done: str
    subject: str
    result: Result
    headline: Headline | None
    sections: Sequence[Section]
    more: Callable[[], Iterable[Section]] = field(default=tuple)
    rows: Callable[[], CsvRows] | None = None
    suite: Callable[[], Suite] | None = None
    page: Callable[[], str] | None = None
    apart: frozenset[str] = frozenset()
    short: Sequence[tuple[str, str]] = ()


def fact(name: str, text: str) -> ToldFacts:
    """Facts with one named sentence."""
    return ToldFacts([(name, text)])


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
        return replace(headline, text=f"{headline.text}; {why}, and the rest was not tried")
    return Headline("INCONCLUSIVE", f"{why}; finished before: {headline.text}")
