"""The checker extracted from the Coq proofs: its verdicts, and those of ``allworlds check``.

    python proofs/coq/certified.py --exec 'COMMAND' [--edges 4] [--limit paper] [--universe all]

asks it about a program (docs/how-to/languages.md): is it right, and within the limit, in every
world with at most so many edges?  ``holds`` is a theorem (``check_correct`` in
``proofs/coq/Checker.v``) about the function of the percepts that the program's answers are part of.
Trusted is what the README of ``proofs/coq`` says of all extracted programs, the driver
``ocaml/checker.ml`` and ``ocaml/pipe.ml`` between the program and the theorem, and that the program
would answer the same percepts in the same way again; where it is seen not to, the verdict is ``no
function``.

``checkers_agree`` compares: Algorithm 1 and every wrong explorer of ``corpus/explorers.py``
get the same verdict from both, and are refuted by the same smallest world.
"""

from __future__ import annotations

import argparse
import json
import shlex
import signal
import subprocess
import sys
import time
import traceback
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from allworlds.cli.output import abandon_stdout
from allworlds.corpus.explorers import (
    EQUIVALENT_EXPLORERS,
    WRONG_EXPLORERS,
    WrongExplorer,
)
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import EpisodeEnding, Fault
from allworlds.judging.findings.finding import Finding
from allworlds.judging.laws.bounds import bound_named
from allworlds.maps import rooted_code
from allworlds.outcome import Verdict
from allworlds.studies.check.exhaustive import check
from allworlds.studies.check.report import CheckReport
from allworlds.words import plural
from certificate_file import NoVerdict

HERE = Path(__file__).resolve().parent
CHECKER = HERE / "checker"
SERVER = HERE / "explorer_server.py"
LAWS = ("map", "pose", "bound")
"""Those that the certified checker decides; a run that gives no answer breaks one before them."""
POLICIES = ("fifo", "lifo", "nearest")
VERDICTS = ("holds", "refuted", "no function")
REFUSED = 2
"""The exit code with which it has said on stderr why there is no verdict."""

Key = tuple[int, tuple[int, ...], tuple[int, ...], int]
"""The order of findings with equal numbers of edges: vertices, sigma, alpha, place."""


def asked(
    edges: int, explorer: Sequence[str], stderr: int | None = None, **options: object
) -> dict[str, Any]:
    """The certified checker's answer; what it and the program say on stderr goes there.

    Raises:
        allworlds.InputError: if it refuses the options, or the program cannot be run; the message
            says why, unless it has said so itself.
        NoVerdict: if it does not end well.
    """
    named = [word for name, value in options.items() for word in (f"--{name}", str(value))]
    command = [str(CHECKER), str(edges), *named, *explorer]
    try:
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=stderr, text=True, check=False)
    except OSError as error:
        raise InputError(f"{error.filename}: {error.strerror}") from None
    if run.returncode == REFUSED:
        raise InputError("")
    if run.returncode < 0:
        name = signal.Signals(-run.returncode).name
        raise NoVerdict(f"the certified checker has ended with {name}: there is no verdict")
    try:
        answer = json.loads(run.stdout)
        if run.returncode == 0 and answer["verdict"] in VERDICTS:
            return answer
    except (ValueError, KeyError, TypeError):
        pass
    code = run.returncode
    raise NoVerdict(f"the certified checker has ended with code {code} and no verdict")


def limits(text: str, edges: int) -> str:
    """A limit as the certified checker takes it.

    Raises:
        allworlds.InputError: if it is no bound.
        ValueError: if it needs more of a world than n, m and d0.
    """
    if text in ("paper", "two-vertices") or text.isdigit():
        return text
    bound = bound_named(text)
    table = {}
    for m in range(1, edges + 1):
        for n in range(1, m + 2):
            for d0 in range(1, 2 * m + 1):
                value = bound.value(n, m, d0, 0, 0, 0)
                if value is None or not bound.variables <= {"n", "m", "d0"}:
                    message = (
                        f"--limit {text}: without a limit the question cannot be decided; legal "
                        "are paper, two-vertices and expressions in n, m and d0"
                    )
                    raise ValueError(message)
                table[f"{n} {m} {d0}"] = max(value, 0)
    return json.dumps(table)


# ---- A program ----


