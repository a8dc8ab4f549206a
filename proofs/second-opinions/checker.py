"""The statements of this folder, without a solver: each is the one that is meant.  See README.md.

Each ``X.smt2`` must have the title, the expected answer and the commands of ``X`` in
``opinions.py``, and no more.  Its ``X.model.smt2`` must be a legal script, define every symbol as
the statement declares it, have the same hypotheses, and make them all true, by the evaluator of
``smtlib.py``; the conclusion must then be true there, too, whatever the values of the constants
that it alone names.  That the conclusion follows in every other model is for the solvers
(``check.py`` beside this file).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product, zip_longest
from pathlib import Path
from typing import Any

from lrat import Refused, read
from opinions import STATEMENTS, Statement
from smtlib import Definitions, Term, assertions, commands, definitions, require_well_sorted

DEFINING = ("declare-datatypes", "define-fun")


def check(folder: Path) -> list[str]:
    """Return what has been checked, sentence by sentence."""
    wanted = {f"{name}{end}" for name in STATEMENTS for end in (".smt2", ".model.smt2")}
    there = {path.name for path in folder.glob("*.smt2")}
    if wanted != there:
        name = min(wanted ^ there)
        raise Refused(f"{name} is {'no statement of ours' if name in there else 'missing'}")
    for name in STATEMENTS:
        require_statement(
            name, *(read(folder / f"{name}{end}") for end in (".smt2", ".model.smt2"))
        )
    settled = sum(not statement.conclusion for statement in STATEMENTS.values())
    others = len(STATEMENTS) - settled
    return [
        f"{len(STATEMENTS)} statements, word for word those that are meant",
        "none vacuous: a model of each, evaluated, and no conclusion is false there",
        f"{settled} is settled by its model; for solvers, second-opinions/check.py: {others}",
    ]


def require_statement(name: str, text: str, model_text: str) -> None:
    """Accept the statement of this name, and its model.

    Raises:
        Refused: if the file says anything else, or its model is none.
    """
    statement = STATEMENTS[name]
    try:
        _require_meant(statement, text)
        _require_model(statement, model_text)
    except Refused as error:
        raise Refused(f"{name}: {error}") from None


def _require_meant(statement: Statement, text: str) -> None:
    """Accept the text if title, expected answer and commands are those of the statement."""
    remarks = [line for line in text.splitlines() if line.startswith(";")]
    if not text.startswith(f"; {statement.title}\n"):
        raise Refused(f"it does not begin with its title, {statement.title!r}")
    if [r for r in remarks if r.startswith("; Expected:")] != [f"; Expected: {statement.expected}"]:
        raise Refused(f"it does not say '; Expected: {statement.expected}', once")
    for i, (mine, theirs) in enumerate(zip_longest(commands(statement.script), commands(text)), 1):
        if mine != theirs:
            raise Refused(f"command {i} is {_text(theirs)}, and should be {_text(mine)}")


def _require_model(statement: Statement, text: str) -> None:
    """Accept a script that makes the hypotheses true, and the conclusion with them."""
    model, meant = commands(text), commands(statement.script)
    _require_form(model)
    hypotheses = commands(" ".join(statement.hypotheses))
    if assertions(model) != hypotheses:
        raise Refused("the model has other hypotheses")
    require_well_sorted(model)
    defined = definitions(model)
    bodies = [body for _, body in definitions(meant).functions.values()]
    # A symbol that only the conclusion names may be left open, but not have another meaning.
    looked_at = {*_words([*hypotheses, *bodies]), *defined.functions}
    for command in meant:
        if command[0] not in ("assert", "set-logic", "check-sat") and command[1] in looked_at:
            _require_defined(command, model, defined)
    for hypothesis in hypotheses:
        if defined.value(hypothesis, {}) is not True:
            raise Refused(f"the model makes a hypothesis false: {_text(hypothesis)}")
    if statement.conclusion:
        _require_conclusion(statement, meant, defined)


def _require_conclusion(
    statement: Statement, meant: Sequence[list[Any]], defined: Definitions
) -> None:
    """Accept a model in which the conclusion is true for all values of what is left open."""
    [conclusion] = commands(statement.conclusion)
    named = set(_words(conclusion))
    left = [
        (name, sort)
        for kind, name, sort in (c for c in meant if c[0] == "declare-const")
        if name in named
        and name not in defined.functions
        and name not in defined.sorts.get(sort, [])
    ]
    if numbers := [name for name, sort in left if not defined.sorts.get(sort)]:
        raise Refused(f"the model leaves {numbers[0]} open")
    for values in product(*(defined.sorts[sort] for _, sort in left)):
        point = dict(zip([name for name, _ in left], values, strict=True))
        if defined.value(conclusion, point) is not True:
            raise Refused(f"the model makes the conclusion false, at {point}")


def _require_form(script: Sequence[list[Any]]) -> None:
    """Accept a logic, then definitions, then assertions, then one question, and no more."""
    heads = [command[0] if command else "()" for command in script]
    asserted = heads.count("assert")
    symbols = heads[1 : -asserted - 1]
    form = ["set-logic", *symbols, *["assert"] * asserted, "check-sat"]
    if asserted == 0 or heads != form or not set(symbols) <= set(DEFINING):
        raise Refused("not a logic, definitions, assertions and one check-sat, in this order")


def _words(term: Term) -> Iterator[str]:
    if isinstance(term, str):
        yield term
    else:
        for part in term:
            yield from _words(part)


def _text(term: Term | None) -> str:
    if term is None:
        return "missing"
    return term if isinstance(term, str) else f"({' '.join(map(_text, term))})"


def _require_defined(command: list[Any], model: Sequence[list[Any]], defined: Definitions) -> None:
    """Accept a model that defines what the statement declares or defines, as it should."""
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
            right = False
    if not right:
        raise Refused(f"the model does not define as it should: {command[1]}")
