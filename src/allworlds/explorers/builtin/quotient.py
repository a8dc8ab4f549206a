"""The explorer that learns the quotient of its world by experiments.

A *word* is a sequence of the letters ``s`` (turn to the next dart clockwise) and ``a`` (go through
the dart).  An experiment walks a word, and reads the percept at its end.  A *class* is a set of
darts that no word tells apart: from each of them the robot senses the same after the same word.

The explorer does not know which of its arrivals are at the same vertex.  So it notes each of them
as a *node* of a *tree*: the first step by a dart of the tree leads to a new node; only a step
straight back leads to the node before.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

from allworlds.explorers.builtin.algorithm1 import Stage, nobody
from allworlds.maps.combinatorial import CombinatorialMap, cycles
from allworlds.protocol.actions import Ambiguous, Estimate, Move, Percept
from allworlds.protocol.choices import Choices

SensedWord: TypeAlias = tuple[str, ...]
"""A word, as the tuple of its letters."""

SensedRow: TypeAlias = tuple[Percept, ...]
"""The percepts after each of several words, all walked from the same dart."""


class TreeDart(NamedTuple):
    """A dart in the tree of all walks from the start; see :class:`Experiments`.

    Attributes:
        node: the node of the dart, given by the way from the start to the node along the tree.  The
            tuple holds the ``turn`` of each dart by which this way leaves a node; it is empty for
            the node of the start.
        turn: the number of darts, clockwise, from the dart by which this way enters the node to
            this dart.  At the node of the start it is counted from the dart that the robot faces.
    """

    node: tuple[int, ...]
    turn: int

    @property
    def beyond(self) -> "TreeDart":
        """The other dart of the edge in the tree.

        For the dart by which the way from the start enters a node, this is a dart of the node
        before; for any other dart it is the dart of entry of a further node.
        """
        if self.node and self.turn == 0:
            return TreeDart(self.node[:-1], self.node[-1])
        return TreeDart((*self.node, self.turn), 0)


class Experiments:
    """The tree of all walks from the start.

    Each arrival at a vertex makes a new node, unless the robot goes back along an edge of the tree.
    So several nodes can be one vertex; the tree does not tell which.

    Attributes:
        start: the dart of the tree that the robot faces at the start.
        here: the robot's dart in the tree.

    Args:
        first: the percept at the start.

    Cost: a step that was made before costs nothing.  Before a new step the robot walks to the node
    where the step begins, along the edges of the tree.
    """

    def __init__(self, first: Percept) -> None:
        self.start = self.here = TreeDart((), 0)
        self._percepts = {self.start.node: first}

    def sensed(self, dart: TreeDart) -> Percept:
        """The percept of the robot at a dart of the tree, whose node it must have visited."""
        return self._percepts[dart.node]

    def walk(self, word: Sequence[str], start: TreeDart | None = None) -> Stage[TreeDart]:
        """Walk a word through the tree; return the dart at the end of the word.

        The word begins at the dart ``start``; None stands for the attribute ``start``.
        """
        at = self.start if start is None else start
        for letter in word:
            if letter == "s":
                at = TreeDart(at.node, (at.turn + 1) % self.sensed(at).degree)
                continue
            beyond = at.beyond
            if beyond.node not in self._percepts:
                yield from self._go(at.node)
                self._percepts[beyond.node] = yield from self._leave(at.turn)
            at = beyond
        return at

    def word_to(self, dart: TreeDart) -> SensedWord:
        """The word, as a tuple of letters, that leads from the start along the tree to ``dart``."""
        return (*"".join("s" * turn + "a" for turn in dart.node), *"s" * dart.turn)

    def _go(self, goal: tuple[int, ...]) -> Stage[None]:
        """Walk to the node ``goal``: back to a node on the way from the start to it, then onward.

        ``goal`` has the form of :attr:`TreeDart.node`.
        """
        while self.here.node != goal[: len(self.here.node)]:
            yield from self._leave(0)
        for turn in goal[len(self.here.node) :]:
            yield from self._leave(turn)

    def _leave(self, turn: int) -> Stage[Percept]:
        """Leave the robot's node by its dart with this ``turn``; return the percept after that."""
        seen = yield Move(turn - self.here.turn)
        self.here = TreeDart(self.here.node, turn).beyond
        return seen


def quotient(
    first: Percept,
    *,
    choices: Choices | None = None,  # noqa: ARG001  # it has no freedom worth a choice
    notice: Callable[[str], None] = nobody,
) -> Stage[Estimate | Ambiguous]:
    """Explore under the lighthouse ``position``: learn the rooted quotient of the world.

    This lighthouse is a marker at v0 that points nowhere: the robot senses one mark at v0, no mark
    elsewhere, and no bearing.  The answer is the map if only one map has this quotient, else the
    quotient.

    Args:
        first: the percept at the start.
        choices: not used, because the explorer makes no choice.
        notice: the function that gets one event at the end: ``map`` or ``ambiguous``, the kind of
            the answer.

    Cost: polynomial in the darts; at most 557 traversals for up to 4 edges, 1,791 for 5 edges.
    """
    learner = _Learner(Experiments(first))
    yield from learner.learn()
    found = learner.table
    answer = found.only_world() if found.is_alone() else found.ambiguous()
    notice("map" if isinstance(answer, Estimate) else "ambiguous")
    return answer


