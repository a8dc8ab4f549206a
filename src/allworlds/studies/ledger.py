"""``ledger``: sentences of a paper, each with the function that checks it.

Expected verdicts and numbers are in ``ledger.toml`` alone; the functions that find them do not
read it.
"""

import re
import time
import tomllib
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import KW_ONLY
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias, get_args

from msgspec import Meta, Struct, field
from typing_extensions import override

from allworlds import outcome
from allworlds.documents import document as doc
from allworlds.documents.reading import parse
from allworlds.engines import limits, tally
from allworlds.engines.listeners import Listener
from allworlds.inputs.checks import (
    InputError,
    NotInstalled,
    a_path,
    a_word,
    did_you_mean,
    exit_code_kept,
    not_one_of,
    read_text,
    show,
)
from allworlds.inputs.requests import EFFORT, SCOPE, Argument, Converted, Option, answers
from allworlds.protocol.importing import attempted, attribute_of, module_of_text, text_of
from allworlds.studies.check.report import CheckReport
from allworlds.studies.options import ListenerOptions
from allworlds.studies.reports import RowsReport
from allworlds.world.world import World

# ---------------------------------------------------------------- what decides a claim

Truth: TypeAlias = Literal["holds", "refuted"]
Budget: TypeAlias = Literal["quick", "full"]
Shown: TypeAlias = int | float | str | Sequence[int | float | str]
"""A figure of a claim: a number, a name, or a list of these."""


class Picture(Struct, frozen=True):
    """A world to be drawn beside a claim."""

    caption: str
    world: World


class Found(Struct, frozen=True):
    """The result of a claim's function, which does not know the expected verdict and numbers.

    Attributes:
        verdict: whether the sentence holds in the scope.
        witnesses: for each case that the sentence is about, the number of its occurrences.  If a
            case does not occur, the report gives the claim the verdict ``vacuous`` in place of
            ``verdict``.
        figures: the numbers that the sentence names, as found, by their names in ``ledger.toml``.
        pictures: worlds that show the result, each with its caption.
        told: the refutation or an explanation, in words; may be empty.
    """

    verdict: Truth
    witnesses: Mapping[str, int]
    figures: Mapping[str, Shown] = field(default_factory=dict)
    pictures: tuple[Picture, ...] = ()
    told: str = ""


class NotChecked(Struct, frozen=True):
    """The reason why a sentence could not be checked on this machine."""

    reason: str


class Unfinished(RuntimeError):
    """Raised in a claim's function if a check that the function runs ends without an answer.

    The claim then gets the verdict ``refuted`` and the standing ``unexpected`` in the report, even
    if ``refuted`` is the expected verdict.  All errors in :data:`FAULTS` are treated so.
    """


class Means(Struct, frozen=True):
    """The resources that a claim's function may use.

    Attributes:
        workers: the number of processes, or of threads.
        budget: the amount of work, ``quick`` or ``full``.
    """

    workers: int
    budget: Budget = "quick"


ClaimFunction: TypeAlias = Callable[..., Found | NotChecked]
"""The function of a claim; its arguments are the ``Means``, and the bounds as keywords."""


def truth(holds: object) -> Truth:
    """The verdict of a claim: ``"holds"`` if the argument is true in Python, else ``"refuted"``."""
    return "holds" if holds else "refuted"


def of_check(report: CheckReport, *events: str, **figures: Shown) -> Found:
    """The result of a claim that an exhaustive check decides.

    The numbers of worlds and of runs are always witnesses of the claim.

    Args:
        report: the report of the check.
        events: the names of witnesses of the check that become witnesses of the claim, too.
        figures: the numbers that the sentence names.

    Raises:
        Unfinished: if the verdict of the check is neither ``holds`` nor ``refuted``.
    """
    whole = report.uninterrupted()
    if whole.verdict not in (outcome.Verdict.HOLDS, outcome.Verdict.REFUTED):
        raise Unfinished(f"the check of {whole.explorer} ended as {whole.verdict.value}")
    seen: dict[str, Any] = {"worlds": whole.worlds, "runs": whole.runs}
    seen |= {event: whole.tally.witnesses.get(event, 0) for event in events}
    if not whole.findings:
        return Found(truth(whole.verdict is outcome.Verdict.HOLDS), seen, figures)
    finding = whole.findings[0]
    picture = Picture(f"the smallest world in which {whole.explorer} fails", finding.world)
    edges, vertices, *_ = finding.key
    refutation = (
        f"the law {finding.law} is broken in a world with {edges} edges and {vertices} vertices"
    )
    return Found("refuted", seen, figures, (picture,), refutation)


