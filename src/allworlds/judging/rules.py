"""The rules by which a run is played and judged: options of ``check``, ``fuzz`` and ``run``."""

from collections.abc import Iterable, Sequence
from dataclasses import KW_ONLY, replace
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, NamedTuple

from allworlds.documents import document as doc
from allworlds.explorers.loading import Subject, is_library, own_bound
from allworlds.inputs.checks import (
    InputError,
    a_text,
    an_integer,
    integer_of,
    not_one_of,
    one_of,
    show,
)
from allworlds.inputs.requests import (
    RARE_RULES,
    RULES,
    Converted,
    Option,
    Request,
    as_json,
    fields_of,
    given_again,
    meant_by,
    values_of,
)
from allworlds.judging import tasks
from allworlds.judging.laws.bounds import (
    BOUNDS,
    NO_BOUND,
    Bound,
    bound_named,
    default_step_budget,
    far_beyond,
    paper_bound,
)
from allworlds.judging.laws.law_table import (
    BOUNDED,
    FOLDS,
    IDLE,
    LAWS,
    MAPS,
    TASK,
    JudgedLaw,
)
from allworlds.maps import classes, combinatorial
from allworlds.protocol.choices import DEFAULT_POLICY, POLICIES, SEEDED, Choices, policy_named
from allworlds.world.lighthouses import base, kinds, marked
from allworlds.world.world import World

SIZE = {"n", "m"}
"""The variables of a bound that depends only on the size: the numbers of vertices and edges."""


def law_names(text: str) -> tuple[str, ...]:
    """The names of laws in ``text``, where commas separate the names."""
    return tuple(part.strip() for part in text.split(","))


def _policy(given: object) -> str:
    policy = a_text("policy", given)
    policy_named(policy)
    return policy


def _bound(given: object) -> Bound | None:
    if given is None or isinstance(given, Bound):
        return given
    return bound_named(given if isinstance(given, str) else str(an_integer("bound", given)))


def _laws(given: object) -> tuple[str, ...] | None:
    """The names of laws in ``given``, a list or other iterable of texts.

    The result is None if ``given`` is None.

    Raises:
        InputError: if ``given`` is a single text or no iterable, or names no law, an unknown law,
            or a law twice.
    """
    if given is None:
        return None
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise InputError(f"laws = {show(given)} is not a list of names of {', '.join(LAWS)}")
    names = tuple(given)
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"law {show(name)} is named twice")
        if name not in list(LAWS):  # a key would have to be hashable
            raise not_one_of("law", name, LAWS)
    if not names:
        raise InputError(f"laws = () names no law; legal are {', '.join(LAWS)}")
    return names


def _step_budget(given: object) -> int | None:
    if given is None:
        return None
    budget = an_integer("step_budget", given)
    if budget < 1:
        raise InputError(f"step budget {show(budget)} is not positive")
    return budget


