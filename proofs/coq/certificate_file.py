"""The file of a certificate: written from a tree, read, and checked with Coq; without the package.

    python proofs/coq/certified.py --verify FILE.v EXPLORER [--edges 4] [--limit paper]
                               [--universe all] [--against EXPLORER]

says whether FILE.v is a certificate of what is claimed of it: that what EXPLORER, a text that is
not run, does is right in every world with at most so many edges.  Of the file the tree alone is
read.  The rest, head, statement and end, is written anew from the claim, and compared byte by byte;
so the tree is all that can be another one.  ``coqc`` then gets the text that has been written
here, and what it prints must be that the theorem rests on no axiom.

``--against EXPLORER`` also has this explorer, any that ``allworlds check`` takes
(``exec:COMMAND`` for a program), sense the percepts of each way through the tree: it must make the
motions and give the answer that stand there.  This, and a limit that is not ``paper``, need the
package; all else needs Python, Coq, and ``make -C proofs/coq DecisionTrees.vo``.

Exit code 0: accepted; 1: the file is not what is claimed (DIFFERS), or coqc has computed that the
tree is not right (REFUSED); 2: bad arguments, or no Coq; 3: it could not be decided (UNDECIDED).
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import zip_longest
from pathlib import Path
from typing import Literal, TypeAlias

COQ = Path(__file__).resolve().parent
LARGEST = 5000
"""Coq writes a number n as n signs, and its parser warns of larger ones."""
REFUSAL = 'Unable to unify "true" with "false"'
"""What coqc says where it has computed that a tree is not right."""
ACCEPTANCE = "Closed under the global context\n"
"""All that coqc prints of a file that it accepts."""
PROMISES = {"all": "every world", "simple": "every simple world"}

Sensed: TypeAlias = tuple[int, int]
"""A percept: the degree and the bearing, -1 for none, so that percepts have an order."""


class NoVerdict(Exception):
    """A program has come to none; the message says why."""


class NoTree(ValueError):
    """Raised where a text has no tree; the message says where."""


@dataclass(frozen=True, slots=True)
class Leaf:
    """An answer: a rooted map."""

    sigma: tuple[int, ...]
    alpha: tuple[int, ...]
    here: int


@dataclass(slots=True)
class Node:
    """A motion, and what is done after each percept that may follow."""

    k: int
    after: Branches = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Nothing:
    """Neither a motion nor an answer: the law that the run has broken."""

    law: str


Branches: TypeAlias = "dict[Sensed, Leaf | Node | Nothing]"


# ---- The file ----

# It is compared byte by byte, also with files that others hold: so its words must stay.
HEAD = """(* A certificate (proofs/coq/DecisionTrees.v): what {who} does
   in every world with at most {edges} edges.  Written by proofs/certified.py; coqc checks it.
   If it cannot unify true with false, it has computed that in some of these worlds the explorer
   gives no answer, or a wrong one, or makes more motions than the limit. *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model DecisionTrees.

"""

BEGIN = "Definition tree : branches :=\n"

TAIL = """.

{definition}Lemma computed : certified tree {name} {universe} {edges} = true.
Proof. vm_compute. reflexivity. Qed.

Theorem right_in_every_world :
  forall X : explorer percept numbered_map, answers_as X tree ->
  forall W : lighthouse_world, {promise}edges W <= {edges} ->
  exists transcript answer z,
  [/\\ episode X (rooted start) (@percept_of W) ({limit})
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. exact: ({lemma} computed). Qed.
Print Assumptions right_in_every_world.
"""


def written(
    tree: Branches, edges: int, who: str, universe: str = "all", limit: str | None = None
) -> str:
    """The text of the file; the limit as a function in Coq, None for that of the paper."""
    simple = universe == "simple"
    lemma = "certified_paper" if limit is None else "certified_limit"
    # a comment is read for its end, and for quotation marks
    head = HEAD.format(who=re.sub(r"[^A-Za-z0-9 ./:=_-]", "_", who), edges=edges)
    tail = TAIL.format(
        definition="" if limit is None else f"Definition limit := {limit}.\n",
        name="paper" if limit is None else "limit",
        universe="SimpleWorlds" if simple else "AllWorlds",
        edges=edges,
        promise="simple_world W -> " if simple else "",
        limit="paper_bound (vertices W) (edges W)"
        if limit is None
        else "limit (vertices W) (edges W) (degree (@start W))",
        lemma=f"{lemma}_simple" if simple else lemma,
    )
    return head + BEGIN + "".join(_lines(tree)) + tail


def _lines(tree: Branches) -> Iterator[str]:
    """A line for each motion and each answer; branches in the order of their percepts."""
    open_, separators = [_in_order(tree)], ["[::"]
    while open_:
        percept, branch = next(open_[-1], (None, None))
        if percept is None:
            open_.pop()
            yield ("[::]" if separators.pop() == "[::" else "]") + (")" if open_ else "")
            continue
        yield f"{separators[-1]}\n{' ' * (len(open_) - 1)}({percept_in_words(percept)}, "
        separators[-1] = ";"
        if isinstance(branch, Node):
            yield f"Node {branch.k} "
            open_.append(_in_order(branch.after))
            separators.append("[::")
        elif isinstance(branch, Leaf):
            numbers = f"{_numbers(branch.sigma)} {_numbers(branch.alpha)} {branch.here}"
            yield f"Leaf (NumberedMap {numbers}))"


def _in_order(branches: Branches) -> Iterator[tuple[Sensed | None, Leaf | Node | Nothing | None]]:
    for percept, branch in sorted(branches.items(), key=lambda item: item[0]):
        if not isinstance(branch, Nothing):
            yield percept, branch


def percept_in_words(percept: Sensed) -> str:
    """A percept as Coq has it."""
    degree, bearing = percept
    return f"({degree}, {'None' if bearing < 0 else f'Some {bearing}'})"


def _numbers(numbers: Sequence[int]) -> str:
    return f"[:: {'; '.join(map(str, numbers))}]" if numbers else "[::]"


NUMBERS = r"\[::((?: [0-9]+(?:; [0-9]+)*)?)\]"
BRANCH = re.compile(
    r";?\n *\(\(([0-9]+), (?:None|Some ([0-9]+))\), "
    rf"(?:Node ([0-9]+) \[::|Leaf \(NumberedMap {NUMBERS} {NUMBERS} ([0-9]+)\)\))"
)


def tree_in(text: str) -> Branches:
    """The tree of a file, whatever else stands there: who writes it anew sees what differs.

    Raises:
        NoTree: if there is none.
        NoVerdict: if a number is too large for Coq.
    """
    at = text.find(BEGIN + "[::")
    if at < 0:
        raise NoTree(f"there is no line {BEGIN.strip()!r} with a tree behind it")
    at += len(BEGIN + "[::")
    tree: Branches = {}
    open_ = [tree]
    while open_:
        if text.startswith("]", at):
            open_.pop()
            at += 1 + bool(open_)  # and the bracket around a motion
            continue
        found = BRANCH.match(text, at)
        if found is None:
            raise NoTree(f"line {text.count(chr(10), 0, at) + 2}: no branch of a tree")
        degree, bearing, k, sigma, alpha, here = found.groups()
        percept = _small(degree), -1 if bearing is None else _small(bearing)
        if k is None:
            darts = (tuple(map(_small, re.findall("[0-9]+", each))) for each in (sigma, alpha))
            open_[-1][percept] = Leaf(*darts, _small(here))
        else:
            node = Node(_small(k))
            open_[-1][percept] = node
            open_.append(node.after)
        at = found.end()
    return tree


def _small(digits: str) -> int:
    if len(digits) > 4 or int(digits) > LARGEST:
        raise NoVerdict(f"{digits[:20]} is too large a number for Coq, which writes n as n signs")
    return int(digits)


def ways(tree: Branches) -> Iterator[tuple[list[Sensed], list[int], Leaf | Nothing | None]]:
    """Every way through the tree: its percepts, its motions, and the answer, None for no branch."""
    todo: list[tuple[list[Sensed], list[int], Branches]] = [([], [], tree)]
    while todo:
        seen, motions, branches = todo.pop()
        if not branches and seen:
            yield seen, motions, None
        for percept, branch in branches.items():
            now = [*seen, percept]
            if isinstance(branch, Node):
                todo.append((now, [*motions, branch.k], branch.after))
            else:
                yield now, motions, branch


# ---- Coq ----


def is_built() -> bool:
    """Whether there is Coq, and the theorems are compiled; if not, stderr says so."""
    there = shutil.which("coqc") is not None and (COQ / "DecisionTrees.vo").exists()
    if not there:
        print("not built: make -C proofs/coq DecisionTrees.vo", file=sys.stderr)
    return there


def asked_of_coq(file: Path) -> Literal["accepted", "refused"]:
    """Whether coqc accepts a certificate, or has computed that its tree is not right.

    Raises:
        NoVerdict: if it refuses the file for another reason, or finds an assumption.
    """
    command = ["coqc", "-q", "-Q", str(COQ), "Allworlds", str(file)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode == 0 and run.stdout == ACCEPTANCE:
        return "accepted"
    if run.returncode == 1 and REFUSAL in run.stderr:
        return "refused"
    raise NoVerdict(f"coqc {file}: {run.returncode} {run.stdout}{run.stderr}")


def difference(found: bytes, claimed: bytes) -> str:
    """The first line in which a file is not what is claimed, in words; '' if they are equal."""
    lines = zip_longest(found.split(b"\n"), claimed.split(b"\n"))
    for number, (said, due) in enumerate(lines, 1):
        if said != due:
            return f", line {number}: {_shown(said)}; claimed is {_shown(due)}"
    return ""


def _shown(line: bytes | None) -> str:
    """A line as it is told; None: there is none, not even an empty one behind a newline."""
    return "no line" if line is None else repr(line[:100].decode("ascii", "backslashreplace"))


def judged(file: Path, found: bytes, claimed: str, against: str = "") -> int:
    """The exit code: whether coqc accepts a certificate, if the file is the one that is claimed.

    Args:
        file: its name.
        found: all that stands in it.
        claimed: all that should.
        against: in words, where an explorer does something else than its tree says.
    """
    data = claimed.encode("ascii", "replace")
    others = [other for other in (difference(found, data), against) if other]
    for other in others:
        print(f"DIFFERS    {file}{other}")
    if others:
        return 1
    if not is_built():
        return 2
    try:
        with tempfile.TemporaryDirectory() as folder:  # coqc gets what has been compared
            copy = Path(folder) / "certificate.v"
            copy.write_bytes(data)
            said = asked_of_coq(copy)
    except NoVerdict as error:
        print(f"UNDECIDED  {error}")
        return 3
    print(f"{said.upper():10} {file}, by coqc")
    return 0 if said == "accepted" else 1


# ---- A stranger ----


def verify(arguments: Sequence[str]) -> int:
    """The exit code: see the head of this file."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--verify", type=Path, required=True, metavar="FILE.v")
    parser.add_argument("explorer", nargs="?", help="whose certificate it is; is not run")
    parser.add_argument("--exec", metavar="COMMAND", help="or a program; is not run")
    parser.add_argument("--edges", type=int, default=4)
    parser.add_argument("--limit", default="paper")
    parser.add_argument("--universe", choices=tuple(PROMISES), default="all")
    parser.add_argument("--against", metavar="EXPLORER", help="is played along the tree")
    parser.add_argument("--answer-timeout", type=float, default=10.0, metavar="SECONDS")
    options = parser.parse_args(arguments)
    if (options.explorer is None) == (options.exec is None):
        parser.error("whose certificate? one name expected, or --exec 'COMMAND'")
    if options.edges < 1:
        parser.error(f"--edges {options.edges}: at least 1")
    file: Path = options.verify
    who = options.explorer if options.exec is None else f"exec:{options.exec}"
    try:
        found = file.read_bytes()
        tree = tree_in(found.decode("ascii", "replace"))
        if not tree:
            raise NoTree("the tree is empty: it says nothing of any explorer")
        limit, against = None, ""
        if options.limit != "paper" or options.against is not None:
            import certified_trees  # needs the package

            if options.limit != "paper":
                limit = certified_trees.limit_in_coq(options.limit, options.edges, tree)
            if options.against is not None:  # whatever else the file says: its tree is played
                against = certified_trees.apart_from(
                    options.against, tree, options.edges, options.answer_timeout
                )
        claimed = written(tree, options.edges, who, options.universe, limit)
        code = judged(file, found, claimed, against and f": {against}")
    except NoTree as error:
        print(f"DIFFERS    {file}: {error}")
        return 1
    except NoVerdict as error:
        print(f"UNDECIDED  {file}: {error}")
        return 3
    except ModuleNotFoundError as error:
        print(f"{error}: --against and --limit need the package", file=sys.stderr)
        return 2
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    if code == 0:
        played = f"; {options.against} does what the tree says" if options.against else ""
        where = f"{PROMISES[options.universe]} with at most {options.edges} edges"
        print(
            f"           who answers as its tree is right within {options.limit} in {where}{played}"
        )
    return code
