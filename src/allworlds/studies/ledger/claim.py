"""Claims: what the functions that decide them take and return, and the file ``ledger.toml``.

Expected verdicts and numbers stand in that file alone; the functions that find them do not read
it.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

from msgspec import Meta, Struct, field

from allworlds.document.reading import taken
from allworlds.document.struct import Document, Positive, Text, about, key
from allworlds.inputs.checks import InputError, read_text, show
from allworlds.outcome import Verdict
from allworlds.studies.check.report import CheckReport
from allworlds.world.world import World

Truth: TypeAlias = Literal["holds", "refuted"]
Budget: TypeAlias = Literal["quick", "full"]
Shown: TypeAlias = int | float | str | Sequence[int | float | str]
"""A figure of a claim: a number, a name, or a list of these."""


class Picture(Struct, frozen=True):
    """A world to be drawn beside a claim."""

    caption: str
    world: World


class Found(Struct, frozen=True):
    """The result of checking a sentence, independent of any expectation.

    Attributes:
        verdict: whether it holds in the scope that was asked for.
        witnesses: how often each thing was met that the sentence is about; where one of them was
            never met nothing was checked.
        figures: the numbers that the sentence names.
        pictures: worlds that show it.
        told: in words, what refutes it or what is to be seen; may be empty.
    """

    verdict: Truth
    witnesses: Mapping[str, int]
    figures: Mapping[str, Shown] = field(default_factory=dict)
    pictures: tuple[Picture, ...] = ()
    told: str = ""


class NotChecked(Struct, frozen=True):
    """The reason why the sentence could not be checked here."""

    reason: str


class Unfinished(RuntimeError):
    """Raised where another part of the program gives no answer: the claim counts as refuted."""


class Means(Struct, frozen=True):
    """Resources for checking claims.

    Attributes:
        workers: processes, or threads.
        budget: how much may be done.
    """

    workers: int = 1
    budget: Budget = "quick"


Check: TypeAlias = Callable[..., Found | NotChecked]
"""Takes the means, and the bounds of its scope as keywords."""


def truth(holds: object) -> Truth:
    """The verdict for a truth value."""
    return "holds" if holds else "refuted"


def of_check(report: CheckReport, *events: str, **figures: Shown) -> Found:
    """The outcome of an exhaustive check. Its worlds, runs and named events are witnesses.

    Raises:
        Unfinished: where it neither holds nor is refuted.
    """
    whole = report.uninterrupted()
    if whole.verdict not in (Verdict.HOLDS, Verdict.REFUTED):
        raise Unfinished(f"the check of {whole.explorer} ended as {whole.verdict.value}")
    seen: dict[str, Any] = {"worlds": whole.worlds, "runs": whole.runs}
    seen |= {event: whole.tally.witnesses.get(event, 0) for event in events}
    pictures = tuple(
        Picture(f"the smallest world in which {whole.explorer} fails", finding.world)
        for finding in whole.findings[:1]
    )
    told = "".join(
        f"the law {finding.law} is broken in a world with {finding.world.map.edge_count} edges and "
        f"{finding.world.map.vertex_count} vertices"
        for finding in whole.findings[:1]
    )
    return Found(truth(whole.verdict is Verdict.HOLDS), seen, figures, pictures, told)


# ---------------------------------------------------------------- ledger.toml


class ClaimScope(Document):
    """The scope of a claim under a budget, and the numbers that must be found there.

    The bounds are the keywords of its function.
    """

    bounds: dict[str, Any] = key(default_factory=dict)
    witnesses: Annotated[dict[str, Positive], Meta(min_length=1)]
    figures: dict[str, Shown] = key(default_factory=dict)


class Sentence(Document):
    """A sentence that can be checked, and the expected verdict."""

    id: Annotated[Text, about("its name, for `--only` and `--require`")]
    section: Annotated[Text, about("of the paper")]
    statement: Annotated[Text, about("the sentence in short")]
    method: Annotated[Text, about("how it is decided")]
    scope: Annotated[Text, about("on what it was decided under this budget")]
    source: Annotated[
        Text, about("where the sentence stands, and where the expected numbers come from")
    ]
    expected: Annotated[Truth, about("the verdict that it must get; `refuted`: an erratum")]


class Claim(Sentence):
    """A sentence and its expected outcome: a table of ``ledger.toml``.

    ``{names}`` in the scope are those of the bounds.
    """

    quick: ClaimScope
    full: ClaimScope | None = None

    @property
    def scopes(self) -> Mapping[Budget, ClaimScope]:
        """The scopes of the claim, by budget."""
        return {"quick": self.quick, "full": self.full or self.quick}

    def scope_under(self, budget: Budget) -> str:
        """The scope under a budget, in words."""
        return self.scope.format(**self.scopes[budget].bounds)

    @property
    def function(self) -> str:
        """The name of the function that decides it: the id with ``_`` for ``-``."""
        return self.id.replace("-", "_")


def claims_in(file: Path) -> tuple[Claim, ...]:
    """The claims of a ``ledger.toml``, as they stand in it.

    Raises:
        InputError: naming the file, the claim and what is wrong with it.
    """
    text = read_text(str(file))
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"file {show(str(file))} is not TOML: {error}") from None
    return tuple(_claim(file, name, table) for name, table in tables.items())


def _claim(file: Path, name: str, table: Any) -> Claim:
    said = f"file {show(str(file))}: claim {name}"
    if not re.fullmatch(r"[a-zA-Z][a-zA-Z0-9-]*", name):
        raise InputError(f"{said}: an id is a letter, and then letters, digits and '-'")
    if not isinstance(table, dict):
        raise InputError(f"{said}: {show(table)} is no table")
    try:
        claim = taken({"id": name, **table}, Claim, "it")
    except InputError as error:
        raise InputError(f"{said}: {error}") from None
    for budget, scope in claim.scopes.items():
        try:
            claim.scope_under(budget)
        except (KeyError, IndexError, ValueError):
            raise InputError(
                f"{said}: scope {show(claim.scope)} does not fit the bounds "
                f"{', '.join(scope.bounds) or '(none)'} of {budget}"
            ) from None
    return claim
