"""Clauses written as implications, and whether a file holds exactly these.

A *clause* is an implication between numbered variables: if all on the left hold, then one of
those on the right does.  With nothing on the left one on the right must hold; with nothing on
the right those on the left do not all hold.  In a DIMACS file the left ones stand negated.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import combinations

from lrat import Refused

Row = list[int]
Table = list[Row]


class Clauses:
    """Variables with names, and clauses with the sentence that they belong to.

    Attributes:
        variables: how many there are; they are numbered from 1.
        tables: the variables by name: rows, or tables of two dimensions.
        headings: as a file's comments name them: ``1..4 sigma1[2][2]``.
        sentences: each clause, as the set of its literals, with its sentence.
    """

    def __init__(self) -> None:
        self.variables = 0
        self.tables: dict[str, Row | Table] = {}
        self.headings: set[str] = set()
        self.sentences: dict[frozenset[int], str] = {}
        self._sentence = ""

    def row(self, name: str, size: int) -> Row:
        """New variables ``name[0], name[1], ...``."""
        self.headings.add(f"{self.variables + 1}..{self.variables + size} {name}[{size}]")
        self.tables[name] = row = self._new(size)
        return row

    def table(self, name: str, rows: int, columns: int) -> Table:
        """New variables ``name[i][j]``, row by row."""
        last = self.variables + rows * columns
        self.headings.add(f"{self.variables + 1}..{last} {name}[{rows}][{columns}]")
        self.tables[name] = table = [self._new(columns) for _ in range(rows)]
        return table

    def _new(self, size: int) -> Row:
        first = self.variables + 1
        self.variables += size
        return list(range(first, first + size))

    def say(self, sentence: str) -> None:
        """The clauses from here on say this together."""
        self._sentence = sentence

    def implies(self, left: Sequence[int], right: Sequence[int]) -> None:
        """If all on the left hold, one on the right does."""
        clause = frozenset([-variable for variable in left] + [*right])
        self.sentences.setdefault(clause, self._sentence)

    def equivalent(self, here: Sequence[int], one: int, other: int) -> None:
        """If all of ``here`` hold, one holds exactly if the other does."""
        self.implies([*here, one], [other])
        self.implies([*here, other], [one])

    def always(self, variable: int) -> None:
        """The variable holds."""
        self.implies([], [variable])

    def never(self, *variables: int) -> None:
        """They do not all hold."""
        self.implies(variables, [])

    def at_most_one(self, variables: Sequence[int]) -> None:
        """No two of them hold."""
        for pair in combinations(variables, 2):
            self.never(*pair)

    def exactly_one(self, variables: Sequence[int]) -> None:
        """One of them holds, and no two do."""
        self.implies([], variables)
        self.at_most_one(variables)

    def in_words(self, clause: frozenset[int]) -> str:
        """The clause as an implication between named variables, and its sentence."""
        left = " and ".join(self._name(-v) for v in sorted(clause, reverse=True) if v < 0)
        right = " or ".join(self._name(v) for v in sorted(clause) if v > 0)
        return f"'{left or 'always'} => {right or 'never'}' ({self.sentences[clause]})"

    def _name(self, variable: int) -> str:
        for name, table in self.tables.items():
            for i, entry in enumerate(table):
                if entry == variable:
                    return f"{name}[{i}]"
                if isinstance(entry, list) and variable in entry:
                    return f"{name}[{i}][{entry.index(variable)}]"
        raise KeyError(variable)


def require_comments(wanted: Clauses, text: str) -> None:
    """Raise Refused unless the comments of a DIMACS text that name variables name the right ones.

    Comments are for readers; a formula means the same without them.

    Raises:
        Refused: naming the comment.
    """
    for line in re.findall(r"^c variables .*", text, re.MULTILINE):
        if line.removeprefix("c variables ").partition(": ")[0] not in wanted.headings:
            raise Refused(f"there are no such variables: {line}")


def require_same(wanted: Clauses, variables: int, clauses: Sequence[Sequence[int]]) -> None:
    """Raise Refused unless a formula has exactly these variables and, as a set, these clauses.

    Order and repetition make no difference; every other difference does.

    Raises:
        Refused: naming a clause that one has and the other has not.
    """
    if variables != wanted.variables:
        raise Refused(f"the formula has {variables} variables, not {wanted.variables}")
    missing = dict.fromkeys(wanted.sentences)
    for number, literals in enumerate(clauses, 1):
        clause = frozenset(literals)
        if clause not in wanted.sentences:
            raise Refused(f"clause {number} of the formula says what it should not: {literals}")
        missing.pop(clause, None)
    for clause in missing:
        raise Refused(f"the formula does not say {wanted.in_words(clause)}")