# ---------------------------------------------------------------- ledger.toml


class ClaimScope(doc.Document, kw_only=True):
    """The scope of a claim under one budget (``quick`` or ``full``), and the expected numbers.

    ``bounds`` are the keyword arguments of the claim's function.  ``witnesses`` and ``figures`` are
    the numbers that the function must find: ``witnesses`` how often each case occurs, ``figures``
    the numbers that the sentence names.
    """

    bounds: dict[str, Any] = doc.key(default_factory=dict)
    witnesses: Annotated[dict[str, doc.Positive], Meta(min_length=1)]
    figures: dict[str, Shown] = doc.key(default_factory=dict)


class Sentence(doc.Document):
    """A sentence that can be checked, and the expected verdict."""

    id: Annotated[doc.Text, doc.about("its name, for `--only` and `--require`")]
    section: Annotated[doc.Text, doc.about("the section of the paper")]
    statement: Annotated[doc.Text, doc.about("the sentence in short")]
    method: Annotated[doc.Text, doc.about("how it is decided")]
    scope: Annotated[doc.Text, doc.about("the cases in which it is decided under this budget")]
    source: Annotated[
        doc.Text, doc.about("where the sentence stands, and where the expected numbers come from")
    ]
    expected: Annotated[Truth, doc.about("the verdict that it must get; `refuted`: an erratum")]


class Claim(Sentence):
    """A sentence and its expected outcome: a table of ``ledger.toml``.

    ``quick`` and ``full`` have the bounds and the expected numbers under the budgets of these
    names; if there is no ``full``, ``quick`` is used under both budgets.  In the text ``scope``,
    ``{name}`` stands for the bound with this name.
    """

    quick: ClaimScope
    full: ClaimScope | None = None

    @property
    def scopes(self) -> Mapping[Budget, ClaimScope]:
        """The scopes of the claim, by budget."""
        return {"quick": self.quick, "full": self.full or self.quick}

    def scope_under(self, budget: Budget) -> str:
        """The scope in words, under one of the ledger's budgets, ``quick`` or ``full``."""
        return self.scope.format(**self.scopes[budget].bounds)

    @property
    def function(self) -> str:
        """The name of the function that checks the claim: the claim's id with ``_`` for ``-``."""
        return self.id.replace("-", "_")


def claims_in(file: Path) -> tuple[Claim, ...]:
    """The claims of a ``ledger.toml``, in the order of the file.

    Raises:
        InputError: if the file is no ledger; the error names the file, the claim, and the fault.
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
        claim = parse({"id": name, **table}, Claim, "it")
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


# ---------------------------------------------------------------- found beside expected

Seen: TypeAlias = Literal["holds", "refuted", "vacuous", "not-checked", "error"]
ClaimStanding: TypeAlias = Literal["as-expected", "unexpected", "vacuous", "not-checked"]

LEDGER, CLAIMS = "ledger.toml", "claims.py"
"""The files of a ledger: the claims, and a function for each claim."""

FAULTS = (Unfinished, outcome.Disagreement, tally.EnginesDisagree)
"""The errors that refute the claim in whose check they are raised.

Such an error says that a check of this program has ended without an answer, or that two
computations of one value differ.
"""


QUICK = 0.5
"""A number of seconds: the check of a claim that takes at most so long is made a second time.

The verdicts, the witnesses and the figures of both checks must be equal.
"""


Returned: TypeAlias = Found | NotChecked | Exception
"""The result of a claim's function: the value that it has returned, or the error it has raised."""


