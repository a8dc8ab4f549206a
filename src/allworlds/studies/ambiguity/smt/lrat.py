"""A checker of LRAT proofs, for those that an external solver has written."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from allworlds.studies.ambiguity.smt.formula import Clause
from allworlds.studies.ambiguity.smt.rup import ProofRefused


def check_lrat(clauses: Sequence[Clause], proof: Iterable[str]) -> None:
    """Raise ProofRefused unless the proof derives the empty clause from the clauses.

    Every hint must be a clause with at most one literal that is not false yet, and the last
    one must be false: a chain of hints that never conflicts proves nothing.  The one literal
    may be true already: CaDiCaL writes a few such hints, and they do no harm.

    Raises:
        ProofRefused: naming the line.

    Cost: a second for 5 MB.
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
    for place, hint in enumerate(hints, 1):
        if hint not in known:
            raise ProofRefused(f"hint {hint} is no clause at this point")
        open_literals = [literal for literal in known[hint] if literal not in false]
        if not open_literals:
            if place < len(hints):
                raise ProofRefused(f"hint {hint} is false already, but more hints follow")
            known[number] = clause
            return
        if len(open_literals) > 1:
            raise ProofRefused(f"hint {hint} is neither false nor implies a literal")
        false.add(-open_literals[0])
    raise ProofRefused("the hints end without a conflict")
