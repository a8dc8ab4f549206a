"""**The** table of the verbs: what each is called, what does it, and what it is for.

The command line and the tests are derived from it.  A new verb is an entry here, the function, the
text and the document that it names, and a function of its name in a module of ``cli``.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any


@dataclass(frozen=True, slots=True)
class Verb:
    """A verb of the command line.

    Attributes:
        name: the words on the command line.
        function: the function that does it, as ``module:name``.
        text: the function that tells its result, as ``module:name``.
        document: the schema of its document, one of :data:`allworlds.documents.PAGES`.
        summary: one line of the help.
        brief: the function that tells the result in one line, likewise, for ``--quiet``; empty
            where there is none.  Of a merge it is that of the verb whose shards were joined.
        merged: the function that makes its report of run directories, likewise; empty where it
            keeps none.
        panel: the heading of the help under which it stands; that of its group, if it has one.
    """

    name: str
    function: str
    text: str
    document: str
    summary: str
    brief: str = ""
    merged: str = ""
    panel: str = ""

    @property
    def group(self) -> str:
        """The first of two words; empty for a verb of one."""
        return self.name.partition(" ")[0] if " " in self.name else ""

    @property
    def python(self) -> str:
        """The name in Python; a group with a folder of its own is a name of the package."""
        module, _, name = self.function.partition(":")
        return f"allworlds.{f'{self.group}.' if module == f'studies.{self.group}' else ''}{name}"


EVERYDAY, LONG_RUNS, COSTS, WORLDS = "Everyday", "Long runs", "Costs", "Worlds"
ALIKE, EVIDENCE = "What no robot can tell apart", "The paper and this program"

VERBS = (
    Verb(
        "check",
        "studies.check:check",
        "reports.check_text:check_text",
        "check",
        "Every world of a class, one explorer, a verdict: the main job.",
        brief="reports.check_text:verdict_line",
        merged="studies.check:merged_check",
        panel=EVERYDAY,
    ),
    Verb(
        "run",
        "studies.run:run",
        "reports.run_text:run_text",
        "run",
        "One world, told step by step.",
        brief="reports.run_text:run_line",
        panel=EVERYDAY,
    ),
    Verb(
        "fuzz",
        "studies.fuzz:fuzz",
        "reports.check_text:check_text",
        "check",
        "Random worlds beyond the exhaustive bound.",
        brief="reports.check_text:verdict_line",
        panel=EVERYDAY,
    ),
    Verb(
        "replay",
        "studies.replay:replay",
        "reports.run_text:replay_text",
        "replay",
        "A finding once more: reproduced or fixed.",
        brief="reports.run_text:replay_line",
        panel=EVERYDAY,
    ),
    Verb(
        "explain",
        "judging:explain",
        "reports.explain_text:explain_text",
        "explain",
        "A finding in plain words.",
        panel=EVERYDAY,
    ),
    Verb(
        "init",
        "studies.init:init",
        "reports.init_text:init_text",
        "init",
        "An explorer to begin with, in one of four languages.",
        panel=EVERYDAY,
    ),
    Verb(
        "play",
        "studies.play:play",
        "reports.play_text:play_text",
        "play",
        "Be the robot yourself, in a page or in the terminal.",
        panel=EVERYDAY,
    ),
    Verb(
        "merge",
        "studies.merge:merge",
        "reports.merge_text:merge_text",
        "merge",
        "One report of all shards of a job.",
        brief="reports.merge_text:merge_line",
        panel=LONG_RUNS,
    ),
    Verb(
        "status",
        "studies.status:status",
        "reports.merge_text:status_text",
        "status",
        "How far a run directory is.",
        panel=LONG_RUNS,
    ),
    Verb(
        "compare",
        "studies.compare:compare",
        "reports.compare_text:compare_text",
        "compare",
        "Explorers side by side on the same worlds, or as the worlds grow.",
        panel=COSTS,
    ),
    Verb(
        "worst",
        "studies.worst:worst",
        "reports.worst_text:worst_text",
        "worst",
        "An explorer at its worst and best, over every schedule.",
        merged="studies.worst:merged_worst",
        panel=COSTS,
    ),
    Verb(
        "optimum",
        "studies.optimum:optimum",
        "reports.optimum_text:optimum_text",
        "optimum",
        "The best that any explorer can do in the worst world, by minimax.",
        panel=COSTS,
    ),
    Verb(
        "count",
        "studies.count:count",
        "reports.count_text:count_text",
        "count",
        "How many maps there are, counted twice.",
        panel=WORLDS,
    ),
    Verb(
        "ambiguity twins",
        "studies.ambiguity:twins",
        "reports.ambiguity_text:twins_text",
        "twins",
        "Can any motion tell two worlds apart?",
    ),
    Verb(
        "ambiguity class",
        "studies.ambiguity:class_of",
        "reports.ambiguity_text:class_text",
        "ambiguity-class",
        "Every world that no motion tells from a world.",
    ),
    Verb(
        "ambiguity census",
        "studies.ambiguity:census",
        "reports.ambiguity_text:census_text",
        "ambiguity-census",
        "Which worlds of a class no motion tells apart.",
        merged="studies.ambiguity:merged_census",
    ),
    Verb(
        "ambiguity search",
        "studies.ambiguity:search",
        "reports.search_text:search_text",
        "search",
        "Worlds that no motion tells apart, by SMT.",
    ),
    Verb(
        "paper claims",
        "evidence.claims:claims",
        "evidence.claims.claims_text:claims_text",
        "claims",
        "The paper's sentences and ours, each with what was found.",
        brief="evidence.claims.claims_text:claims_line",
    ),
    Verb(
        "paper figure",
        "evidence.figures:figure",
        "evidence.figures.figure_text:figure_text",
        "figure",
        "The paper's figures, drawn anew from runs.",
        brief="evidence.figures.figure_text:figure_line",
    ),
    Verb(
        "self mutants",
        "evidence.mutants:mutants",
        "evidence.mutants.mutants_text:mutants_text",
        "mutants",
        "What the checks are known to catch.",
    ),
    Verb(
        "self bench",
        "evidence.bench:bench",
        "evidence.bench.bench_text:bench_text",
        "bench",
        "This program and others side by side.",
    ),
)
"""Every verb, in the order of the help."""

BY_NAME = {verb.name: verb for verb in VERBS}
"""Every verb by its name."""


@dataclass(frozen=True, slots=True)
class Group:
    """Verbs of two words that begin with the same one."""

    example: str
    summary: str
    panel: str


GROUPS = {
    "ambiguity": Group(
        "allworlds ambiguity class wheel-4",
        "Worlds that look alike to a robot, with proofs.",
        ALIKE,
    ),
    "paper": Group(
        "allworlds paper claims",
        "The paper's claims and figures, checked and drawn anew.",
        EVIDENCE,
    ),
    "self": Group(
        "allworlds self mutants",
        "This program: the mistakes that it catches, and its speed.",
        EVIDENCE,
    ),
}
"""The groups of verbs of two words, by the first."""

RENAMED = {
    "twins": "ambiguity twins",
    "search": "ambiguity search",
    "claims": "paper claims",
    "figure": "paper figure",
    "mutants": "self mutants",
    "bench": "self bench",
    "grow": "compare EXPLORER... --family F,F --to M",
    "native": "init --header",
}
"""Verbs as they were called once; they are refused with the name that they have now."""

REPLACED = {
    "grow": "compare(*explorers, family=..., to=M)",
    "native": "init(header=True)",
}
"""Functions of the package that are gone, and what does the same."""


def loaded(home: str) -> Any:
    """Return what ``module:name`` below ``allworlds`` names; its module is loaded."""
    module, _, name = home.partition(":")
    return getattr(import_module(f"allworlds.{module}"), name)
