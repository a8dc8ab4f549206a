"""Certificates: what a program does in all worlds to a bound, as a file that Coq's kernel checks.

    python proofs/coq/certified.py --certificate FILE.v (EXPLORER | --exec 'COMMAND') [--edges 4]
                               [--limit paper] [--universe all]

runs the explorer in every world with at most so many edges under a directional lighthouse, and
writes to FILE.v the decision tree of what it has done, and a theorem about every explorer that
answers as the tree does (``proofs/coq/DecisionTrees.v``).  Nothing is judged here: ``coqc``
computes whether the theorem holds, and the worlds are those that Coq enumerates.  A world that is
left out here, a run without an answer, a wrong answer: each makes ``coqc`` refuse the file.
EXPLORER is a name that ``allworlds check`` takes: a built-in one, MODULE:FUNCTION,
FILE.py:FUNCTION, native:LIBRARY.  The file is the same, byte by byte, whenever the explorer does
the same.

    python proofs/coq/certified.py --check FILE.v (EXPLORER | --exec 'COMMAND') [--edges 4] ...

has ``coqc`` judge FILE.v as the certificate of this explorer.  What ``coqc`` accepts is the theorem
that stands in the file, whatever it says: so first it is compared, byte by byte, with what is
written now.

Exit code 0: written, or accepted; 1: a run without an answer, no function of the percepts, another
file than is claimed, or one that coqc refuses; 2: bad arguments, or no Coq; 3: undecided, for
processes are lost again and again, or coqc has come to no verdict.

    python proofs/coq/certified_trees.py [--edges 3] [--all | WRONG ...]

has ``coqc`` accept the certificate of Algorithm 1, and those of wrong explorers exactly where
``allworlds check`` finds nothing wrong.  It needs what ``make -C proofs/coq`` builds.  Exit code 1:
coqc says otherwise; 2: bad arguments, or no Coq; 3: undecided.
"""

from __future__ import annotations

import argparse
import re
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.engines.limits import Limits
from allworlds.engines.players import Unsettled
from allworlds.engines.single import subject_of
from allworlds.explorers.loading import Subject, built_in, in_process_subject
from allworlds.inputs.checks import InputError
from allworlds.judging.episode import Answered, Fault, ending_of, fault_of
from allworlds.judging.laws.bounds import bound_named, default_step_budget, paper_bound
from allworlds.log import Log
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.words import plural
from allworlds.world import worlds
from certificate_file import (
    COQ,
    LARGEST,
    Branches,
    Leaf,
    Node,
    Nothing,
    NoVerdict,
    Sensed,
    asked_of_coq,
    is_built,
    judged,
    percept_in_words,
    ways,
    written,
)
from certified_checker import agreement, outcome, package_outcome, tell
from certified_runs import NoAnswer, episodes, logs_along

OF_THE_PACKAGE = {"holds": "accepted", "refuted": "refused", "no function": "no function"}
"""What coqc says where ``allworlds check`` says this."""
WRONG = ("mirror-image", "pose-lost", "walks-too-much", "wrong-in-one-world")


class NoFunction(Exception):
    """The program has not always answered the same percepts alike; the message says where."""


# ---- What a program does ----


def sensed(percept: Percept) -> Sensed:
    """A percept under a directional lighthouse; there is one mark exactly where a bearing is."""
    assert percept.marks == (percept.bearing is not None)
    return percept.degree, -1 if percept.bearing is None else percept.bearing


def tree_of(
    subject: Subject, edges: int, map_class: str = "maps", limits: Limits | None = None
) -> tuple[Branches, int, Counter[str]]:
    """The decision tree of an explorer, the number of runs, and the laws of those without answer.

    Raises:
        NoFunction: if it does something else after the same percepts.
        NoAnswer: at the first run that is silent, or has cost its process.
    """
    tree: Branches = {}
    runs, unanswered = 0, Counter[str]()
    # the same for all worlds: where a run is cut off depends on its percepts alone
    budget = default_step_budget(max(paper_bound(n, edges) for n in range(1, edges + 2)))
    every = worlds(edges=edges, map_class=map_class, places="all")
    for episode in episodes(subject, every, budget, limits or Limits()):
        runs += 1
        at, seen = tree, [sensed(episode.transcript.first)]
        for action, percept in episode.transcript.steps:
            assert isinstance(action, Move)  # there is nothing to be dropped
            branch = at.setdefault(seen[-1], Node(action.k))
            if not isinstance(branch, Node) or branch.k != action.k:
                raise NoFunction(apart(seen, branch, Node(action.k)))
            at = branch.after
            seen.append(sensed(percept))
        match episode.ending:
            case Answered(Estimate() as e):
                last: Leaf | Nothing = Leaf(tuple(e.map.sigma), tuple(e.map.alpha), e.here)
            case Fault(law=law):
                last = Nothing(law)
            case _:
                last = Nothing("no-estimate")
        if isinstance(last, Nothing):
            unanswered[last.law] += 1
        if at.setdefault(seen[-1], last) != last:
            raise NoFunction(apart(seen, at[seen[-1]], last))
    return tree, runs, unanswered