class ClassTable(NamedTuple):
    """The table of the classes of darts: to which class each letter leads from each class.

    The classes are numbered 0, 1, 2, ...; class 0 is that of the dart that the robot faces at the
    start.

    Attributes:
        sigma, alpha: for each class the class to which the letter ``s``, or ``a``, leads.
        sensed: for each class the percept of a robot at its darts.
        here: the class of the robot's dart at the end of the experiments; 0 before.
    """

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    sensed: tuple[Percept, ...]
    here: int

    def after(self, word: SensedWord, of: int = 0) -> int:
        """The class to which ``word`` leads from the class ``of``, by this table."""
        for letter in word:
            of = self.sigma[of] if letter == "s" else self.alpha[of]
        return of

    def words(self) -> dict[int, SensedWord]:
        """For each class that can be reached, a shortest word from the class of the start to it."""
        words: dict[int, SensedWord] = {0: ()}
        for of in (queue := [0]):
            for letter in "sa":
                other = self.after((letter,), of)
                if other not in words:
                    words[other] = (*words[of], letter)
                    queue.append(other)
        return words

    def vertices(self) -> tuple[tuple[int, ...], ...]:
        """The cycles of sigma, each a vertex of the quotient; the cycle of class 0 comes first."""
        return cycles(self.sigma)

    @property
    def sheets(self) -> int:
        """The number of darts of the world in each class, the same for all classes.

        v0 alone has a mark, so the classes of its darts hold no darts of other vertices: the number
        is the degree of v0, divided by the number of these classes.
        """
        return self.turns(self.vertices()[0])

    def is_alone(self) -> bool:
        """Whether only one world has this quotient."""
        halves = sum(of == other for of, other in enumerate(self.alpha))
        vertices = self.vertices()
        cycles = (len(self.alpha) - halves) // 2 - len(vertices) + 1
        rigid = not halves and all(self.turns(v) == 1 for v in vertices[1:])
        return self.sheets == 1 or (not cycles and (self.sheets == 2 or rigid))

    def turns(self, vertex: Sequence[int]) -> int:
        """The number of times that each class in ``vertex`` occurs round a vertex of the world.

        ``vertex`` is one of :meth:`vertices`.  All vertices of the world that have darts of these
        classes have the same degree; the result is this degree divided by the number of the
        classes.
        """
        return self.sensed[vertex[0]].degree // len(vertex)

    def only_world(self) -> Estimate:
        """The only world with this quotient, as an estimate; :meth:`is_alone` must be true.

        The darts of each class have numbers, from 0 on, as many as there are sheets.  sigma and
        alpha lead to a dart with the same number in another class, with two exceptions.

        First: the classes of a vertex of the quotient (see :meth:`vertices`) may occur several
        times round a vertex of the world.  By :meth:`is_alone` this number is then that of the
        sheets.  So one vertex has all darts of these classes: first those with the number 0,
        clockwise, then those with the number 1, and so on.  Where sigma leads from the last of
        these classes to the first one, it adds 1 to the number, modulo the number of sheets.

        Second: alpha may lead from a class to itself.  By :meth:`is_alone` there are then two
        sheets, and alpha exchanges the darts 0 and 1 of this class.
        """
        k = self.sheets
        sigma = [of * k + i for of in self.sigma for i in range(k)]
        alpha = [of * k + i for of in self.alpha for i in range(k)]
        for vertex in self.vertices():
            if self.turns(vertex) > 1:
                last = vertex[-1]
                for i in range(k):
                    sigma[last * k + i] = vertex[0] * k + (i + 1) % k
        for of, other in enumerate(self.alpha):
            if of == other:
                alpha[of * k], alpha[of * k + 1] = of * k + 1, of * k
        return Estimate(CombinatorialMap(sigma, alpha), self.here * k)

    def ambiguous(self) -> Ambiguous:
        """The answer with the rooted quotient instead of a map."""
        degree = tuple(percept.degree for percept in self.sensed)
        marks = tuple(percept.marks for percept in self.sensed)
        return Ambiguous(self.sigma, self.alpha, degree, marks, self.here)


