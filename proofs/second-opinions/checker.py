"""The statements of this folder, without a solver: none is vacuous.  See README.md.

For each ``X.smt2`` its ``X.model.smt2`` must define every symbol, have the same hypotheses, and
make them all true, by the evaluator of ``smtlib.py``.  That the negated conclusion contradicts the
hypotheses is for the solvers (``check.py`` beside this file).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from lrat import Refused, read
from smtlib import Definitions, Term, assertions, commands, definitions

DECLARING = ("declare-sort", "declare-fun", "declare-const", "define-fun")
DEFINING = ("declare-datatypes", "define-fun")


def check(folder: Path) -> list[str]:
    """What has been checked, sentence by sentence."""
    models = {path.name for path in folder.glob("*.model.smt2")}
    names = sorted(p.stem for p in folder.glob("*.smt2") if p.name not in models)
    if models != {f"{name}.model.smt2" for name in names}:
        raise Refused("a statement without a model, or a model without a statement")
    settled = 0
    for name in names:
        try:
            settled += _require_model(
                read(folder / f"{name}.smt2"), read(folder / f"{name}.model.smt2")
            )
        except Refused as error:
            raise Refused(f"{name}: {error}") from None
    return [
        f"{len(names)} statements, none vacuous: a model of the hypotheses of each, evaluated",
        f"{settled} says that something exists, which its model settles",
        f"the other {len(names) - settled} are for solvers: second-opinions/check.py",
    ]


def _require_model(text: str, model_text: str) -> bool:
    """Whether the model settles the statement; it is one of the hypotheses in any case.

    Raises:
        Refused: if it is not, or a script has not the form that is expected.
    """
    statement, model = commands(text), commands(model_text)
    _require_form(statement, DECLARING)
    _require_form(model, DEFINING)
    expected = re.search(r"^; Expected: (sat|unsat)$", text, re.MULTILINE)
    if expected is None:
        raise Refused("it does not say '; Expected: sat' or 'unsat'")
    exists = expected[1] == "sat"
    hypotheses = assertions(statement)[: None if exists else -1]
    if assertions(model) != hypotheses:
        raise Refused("the model has other hypotheses")
    defined = definitions(model)
    bodies = [body for _, body in definitions(statement).functions.values()]
    # A symbol that only the conclusion names may be left open, but not have another meaning.
    looked_at = {*_words([*hypotheses, *bodies]), *defined.functions}
    for command in statement:
        if command[0] in DECLARING and command[1] in looked_at:
            _require_defined(command, model, defined)
    for hypothesis in hypotheses:
        if defined.value(hypothesis, {}) is not True:
            raise Refused(f"the model makes a hypothesis false: {hypothesis}")
    return exists


def _require_form(script: Sequence[list[Any]], before: tuple[str, ...]) -> None:
    """A logic, then symbols, then assertions, then one question, and nothing else."""
    heads = [command[0] for command in script]
    asserted = heads.count("assert")
    symbols = heads[1 : -asserted - 1]
    form = ["set-logic", *symbols, *["assert"] * asserted, "check-sat"]
    if asserted == 0 or heads != form or not set(symbols) <= set(before):
        raise Refused("not a logic, symbols, assertions and one check-sat, in this order")


def _words(term: Term) -> Iterator[str]:
    if isinstance(term, str):
        yield term
    else:
        for part in term:
            yield from _words(part)


def _require_defined(command: list[Any], model: Sequence[list[Any]], defined: Definitions) -> None:
    """Nothing, if what the statement declares or defines is defined in the model, as it should."""
    match command:
        case ["declare-sort", sort, "0"]:
            right = sort in defined.sorts
        case ["declare-const", name, sort]:
            constructed = name in defined.sorts.get(sort, [])
            right = constructed or any(c[:4] == ["define-fun", name, [], sort] for c in model)
        case ["declare-fun", name, sorts, sort]:
            right = any(
                c[:2] == ["define-fun", name] and [s for _, s in c[2]] == sorts and c[3] == sort
                for c in model
            )
        case ["define-fun", *_]:
            right = command in model
        case _:
            right = True
    if not right:
        raise Refused(f"the model does not define as it should: {command[1]}")
