"""**The** table of the verbs: the name, the function and the summary of each verb.

The command line and the tests are derived from this table.  A new verb needs an entry in this
table, and a module with its request, its function and its document.  By default a report is shown
by the function ``plain_content``; a report that this function does not show well needs a function
of its own in ``reports.content``.  A verb that does more than answer a request also needs a
function in ``cli``.
"""

from dataclasses import dataclass

ROWS, CASES, FINDINGS = "rows or a walk", "cases", "findings"
PAGE, CURVE = "a page of its own", "a curve"
RUNS = "runs of several robots"
WORLD_FILE = "worlds, in a notation"
PICTURE = "a picture of a map"
"""The kinds of content that a report can have, beside its sentences.

Each kind of file that ``-o`` can write shows some of these kinds of content.
"""


@dataclass(frozen=True, slots=True)
class Verb:
    """A verb of the command line.

    Attributes:
        name: the words on the command line.
        document: the name of the schema of the verb's document.
        summary: the line about the verb in the help of ``allworlds``.
        has: the kinds of content, such as :data:`ROWS` and :data:`FINDINGS`, that the verb's
            reports have.  Some file formats show only certain kinds of content; the option ``-o``
            of the verb accepts such a format only if it shows one of the kinds in ``has``.
        swept: whether the job consists of units, which a run directory keeps.
        python: the name of the verb's function below ``allworlds``, if it differs from ``name``.
        panel: the heading under which the verb stands in the help; empty for a verb in a group
            (:data:`GROUPS`), which has the heading of the group.
        example: the arguments and options of the example with which the help of the verb begins.
        help: the text of the verb's help that follows the example.  If ``help`` is empty, the
            docstring of the verb's function in ``cli`` is the whole help, and ``example`` is not
            used.
    """

    name: str
    document: str
    summary: str
    has: tuple[str, ...] = (ROWS,)
    swept: bool = False
    python: str = ""
    panel: str = ""
    example: str = ""
    help: str = ""

    @property
    def group(self) -> str:
        """The first word of the verb's name, if the name has two words; else empty."""
        return self.name.partition(" ")[0] if " " in self.name else ""

    @property
    def path(self) -> str:
        """The name of the verb's function in Python, such as ``allworlds.check``.

        This module imports no function; other modules find it by ``pkgutil.resolve_name``.
        """
        return f"allworlds.{self.python or self.name.replace(' ', '.')}"


EVERYDAY, LONG_RUNS, COSTS, WORLDS = "Everyday", "Long runs", "Costs", "Worlds"
ALIKE, PAPERS = "What no robot can tell apart", "Papers"