def judge_program(arguments: Sequence[str]) -> int:
    """The exit code: 0 holds, 1 refuted or no function, 2 bad arguments, 3 no verdict."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--exec", required=True, metavar="COMMAND")
    parser.add_argument("--edges", type=int, default=4)
    parser.add_argument("--limit", default="paper", help="paper, two-vertices, or an expression")
    parser.add_argument("--universe", choices=("all", "simple"), default="all")
    parser.add_argument(
        "--lighthouse", choices=("directional", "cluster", "natural"), default="directional"
    )
    parser.add_argument("--answer-timeout", type=float, default=10.0, metavar="SECONDS")
    options = parser.parse_args(arguments)
    command = shlex.split(options.exec)
    try:
        if not command:
            raise InputError("--exec '': a command expected")
        if options.edges < 1:
            raise InputError(f"--edges {options.edges}: at least 1")
        answer = asked(
            options.edges,
            ["--exec", *command],
            limit=limits(options.limit, options.edges),
            universe=options.universe,
            lighthouse=options.lighthouse,
            timeout=options.answer_timeout,
        )
    except (InputError, ValueError, NoVerdict) as error:
        if why := str(error):
            print(why, file=sys.stderr)
        return 3 if isinstance(error, NoVerdict) else 2
    tell(*told(answer, options.limit))
    return 0 if answer["verdict"] == "holds" else 1


def tell(*lines: str) -> None:
    """Print the lines; that their reader has gone (a pipe to head) is no fault."""
    try:
        print("\n".join(lines), flush=True)
    except BrokenPipeError:
        abandon_stdout()


def told(answer: dict[str, Any], limit: str) -> list[str]:
    """The answer in words."""
    match answer["verdict"]:
        case "holds":
            edges = plural(answer["edges"], "edge")
            right = f"right within {limit} in every world with at most {edges}"
            what = "a theorem about what the program has answered"
            lines = [
                f"HOLDS      {right}; {answer['runs']:,} runs",
                f"           {what} (check_correct, proofs/coq/Checker.v)",
            ]
        case "refuted":
            least = min(answer["refutations"], key=key_of)
            broken = f"{least['fault']}: {least['how']}" if "fault" in least else least["finding"]
            wrong = plural(len(answer["refutations"]), "world")
            count = f"{wrong} with {plural(answer['edges'], 'edge')}"
            where = f"start 0, place {least['place']}"
            runs = f"{answer['runs']:,} runs"
            lines = [
                f"REFUTED    {broken}; {count}, none with fewer; {runs}",
                f"smallest   sigma {least['sigma']} alpha {least['alpha']}, {where}",
            ]
        case _:
            lines = [
                "NO FUNCTION  the program has not always answered the same percepts alike",
                *(f"           {percept}" for percept in answer["history"]),
                f"before     {json.dumps(answer['before'])}",
                f"now        {json.dumps(answer['now'])}",
            ]
    if answer.get("open"):
        least = min(answer["open"], key=key_of)
        lines.append(
            f"open       {len(answer['open']):,} logs, folded, leave a dart open: there are other "
            f"worlds in which it is wrong; sigma {least['sigma']} alpha {least['alpha']}, "
            f"place {least['place']}"
        )
    return lines


def key_of(world: dict[str, Any]) -> Key:
    """Its place in the order of findings."""
    sigma, alpha = tuple(world["sigma"]), tuple(world["alpha"])
    return (_vertices(sigma), sigma, alpha, world["place"])


def _vertices(sigma: tuple[int, ...]) -> int:
    seen: set[int] = set()
    count = 0
    for dart in range(len(sigma)):
        count += dart not in seen
        at = dart
        while at not in seen:
            seen.add(at)
            at = sigma[at]
    return count


# ---- Compared with the package's ----


def outcome(*comparisons: Callable[[], bool]) -> int:
    """The exit code: 0 if all agree, 1 if one does not, else 3, for one could not be made."""
    agree, undecided = True, False
    for compare in comparisons:
        try:
            agree = compare() and agree
        except NoVerdict as error:
            undecided = True
            print(f"could not be decided: {error}")
        except Exception as error:  # noqa: BLE001  # whatever ends it, nothing has been compared
            undecided = True
            traceback.print_exc()
            print(f"could not be decided: {type(error).__name__}: {error}")
    code = 1 if not agree else 3 if undecided else 0
    print({0: "AGREE", 1: "DISAGREE", 3: "UNDECIDED"}[code])
    return code


def agreement(agree: bool, tried: bool, missing: str) -> bool:
    """Whether both agree.

    Raises:
        NoVerdict: if they do, and it says nothing, for what could differ was not tried.
    """
    if agree and not tried:
        raise NoVerdict(f"nothing differs, and that says nothing: {missing}")
    return agree


def finished(report: CheckReport) -> CheckReport:
    """The report of a check.

    Raises:
        NoVerdict: if the check has come to none.
    """
    if report.verdict in (Verdict.INCONCLUSIVE, Verdict.ERROR):
        raise NoVerdict(f"allworlds check {report.explorer}: {report.verdict}")
    for found in report.findings:
        if found.law in ("crash", "timeout") and found.machine:
            raise NoVerdict(f"{report.explorer}: {found.law}: {found.seen}")
    return report


def answered_by(program: Path, lines: Sequence[str], *arguments: str) -> list[str]:
    """The lines with which an extracted program answers each of these.

    Raises:
        NoVerdict: if it does not; the message says what came, and what it has said on stderr.
    """
    command = [str(program), *arguments]
    try:
        run = subprocess.run(
            command, input="".join(lines), capture_output=True, text=True, check=False, timeout=600
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise NoVerdict(f"{program.name}: {error}") from None
    answers = run.stdout.splitlines()
    if run.returncode or len(answers) != len(lines):
        what = f"{len(answers)} answers to {len(lines)} lines, exit code {run.returncode}"
        raise NoVerdict(f"{program.name}: {what}; {run.stderr.strip()}")
    return answers


def not_lost(name: str, ending: EpisodeEnding | Finding) -> None:
    """See that a run has not ended because a program is lost or silent.

    Raises:
        NoVerdict: if so: it has not answered otherwise, for it has not answered.
    """
    if isinstance(ending, Fault | Finding) and ending.law in ("crash", "timeout"):
        raise NoVerdict(f"{name}: {ending.law}: {ending.seen}")


@dataclass(frozen=True, slots=True)
class Outcome:
    """The verdict of a checker on an explorer.

    Attributes:
        verdict: ``holds``, ``refuted`` or ``no function``.
        edges: the size of the smallest world that refutes the explorer, if there is one.
        world: that world.
    """

    verdict: str
    edges: int | None = None
    world: Key | None = None


def certified_outcome(answer: dict[str, Any]) -> Outcome:
    """The certified checker's answer in short."""
    if answer["verdict"] != "refuted":
        return Outcome(answer["verdict"])
    return Outcome("refuted", answer["edges"], min(map(key_of, answer["refutations"])))


