"""Checks that an LRAT proof refutes a formula.  Python's standard library, nothing else.

    python proofs/certificates/lrat.py FORMULA.cnf PROOF.lrat        (either may be compressed: .xz)

prints one line, ``VERIFIED: ...`` (exit code 0) or ``REFUSED: ...`` (1; 2: a file is missing).

A proof is a list of lines ``number literals 0 hints 0``.  A line is right if the negation of
its literals, and then the hints in their order, lead to a contradiction: each hint names a
clause all of whose literals are false but one, which is then true, and the last hint names a
clause all of whose literals are false.  (The one literal may be true already; such a hint does no
harm, and solvers write some.)  A line ``number d numbers 0`` forgets clauses.  Every
line is checked, to the end of the file, and the empty clause must be among them.  Refused are
also: a hint with two open literals, hints after the contradiction, a number that is not larger
than all before it, a clause that is forgotten twice, literals that are no variables of the
formula, steps with a negative hint (RAT), and anything that is no number.
"""

from __future__ import annotations

import lzma
import re
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

FOREIGN = re.compile(r"[^-\dd \t]", re.ASCII)
"""``int`` would take 1_0 and +1 for numbers."""


class Refused(Exception):
    """The proof, or a file, is not what it should be; the message says where."""


def read(path: Path) -> str:
    """The text of a file, decompressed if its name ends in ``.xz``."""
    try:
        data = path.read_bytes()
        return (lzma.decompress(data) if path.suffix == ".xz" else data).decode("ascii")
    except (lzma.LZMAError, UnicodeDecodeError) as error:
        raise Refused(f"{path.name} is damaged: {error}") from None


def read_formula(text: str) -> tuple[int, list[list[int]]]:
    """The number of variables and the clauses of a DIMACS text, one clause a line."""
    variables, announced, clauses = 0, -1, []
    for i, line in enumerate(text.splitlines(), 1):
        if line.split()[:1] in ([], ["c"]):
            continue
        try:
            if announced < 0:
                p, cnf, *numbers = line.split()
                variables, announced = map(int, numbers)
                if (p, cnf) != ("p", "cnf") or variables < 0 or announced < 0:
                    raise ValueError
                continue
            words = _words(line)
            *clause, _ = map(int, words)
        except ValueError:
            raise Refused(f"line {i} of the formula is neither header nor clause") from None
        if words[-1] != "0" or any(not 0 < abs(literal) <= variables for literal in clause):
            raise Refused(f"line {i} of the formula has a literal that is none, or no end")
        clauses.append(clause)
    if len(clauses) != announced:
        raise Refused(f"the formula announces {announced} clauses and has {len(clauses)}")
    return variables, clauses


def check(variables: int, clauses: Sequence[Sequence[int]], proof: Iterable[str]) -> int:
    """The number of clauses derived by a proof that refutes the formula.

    Raises:
        Refused: naming the line.
    """
    known: dict[int, Sequence[int]] = dict(enumerate(clauses, 1))
    newest, derived, refuted = len(clauses), 0, False
    for i, line in enumerate(proof, 1):
        try:
            words = _words(line)
            if len(words) > 1 and words[1] == "d":
                forgotten = _numbers(words[:1] + words[2:])[1:]
                for number in forgotten:
                    if known.pop(number, None) is None:
                        raise Refused(f"clause {number} is forgotten, but there is none")
                continue
            if "0" not in words:
                raise Refused("no 0 ends the literals")
            middle = words.index("0")
            number, *clause = map(int, words[:middle])
            hints = _numbers(words[middle + 1 :])
            if number <= newest:
                raise Refused(f"number {number} is not larger than {newest}")
            if any(not 0 < abs(literal) <= variables for literal in clause):
                raise Refused("a literal is no variable of the formula")
            _contradiction(known, clause, hints)
        except ValueError:
            raise Refused(f"line {i}: not a line of numbers") from None
        except Refused as error:
            raise Refused(f"line {i}: {error}") from None
        known[number] = clause
        newest = number
        derived += 1
        refuted = refuted or not clause
    if not refuted:
        raise Refused("the empty clause is not derived")
    return derived


def _words(line: str) -> list[str]:
    """The words of a line; ValueError, if a character is in it that stands in no number."""
    if FOREIGN.search(line):
        raise ValueError(line)
    return line.split()


def _numbers(words: list[str]) -> list[int]:
    """The numbers before the 0 that ends a line."""
    *numbers, _ = map(int, words)
    if words[-1] != "0" or 0 in numbers:
        raise Refused("a 0 does not stand at the end alone")
    if any(number < 0 for number in numbers):
        raise Refused("a negative hint: RAT is not admitted")
    return numbers


def _contradiction(
    known: dict[int, Sequence[int]], clause: Sequence[int], hints: Sequence[int]
) -> None:
    """Raise Refused unless the hints refute the clause's negation."""
    true = {-literal for literal in clause}
    if any(literal in true for literal in clause):
        raise Refused("the clause is always true")
    for place, hint in enumerate(hints, 1):
        if hint not in known:
            raise Refused(f"hint {hint} is no clause at this point")
        implied = 0
        for literal in known[hint]:
            if -literal not in true and literal != implied:
                if implied:
                    raise Refused(f"hint {hint} implies nothing: two literals are open")
                implied = literal
        if implied == 0:
            if place < len(hints):
                raise Refused(f"hints follow after the contradiction at hint {hint}")
            return
        true.add(implied)
    raise Refused("the hints end without a contradiction")


def check_files(formula: Path, proof: Path) -> int:
    """The number of clauses derived.

    Raises:
        Refused: if the proof does not refute the formula.
    """
    variables, clauses = read_formula(read(formula))
    try:
        return check(variables, clauses, read(proof).splitlines())
    except Refused as error:
        raise Refused(f"{proof.name}: {error}") from None


def main(arguments: list[str]) -> int:
    """One line on stdout, and the exit code."""
    try:
        formula, proof = map(Path, arguments)
    except ValueError:
        print("usage: python lrat.py FORMULA PROOF", file=sys.stderr)
        return 2
    try:
        print(
            f"VERIFIED: {check_files(formula, proof):,} clauses derived, the empty one among them"
        )
    except Refused as error:
        print(f"REFUSED: {error}")
        return 1
    except OSError as error:
        print(f"lrat.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