class RuleOptions(Request):
    """The part of a request that says how runs are played and judged.

    The default of an option may depend on the options that stand before it: for example, the
    default of ``step_budget`` depends on ``bound``.
    """

    task: Annotated[
        Converted[str | tasks.Complaint | tasks.Task, tasks.Task],
        Option(
            RULES,
            "TASK",
            f"What counts as done: {one_of(tasks.TASKS)}, or path/to/file.py:judge, a function of "
            "(world, transcript, answer): it returns None if all is right, else the fault in "
            "words.",
            document_type=Annotated[
                doc.IfAny[doc.Text | None],
                doc.about("what counted as done; where it is left out, the map"),
            ],
        ),
    ] = Converted(tasks.task_named, tasks.MAP)
    policy: Annotated[
        Converted[str, str],
        Option(
            RARE_RULES,
            "POLICY",
            f"How choices are made where the explorer is free: {one_of([*POLICIES, SEEDED])}.",
            document_type=Annotated[doc.Text, doc.about("who answered the explorer's choices")],
        ),
    ] = Converted(_policy, DEFAULT_POLICY)
    bound: Annotated[
        Converted[str | int | Bound | None, Bound | None],
        Option(
            RULES,
            "BOUND",
            f"Largest number of traversals: {', '.join(BOUNDS)} (paper: the sum of its bounds (1) "
            "and (2)), or an expression with + - * // **, min and max over paper, n "
            "vertices, m edges, d0 degree of the start, D largest degree, d diameter, g genus "
            "[default: the explorer's own, else the lighthouse's].",
            document_type=Annotated[
                doc.Text,
                doc.about("the bound on the traversals; `none` where the law was not checked"),
            ],
        ),
    ] = Converted(_bound, None)
    laws: Annotated[
        Converted[Iterable[str] | None, tuple[str, ...] | None],
        Option(
            RARE_RULES,
            "LAWS",
            f"Check these alone, with commas: {', '.join(LAWS)} [default: all that apply].",
            parse=law_names,
            document_type=Annotated[
                doc.Different[JudgedLaw],
                doc.about("the laws that were checked; `task` where the task is none of them"),
            ],
        ),
    ] = Converted(_laws, None)
    step_budget: Annotated[
        Converted[int | None, int | None],
        Option(
            RARE_RULES,
            "B",
            "The most traversals of a run: more break the law 'budget' [default: 8 "
            "times the bound 'paper', plus 100; at most 100 times --bound, plus 100].",
            parse=integer_of,
            document_type=Annotated[
                doc.Positive | None,
                doc.about("the largest legal number of traversals; null: default"),
            ],
        ),
    ] = Converted(_step_budget, None)

    def rules_of(
        self,
        subject: Subject,
        lighthouse: kinds.GivenLighthouse,
        *,
        promised: bool = False,
        among: "Among | None" = None,
    ) -> "Rules":
        """The rules for the explorer ``subject`` under the lighthouse ``lighthouse``.

        A built-in explorer, or one with a wrapper, may have a bound and a step budget of its own.
        The field ``own_bound`` of the rules is the explorer's own bound; None if it has none.  If
        the request has no step budget, the rules get the explorer's own step budget; None if it has
        none.  ``promised`` and ``among`` become the fields of :class:`Rules` with these names.

        Raises:
            InputError: naming the offending option and what would be legal.
        """
        options = values_of(RuleOptions, self)
        if self.step_budget is None:
            options["step_budget"] = subject.step_budget
        kind = kinds.lighthouse_kind(lighthouse)
        told_numbers = kinds.numbers_told(kind)
        if len(told_numbers) > 1 and is_library(subject.name):
            raise InputError(
                f"explorer {show(subject.name)} is a library, which is told one number at most, "
                f"and the lighthouse {kind} tells {', '.join(told_numbers)}; legal is told:n, or "
                "an explorer that reads lines of JSON"
            )
        own = own_bound(subject.name, str(kind))
        return Rules(lighthouse, promised=promised, own_bound=own, among=among, **options)


class Among(NamedTuple):
    """A condition on the maps of worlds, as a finding records the condition.

    A check plays runs only in maps that meet the condition, and shrinks findings only to such maps.

    Attributes:
        name: the condition as a text that the option ``--where`` takes.
        digest: the SHA-256 of the user's file with the condition; for several files the digests,
            joined by ``AND`` of the module ``classes``; None for a condition of this program.
    """

    name: str
    digest: str | None = None

    @classmethod
    def of(cls, where: classes.Condition | None) -> "Among | None":
        """The condition ``where`` of a request, as an :class:`Among`; None if ``where`` is None."""
        if where is None:
            return None
        digests = [code.digest for code in getattr(where, "codes", ())]
        return cls(where.name, classes.AND.join(digests) or None)