def package_outcome(mutant: WrongExplorer, edges: int) -> Outcome:
    """The outcome of ``allworlds check`` for a mutant, with the laws that both checkers decide."""
    findings = finished(check(mutant.explorer(), edges=edges, laws=LAWS).uninterrupted()).findings
    if not findings:
        return Outcome("holds")
    finding = findings[0]
    if finding.law == "nondeterministic":
        return Outcome("no function")
    map_ = finding.world.map
    sigma, alpha = rooted_code(map_.sigma, map_.alpha, finding.world.start)
    return Outcome(
        "refuted", map_.edge_count, (map_.vertex_count, tuple(sigma), tuple(alpha), finding.place)
    )


def served(name: str, policy: str = "fifo") -> list[str]:
    """The command that serves an explorer of the package."""
    return ["--exec", sys.executable, str(SERVER), name, policy]


def checkers_agree(edges: int) -> bool:
    """Whether both checkers say the same of Algorithm 1 and of every mutant."""
    agree = True
    for policy in POLICIES:
        for what, explorer in (
            ("the certified Algorithm 1", ["--policy", policy]),
            ("the package's", served("algorithm1", policy)),
        ):
            start = time.monotonic()
            answer = asked(edges, explorer)
            fine = answer["verdict"] == "holds" and answer["runs"] > 0 and answer["open"] == []
            agree = agree and fine
            print(
                f"certified checker, {what}, {policy}: {answer['verdict']}, "
                f"{answer['runs']:,} runs, {time.monotonic() - start:.0f} s"
            )
    verdicts: dict[str, int] = {}
    unsettled: list[str] = []  # each checker knows only what it has seen an explorer do
    for mutant in (*WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS):
        # One of them crashes, and says so on stderr.
        certified = certified_outcome(asked(edges, served(mutant.name), subprocess.DEVNULL))
        package = package_outcome(mutant, edges)
        verdicts[certified.verdict] = verdicts.get(certified.verdict, 0) + 1
        if certified != package:
            seen_by_one = {certified.verdict, package.verdict} == {"holds", "no function"}
            unsettled += [mutant.name] * seen_by_one
            agree = agree and seen_by_one
            print(f"  {mutant.name}: certified {certified}, allworlds check {package}")
    summary = ", ".join(f"{verdict} {count}" for verdict, count in sorted(verdicts.items()))
    same = agree and not unsettled
    print(f"certified checker, mutants: {summary}; the same from allworlds check: {_yes(same)}")
    if agree and unsettled:
        raise NoVerdict(f"only one has seen {', '.join(unsettled)} answer the same in two ways")
    return agreement(agree, set(verdicts) == set(VERDICTS), "one of the verdicts did not come up")


def _yes(agree: bool) -> str:
    return "yes" if agree else "NO"


if __name__ == "__main__":
    sys.exit(judge_program(sys.argv[1:]))
