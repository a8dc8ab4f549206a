"""Learning by a homing sequence: the map as an automaton that cannot be put back to its start.

The states are darts, the inputs are offsets, the outputs are percepts.  A word is a homing
sequence if its percepts tell where the robot is in the end.  The explorer thinks that a word is
one, walks it before every experiment, and keeps a table of experiments for each series of
percepts that it has sensed on the way.  If the same experiment ends differently for one series, the
word is no homing sequence: the word and the experiment make a longer one, and the tables are begun
anew.  A table with as many different rows as there are darts is the map.

Source: R. Rivest, R. Schapire, Inference of finite automata using homing sequences (1993);
D. Angluin, Learning regular sets from queries and counterexamples (1987).

Lighthouse: ``directional+told:m``, under which all darts differ, and their number is told.  Task:
``map``.  Expected: ``learns`` HOLDS as far as it was tried (3 edges); ``trusts``, which never makes
the word longer, is REFUTED by the law ``budget``, in the smallest case in the loop::

    allworlds check homing.py:learns --edges 3 --lighthouse directional+told:m --bound none
        --step-budget 20000
"""

from itertools import product

from allworlds import CombinatorialMap, Estimate, Move


def by_homing(*, doubts):
    """The explorer that doubts that its word is a homing sequence, or never does."""

    def explore(first, *, told):
        darts = 2 * told["m"]
        word, tables, percept = (), {}, first
        while True:
            homed = [percept]
            for offset in word:
                percept = yield Move(offset)
                homed.append(percept)
            home = tuple(homed[1:])  # what was sensed before the word is not of its making
            table = tables.setdefault(home, Table(percept, darts))
            asked = table.next_experiment()
            if asked is None:
                return table.answer()
            seen = []
            for offset in asked:
                percept = yield Move(offset)
                seen.append(percept)
            if not table.takes(asked, seen) and doubts:
                word, tables = (*word, *asked), {}

    return explore


class Table:
    """Experiments after the homing sequence has ended in one way.

    Attributes:
        darts: the number of different rows that are wanted.
        seen: the percept at the end of each word that was walked.
        access: words that lead to different rows.
        endings: a row holds the percepts at the end of the word and of each of these after it.
    """

    def __init__(self, first, darts):
        self.darts, self.seen = darts, {(): first}
        self.access, self.endings = [()], [(0,), (1,)]

    def takes(self, asked, seen):
        """Note an experiment; whether its percepts agree with all that was seen before."""
        ends = [asked[: i + 1] for i in range(len(asked))]
        return all(
            self.seen.setdefault(end, told) == told for end, told in zip(ends, seen, strict=True)
        )

    def row(self, word):
        """The row of a word; all of it was seen."""
        return tuple(self.seen[word + ending] for ending in [(), *self.endings])

    def next_experiment(self):
        """The first word that is not known and must be; None if the table is finished.

        Offsets 0 and 1 are enough: they lead from any dart to every other one.
        """
        while True:
            onward = [word + step for word in self.access for step in [(0,), (1,)]]
            for word in [*self.access, *onward]:
                for ending in self.endings:
                    if word + ending not in self.seen:
                        return word + ending
            rows = {self.row(word) for word in self.access}
            if new := next((word for word in onward if self.row(word) not in rows), None):
                self.access.append(new)
            elif len(rows) == self.darts:
                return None
            else:
                self.endings += product((0, 1), repeat=len(self.endings[-1]) + 1)

    def answer(self):
        """The map, and the dart at the end of the homing sequence."""
        numbers = {self.row(word): i for i, word in enumerate(self.access)}
        alpha = [numbers[self.row((*word, 0))] for word in self.access]
        onward = [numbers[self.row((*word, 1))] for word in self.access]
        return Estimate(CombinatorialMap([alpha[dart] for dart in onward], alpha), 0)


learns = by_homing(doubts=True)
trusts = by_homing(doubts=False)
