"""Checkers of the proofs, written by a solver, that a formula has no model.

The checkers share no code with the modules that make or solve formulas.  A proof adds clauses that
follow from the formula, line by line, until it adds the empty clause.  DRAT and LRAT are two
formats of proofs.  :func:`check_lrat` checks LRAT; :func:`lrat_of_drat` is a forward checker of
DRAT by unit propagation, which returns LRAT.

*Unit propagation*: as long as all literals of a clause but one are false, and this one is open, the
open literal becomes true.  A *conflict* is a clause whose literals are all false.  Every added
clause must have the property RUP: if its literals are assumed false, unit propagation over the
clauses so far ends in a conflict.  The clauses of this propagation become the *hints* of an LRAT
line, so that the result can be checked again without any search.  Lines that need the property RAT
are refused; the solver of this package writes no such lines.
"""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TypeAlias

Literal: TypeAlias = int
"""A variable ``1, 2, ...``, or its negative."""

Clause: TypeAlias = tuple[Literal, ...]
"""A disjunction of literals."""


class ProofRefused(ValueError):
    """Raised if a proof does not prove its claim; the message names the line that is wrong."""


def check_lrat(clauses: Sequence[Clause], proof: Iterable[str]) -> None:
    """Raise ProofRefused unless the proof derives the empty clause from the clauses.

    A step of the proof adds a clause, and its hints name earlier clauses.  The literals of the new
    clause are assumed false.  Then each hint in turn must have at most one literal that is not
    false yet, and all literals of the last hint must be false: hints without a conflict prove
    nothing.  The one literal that is not false may be true already: CaDiCaL writes a few hints of
    this kind, and they are harmless.

    Raises:
        ProofRefused: naming the line that is wrong, or saying that there is no empty clause.

    Cost: a second for a proof of 5 MB.
    """
    known: dict[int, Clause] = dict(enumerate(clauses, 1))
    for i, line in enumerate(proof, 1):
        words = line.split()
        try:
            if words[1] == "d":
                _forget(known, [int(word) for word in words[2:]])
                continue
            number, *rest = map(int, words)
            end = rest.index(0)
            clause, hints = tuple(rest[:end]), rest[end + 1 :]
            _derive(known, number, clause, hints)
        except (ValueError, IndexError) as error:
            raise ProofRefused(f"line {i} of the LRAT proof: {error}") from None
        if not clause:
            return
    raise ProofRefused("the LRAT proof ends without the empty clause")


def _forget(known: dict[int, Clause], numbers: list[int]) -> None:
    if numbers[-1] != 0:
        raise ProofRefused("does not end with 0")
    for number in numbers[:-1]:
        if known.pop(number, None) is None:
            raise ProofRefused(f"deletes clause {number}, which there is not")


def _derive(known: dict[int, Clause], number: int, clause: Clause, hints: list[int]) -> None:
    if number in known:
        raise ProofRefused(f"number {number} is taken")
    if hints.pop() != 0:
        raise ProofRefused("does not end with 0")
    false = set(clause)
    if any(-literal in false for literal in clause):
        raise ProofRefused(f"adds {clause}, which is always true")
    for index, hint in enumerate(hints, 1):
        if hint not in known:
            raise ProofRefused(f"hint {hint} is no clause at this point")
        open_literals = [literal for literal in known[hint] if literal not in false]
        if not open_literals:
            if index < len(hints):
                raise ProofRefused(f"hint {hint} is false already, but more hints follow")
            known[number] = clause
            return
        if len(open_literals) > 1:
            raise ProofRefused(f"hint {hint} is neither false nor implies a literal")
        false.add(-open_literals[0])
    raise ProofRefused("the hints end without a conflict")