class _Learner:
    """The learning of the table of classes by experiments.

    Attributes:
        world: the tree of all walks, in which the robot makes the experiments.
        telling: the words that distinguish the classes: two darts are in one class if the robot
            senses the same after each of these words.
        table: the table of classes.
    """

    def __init__(self, world: Experiments) -> None:
        self.world = world
        self.telling: list[SensedWord] = [()]
        self.table = ClassTable((), (), (), 0)
        self._reached: list[SensedWord] = []
        self._rows: list[SensedRow] = []

    def learn(self) -> Stage[None]:
        """Make experiments until the attribute ``table`` is right.

        The table is right as soon as it predicts all percepts along the words of
        :meth:`_to_be_met`.  A word for which it predicts a wrong percept joins ``telling`` with all
        its suffixes; then a new table is made.  At last the class of the robot's dart (``here``) is
        written into the table.
        """
        wrong: SensedWord | None = ()
        while wrong is not None:
            for i in range(len(wrong) + 1):
                if wrong[i:] not in self.telling:
                    self.telling.append(wrong[i:])
            yield from self._close()
            wrong = yield from self._refuted()
        # Experiments would move the robot, and the way of the robot suffices.
        here = self.table.after(self.world.word_to(self.world.here))
        self.table = self.table._replace(here=here)

    def _close(self) -> Stage[None]:
        """Set the attribute ``table`` to a new table of classes, made by experiments.

        Two darts are in one class if the robot senses the same after each word of ``telling``.
        """
        self._reached, self._rows = [()], [(yield from self._row(self.world.start))]
        leads: dict[str, list[int]] = {"s": [], "a": []}
        for word in self._reached:
            for letter, to in leads.items():
                further = (*word, letter)
                row = yield from self._row((yield from self.world.walk(further)))
                if row not in self._rows:
                    self._rows.append(row)
                    self._reached.append(further)
                to.append(self._rows.index(row))
        sensed = tuple(row[0] for row in self._rows)
        self.table = ClassTable(tuple(leads["s"]), tuple(leads["a"]), sensed, 0)

    def _row(self, dart: TreeDart) -> Stage[SensedRow]:
        row = []
        for word in self.telling:
            row.append(self.world.sensed((yield from self.world.walk(word, dart))))
        return tuple(row)

    def _refuted(self) -> Stage[SensedWord | None]:
        """A word from the start at whose end the attribute ``table`` predicts a wrong percept.

        The robot walks the words of :meth:`_to_be_met`.  At the start and after each letter it
        walks each word of ``telling`` from the dart that it has reached, and compares the percept
        at the end with the prediction of the table.  The result consists of the letters so far and
        the word of ``telling`` that gave a wrong percept; None if all predictions are right.
        """
        for word in self._to_be_met():
            at, of = self.world.start, 0
            for i in range(len(word) + 1):
                if i:
                    at = yield from self.world.walk(word[i - 1 : i], at)
                    of = self.table.after(word[i - 1 : i], of)
                row = yield from self._row(at)
                if row != self._rows[of]:
                    shown = zip(self.telling, row, self._rows[of], strict=True)
                    return word[:i] + next(telling for telling, a, b in shown if a != b)
        return None

    def _to_be_met(self) -> Iterator[SensedWord]:
        """Yield the words from the start along which the table must predict rightly.

        If the attribute ``table`` predicts rightly along all these words, it is right for every
        word.  Each of the first words leads to a dart of a class, and then goes on by ``a`` twice,
        or by ``s`` as often as the vertex has darts: this shows that ``a`` and ``s`` can be undone.

        Each other word has four parts.  First: letters ``s`` lead to a dart of v0 that is in class
        0 by the table.  Second: a shortest word leads to some class.  Third: one letter leads to a
        next class.  Fourth: the letters of :meth:`_back`, which undo a shortest word to the next
        class, lead to a dart of class 0 at v0, which the mark shows.  So from the darts of class 0
        the second and third parts lead to the same darts as that shortest word, and these darts are
        all that the next class has.
        """
        table = self.table
        degrees = [percept.degree for percept in table.sensed]
        # The letters have inverses, and v0 has as many classes as there are different rows.
        for word, degree in zip(self._reached, degrees, strict=True):
            yield (*word, "a", "a")
            yield (*word, *"s" * degree)
        size = len(table.vertices()[0])
        words = table.words()
        for turned in range(0, degrees[0], size):
            for of, word in words.items():
                for letter in "sa":
                    other = table.after((letter,), of)
                    back = self._back(words[other], degrees)
                    yield (*"s" * turned, *word, letter, *back)

    def _back(self, word: SensedWord, degrees: list[int]) -> SensedWord:
        """The word that undoes ``word``, which begins at class 0: it leads back to class 0.

        ``a`` undoes the letter ``a``; at a vertex of degree d, d - 1 times ``s`` undo one ``s``.
        ``degrees`` holds for each class the degree of its darts' vertices.
        """
        back: list[str] = []
        for i in range(len(word), 0, -1):
            degree = degrees[self.table.after(word[: i - 1])]
            back += ["a"] if word[i - 1] == "a" else ["s"] * (degree - 1)
        return tuple(back)
