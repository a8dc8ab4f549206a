"""**The** table of the verbs: what each is called, what does it, and what it is for.

The command line, the names of the package and the tests are derived from it.  A new verb is
an entry here, the function, the text and the document that it names, and a module of ``cli``
of its name.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Verb:
    """A verb of the command line.

    Attributes:
        name: the words on the command line.
        function: what does it, as ``module:name``; a verb of one word is a name of the package.
        text: what tells its result, as ``module:name`` of :mod:`allworlds.reports`.
        document: the schema of its document, one of :data:`allworlds.documents.PAGES`.
        summary: one line of the help.
        brief: what tells it in one line, likewise, for ``--quiet``; empty where nothing does.
            Of a merge it is that of the verb whose shards were joined.
    """

    name: str
    function: str
    text: str
    document: str
    summary: str
    brief: str = ""

    @property
    def group(self) -> str:
        """The first of two words; empty for a verb of one."""
        return self.name.partition(" ")[0] if " " in self.name else ""


VERBS = (
    Verb(
        "check",
        "checker:check",
        "check_text:check_text",
        "check",
        "Every world of a class, one explorer, a verdict: the main job.",
        brief="check_text:verdict_line",
    ),
    Verb(
        "run",
        "checker:run",
        "run_text:run_text",
        "run",
        "One world, told step by step.",
        brief="run_text:run_line",
    ),
    Verb(
        "fuzz",
        "fuzzer:fuzz",
        "check_text:check_text",
        "check",
        "Random worlds beyond the exhaustive bound.",
        brief="check_text:verdict_line",
    ),
    Verb(
        "replay",
        "checker:replay",
        "run_text:replay_text",
        "replay",
        "A finding once more: reproduced or fixed.",
        brief="run_text:replay_line",
    ),
    Verb(
        "explain",
        "explaining:explain",
        "explain_text:explain_text",
        "explain",
        "A finding in plain words.",
    ),
    Verb(
        "mutants",
        "mutation:mutants",
        "mutants_text:mutants_text",
        "mutants",
        "What the checks are known to catch.",
    ),
    Verb(
        "count",
        "counter:count",
        "count_text:count_text",
        "count",
        "How many maps there are, counted twice.",
    ),
    Verb(
        "worst",
        "worst_case:worst",
        "worst_text:worst_text",
        "worst",
        "An explorer at its worst and best, over every schedule.",
    ),
    Verb(
        "compare",
        "comparing:compare",
        "compare_text:compare_text",
        "compare",
        "Explorers side by side on the same worlds.",
    ),
    Verb(
        "grow",
        "growing:grow",
        "grow_text:grow_text",
        "grow",
        "How an explorer's cost grows with the world.",
    ),
    Verb(
        "figure",
        "figures:figure",
        "figure_text:figure_text",
        "figure",
        "The paper's figures, drawn anew from runs.",
        brief="figure_text:figure_line",
    ),
    Verb(
        "merge",
        "joining:merge",
        "merge_text:merge_text",
        "merge",
        "One report of all shards of a job.",
        brief="merge_text:merge_line",
    ),
    Verb(
        "status",
        "joining:status",
        "merge_text:status_text",
        "status",
        "How far a run directory is.",
    ),
    Verb(
        "twins",
        "ambiguity:twins",
        "ambiguity_text:twins_text",
        "twins",
        "Can any motion tell two worlds apart?",
    ),
    Verb(
        "search",
        "smt:search",
        "search_text:search_text",
        "search",
        "Worlds that no motion tells apart, by SMT.",
    ),
    Verb(
        "bench",
        "benching:bench",
        "bench_text:bench_text",
        "bench",
        "This program and others side by side.",
    ),
    Verb(
        "optimum",
        "minimax:optimum",
        "optimum_text:optimum_text",
        "optimum",
        "The best that any explorer can do in the worst world, by minimax.",
    ),
    Verb(
        "claims",
        "ledger:claims",
        "claims_text:claims_text",
        "claims",
        "The paper's sentences and ours, each with what was found.",
        brief="claims_text:claims_line",
    ),
    Verb(
        "init",
        "skeletons:init",
        "init_text:init_text",
        "init",
        "A skeleton of an explorer of one's own, in one of several languages.",
    ),
    Verb(
        "play",
        "playing:play",
        "play_text:play_text",
        "play",
        "Be the robot yourself, in a page or in the terminal.",
    ),
    Verb(
        "native",
        "libraries:native",
        "native_text:native_text",
        "native",
        "The C header of explorers in shared libraries.",
    ),
    Verb(
        "ambiguity census",
        "ambiguity:census",
        "ambiguity_text:census_text",
        "ambiguity-census",
        "Which worlds of a class no motion tells apart.",
    ),
    Verb(
        "ambiguity class",
        "ambiguity:class_of",
        "ambiguity_text:class_text",
        "ambiguity-class",
        "Every world that no motion tells from a world.",
    ),
)
"""Every verb, in the order of the help."""


@dataclass(frozen=True, slots=True)
class Group:
    """Verbs of two words that begin with the same one."""

    example: str
    summary: str


GROUPS = {
    "ambiguity": Group(
        "allworlds ambiguity class wheel-4",
        "What a robot that knows only its position cannot tell apart.",
    ),
}
"""The groups of verbs of two words, by the first."""