class RupChecker:
    """A checker of the clauses that a DRAT proof adds and deletes, by unit propagation.

    The checker holds the clauses of the formula and the derived clauses, which it numbers.  The
    *trail* is the list of the literals that are true, in the order in which they became true.  Two
    literals of each clause are *watched*: propagation looks at a clause only when a watched literal
    of the clause becomes false, so most clauses are skipped.

    Attributes:
        lemmas: the literals and hints of each derived clause, by its number.  Hints are the numbers
            of the clauses that a propagation uses.
        empty: the number of the empty clause once it has been derived, else None.
    """

    def __init__(self, variables: int, clauses: Sequence[Clause]) -> None:
        # Negative indices reach the second half: value[-v] is the literal -v's.
        self._value: list[int] = [0] * (2 * variables + 1)
        self._watched: list[list[int]] = [[] for _ in range(2 * variables + 1)]
        self._reason: list[int] = [0] * (variables + 1)
        self._clauses: dict[int, list[Literal]] = {}
        self._numbers: dict[tuple[Literal, ...], list[int]] = {}
        self._trail: list[Literal] = []
        self._free = len(clauses) + 1
        self.lemmas: dict[int, tuple[Clause, list[int]]] = {}
        self.empty: int | None = None
        for number, clause in enumerate(clauses, 1):
            self._insert(number, clause)
        for number, clause in enumerate(clauses, 1):
            if self.empty is None and len(clause) <= 1:
                self._settle(number)

    def add(self, clause: Clause) -> None:
        """Derive a clause, and add it to the clauses.

        Raises:
            ProofRefused: if unit propagation from the clause's negation finds no conflict.
        """
        number = self._derive(clause, self._hints(clause))
        if self.empty is None:
            self._insert(number, clause)
            self._settle(number)

    def delete(self, clause: Clause) -> None:
        """Delete a clause from the clauses.

        Unit clauses stay, because their consequences have been used.

        Raises:
            ProofRefused: if the clause is not among the clauses.
        """
        literals = tuple(sorted(set(clause)))
        numbers = self._numbers.get(literals)
        if not numbers:
            raise ProofRefused(f"deletes {clause}, which is no clause at this point")
        if len(literals) > 1:
            # The watches are dropped when they are next visited.
            del self._clauses[numbers.pop()]

    def _derive(self, clause: Clause, hints: list[int]) -> int:
        number = self._free
        self._free += 1
        self.lemmas[number] = (clause, hints)
        if not clause:
            self.empty = number
        return number

    def _insert(self, number: int, clause: Clause) -> None:
        value = self._value
        literals = sorted(set(clause), key=lambda literal: value[literal] < 0)
        self._numbers.setdefault(tuple(sorted(literals)), []).append(number)
        self._clauses[number] = literals
        for literal in literals[:2]:
            self._watched[literal].append(number)

    def _settle(self, number: int) -> None:
        """Derive, by unit propagation, the unit clauses that follow from clause ``number``.

        If propagation finds a conflict, the empty clause is derived.
        """
        free = [literal for literal in self._clauses[number] if self._value[literal] >= 0]
        if len(free) > 1 or (free and self._value[free[0]] > 0):
            return
        conflict, start = number, len(self._trail)
        if free:
            self._assign(free[0], number)
            conflict = self._propagate(start)
        for literal in self._trail[start:]:
            self._name_unit(literal)
        if conflict:
            others = [self._reason[abs(literal)] for literal in self._clauses[conflict]]
            self._derive((), [*others, conflict])

    def _name_unit(self, literal: Literal) -> None:
        reason = self._reason[abs(literal)]
        clause = self._clauses[reason]
        if len(clause) > 1:
            others = [self._reason[abs(other)] for other in clause if other != literal]
            self._reason[abs(literal)] = number = self._derive((literal,), [*others, reason])
            self._insert(number, (literal,))

    def _hints(self, clause: Clause) -> list[int]:
        """The numbers of the clauses by which unit propagation refutes the negation of ``clause``.

        The numbers are in the order in which the propagation uses the clauses.

        Raises:
            ProofRefused: if propagation finds no conflict.
        """
        value, base = self._value, len(self._trail)
        for literal in clause:
            if value[literal] > 0:
                unit = self._reason[abs(literal)]
                self._retract(base)
                if unit == 0:
                    raise ProofRefused(f"adds {clause}, which contains {literal} and {-literal}")
                return [unit]
            if value[literal] == 0:
                self._assign(-literal, 0)
        conflict = self._propagate(base)
        if not conflict:
            self._retract(base)
            raise ProofRefused(f"adds {clause}, which unit propagation does not give")
        hints = self._explain(clause, conflict, base)
        self._retract(base)
        return hints

    def _explain(self, lemma: Clause, conflict: int, base: int) -> list[int]:
        reason, trail, clauses = self._reason, self._trail, self._clauses
        needed = {-literal for literal in clauses[conflict]}
        chain = [conflict]
        for literal in reversed(trail[base:]):
            if literal in needed:
                needed.discard(literal)
                number = reason[abs(literal)]
                if number:
                    chain.append(number)
                    needed.update(-other for other in clauses[number] if other != literal)
        # What is left is known for good, or is the negation of a literal of the lemma.
        needed -= {-literal for literal in lemma}
        units = {reason[abs(literal)] for literal in needed}
        return [*sorted(units), *reversed(chain)]

    def _assign(self, literal: Literal, reason: int) -> None:
        self._value[literal] = 1
        self._value[-literal] = -1
        self._reason[abs(literal)] = reason
        self._trail.append(literal)

    def _retract(self, length: int) -> None:
        value, reason = self._value, self._reason
        for literal in self._trail[length:]:
            value[literal] = value[-literal] = 0
            reason[abs(literal)] = 0
        del self._trail[length:]

    def _propagate(self, head: int) -> int:
        """Make all literals true that follow by unit propagation; append them to the trail.

        Before index ``head`` of the trail the consequences of every literal are known already.
        Return the number of a clause that is a conflict, or 0 if propagation ends without one.
        """
        value, watched, clauses = self._value, self._watched, self._clauses
        trail, reason = self._trail, self._reason
        while head < len(trail):
            false = -trail[head]
            head += 1
            waiting = watched[false]
            kept: list[int] = []
            for i, number in enumerate(waiting):
                clause = clauses.get(number)
                if clause is None:
                    continue
                other = clause[0]
                if other == false:
                    if len(clause) == 1:
                        kept += waiting[i:]
                        watched[false] = kept
                        return number
                    other = clause[0] = clause[1]
                    clause[1] = false
                if value[other] > 0:
                    kept.append(number)
                    continue
                for k in range(2, len(clause)):
                    literal = clause[k]
                    if value[literal] >= 0:
                        clause[1] = literal
                        clause[k] = false
                        watched[literal].append(number)
                        break
                else:
                    kept.append(number)
                    if value[other] < 0:
                        kept += waiting[i + 1 :]
                        watched[false] = kept
                        return number
                    value[other] = 1
                    value[-other] = -1
                    reason[abs(other)] = number
                    trail.append(other)
            watched[false] = kept
        return 0