class CheckedClaim(Sentence):
    """A sentence that can be checked, with the expected and the found verdict and numbers.

    ``truth`` is the verdict of the claim's function, or None if nothing was checked; ``seconds`` is
    the duration of the check; ``captions`` has a caption for each of the ``worlds``.
    ``disagreement`` is the text of an error of the kinds :data:`FAULTS`: for example, two
    computations of one value differ. After such an error the found verdict is ``refuted``, and the
    claim is never as expected, even if the expected verdict is ``refuted``, too. ``error`` is the
    text of any other error in the claim's function. The found verdict is then ``error``: the
    sentence is neither confirmed nor refuted. Each of the two texts is empty if no such error was
    raised.
    """

    witnesses: Annotated[
        dict[str, doc.Natural], doc.about("each case that the sentence is about: how often it came")
    ]
    expected_witnesses: Annotated[dict[str, doc.Positive], doc.about("how often each must occur")]
    figures: Annotated[dict[str, Shown], doc.about("the numbers that the sentence names, as found")]
    expected_figures: Annotated[dict[str, Shown], doc.about("the expected numbers")]
    told: Annotated[
        str, doc.about("a refutation, an explanation, the reason for no check, or a traceback")
    ]
    worlds: Annotated[tuple[World, ...], doc.about("worlds that show the result")]
    captions: doc.NotInDocument[tuple[str, ...]]
    truth: doc.NotInDocument[Truth | None]
    disagreement: doc.NotInDocument[str]
    error: doc.NotInDocument[str]
    seconds: doc.NotInDocument[float]

    @doc.computed
    def verdict(self) -> Seen:
        """The verdict found; ``vacuous``: a case did not occur; ``error``: the check failed.

        ``not-checked``: the claim cannot be checked on this machine.  A case is one of those that
        the sentence is about; :attr:`witnesses` counts the occurrences of each case.
        """
        if self.error:
            return "error"
        if self.truth is None:
            return "not-checked"
        if self.disagreement:
            return "refuted"
        seen = self.witnesses
        met = seen and all(seen.values()) and seen.keys() >= self.expected_witnesses.keys()
        return self.truth if met else "vacuous"

    @doc.computed
    def standing(self) -> ClaimStanding:
        """The comparison of verdict, witnesses and figures with the expected ones, in a word.

        If the found verdict is ``vacuous`` or ``not-checked``, the standing is the same word,
        whatever verdict is expected: nothing is compared.  Otherwise there are two cases.
        ``as-expected``: all are equal.  ``unexpected``: at least one differs, or the check raised
        an error of any kind.
        """
        if self.verdict in ("not-checked", "vacuous"):
            return self.verdict
        return "unexpected" if self.differences else "as-expected"

    @doc.computed
    def differences(self) -> tuple[str, ...]:
        """The differences from the expected verdict and numbers, or the error, in words.

        The result is empty if there is no difference, or if the claim was not checked.
        """
        if self.error:
            return (f"an error of this program: {self.error}",)
        if self.truth is None:
            return ()
        if self.disagreement:
            return (f"the check failed, so the claim counts as refuted: {self.disagreement}",)
        differ, none = [], "none"
        if self.verdict != self.expected:
            differ.append(f"verdict: expected {self.expected}, found {self.verdict}")
        for wanted, seen in (
            (self.expected_witnesses, self.witnesses),
            (self.expected_figures, self.figures),
        ):
            differ += [
                f"{name}: expected {wanted.get(name, none)}, found {seen.get(name, none)}"
                for name in sorted({*wanted, *seen})
                if wanted.get(name) != seen.get(name)
            ]
        return tuple(differ)


