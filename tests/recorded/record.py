"""Record what every verb says: exit code, document on stdout, line on stderr.

``python tests/recorded/record.py`` writes the records anew; what then differs is to be meant,
and told in the commit.  ``test_recorded.py`` compares.  No record depends on the clock, on
the machine, on where the project lies, or on the number of workers: each command is done in a new
directory that holds the explorers.
"""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import sys
import tempfile
from contextlib import ExitStack, chdir, redirect_stderr, redirect_stdout
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from allworlds.cli.app import call
from allworlds.studies.check.exhaustive import check
from allworlds.world.named import own_corpus

HERE = Path(__file__).parent
FINDINGS = own_corpus().directory / "findings"
PLANTRI = HERE.parent / "support" / "data" / "plantri"
PAPER = HERE.parents[1] / "papers" / "minimal_information"
RECORDS = HERE / "records"
PATH_3 = '{"sigma":[0,2,1,3],"alpha":[1,0,3,2]}'

# The fewest words with which each verb does something; {tmp} is a directory to write in.
LEAST = {
    "check": "--edges 1",
    "run": "theta",
    "fuzz": "--edges 1 --runs 1",
    "replay": "{findings}/lucky-guess.json",
    "explain": "{findings}/lucky-guess.json",
    "init": "{tmp}/least",
    "team": "{recorded}/explorers.py:waits --robots 1 --edges 1",
    "play": "theta -o {tmp}/least-play.html",
    "merge": "{run}",
    "status": "{run}",
    "compare": "algorithm1 folding --edges 1",
    "worst": "--edges 1",
    "count": "--edges 1",
    "convert": "{plantri}/tri6.pl",
    "ambiguity twins": "k4 k4",
    "ambiguity class": "k4",
    "ambiguity census": "--edges 1",
    "ambiguity search": "--lighthouse position --vertices 1 --edges 1 --out {tmp}/least",
    "ambiguity sensors": "door --edges 1",
    "ambiguity weakest": "{recorded}/features.py:Ends --edges 1",
    "ledger": "{paper} --only fig1",
}