def lrat_of_drat(
    variables: int, clauses: Sequence[Clause], proof: Iterable[str]
) -> list[tuple[int, Clause, list[int]]]:
    """Check a DRAT proof, and return it as LRAT steps ``(number, clause, hints)``.

    Args:
        variables: the largest variable.
        clauses: the formula.
        proof: DRAT lines, ``1 -2 0`` to add and ``d 1 -2 0`` to delete.

    Raises:
        ProofRefused: naming the first line that does not follow, or the missing empty clause.

    Cost: some 10,000 lines a second for formulas of 50,000 clauses.
    """
    checker = RupChecker(variables, clauses)
    for i, line in enumerate(proof, 1):
        words = line.split()
        if checker.empty is not None:
            break
        try:
            *literals, end = map(int, words[words[0] == "d" :])
            if end != 0 or any(not 0 < abs(literal) <= variables for literal in literals):
                raise ProofRefused("is no clause over the formula's variables")
            (checker.delete if words[0] == "d" else checker.add)(tuple(literals))
        except (ValueError, IndexError) as error:
            raise ProofRefused(f"line {i} of the DRAT proof: {error}") from None
    if checker.empty is None:
        raise ProofRefused("the DRAT proof ends without the empty clause")
    return [(number, *lemma) for number, lemma in checker.lemmas.items()]


def write_lrat(steps: Iterable[tuple[int, Clause, list[int]]], path: Path) -> None:
    """Write the steps as an LRAT file, one step a line: number, literals, 0, hints, 0."""
    lines = [
        " ".join(map(str, [number, *clause, 0, *hints, 0])) + "\n"
        for number, clause, hints in steps
    ]
    path.write_text("".join(lines), encoding="ascii")