class Rules(RuleOptions, kw_only=False):
    """The rules by which a run is played and judged, in any world.

    The field ``bound`` is None if the bound is the default one; the field ``laws`` is None if the
    laws are the default ones.

    Attributes:
        lighthouse: the kind of lighthouse.
        promised: whether all maps of the class are planar, so that the explorer may rely on this.
            Then an explorer can be right although its log does not determine the map, so the law
            ``folding`` is not checked.
        own_bound: the explorer's own bound on the traversals under this lighthouse; None if it has
            none.
        among: the condition on the maps; None if there is none.  Findings record the condition;
            runs do not depend on it.
        shared_file: the name of a file that holds both the explorer and code that judges the
            explorer; empty if there is no such file.  Since the explorer's code could then change a
            verdict, reports name the file in a warning.
    """

    lighthouse: Converted[kinds.GivenLighthouse, kinds.LighthouseKind] = Converted(
        kinds.lighthouse_kind, marked.Directional.kind
    )
    _: KW_ONLY
    promised: bool = False
    own_bound: Converted[str | Bound | None, Bound | None] = Converted(_bound, None)
    among: Among | None = None
    shared_file: str = ""

    def __post_init__(self) -> None:
        for law in self.laws or ():
            if (condition := LAWS[law].needs) not in self._met:
                raise InputError(f"law {law!r} {IDLE[condition]}")
        if self.bound == self.default_bound:
            vars(self)["bound"] = None
        if self.laws is not None:
            if "bound" not in self.laws and self.bound not in (None, NO_BOUND):
                raise InputError(
                    f"bound {show(str(self.bound))} has no effect without the law 'bound'; the "
                    f"laws are {', '.join(self.laws)}"
                )
            usual, named = self._usual_laws, tuple(law for law in LAWS if law in self.laws)
            vars(self)["laws"] = None if named == usual else named

    @property
    def kind(self) -> type[base.Lighthouse]:
        """The Python class of the lighthouses of the kind :attr:`lighthouse`."""
        return self.lighthouse.as_class

    @property
    def files(self) -> tuple[Path, ...]:
        """The user's files from which the judge loads code."""
        codes = (*self.lighthouse.codes, *self.task.codes)
        return tuple(file for code in codes for file in code.files)

    @cached_property
    def the_bound(self) -> Bound:
        """The bound that the law ``bound`` checks; :data:`NO_BOUND` if this law is not checked."""
        return self._named_bound if "bound" in self.applying else NO_BOUND

    @property
    def default_bound(self) -> Bound:
        """The bound on traversals that is checked if the user names none.

        For the task ``map`` the default is the explorer's own bound, or else the lighthouse's
        default bound.  For any other task the default is :data:`NO_BOUND`.
        """
        if not self.task.is_map:
            return NO_BOUND
        return self.own_bound or bound_named(self.kind.default_bound)

    @property
    def _named_bound(self) -> Bound:
        return self.default_bound if self.bound is None else self.bound

    @property
    def _met(self) -> set[str]:
        """The conditions of laws that these rules meet: some of ``maps``, ``folds``, ``bounded``.

        A law is checked by default if the rules meet its condition.  ``maps``: the task is ``map``.
        ``folds``: the task is ``map``; under this lighthouse the log of a correct explorer
        determines the map; and :attr:`promised` is false.  ``bounded``: there is a bound on the
        traversals.
        """
        met = {MAPS} if self.task.is_map else set[str]()
        met |= {FOLDS} if met and self.kind.folds and not self.promised else set()
        return met | ({BOUNDED} if self._named_bound != NO_BOUND else set())

    @property
    def _usual_laws(self) -> tuple[str, ...]:
        return tuple(name for name, law in LAWS.items() if law.needs in self._met)

    @cached_property
    def applying(self) -> tuple[str, ...]:
        """The names of those laws in :data:`LAWS` that are checked, in the order of precedence.

        The law ``task`` is not in :data:`LAWS`; see :attr:`judged`.
        """
        return self._usual_laws if self.laws is None else self.laws

    @property
    def judged(self) -> tuple[str, ...]:
        """The names of the laws that are checked, the law ``task`` included.

        These are the laws :attr:`applying`; before them stands ``task`` unless the task is ``map``.
        """
        return self.applying if self.task.is_map else (TASK, *self.applying)

    def budget(self, map_: combinatorial.CombinatorialMap) -> int:
        """The step budget of a run in a world with the map ``map_``.

        A run with more traversals is cut off, and breaks the law ``budget``.
        """
        return self.budget_by_size(map_.vertex_count, map_.edge_count)

    def budget_by_size(self, vertices: int, edges: int) -> int:
        """The step budget of a run in a world of this size; see :meth:`budget`.

        If the field ``step_budget`` is not None, it is the result.  Otherwise the result is
        computed in three steps.  First, the result is :func:`default_step_budget` of the paper's
        bound.  Second, if the explorer's own bound depends only on the size, and is larger than
        this number, the result becomes the own bound: a run that keeps the own bound needs no more
        traversals.  Third, if :meth:`budget_of_bound` has a value, and this value is smaller, the
        result becomes this value.

        ``vertices`` and ``edges`` are the size: the numbers of vertices and edges.
        """
        if self.step_budget is not None:
            return self.step_budget
        usual = default_step_budget(paper_bound(vertices, edges))
        brought = self.own_bound or NO_BOUND
        if brought.variables <= SIZE:
            usual = max(usual, brought.value(vertices, edges, 0, 0, 0, 0) or 0)
        far = self.budget_of_bound(vertices, edges)
        return usual if far is None else min(usual, far)

    def budget_of_bound(self, vertices: int, edges: int) -> int | None:
        """A hundred times :attr:`the_bound`, plus 100, in a world of this size.

        Return None if there is no bound, or if the bound depends on more than the size, or has no
        value for this size.  A run with more traversals than the result breaks the law ``bound`` in
        any case, so by default such a run is cut off.
        """
        if not self.the_bound.variables <= SIZE:
            return None
        try:
            bound = self.the_bound.value(vertices, edges, 0, 0, 0, 0)
        except InputError:  # a run of that size reports it
            return None
        return None if bound is None else far_beyond(bound)

    def choices(self, name: str, script: Sequence[int] = ()) -> Choices:
        """Return a new :class:`Choices`, which makes the choices of one run by the policy.

        ``name`` is the name of the run, see :func:`~allworlds.judging.referee.name_run`: under a
        policy ``random:SEED`` the choices follow from SEED and this name.  ``script`` holds for
        each of the first choices the index of the option to take; the policy makes all other
        choices.
        """
        return Choices(policy_named(self.policy, name), script)

    def arguments(self, script: Sequence[int] = ()) -> list[str]:
        """The options of the command ``run`` for these rules, as words of the command line.

        Options with default values are left out.  ``script`` holds for each of the explorer's first
        choices the index of the option to take.  The command ``run`` has no option for the field
        ``promised``; so if this field is true, the words name the laws that are checked.
        """
        answered = any(script) or (script and self.policy != DEFAULT_POLICY)
        choices = ["--choices", ",".join(map(str, script))] if answered else []
        of_run = replace(self, promised=False, laws=self.applying or None)
        return [*given_again(RuleOptions, of_run), *choices]

    def keywords(self, script: Sequence[int] = ()) -> list[str]:
        """The options of :meth:`arguments`, each as ``NAME=VALUE`` of a call in Python."""
        words = self.arguments(script)
        options = zip(words[::2], words[1::2], strict=True)
        return [_keyword(option, text) for option, text in options]

    @property
    def in_effect(self) -> dict[str, Any]:
        """The options and the lighthouse that are in effect, as reports and findings show them.

        The keys are those of these documents, such as ``step_budget``; the values are JSON values.
        ``bound`` is the bound that is checked, or ``none``.  ``laws`` are the names of all laws
        that are checked, the law ``task`` included.  ``task`` is None for the task ``map``, which
        findings leave out.
        """
        effective = {
            "task": None if self.task.is_map else self.task,
            "bound": self.the_bound,
            "laws": self.judged,
            "lighthouse": self.lighthouse,
        }
        return meant_by(RuleOptions, self) | {key: as_json(each) for key, each in effective.items()}

    @cached_property
    def recorded(self) -> "RecordedRules":
        """These rules in the form in which a finding records them."""
        options = {key: value for key, value in self.in_effect.items() if key != "lighthouse"}
        return RecordedRules(
            **options,
            task_digest=self.task.code.digest if self.task.code else None,
            where=self.among.name if self.among else None,
            where_digest=self.among.digest if self.among else None,
        )


