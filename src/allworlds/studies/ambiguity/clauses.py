"""Clauses over named variables, and the DIMACS files that hold them."""

from collections.abc import Sequence
from itertools import combinations
from math import prod
from pathlib import Path
from typing import TypeAlias

from msgspec import Struct

Literal: TypeAlias = int
"""A variable ``1, 2, ...``, or its negative."""

Clause: TypeAlias = tuple[Literal, ...]
"""A disjunction of literals."""


class Atoms(Struct, frozen=True):
    """A block: consecutive variables of a formula, one for each index, or each pair of indices.

    Attributes:
        name: the name of the block, for example ``sigma1``.
        first: the variable of index 0, or of the pair ``(0, 0)``.
        shape: the number of indices; for pairs, the numbers of first and of second indices.  The
            variables that have the same first index are consecutive.
        meaning: a sentence about the indices x and y; the variable is true if this sentence is.
    """

    name: str
    first: int
    shape: tuple[int, ...]
    meaning: str

    def __getitem__(self, index: int | tuple[int, int]) -> int:
        """The variable of an index, or of a pair of indices."""
        if isinstance(index, int):
            return self.first + index
        return self.first + index[0] * self.shape[1] + index[1]

    def slices(self) -> list[range]:
        """The variables of a two-dimensional block, a range for each first index."""
        height, width = self.shape
        return [range(self.first + i * width, self.first + (i + 1) * width) for i in range(height)]

    @property
    def variables(self) -> range:
        """Every variable of the block."""
        return range(self.first, self.first + prod(self.shape))


class Formula:
    """Clauses, and their variables, which are made in blocks (:class:`Atoms`).

    Attributes:
        title: the statement of the formula, line by line.
        blocks: the blocks of variables, in the order in which they were made.
        variable_count: the number of variables in all blocks.
        clauses: the clauses; each is a tuple of literals, a variable or its negative.
    """

    def __init__(self, title: Sequence[str] = ()) -> None:
        self.title = title
        self.variable_count = 0
        self.clauses: list[Clause] = []
        self.blocks: list[Atoms] = []
        self._sections: list[tuple[int, str]] = []

    def block(self, name: str, shape: tuple[int, ...], meaning: str) -> Atoms:
        """Add a block of new variables to the formula, and return the block.

        The arguments are the attributes of :class:`Atoms` with these names.
        """
        block = Atoms(name, self.variable_count + 1, shape, meaning)
        self.blocks.append(block)
        self.variable_count += prod(shape)
        return block

    def section(self, text: str) -> None:
        """Begin a section of clauses; ``text``, its meaning, becomes a comment in the file."""
        self._sections.append((len(self.clauses), text))

    def add(self, *literals: Literal) -> None:
        """Add one clause, a disjunction of literals."""
        self.clauses.append(literals)

    def exactly_one(self, variables: Sequence[Literal]) -> None:
        """Require exactly one of these variables to be true."""
        self.clauses.append(tuple(variables))
        self.at_most_one(variables)

    def at_most_one(self, variables: Sequence[Literal]) -> None:
        """Require at most one of these variables to be true."""
        self.clauses += [(-a, -b) for a, b in combinations(variables, 2)]

    def equivalent(self, a: Literal, b: Literal, *unless: Literal) -> None:
        """Require two literals to be both true or both false, unless one of ``unless`` is true."""
        self.clauses += [(-a, *unless, b), (a, *unless, -b)]

    def write(self, path: Path) -> None:
        """Write the formula as a DIMACS file, with the meanings of variables and clauses.

        Cost: about a microsecond a literal.
        """
        lines = [f"c {line}" for line in self.title]
        lines += [
            f"c variables {b.variables[0]}..{b.variables[-1]} "
            f"{b.name}{''.join(f'[{size}]' for size in b.shape)}: {b.meaning}"
            for b in self.blocks
            if b.variables
        ]
        header, *written = dimacs(self.variable_count, self.clauses)
        lines.append(header)
        ends = [start for start, _ in self._sections[1:]] + [len(written)]
        for (start, text), end in zip(self._sections, ends, strict=True):
            if start < end:
                lines.append(f"c clauses {start + 1}..{end}: {text}")
            lines += written[start:end]
        path.write_text("\n".join(lines) + "\n", encoding="ascii")


def dimacs(variables: int, clauses: Sequence[Clause]) -> list[str]:
    """The lines, without comments, of the DIMACS file of these clauses and this many variables."""
    lines = [" ".join(map(str, clause)) + " 0" for clause in clauses]
    return [f"p cnf {variables} {len(clauses)}", *lines]


def read_dimacs(path: Path, leave_out: str = "") -> tuple[int, list[Clause]]:
    """The number of variables and the clauses in a DIMACS file that :class:`Formula` wrote.

    Args:
        path: the path of the file.
        leave_out: the text of the section whose clauses are left out; empty: all clauses are read.

    Raises:
        ValueError: if the file has no section with this text.
    """
    variables, clauses, section, found = 0, list[Clause](), "", False
    for line in path.read_text(encoding="ascii").splitlines():
        if line.startswith("p cnf "):
            variables = int(line.split()[2])
        elif line.startswith("c clauses "):
            section = line.partition(": ")[2]
            found = found or section == leave_out
        elif not line.startswith("c") and not (leave_out and section == leave_out):
            clauses.append(tuple(map(int, line.split()[:-1])))
    if leave_out and not found:
        raise ValueError(f"{path} has no section {leave_out!r}")
    return variables, clauses