class LedgerReport(RowsReport):
    """Report of 'ledger'.

    The claims of a paper that were checked, each with the expected and the found verdict.
    """

    budget: Annotated[Budget, doc.about("the amount of work")]
    required: Annotated[tuple[str, ...], doc.about("the claims that had to be checked")]
    claims: Annotated[tuple[CheckedClaim, ...], doc.about("in the order of the file")]
    directory: doc.NotInDocument[str] = ""

    @property
    def _standings(self) -> set[str]:
        return {one.standing for one in self.claims}

    @property
    @override
    def agrees(self) -> bool:
        return not any(one.error for one in self.claims)

    @property
    @override
    def refuted(self) -> bool:
        return "unexpected" in self._standings

    @property
    @override
    def undecided(self) -> bool:
        return bool(self.missed)

    @property
    @override
    def empty(self) -> bool:
        return "vacuous" in self._standings or self._standings <= {"not-checked"}

    @property
    @override
    def seconds_by_part(self) -> dict[str, list[float]]:
        return {"claim_seconds": [one.seconds for one in self.claims]}

    @property
    def missed(self) -> list[str]:
        """The ids of the claims that the option ``require`` names and that were not checked."""
        return [
            one.id
            for one in self.claims
            if one.id in self.required and one.standing == "not-checked"
        ]


def _names(given: Iterable[str]) -> tuple[str, ...]:
    return (given,) if isinstance(given, str) else tuple(given)


class LedgerRequest(ListenerOptions, limits.WorkerOptions, kw_only=False):
    """Request of ``ledger``: a paper's folder, the claims to check, and the amount of work."""

    directory: Annotated[
        str | Path,
        Argument("", "DIR", "The folder of a paper, with ledger.toml and claims.py."),
    ]
    _: KW_ONLY
    only: Annotated[
        Converted[Iterable[str], tuple[str, ...]],
        Option(SCOPE, "ID", "Only this claim; may be repeated.", repeated=True),
    ] = Converted(_names, ())
    require: Annotated[
        Converted[Iterable[str], tuple[str, ...]],
        Option(
            SCOPE,
            "ID",
            "A claim that must be checked, else the exit code is 3; may be repeated.",
            repeated=True,
        ),
    ] = Converted(_names, ())
    budget: Annotated[
        Converted[str, Budget],
        Option(
            EFFORT,
            "quick|full",
            "How much is checked: the bounds of ledger.toml for quick, or for full.",
        ),
    ] = Converted(a_word("budget", get_args(Budget)), "quick")


@answers(LedgerRequest)
def ledger(request: LedgerRequest) -> LedgerReport:
    """Check the sentences of a paper, each in its scope, and compare with the expected results.

    In the paper's folder ``claims.py`` has a function for each claim of ``ledger.toml``.  Each
    function takes ``Means``, and the bounds of its claim as keyword arguments, and returns a
    ``Found`` or a ``NotChecked`` (see ``allworlds.claims``).

    Raises:
        InputError: naming the offending value and what would be legal.
    """
    folder = a_path("directory", request.directory)
    claims = claims_in(folder / LEDGER)
    for option in ("only", "require"):
        _ensure_named(option, getattr(request, option), [claim.id for claim in claims])
    checks = _checks(folder / CLAIMS, claims)
    chosen, required = request.only, request.require
    wanted = [c for c in claims if not chosen or c.id in {*chosen, *required}]
    means = Means(request.workers, request.budget)
    request.listener.stage("claims", len(wanted), "claims")
    entries, ending = outcome.until_interrupted(_entries(wanted, checks, means, request.listener))
    return LedgerReport(
        ending=ending, budget=means.budget, required=required, claims=entries, directory=str(folder)
    )


def _checks(file: Path, claims: Sequence[Claim]) -> Mapping[str, ClaimFunction]:
    """The functions in ``file`` that check the claims, by the ids of the claims.

    Raises:
        InputError: if the file does not exist, cannot be imported, or lacks a function.
    """
    source = text_of(str(file))
    assert source is not None
    with exit_code_kept():
        module = module_of_text(str(file), source)
    return {claim.id: attribute_of(module, claim.function, str(file)) for claim in claims}


def _entries(
    wanted: Sequence[Claim], checks: Mapping[str, ClaimFunction], means: Means, listener: Listener
) -> Iterator[CheckedClaim]:
    for claim in wanted:
        yield entry_of(claim, checks[claim.id], means)
        listener.progress(1)


