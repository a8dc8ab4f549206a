"""Options that several verbs share, in groups: each stands here once on the command line."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import typer

from allworlds.cli.values import integer, law_names, seconds, worker_count
from allworlds.explorers import EXEC, NATIVE
from allworlds.inputs import InputError, show
from allworlds.studies.check import DEFAULTS, LEGAL

if TYPE_CHECKING:
    from allworlds.studies.check import ManyRunsOptions, RunOptions

ANSWER_TIMEOUT: float = DEFAULTS["answer_timeout"]
FORMS = ", ".join(LEGAL["family"])
"""How a world of a family is written."""

SCOPE, RULES, EFFORT, OUTPUT = "What is checked", "How it is judged", "Effort", "Output"


def one_of(names: Iterable[str]) -> str:
    """The names of a table, as a help says them: ``a, b or c``."""
    *others, last = names
    return f"{', '.join(others)} or {last}"


def legal(option: str) -> str:
    """The names that an option may be, likewise."""
    return one_of(LEGAL[option])


def option(panel: str, metavar: str, help_: str, *names: str, **more: Any) -> Any:
    """An option of a panel of the help; without ``names`` its field names it."""
    return typer.Option(*names, metavar=metavar, help=help_, rich_help_panel=panel, **more)


def flag(panel: str, help_: str, *names: str) -> Any:
    """An option without a value."""
    return option(panel, "", help_, *names)


def number(panel: str, metavar: str, help_: str, *names: str, **more: Any) -> Any:
    """The same for an integer."""
    return option(panel, metavar, help_, *names, parser=integer, **more)


Explorer = Annotated[
    str | None,
    typer.Argument(
        metavar="[EXPLORER]",
        help="A built-in name, module:attribute, path/to/file.py:attribute or an entry point "
        "(default: algorithm1). Of a file with one generator function its name will do.",
        show_default=False,
    ),
]
WORLD = "Inline JSON, @file, or a name such as k4, wheel-4, fig1-left."
WorldText = Annotated[str, typer.Argument(metavar="WORLD", help=WORLD)]
FindingFile = Annotated[
    str, typer.Argument(metavar="FILE", help="A finding, or a check's report; - for stdin.")
]
Exec = Annotated[
    str | None,
    option(SCOPE, "COMMAND", "In place of EXPLORER: a program that speaks JSON lines.", "--exec"),
]
Native = Annotated[
    str | None,
    option(
        SCOPE,
        "PATH",
        "In place of EXPLORER: a shared library with the functions of allworlds.h.",
        "--native",
    ),
]
Explorers = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="[EXPLORER...]",
        help="Built-in names, module:attribute, path/to/file.py:attribute or entry points; those "
        "of --exec and --native come after them.",
        show_default=False,
    ),
]
Workers = Annotated[str, option(EFFORT, "N|auto", "Processes, or threads.")]
MapClassName = Annotated[str, option(SCOPE, "CLASS", f"{one_of(LEGAL['map_class'])}.", "--class")]
LighthouseName = Annotated[
    str | None,
    option(
        SCOPE,
        "KIND",
        f"KIND[:key=value,...]: {one_of(LEGAL['lighthouse'])} (default: directional, or the one "
        "that a built-in explorer is written for).",
        show_default=False,
    ),
]
LighthouseOfWorld = Annotated[
    str,
    option(
        SCOPE,
        "KIND",
        f"The lighthouse of a WORLD that names none: {one_of(LEGAL['lighthouse'])}.",
    ),
]
ShardText = Annotated[
    str, option(SCOPE, "K/N", "Only the K-th of N parts of about equal weight, from 0.")
]
RunDirectory = Annotated[
    str | None,
    option(
        EFFORT,
        "DIR",
        "A directory that keeps what is finished: the same command goes on from there, and "
        "'merge' joins shards.",
        show_default=False,
    ),
]
DaskAddress = Annotated[
    str | None,
    option(
        EFFORT,
        "ADDRESS|local",
        "Do the work on the workers of this Dask scheduler (extra: distributed).",
        show_default=False,
    ),
]
TimeLimit = Annotated[float | None, option(EFFORT, "S", "Seconds for everything.", parser=seconds)]
CsvFile = Annotated[
    str | None,
    option(OUTPUT, "FILE", "Write the rows as CSV too.", show_default=False),
]
AnswerTimeout = Annotated[
    float,
    option(EFFORT, "S", "Seconds of silence that break the law 'timeout'.", parser=seconds),
]


Holes = Annotated[
    str | None,
    option(
        SCOPE,
        "P%",
        "Share of a family's edges to remove [default: none].",
        show_default=False,
    ),
]


@dataclass(frozen=True, slots=True)
class ExtentGroup:
    """The extent of an exhaustive verb."""

    edges: Annotated[
        int | None,
        number(
            SCOPE,
            "M",
            f"At most M edges (default of check, unless --vertices is given: {DEFAULTS['edges']}).",
            show_default=False,
        ),
    ] = None
    vertices: Annotated[
        int | None,
        number(SCOPE, "N", "At most N vertices (alone: simple classes only; default: any)."),
    ] = None
    map_class: MapClassName = "maps"


@dataclass(frozen=True, slots=True)
class FamilyGroup:
    """One world of a family, in place of another."""

    family: Annotated[str | None, option(SCOPE, "F", f"One world of a family: {FORMS}.")] = None
    holes: Holes = None
    seed: Annotated[int, number(SCOPE, "S", "For whatever is drawn of a family.")] = 0


@dataclass(frozen=True, slots=True)
class ProgramsGroup:
    """Explorers that are no Python, beside the EXPLORERs."""

    command: Annotated[
        list[str] | None,
        option(
            SCOPE,
            "COMMAND",
            "An explorer too: a program that speaks JSON lines; repeatable.",
            "--exec",
            show_default=False,
        ),
    ] = None
    native: Annotated[
        list[str] | None,
        option(
            SCOPE,
            "PATH",
            "An explorer too: a shared library with the functions of allworlds.h; repeatable.",
            "--native",
            show_default=False,
        ),
    ] = None

    def after(self, explorers: list[str] | None) -> list[str]:
        """The names of all explorers, these at the end."""
        return [
            *(explorers or []),
            *(EXEC + command for command in self.command or []),
            *(NATIVE + path for path in self.native or []),
        ]


@dataclass(frozen=True, slots=True)
class RulesGroup:
    """How runs are played and judged."""

    policy: Annotated[
        str,
        option(
            RULES,
            "POLICY",
            f"Who answers the explorer's choices: {one_of(LEGAL['policy'])}.",
        ),
    ] = DEFAULTS["policy"]
    bound: Annotated[
        str | None,
        option(
            RULES,
            "BOUND",
            "Largest number of traversals: paper (the sum of the paper's bounds (1) and (2)), "
            "two-vertices, none, or an expression over n, m, d0, D with + - * // **, min, max "
            "(default: the explorer's own, else the lighthouse's).",
            show_default=False,
        ),
    ] = None
    laws: Annotated[
        str | None,
        option(
            RULES,
            "LAWS",
            f"Of {', '.join(LEGAL['laws'])}, with commas (default: all that apply).",
            show_default=False,
        ),
    ] = None
    step_budget: Annotated[
        int | None,
        number(
            RULES,
            "B",
            "More traversals break the law 'budget' (default: 8 x the bound paper + 100).",
            show_default=False,
        ),
    ] = None
    answer_timeout: AnswerTimeout = ANSWER_TIMEOUT

    def options(self) -> RunOptions:
        """As ``run`` takes them."""
        return {
            "policy": self.policy,
            "bound": self.bound,
            "laws": law_names(self.laws),
            "step_budget": self.step_budget,
            "answer_timeout": self.answer_timeout,
        }


@dataclass(frozen=True, slots=True)
class EffortGroup:
    """What bounds the effort of many runs."""

    workers: Workers = "auto"
    time_limit: TimeLimit = None
    memory: Annotated[
        int | None,
        number(EFFORT, "MB", "Address space of each worker process; the kernel engine has none."),
    ] = None

    @property
    def count(self) -> int:
        """The number of workers."""
        return worker_count(self.workers)


def many_runs(
    map_class: str, lighthouse: str | None, rules: RulesGroup, effort: EffortGroup
) -> ManyRunsOptions:
    """As ``check`` and ``fuzz`` take them."""
    return {
        **rules.options(),
        "map_class": map_class,
        "lighthouse": lighthouse,
        "workers": effort.count,
        "time_limit": effort.time_limit,
        "memory": effort.memory,
    }


@dataclass(frozen=True, slots=True)
class OutputGroup:
    """What is printed."""

    as_json: Annotated[bool, flag(OUTPUT, "One JSON document on stdout.", "--json")] = False
    quiet: Annotated[
        bool, flag(OUTPUT, "No progress, and of a verdict one line.", "-q", "--quiet")
    ] = False


@dataclass(frozen=True, slots=True)
class LongOutputGroup(OutputGroup):
    """What is printed of a verb that may take long, and what is told of it meanwhile."""

    events: Annotated[
        str | None,
        option(
            OUTPUT,
            "FILE",
            "Write what happens, as it happens: a line of JSON each.",
            show_default=False,
        ),
    ] = None


def explorer_name(
    explorer: str | None, command: str | None = None, native: str | None = None
) -> str:
    """The name of the subject; ``algorithm1`` where none is given."""
    given = {
        f"EXPLORER {show(explorer)}": explorer,
        f"--exec {show(command)}": None if command is None else EXEC + command,
        f"--native {show(native)}": None if native is None else NATIVE + native,
    }
    named = {option: name for option, name in given.items() if name is not None}
    if len(named) > 1:
        raise InputError(f"give {' or '.join(named)}, not both")
    return next(iter(named.values()), "algorithm1")