def _keyword(option: str, text: str) -> str:
    """The option ``option`` with the value ``text``, as ``NAME=VALUE`` of a call in Python."""
    name = option.removeprefix("--").replace("-", "_")
    value: Any = int(text) if name == "step_budget" else text
    if name in ("laws", "choices"):
        value = [int(part) if part.isdigit() else part for part in text.split(",")]
    return f"{name}={value!r}"


@doc.with_options(RuleOptions)
class RecordedRules(doc.Document, forbid_unknown_fields=False):
    """Options of a run.

    How a run was played and judged. An option that is missing when the document is read has its
    default.
    """

    task_digest: Annotated[
        doc.IfAny[doc.Text | None], doc.about("SHA-256 of the judge's file, where it is the user's")
    ] = None
    where: Annotated[
        doc.IfAny[doc.Text | None],
        doc.about("the condition on the maps among which it is minimal, if any"),
    ] = None
    where_digest: Annotated[
        doc.IfAny[doc.Text | None],
        doc.about("SHA-256 of the predicate's file, where it is the user's; of each of several"),
    ] = None

    def rules(self, world: World, own_bound: str | None = None) -> Rules:
        """The recorded rules, for a run in ``world``.

        ``own_bound`` is the explorer's own bound, or None if it has none.  If a user has changed
        the record, its bound and its list of laws may contradict each other, and :class:`Rules`
        would refuse them.  In two cases the result is therefore made without the offending part.
        First: there is a bound, but the list does not hold the law ``bound``.  Then the recorded
        bound is ignored.  Second: the list holds the law ``bound``, but the recorded bound is
        ``none``; or no bound is recorded, and the default bound is ``none``.  Then this law is
        ignored.

        Raises:
            InputError: naming the offending option.
        """
        options = {field.name: getattr(self, field.name) for field in fields_of(RuleOptions)}
        bare = Rules(
            kinds.kind_of(world.lighthouse),
            task=options["task"] or tasks.MAP,
            own_bound=own_bound,
            among=Among(self.where, self.where_digest) if self.where else None,
        )
        if bare.task.code:
            bare.task.code.ensure_recorded(self.task_digest)
        if options["laws"] is not None:
            laws = {*options["laws"]} - {TASK}
            if (options["bound"] or str(bare.default_bound)) == str(NO_BOUND):
                laws -= {"bound"}
            elif "bound" not in laws:
                options["bound"] = None
            options["laws"] = laws if laws or bare.task.is_map else None
        return replace(bare, **{**options, "task": bare.task})