def apart(seen: Sequence[Sensed], before: object, now: object) -> str:
    """Two things done after the same percepts, in words."""

    def words(done: object) -> str:
        return f"motion {done.k}" if isinstance(done, Node) else str(done)

    percepts = " ".join(percept_in_words(o) for o in seen)
    return f"after {percepts}: {words(before)}, and another time: {words(now)}"


def walks(tree: Branches) -> Iterator[int]:
    """The number of motions before each answer."""
    todo = [(tree, 0)]
    while todo:
        branches, motions = todo.pop()
        for branch in branches.values():
            if isinstance(branch, Node):
                todo.append((branch.after, motions + 1))
            elif isinstance(branch, Leaf):
                yield motions


def size_of(tree: Branches) -> int:
    """The number of its motions and answers."""
    count, todo = 0, [tree]
    while todo:
        for branch in todo.pop().values():
            count += not isinstance(branch, Nothing)
            if isinstance(branch, Node):
                todo.append(branch.after)
    return count


# ---- The file ----


def certificate(
    tree: Branches, edges: int, who: str, limit: str = "paper", universe: str = "all"
) -> str:
    """The text of the file.

    Raises:
        InputError: if the limit is no bound, or needs more of a world than n, m and d0.
    """
    in_coq = None if limit == "paper" else limit_in_coq(limit, edges, tree)
    return written(tree, edges, who, universe, in_coq)


def limit_in_coq(text: str, edges: int, tree: Branches) -> str:
    """A limit as Coq has it: a function of n, m and d0."""
    bound = bound_named(text)
    if text == "none":  # the tree is finite: no walk is longer than its longest
        return f"fun _ _ _ : nat => {max(walks(tree), default=0)}"
    rows = []
    for m in range(1, edges + 1):
        for n in range(1, m + 2):
            for d0 in range(1, 2 * m + 1):
                value = bound.value(n, m, d0, 0, 0, 0)
                if value is None or not bound.variables <= {"n", "m", "d0"}:
                    raise InputError(f"limit {text}: an expression in n, m and d0 expected")
                if value > LARGEST:
                    raise InputError(f"limit {text}: {value} for n = {n}, m = {m} is too large")
                rows.append(f"({n}, {m}, {d0}, {max(value, 0)})")
    return f"limit_from [:: {'; '.join(rows)}]"


# ---- Along a tree ----


def apart_from(name: str, tree: Branches, edges: int, answer_timeout: float) -> str:
    """Where an explorer does something else than the tree says, in words; '' if nowhere.

    Raises:
        InputError: if there is no such explorer.
        NoVerdict: if its processes are lost again and again.
    """
    limits = Limits(answer_timeout=answer_timeout)
    subject = subject_of(name, limits)
    every = list(ways(tree))
    percepts = ([percept_of(o) for o in seen] for seen, _, _ in every)
    budget = default_step_budget(max(map(len, (motions for _, motions, _ in every)), default=0))
    try:
        for (seen, motions, due), log in zip(
            every, logs_along(subject, percepts, edges, budget, limits), strict=True
        ):
            fault = fault_of(log, budget)
            if fault and fault.machine:
                raise NoVerdict(f"{name} ends with {fault.law}: {fault.seen}")
            ends = f"ends with {fault.law}: {fault.seen}" if fault else f"answers {_answer_of(log)}"
            done = [*log.actions] if due is not None else [*log.actions][: len(motions)]
            if done != motions:
                pairs = zip(done, motions, strict=False)
                at = next((i for i, (k, other) in enumerate(pairs) if k != other), None)
                at = min(len(done), len(motions)) if at is None else at
                does = f"makes motion {done[at]}" if at < len(done) else ends
                has = f"motion {motions[at]}" if at < len(motions) else due
                return f"{_after(seen[: at + 1])} {has}; {name} {does}"
            if due is not None and due != _answer_of(log):
                return f"{_after(seen)} {due}; {name} {ends}"
    except (NoAnswer, Unsettled) as error:
        raise NoVerdict(f"{name}: {error}") from None
    return ""


def percept_of(sensed_: Sensed) -> Percept:
    """The percept that is written so."""
    degree, bearing = sensed_
    return Percept(degree, int(bearing >= 0), bearing if bearing >= 0 else None)


def _answer_of(log: Log) -> Leaf | None:
    match ending_of(log):
        case Answered(Estimate() as e):
            return Leaf(tuple(e.map.sigma), tuple(e.map.alpha), e.here)
    return None


def _after(seen: Sequence[Sensed]) -> str:
    return f"after {' '.join(map(percept_in_words, seen))} it has"


# ---- Programs ----


