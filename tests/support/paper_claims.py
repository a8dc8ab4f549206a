"""Parts of the tests of every paper: its claims, mutations of them, and how a claim is tried.

A mutation changes the program that the claim looks at, or makes a false cousin of its sentence
(of a sentence that must be refuted, a true one).  The paper is the one whose ``claims`` can be
imported.
"""

from __future__ import annotations

import json
import lzma
import re
import shutil
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

import claims
import decided  # claims.py has put its folder on the path
from allworlds import Estimate, Move, World, check, run
from allworlds.corpus import explorers as wrong
from allworlds.documents.document import replace
from allworlds.explorers.builtin.algorithm1 import Algorithm1
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.studies.ledger import FAULTS, Claim, Means, claims_in, entry_with
from allworlds.studies.worst.every_schedule import EverySchedule

PAPER = Path(claims.__file__).parent
CLAIMS = claims_in(PAPER / "ledger.toml")
BY_NAME = {claim.id: claim for claim in CLAIMS}


def function_of(claim: Claim) -> Callable[..., Any]:
    """The function that decides a claim."""
    return getattr(claims, claim.function)


# ---------------------------------------------------------------- mutants


@dataclass(frozen=True)
class Mutant:
    """A change, and the scope in which the claim is then checked.

    Attributes:
        claim: its id.
        what: the fault, in words.
        patches: (module or class, name, replacement).
        bounds: of the scope in which it is checked; if left out, those of the quick scope.
        changed: bounds of the false cousin that differ from these.
        damage: damages the folder of proofs.
        slow: takes more than a few seconds.
    """

    claim: str
    what: str
    patches: tuple[tuple[object, str, Any], ...] = ()
    bounds: Mapping[str, Any] | None = None
    changed: Mapping[str, Any] = field(default_factory=dict)
    damage: Callable[[Path], None] | None = None
    slow: bool = False


def params(mutants: Iterable[Mutant]) -> Iterator[Any]:
    """The mutants as parameters of a test."""
    for mutant in mutants:
        marks = [pytest.mark.slow] if mutant.slow else []
        yield pytest.param(mutant, id=f"{mutant.claim}: {mutant.what}", marks=marks)


def found_by(check: Any, means: Means, bounds: Mapping[str, Any]) -> Any:
    """The outcome of a claim's function, or the error that it met."""
    try:
        return check(means, **bounds)
    except Exception as error:  # noqa: BLE001  # as the ledger does
        return error