VERBS = (
    Verb(
        "check",
        "check",
        "Run an explorer in every world of a class, for a verdict: the main job.",
        swept=True,
        panel=EVERYDAY,
        has=(ROWS, CASES, FINDINGS),
    ),
    Verb("run", "run", "Run an explorer in one world, step by step.", panel=EVERYDAY),
    Verb(
        "fuzz",
        "check",
        "Run an explorer in random worlds beyond the exhaustive bound.",
        panel=EVERYDAY,
        has=(ROWS, CASES, FINDINGS),
        swept=True,
        example="my_explorer.py:explore --edges 20 --min-edges 6 --runs 1000",
        help=(
            "Run an explorer in random worlds beyond the exhaustive bound, and shrink what "
            "refutes it. Exit code 0: not refuted by the sample, 1: refuted."
        ),
    ),
    Verb("replay", "replay", "Run a finding again: is it reproduced or fixed?", panel=EVERYDAY),
    Verb("explain", "explain", "Explain a finding in plain words.", panel=EVERYDAY),
    Verb(
        "init",
        "init",
        "Write a skeleton of an explorer, in one of four languages.",
        panel=EVERYDAY,
        has=(),
        example="my-explorer --lang javascript",
        help=(
            "Write an explorer to begin with, its test, and a workflow for CI. It builds and runs, "
            "and a check refutes it, until it is filled in. With --header print allworlds.h, for "
            "explorers in shared libraries: check --native PATH tries one."
        ),
    ),
    Verb(
        "team",
        "team",
        "Search every schedule of several robots in worlds that change.",
        panel=EVERYDAY,
        has=(ROWS, CASES, FINDINGS, RUNS),
        swept=True,
        example="waits.py:wait searches.py:search --model meeting:labels=true --edges 3",
        help=(
            "Several robots in every world of a class, from every start, under every schedule and "
            "every choice of an adversary: a model says how the world changes. Exit code 0: holds, "
            "1: refuted, with a shortest run in the smallest world, 3: a budget cuts a run off."
        ),
    ),
    Verb(
        "play",
        "play",
        "Be the robot, in a web page or in the terminal.",
        panel=EVERYDAY,
        has=(PAGE,),
    ),
    Verb(
        "merge",
        "merge",
        "Join the shards of a job into one report.",
        panel=LONG_RUNS,
        example="shard-0 shard-1",
        help=(
            "Join the run directories of all shards of a job to the report that the job would have "
            "made by itself: counts and witnesses are judged over all of them. Exit code 75: a "
            "part is missing, else that of the job."
        ),
    ),
    Verb(
        "status",
        "status",
        "Show the progress of a run directory.",
        panel=LONG_RUNS,
        has=(),
        example="shard-0",
        help=(
            "Progress of a run directory, also while a job adds to it: units, worlds, rate, and "
            "findings."
        ),
    ),
    Verb(
        "compare",
        "compare",
        "Compare explorers in the same worlds, or in worlds that grow.",
        panel=COSTS,
        swept=True,
        has=(ROWS, CURVE),
        example="algorithm1 dudek91 --edges 4",
        help=(
            "Run explorers in the same worlds, each under its own lighthouse, or under the one "
            "after @, as in algorithm1-word@word:12*. In each rooted map, the mean cost of the "
            "first explorer over the lighthouse's places is compared with that of each other one. "
            "With --to run one or more explorers in worlds that grow: cost by size, as in "
            "allworlds compare algorithm1 dudek91 --family lattice,torus --to 100. "
            "Every run is judged. Exit code 0: no law is broken, 1: one is."
        ),
    ),
    Verb(
        "worst",
        "worst",
        "Find the worst and best cost of Algorithm 1, over every schedule.",
        swept=True,
        panel=COSTS,
        example="--edges 5",
        help=(
            "The exact worst and best cost of Algorithm 1 over all worlds and over every "
            "schedule: every choice of edge, order of hypotheses and path. "
            "Exit code 0: answered, 1: a schedule breaks a law, 70: counts, replays or "
            "engines disagree."
        ),
    ),
    Verb(
        "count",
        "count",
        "Count the maps of a class, in two independent ways.",
        panel=WORLDS,
        swept=True,
        example="--edges 6",
        help=(
            "Enumerate every rooted map of a class, count, and compare the counts with an "
            "independent source."
        ),
    ),
    Verb(
        "convert",
        "convert",
        "Tell of the worlds of a file, and write them in another notation.",
        panel=WORLDS,
        has=(ROWS, WORLD_FILE, PICTURE),
    ),
    Verb(
        "ambiguity twins",
        "twins",
        "Decide whether any motion tells two worlds apart.",
        example="fig1-left fig1-right",
        help=(
            "Can any motion tell two worlds apart? The answer comes with the shortest motions that "
            "do, or with classes of darts that prove that none does."
        ),
    ),
    Verb(
        "ambiguity class",
        "ambiguity-class",
        "List every world that no motion tells from a given one.",
        python="ambiguity.class_of",
        example="k4 --class simple",
        help=("Build every world that no motion tells from WORLD, and say why."),
    ),
    Verb(
        "ambiguity census",
        "ambiguity-census",
        "Classify the worlds of a class that no motion tells apart.",
        swept=True,
        example="--edges 5",
        help=(
            "Classify every map with one marked vertex: which of them does no motion tell "
            "apart? Twins are looked for inside the class only."
        ),
    ),
    Verb(
        "ambiguity search",
        "search",
        "Search for worlds that no motion tells apart, by SMT.",
        example="--lighthouse position --class simple --edges 6 --vertices 4",
        help=(
            "Find two different worlds that no motion tells apart, or show that there are none. "
            "Exit code 0: answered, 3: the time was over, 4: no world exists within the bounds."
        ),
    ),
    Verb(
        "ambiguity sensors",
        "ambiguity-sensors",
        "Compare sensors: where each fails first, which tells more.",
        example="position door directional --edges 4",
        help=(
            "Lighthouses side by side: which suffice in every small world? One suffices if no two "
            "worlds (two maps, or one map from two starts) look alike under it. The report has the "
            "two smallest that do, and says of sensors with equal places which one tells more."
        ),
    ),
    Verb(
        "ambiguity weakest",
        "ambiguity-weakest",
        "Find the weakest sensors that suffice, of all coarsenings.",
        example="papers/minimal_information/sensors.py:Features --edges 4",
        help=(
            "Go through every coarsening of a sensor that tells several features apart: which "
            "suffice in every small world, and which of these are minimal?"
        ),
    ),
    Verb(
        "ledger",
        "ledger",
        "Check the sentences of a paper, each by its own function.",
        panel=PAPERS,
        has=(ROWS, CASES),
        example="papers/minimal_information --only fig1",
        help=(
            "The ledger of a paper: a folder with ledger.toml, which has each sentence that can be "
            "checked and the expected verdict, and claims.py, which has a function for each. "
            "allworlds init DIR --ledger writes one to begin with. Exit code 0: all that was "
            "checked is as expected, 1: something is not, 3: a required claim was not checked, "
            "4: no claim was checked, or a claim was checked on no case."
        ),
    ),
)
"""Every verb, in the order of the help."""

BY_NAME = {verb.name: verb for verb in VERBS}
"""Every verb by its name."""


@dataclass(frozen=True, slots=True)
class Group:
    """A group of verbs, which has a help of its own.

    The groups in :data:`GROUPS` hold verbs of two words: all verbs with the same first word.  The
    group :data:`ROOT` stands for ``allworlds`` itself, and holds all verbs.

    Attributes:
        example: the command with which the help of the group begins.
        summary: the line about the group.
        panel: the heading under which the group stands in the help; empty for :data:`ROOT`.
    """

    example: str
    summary: str
    panel: str


GROUPS = {
    "ambiguity": Group(
        "allworlds ambiguity class wheel-4",
        "Worlds that look alike to a robot, with proofs.",
        ALIKE,
    )
}
"""The groups of verbs of two words, by their first word."""

ROOT = Group(
    "allworlds check --edges 4", "Run an exploration algorithm on every small embedded graph.", ""
)
"""The group of all verbs, for the help of ``allworlds`` itself."""