# What every command says is recorded under a name.
COMMANDS = {
    "check": "check --edges 4 --json",
    "check-python": "check --edges 4 --engine python --json",
    "check-kernel": "check --edges 6 --engine kernel --json",
    "check-lifo": "check --edges 4 --policy lifo --json",
    "check-random": "check --edges 3 --policy random:7 --json",
    "check-schedules": "check --edges 2 --schedules all --json",
    "check-simple": "check --class simple --vertices 4 --json",
    "check-planar": "check --class planar --edges 3 --json",
    "check-planar-simple": "check --class planar-simple --edges 5 --json",
    "check-shard": "check --edges 4 --shard 1/3 --json",
    "check-bound-1": "check --edges 3 --bound 1 --json",
    "check-laws": "check --edges 3 --laws map,pose --json",
    "check-cluster": "check algorithm1-cluster --edges 3 --json",
    "check-cluster-all": "check algorithm1-cluster --lighthouse cluster --edges 3 --json",
    "check-natural": "check algorithm1-natural --class simple --edges 6 --json",
    "check-compass": "check explorers.py:stays --lighthouse compass --edges 3 --json",
    "check-none": "check explorers.py:stays --lighthouse none --edges 2 --json",
    "check-position": "check explorers.py:first_edge --lighthouse position --edges 2 --json",
    "check-first-edge": "check explorers.py:first_edge --edges 3 --max-findings 4 --json",
    "check-first-edge-text": "check explorers.py:first_edge --edges 3",
    "check-crash": "check explorers.py:crashes --edges 3 --json",
    "check-nonsense": "check explorers.py:says_nonsense --edges 2 --json",
    "check-for-ever": "check explorers.py:walks_for_ever --edges 2 --step-budget 20 --json",
    "check-chooses": "check explorers.py:chooses --edges 2 --schedules all --json",
    "check-exec": ["check", "--exec", "{python} program.py", "--edges", "2", "--json"],
    "check-vacuous": "check --class simple --edges 1 --lighthouse cluster --json",
    "check-corpus": "check explorers.py:first_edge --edges 3 --corpus corpus --json",
    "check-corpus-again": "check explorers.py:first_edge --edges 3 --corpus corpus --json",
    "check-corpus-mended": "check algorithm1 --edges 3 --corpus corpus --json",
    "run": "run algorithm1 theta-torus --json",
    "run-wrong": "run explorers.py:first_edge theta",
    "run-json-world": ["run", "explorers.py:first_edge", PATH_3, "--json"],
    "run-family": "run algorithm1 --family lattice:3x3 --holes 10% --seed 3 --json",
    "run-choices": "run algorithm1 theta --policy lifo --choices 1,0 --json",
    "run-cluster": "run algorithm1-cluster k4 --json",
    "fuzz": "fuzz algorithm1 --edges 8 --runs 30 --json",
    "fuzz-wrong": "fuzz explorers.py:first_edge --edges 8 --runs 30 --seed 2 --json",
    "team": "team explorers.py:other_end --edges 2 --json",
    "team-text": "team explorers.py:waits explorers.py:other_end --edges 2",
    "team-holds": "team explorers.py:other_end --scheduler central --edges 1 --json",
    "team-cut-off": "team explorers.py:walks_for_ever --edges 1 --budget 3",
    "replay-team": "replay team.json",
    "explain-team": "explain team.json",
    "count": "count --edges 4 --json",
    "convert": "convert {plantri}/tri6.pl -o tri6.ec --json",
    "convert-text": "convert {plantri}/tri5.pl",
    "count-simple-text": "count --class simple --vertices 4",
    "count-compiled": "count --edges 7 --json",
    "worst": "worst --edges 3 --json",
    "worst-shortest": "worst --edges 4 --transit shortest",
    "worst-planar": "worst --edges 4 --class planar --json",
    "compare": "compare algorithm1 folding folding-oldest --edges 3 --json",
    "compare-text": "compare algorithm1 algorithm1-cluster --edges 3",
    "compare-family": "compare folding algorithm1 --family thick:4x5 --seed 2 --json",
    "compare-wrong": "compare folding explorers.py:first_edge --edges 2 --json",
    "worst-shard": "worst --edges 3 --shard 0/2 --json",
    "ledger": "ledger {paper} --only lower-bound-2m --only coq-2m --only pass-kinds --json",
    "ledger-text": "ledger {paper} --only cycles",
    "ledger-required": "ledger {paper} --only bound-order --require coq-2m --json",
    "census-shard": "ambiguity census --edges 3 --shard 0/2 --json",
    "merge": "merge {run} --json",
    "merge-text": "merge {run}",
    "status": "status {run} --json",
    "status-text": "status {run}-0",
    "growth": "compare algorithm1 dudek91 --family lattice,dense --to 50 --draws 2 --json",
    "replay": "replay finding.json --json",
    "replay-text": "replay finding.json",
    "replay-fixed": "replay finding.json --explorer algorithm1 --json",
    "explain": "explain finding.json --json",
    "explain-text": "explain finding.json",
    "explain-crash": "explain crash.json --json",
    "ambiguity-census": "ambiguity census --edges 4 --json",
    "ambiguity-census-text": "ambiguity census --class simple --vertices 4",
    "ambiguity-sensors": "ambiguity sensors position door directional none --edges 3 --json",
    "ambiguity-sensors-text": "ambiguity sensors position door word:1 word:12 --edges 3",
    "ambiguity-weakest": "ambiguity weakest features.py:Ends --edges 3 --json",
    "ambiguity-weakest-text": "ambiguity weakest features.py:Ends --edges 3",
    "ambiguity-class": "ambiguity class wheel-4 --json",
    "ambiguity-class-text": "ambiguity class k4 --class simple --limit 2",
    "twins-apart": "ambiguity twins k4 wheel-4",
    "twins-alike": "ambiguity twins fig1-left fig1-right --json",
    "search-sat": "ambiguity search --lighthouse position --vertices 1 --edges 2 --out sat --json",
    "search-unsat": (
        "ambiguity search --lighthouse directional --vertices 3 --edges 2 --out un --json"
    ),
    "search-none": (
        "ambiguity search --lighthouse none --class simple --vertices 4 --edges 4 --out none --json"
    ),
    "init": "init made/c --lang c --json",
    "init-text": "init made/python",
    "play": "play theta-torus -o play.html --json",
    "play-text": "play theta --lighthouse position",
    "header": "init --header --json",
    "refused-option": "check --egdes 3",
}