def write_certificate(arguments: Sequence[str]) -> int:
    """The exit code: see the head of this file."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    of_file = parser.add_mutually_exclusive_group(required=True)
    of_file.add_argument("--certificate", type=Path, metavar="FILE.v", help="to be written")
    of_file.add_argument("--check", type=Path, metavar="FILE.v", help="to be judged by coqc")
    parser.add_argument("explorer", nargs="?", help="a name that allworlds check takes")
    parser.add_argument("--exec", metavar="COMMAND")
    parser.add_argument("--edges", type=int, default=4)
    parser.add_argument("--limit", default="paper", help="a bound in n, m and d0, or none")
    parser.add_argument("--universe", choices=("all", "simple"), default="all")
    parser.add_argument("--answer-timeout", type=float, default=10.0, metavar="SECONDS")
    parser.add_argument("--memory", type=int, metavar="MB", help="of the explorer's process")
    options = parser.parse_args(arguments)
    file: Path = options.check or options.certificate
    try:
        if (options.explorer is None) == (options.exec is None):
            raise InputError("one explorer expected: a name, or --exec 'COMMAND'")
        if options.edges < 1:
            raise InputError(f"--edges {options.edges}: at least 1")
        if not re.fullmatch(r"[A-Za-z]\w*\.v", file.name, re.ASCII):
            raise InputError(f"{file}: a name of letters, digits and _ expected, and .v")
        name = options.explorer if options.exec is None else f"exec:{options.exec}"
        limits = Limits(answer_timeout=options.answer_timeout, memory=options.memory)
        map_class = "simple" if options.universe == "simple" else "maps"
        subject = subject_of(name, limits)
        tree, runs, unanswered = tree_of(subject, options.edges, map_class, limits)
        text = certificate(tree, options.edges, name, options.limit, options.universe)
        if options.check:
            return judged(file, file.read_bytes(), text)
        file.write_text(text, encoding="ascii", errors="replace")
    except (NoFunction, NoAnswer) as error:
        word = "NO FUNCTION" if isinstance(error, NoFunction) else "NO ANSWER"
        tell(f"{word}  {error}; no file is written")
        return 1
    except (InputError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    except Unsettled as error:
        print(error, file=sys.stderr)
        return 3
    lines = [f"{file}: {runs:,} runs, {size_of(tree):,} motions and answers, {len(text):,} bytes"]
    for law, count in sorted(unanswered.items()):
        lines.append(f"NO ANSWER  {law} in {plural(count, 'run')}: coqc will refuse the file")
    here = Path.cwd()
    where = COQ.relative_to(here) if COQ.is_relative_to(here) else COQ
    tell(*lines, f"to check it: coqc -Q {where} Allworlds {file}")
    return 1 if unanswered else 0


def verdict_of(subject: Subject, name: str, edges: int, folder: Path) -> str:
    """The verdict of coqc on an explorer's certificate; ``no function`` if there is none."""
    try:
        tree = tree_of(subject, edges)[0]
    except NoFunction:
        return "no function"
    file = folder / "certificate.v"
    file.write_text(certificate(tree, edges, name), encoding="ascii")
    return asked_of_coq(file)


def certificates_agree(edges: int, names: Sequence[str]) -> bool:
    """Whether coqc accepts the certificate of Algorithm 1, and that of a mutant if it holds."""
    known = {mutant.name: mutant for mutant in WRONG_EXPLORERS}
    said: dict[str, int] = {}
    agree = True
    with tempfile.TemporaryDirectory() as folder:
        for name in ("algorithm1", *names):
            start = time.monotonic()
            mutant = known.get(name)
            subject = in_process_subject(mutant.explorer()) if mutant else built_in(name)
            certified = verdict_of(subject, name, edges, Path(folder))
            package = package_outcome(mutant, edges).verdict if mutant else "holds"
            agree = agree and certified == OF_THE_PACKAGE[package]
            said[certified] = said.get(certified, 0) + 1
            print(
                f"certificate of {name}, at most {edges} edges: {certified} by coqc, "
                f"allworlds check {package}, {time.monotonic() - start:.0f} s"
            )
    print(f"certificates: {said}; the same from allworlds check: {'yes' if agree else 'NO'}")
    tried = {"accepted", "refused"} <= set(said)
    return agreement(agree, tried, "nothing was accepted, or nothing refused")


def main() -> int:
    """Compare."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--edges", type=int, default=3)
    parser.add_argument("wrong", nargs="*", default=WRONG, metavar="WRONG")
    parser.add_argument("--all", action="store_true", help="of every wrong explorer")
    options = parser.parse_args()
    if unknown := set(options.wrong) - {mutant.name for mutant in WRONG_EXPLORERS}:
        parser.error(f"no wrong explorer is called {', '.join(sorted(unknown))}")
    if not is_built():
        return 2
    names = [mutant.name for mutant in WRONG_EXPLORERS] if options.all else options.wrong
    return outcome(partial(certificates_agree, options.edges, names))


if __name__ == "__main__":
    sys.exit(main())