def entry_of(claim: Claim, check: ClaimFunction, means: Means) -> CheckedClaim:
    """Check a claim and return its entry in the report.

    A claim must have the same result each time.  So if the check took at most :data:`QUICK`
    seconds, it is made a second time, and the two results are compared.

    Args:
        claim: the claim.
        check: the function that checks the claim.
        means: the resources that the function may use.

    Raises:
        InputError: naming the claim, if its function ends the process, returns neither a Found nor
            a NotChecked, or returns another result the second time.
    """
    began = time.monotonic()
    entry = entry_with(claim, means.budget, _outcome_of(claim, check, means))
    entry = doc.replace(entry, seconds=time.monotonic() - began)
    if entry.seconds <= QUICK:
        again = entry_with(claim, means.budget, _outcome_of(claim, check, means))
        first, second = (
            f"{one.verdict}, witnesses {show(one.witnesses)}, figures {show(one.figures)}"
            for one in (entry, again)
        )
        if first != second:
            raise InputError(f"claim {show(claim.id)} has two outcomes: {first}; then {second}")
    return entry


def _outcome_of(claim: Claim, check: ClaimFunction, means: Means) -> Returned:
    """The result of one call of ``check``, which is the claim's function, with ``means``.

    If the function raises :class:`NotInstalled`, because the Python package of an extra of
    allworlds is missing, the result is a :class:`NotChecked`.  If the function raises another
    exception, the result is this exception.

    Raises:
        InputError: if the function ends the process, or returns neither a Found nor a NotChecked.
    """

    def act() -> Any:
        try:
            return check(means, **claim.scopes[means.budget].bounds)
        except NotInstalled as error:
            return NotChecked(str(error))
        except Exception as error:  # noqa: BLE001  # of one claim: the others are checked
            return error

    said = f"claim {show(claim.id)}"
    found = attempted(f"{said} raises", act)
    if isinstance(found, NotChecked | Exception):
        return found
    if not isinstance(found, Found):
        raise InputError(f"{said} returns {show(found)}; legal are a Found and a NotChecked")
    if found.verdict not in get_args(Truth):
        raise not_one_of(f"{said}: verdict", found.verdict, get_args(Truth))
    return found


def entry_with(claim: Claim, budget: Budget, found: Returned, seconds: float = 0) -> CheckedClaim:
    """The entry of a claim in the report.

    Args:
        claim: the claim.
        budget: the amount of work, which determines the scope and the expected numbers.
        found: the result of the claim's function.
        seconds: the duration of the check.
    """
    scope, disagreement, error = claim.scopes[budget], "", ""
    match found:
        case Found():
            shown = found
        case NotChecked(reason):
            shown = Found("refuted", {}, told=reason)
        case Exception() if isinstance(found, FAULTS):
            disagreement = str(found)
            shown = Found("refuted", {}, told=disagreement)
        case _:
            error = "".join(traceback.format_exception_only(found)).strip()
            shown = Found("refuted", {}, told="".join(traceback.format_exception(found)))
    sentence = {name: getattr(claim, name) for name in Sentence.__struct_fields__}
    return CheckedClaim(
        **{**sentence, "scope": claim.scope_under(budget)},
        witnesses=dict(shown.witnesses),
        expected_witnesses=scope.witnesses,
        figures=dict(shown.figures),
        expected_figures=scope.figures,
        told=shown.told,
        worlds=tuple(picture.world for picture in shown.pictures),
        captions=tuple(picture.caption for picture in shown.pictures),
        truth=None if error or isinstance(found, NotChecked) else shown.verdict,
        disagreement=disagreement,
        error=error,
        seconds=seconds,
    )


def _ensure_named(option: str, names: Iterable[str], legal: Sequence[str]) -> None:
    """Raise InputError if one of ``names`` is no claim; ``legal`` has the ids of all claims.

    ``option`` is the option that gave the names; the error names it.
    """
    for name in names:
        if name not in legal:
            some = f"; the first of {len(legal)} are {', '.join(legal[:3])}"
            hint = did_you_mean(str(name), legal) or some
            raise InputError(f"{option} {show(name)} is no claim{hint}")
