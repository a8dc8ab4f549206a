"""Runs every SMT-LIB file of this folder with z3 and with cvc5, and the bound with sympy.

    python proofs/second-opinions/check.py [--solver z3] [--seconds 60] [NAME ...]

Each ``X.smt2`` says what answer it expects; ``X.model.smt2`` holds the same hypotheses, without
the negated conclusion, and defines every symbol of them over a finite domain: it must be sat.
Prints a table.  Exit code 0: all as expected; 1: a wrong answer, a statement that no solver
proves, or a vacuity guard that fails; 2: a solver is not installed; 3: all proved, but not by
both solvers.
"""

from __future__ import annotations

import argparse
import importlib.util
import re
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOLVERS = ("z3", "cvc5")
HOW_CVC5_ANSWERS = {"unsat": "enum-inst=true", "sat": "finite-model-find=true"}


@dataclass(frozen=True)
class Opinion:
    """The answer of a solver, and the seconds that it took.

    The answer is ``sat``, ``unsat``, ``unknown``, ``timeout``, or an error.
    """

    answer: str
    seconds: float


@dataclass(frozen=True)
class Row:
    """One statement: what each solver says of it, and why it might be vacuous ('' if not)."""

    name: str
    statement: str
    expected: str
    opinions: dict[str, Opinion]
    vacuous: str

    @property
    def proved_by(self) -> list[str]:
        """The solvers that give the expected answer."""
        return [s for s, opinion in self.opinions.items() if opinion.answer == self.expected]

    @property
    def wrong(self) -> bool:
        """Whether a solver contradicts it, or errs, or none proves it, or it may be vacuous."""
        open_ = {self.expected, "unknown", "timeout"}
        return (
            bool(self.vacuous)
            or not self.proved_by
            or any(opinion.answer not in open_ for opinion in self.opinions.values())
        )


def statements() -> list[str]:
    """The names of all statements of this folder."""
    return sorted(
        path.stem for path in HERE.glob("*.smt2") if not path.name.endswith(".model.smt2")
    )


def header(text: str) -> tuple[str, str]:
    """The statement in words, and the expected answer."""
    expected = re.search(r"^; Expected: (sat|unsat)$", text, re.MULTILINE)
    if not text.startswith("; ") or expected is None:
        raise ValueError("a file begins with its statement and says '; Expected: sat' or 'unsat'")
    return text.splitlines()[0].removeprefix("; "), expected[1]


def commands(text: str) -> Iterator[str]:
    """The commands of a script, without comments, one space between words."""
    depth, words = 0, []
    for token in re.findall(r"[()]|[^\s()]+", re.sub(r";.*", "", text)):
        depth += (token == "(") - (token == ")")
        words.append(token)
        if depth == 0:
            yield " ".join(words)
            words = []
    if words:
        raise ValueError("a parenthesis is not closed")


def assertions(text: str) -> list[str]:
    """The assertions of a script, in their order."""
    return [command for command in commands(text) if command.startswith("( assert ")]


def ask(solver: str, path: Path, expected: str, seconds: float) -> Opinion:
    """The answer of a solver, from a process that is killed when its time is over."""
    line = [sys.executable, str(HERE / "solve.py"), solver, str(path)]
    start = time.perf_counter()
    try:
        done = subprocess.run(
            [*line, HOW_CVC5_ANSWERS[expected]],
            capture_output=True,
            text=True,
            timeout=seconds,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Opinion("timeout", seconds)
    said = done.stdout if done.returncode == 0 else f"error: {done.stderr}"
    return Opinion(" ".join(said.split()) or "silent", time.perf_counter() - start)


def why_vacuous(name: str, text: str, solvers: Sequence[str], seconds: float) -> str:
    """'' if the model of the hypotheses is one, for every solver; otherwise what is amiss."""
    path = HERE / f"{name}.model.smt2"
    if not path.exists():
        return "no model"
    model = path.read_text(encoding="ascii")
    hypotheses = assertions(text)
    if header(text)[1] == "unsat":
        hypotheses.pop()
    if assertions(model) != hypotheses:
        return "the model has other hypotheses"
    if re.search(r"\(declare-(sort|fun|const)\b", model):
        return "the model leaves a symbol open"
    for solver in solvers:
        answer = ask(solver, path, "sat", seconds).answer
        if answer != "sat":
            return f"{solver} says of the model: {answer}"
    return ""


def judge(name: str, solvers: Sequence[str], seconds: float) -> Row:
    """One statement, put to the solvers, and its model with it."""
    path = HERE / f"{name}.smt2"
    text = path.read_text(encoding="ascii")
    statement, expected = header(text)
    opinions = {solver: ask(solver, path, expected, seconds) for solver in solvers}
    vacuous = why_vacuous(name, text, solvers, seconds)
    return Row(name, statement, expected, opinions, vacuous)


def table(rows: Sequence[Row], solvers: Sequence[str]) -> Iterator[str]:
    """The lines of the report, one for each statement."""
    for row in rows:
        said = "  ".join(
            f"{solver} {row.opinions[solver].answer:<7} {row.opinions[solver].seconds:5.2f} s"
            for solver in solvers
        )
        guard = row.vacuous or "not vacuous"
        yield f"{row.name:<24} {said}  {guard:<12} {row.statement}"


def exit_code(rows: Sequence[Row], solvers: Sequence[str]) -> int:
    """0, 1 or 3, as the module says."""
    if any(row.wrong for row in rows):
        return 1
    return 3 if any(len(row.proved_by) < len(solvers) for row in rows) else 0


def main(arguments: Sequence[str] | None = None) -> int:
    """Print the table and return the exit code."""
    parser = argparse.ArgumentParser(description="Second opinions on the proofs.")
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="statements; all, if none is named"
    )
    parser.add_argument("--solver", action="append", choices=SOLVERS, help="both, if none is named")
    parser.add_argument("--seconds", type=float, default=60.0, help="time for one answer")
    options = parser.parse_args(arguments)
    solvers = options.solver or list(SOLVERS)
    missing = [s for s in [*solvers, "sympy"] if importlib.util.find_spec(s) is None]
    if missing:
        print(f"not installed: {', '.join(missing)} (pip install '.[proofs]')")
        return 2
    import bound

    names = options.names or statements()
    with ThreadPoolExecutor(max_workers=4) as pool:
        rows = list(pool.map(lambda name: judge(name, solvers, options.seconds), names))
    for line in table(rows, solvers):
        print(line)
    by_one = [f"{row.name} ({row.proved_by[0]} only)" for row in rows if len(row.proved_by) == 1]
    if len(solvers) > 1 and by_one:
        print("proved by one solver: " + ", ".join(by_one))
    difference = bound.difference()
    print(f"sympy: (1) + (2) minus the polynomial is {difference}")
    code = 1 if difference != 0 else exit_code(rows, solvers)
    proved = sum(not row.wrong for row in rows)
    print(f"{proved} of {len(rows)} statements as expected, by {' and '.join(solvers)}")
    return code


if __name__ == "__main__":
    sys.exit(main())