# What must be there before a command: explorers, reports of other commands, in files, and what
# other commands leave in a corpus.
EXPLORERS = ("explorers.py", "features.py", "program.py")
FILES = {
    "finding.json": "check explorers.py:first_edge --edges 3 --json",
    "team.json": "team explorers.py:other_end --edges 2 --json",
    "crash.json": "check explorers.py:crashes --edges 3 --json",
}
BEFORE = {
    "check-corpus-again": ["check-corpus"],
    "check-corpus-mended": ["check-corpus", "check-corpus-again"],
}


def least(verb: str, tmp: str) -> list[str]:
    """A command of that verb that soon does something."""
    return [*verb.split(), *words(LEAST[verb], tmp)]


def words(command: str | list[str], tmp: str) -> list[str]:
    names = {"tmp": tmp, "python": sys.executable}
    names |= {"findings": str(FINDINGS), "paper": str(PAPER), "plantri": str(PLANTRI)}
    names["recorded"] = str(HERE)
    given = command if isinstance(command, list) else command.split()
    if any("{run}" in word for word in given):
        names["run"] = str(run_directory(Path(tmp) / "run"))
    return [
        re.sub(r"\{(\w+)\}", lambda found: names.get(found[1], found[0]), word) for word in given
    ]


def run_directory(path: Path) -> Path:
    """A run directory of a finished check; beside it that of a shard alone."""
    if not path.exists():
        check(edges=2, run=path)
        check(edges=2, shard=(0, 2), run=f"{path}-0")
    return path


# What a terminal or a CI tells programs about colours and pages; a record is plain.
COLOURS = {"FORCE_COLOR", "CLICOLOR_FORCE", "PY_COLORS", "NO_COLOR"}
COLOURS |= {"GITHUB_ACTIONS", "GITHUB_STEP_SUMMARY"}


class Said(NamedTuple):
    """What a command has written, and its exit code."""

    code: int
    out: str
    err: str


def said(command: str | list[str], directory: str) -> Said:
    """Do a command there, in this process."""
    out, err = io.StringIO(), io.StringIO()
    env = {name: value for name, value in os.environ.items() if name not in COLOURS}
    env |= {"COLUMNS": "100", "TERM": "dumb"}
    with ExitStack() as here:
        here.enter_context(patch.dict(os.environ, env, clear=True))
        here.enter_context(patch("sys.stdin", io.StringIO()))
        for each in (chdir(directory), redirect_stdout(out), redirect_stderr(err)):
            here.enter_context(each)
        code = call(words(command, directory))
    return Said(code, out.getvalue(), err.getvalue())


def record(name: str, directory: str) -> str:
    """One command's record: the command, its exit code, stderr, then stdout."""
    command = COMMANDS[name]
    prepare(name, directory)
    done = said(command, directory)
    try:
        document = json.loads(done.out)
        del document["made_by"]
        told = json.dumps(document, indent=1)
    except ValueError:
        told = done.out
    errors = [line for line in done.err.splitlines() if "compiling" not in line]
    shown = command if isinstance(command, str) else json.dumps(command)
    text = "\n".join([f"$ allworlds {shown}", f"exit code {done.code}", *errors, told])
    text = text.replace(directory, "{directory}").replace(sys.executable, "{python}")
    return re.sub(r"\b\d+\.\d\d\b(?= +\S+\.cnf)", "0.00", text.rstrip()) + "\n"


def prepare(name: str, directory: str) -> None:
    """The explorers, and what else the command reads."""
    for file in EXPLORERS:
        shutil.copy(HERE / file, directory)
    for file, command in FILES.items():
        if file in COMMANDS[name]:
            (Path(directory) / file).write_text(said(command, directory).out, encoding="utf-8")
    for earlier in BEFORE.get(name, ()):
        said(COMMANDS[earlier], directory)


def main() -> None:
    names = sys.argv[1:] or [*COMMANDS]
    if not sys.argv[1:]:
        shutil.rmtree(RECORDS, ignore_errors=True)
    RECORDS.mkdir(exist_ok=True)
    for name in names:
        with tempfile.TemporaryDirectory() as made:
            text = record(name, str(Path(made).resolve()))
        (RECORDS / f"{name}.txt").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