def assert_fails(mutant: Mutant, monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    """Require that the claim is as expected before its mutation, and fails under it."""
    claim = BY_NAME[mutant.claim]
    bounds = claim.quick.bounds if mutant.bounds is None else mutant.bounds
    tried = partial(found_by, function_of(claim), _means(mutant, monkeypatch, folder))
    found = tried(bounds)
    assert getattr(found, "verdict", found) == claim.expected
    for where, name, other in mutant.patches:
        monkeypatch.setattr(where, name, other)
    if mutant.damage:
        mutant.damage(folder)
    found = tried({**bounds, **mutant.changed})
    entry = entry_with(claim, "quick", found)
    assert entry.standing in ("unexpected", "vacuous")
    assert entry.truth == {"holds": "refuted", "refuted": "holds"}[claim.expected], found
    assert isinstance(found, FAULTS) <= (entry.verdict == "refuted")


def _means(mutant: Mutant, monkeypatch: pytest.MonkeyPatch, folder: Path) -> Means:
    """With what the claim is looked at: a copy of the proofs, or Coq's answers as claimed."""
    if mutant.damage:
        left_out = shutil.ignore_patterns("coq", "__pycache__")
        shutil.copytree(decided.PROOFS, folder, ignore=left_out, dirs_exist_ok=True)
        monkeypatch.setattr(decided, "PROOFS", folder)
    if not mutant.claim.startswith("coq-"):
        return Means(1)
    monkeypatch.setattr(decided, "_assumptions", lambda _folder: as_claimed())
    monkeypatch.setattr(decided.shutil, "which", lambda name: name)
    return Means(1, "full")


# ---------------------------------------------------------------- explorers and worlds


def mirrored(name: str) -> Callable[..., Any]:
    """The built-in explorer, with the mirror image of its map as its answer."""
    explore = BUILT_IN[name].explore

    def mirror(*args: Any, **keywords: Any) -> Any:
        right = yield from explore(*args, **keywords)
        return Estimate(right.map.mirrored(), right.here)

    def told_mirror(first: Any, *, told: int) -> Any:
        return (yield from mirror(first, told=told))

    def untold_mirror(first: Any) -> Any:
        return (yield from mirror(first))

    return told_mirror if name == "algorithm1-natural" else untold_mirror


def lingering(explore: Callable[..., Any]) -> Callable[..., Any]:
    """The explorer, which walks its last edge many times before it answers."""

    def linger(first: Any) -> Any:
        right = yield from explore(first)
        for _ in range(20 * right.map.edge_count):
            yield Move(0)
        return right

    return linger


def checked(explore: Callable[..., Any]) -> Callable[..., Any]:
    """``check`` of this explorer, whichever was asked for."""

    def check_instead(name: str, **asked: Any) -> Any:
        if name in BUILT_IN:
            asked = {"lighthouse": BUILT_IN[name].lighthouse, **asked}
        asked.pop("engine", None)
        return check(explore, **asked)

    return check_instead


def algorithm1_is(kind: type[Algorithm1]) -> Callable[..., Any]:
    """``check`` of a wrong Algorithm 1."""
    return checked(wrong.WrongExplorer(kind).explorer())


def runs(kind: type[Algorithm1]) -> Callable[..., Any]:
    """``run`` of a wrong Algorithm 1."""
    explore = wrong.WrongExplorer(kind).explorer()
    return lambda _name, world, **asked: run(explore, world, **asked)


def lit(**instead: str) -> Callable[..., World]:
    """``World`` with another lighthouse in place of each of these."""
    return lambda map_, kind: World(map_, instead.get(kind, kind))


# ---------------------------------------------------------------- the search over schedules

right_tests = EverySchedule._tests


def longer_retracing(self: Any, explored: Any, hypothesis: int, entry: int) -> Any:
    """Tests of false hypotheses that cost half as much again."""
    tests = right_tests(self, explored, hypothesis, entry)
    if hypothesis == entry:
        return tests
    return [replace(test, cost=test.cost * 3 // 2) for test in tests]


# ---------------------------------------------------------------- certificates


def damaged(name: str, damage: Callable[[bytes], bytes]) -> Callable[[Path], None]:
    """Make one certificate say something else, and the manifest have its digest."""

    def damage_in(folder: Path) -> None:
        certificates = folder / "certificates"
        path = certificates / name
        right = path.read_bytes()
        path.write_bytes(damage(right))
        assert path.read_bytes() != right
        known = json.loads((certificates / "manifest.json").read_text())
        if name in known:
            known[name] = sha256(path.read_bytes()).hexdigest()
            (certificates / "manifest.json").write_text(json.dumps(known))

    return damage_in


def half(data: bytes) -> bytes:
    """A compressed text without its second half."""
    lines = lzma.decompress(data).splitlines(keepends=True)
    return lzma.compress(b"".join(lines[: len(lines) // 2]))


def exchanged(data: bytes) -> bytes:
    """A bisimulation in which two neighbouring numbers that differ have changed places."""
    before, key, classes = data.partition(b'"bisimulation"')
    return before + key + re.sub(rb"\b(\d+),(\s*)(?!\1\b)(\d+)\b", rb"\3,\2\1", classes, count=1)


def without_an_assertion(data: bytes) -> bytes:
    """A formula without its last assertion."""
    lines = data.splitlines(keepends=True)
    last = max(i for i, line in enumerate(lines) if line.startswith(b"(assert"))
    end = next(i for i in range(last + 1, len(lines)) if lines[i].startswith(b"("))
    return b"".join(lines[:last] + lines[end:])


# ---------------------------------------------------------------- theorems


def as_claimed() -> dict[str, str]:
    """By theorem what Coq prints that it rests on: all that the ledger names, proved."""
    proved = [claim for claim in CLAIMS if claim.id.startswith("coq-")]
    return {name: decided.CLOSED for claim in proved for name in claim.quick.bounds["names"]}


def unproved() -> Iterator[Mutant]:
    """Of each claim that rests on Coq two mutants: its last theorem is missing, or assumes more."""
    told = as_claimed()
    for claim in CLAIMS:
        if claim.id.startswith("coq-"):
            last = claim.quick.bounds["names"][-1]
            others = {name: rests for name, rests in told.items() if name != last}
            for what, built in (
                ("a theorem that rests on an axiom", {**told, last: "Axioms:"}),
                ("a theorem that is missing", others),
            ):
                yield Mutant(claim.id, what, ((decided, "_assumptions", lambda _, b=built: b),))
