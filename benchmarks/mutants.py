"""Random mutants of the source, and how many of them the quick tests kill.

    python benchmarks/mutants.py --number 200 --seed 1 [--wing judging ...] [--workers 2]
        [--in DIR] [--out FILE]
    python benchmarks/mutants.py --number 40 --seed 1 --wing reports/content
    python benchmarks/mutants.py --kernel --number 30 --seed 1 [--out FILE]

A mutant is one small change of one line: another comparison, operator or constant, a bound or a
statement less, None for a result.  Texts, annotations, declarations of classes, assertions (as
strict=True) and what numba compiles stay as they are.  Lines are drawn uniformly, then one change
of each; the same seed on the same source draws the same mutants.

All happens in a copy of the project, which holds all mutants at once, each behind the question
whether it is active.  The quick tests run once without any, and tell which tests meet the place of
which mutant, in whichever process.  Then each mutant becomes active in a fork after the collection
of the tests, and tests run that meet it: those of the module's own file first, then one of each
kind, the quickest first, until one fails.  A mutant that makes them take several times as long is
killed, too, by the deadline, if they end in time without it.  What is met before the first test, as
a default, is tried in a new process, with the tests of the own file and of those that name its
module, or what is changed.  What no test meets survives.

With --kernel the mutants are of what numba compiles of the two engines of Algorithm 1, which Python
runs without numba (``tests/support/mutants/interpreted.py``): a mutant is killed if it answers
otherwise than the compiled engines, first about worlds with at most 4 edges, as the quick tests and
each check ask, then about the units of ``certified.py --sample``, under each policy.

Exit code 1: a mutant survives that is not in the list of the equivalent ones.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import tomllib
import venv
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import accumulate, chain
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
SOURCE = "src/allworlds"
EQUIVALENT = Path(__file__).with_name("equivalent_mutants.toml")

OTHER: dict[type[Any], type[Any]] = {
    ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
    ast.In: ast.NotIn, ast.NotIn: ast.In, ast.And: ast.Or, ast.Or: ast.And,
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt,
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.FloorDiv, ast.FloorDiv: ast.Mult,
    ast.Div: ast.Mult, ast.Mod: ast.FloorDiv, ast.Pow: ast.Mult, ast.MatMult: ast.Mult,
    ast.LShift: ast.RShift, ast.RShift: ast.LShift,
    ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.BitXor: ast.BitAnd,
}  # fmt: skip
"""The operator that stands in a mutant in the place of another."""


@dataclass
class Mutant:
    """One change of one line, and what became of it.

    Attributes:
        file: its path in the project.
        line: the first line of what is changed.
        start, end: what is changed, in bytes of the file; nothing, if a statement is left out.
        before, after: the text, and what stands there instead.
        name: of the function, or of what gets a value, where it is met before any test.
        tests: those that meet it.
        tried: how many tests were run with it.
        text: the line that ``line`` is the number of.
        within: the function or class in which it is, with those around it; empty: in none.
        nth: of equal changes of equal lines there, from 1 on.
        killed_by: a test or the deadline; empty: it survives.
    """

    file: str
    line: int
    start: int
    end: int
    before: str
    after: str
    name: str
    early: bool
    text: str
    within: str = ""
    nth: int = 1
    tests: set[str] = field(default_factory=set)
    tried: int = 0
    killed_by: str = ""

    def is_in(self, place: str) -> bool:
        """Whether it is in a wing, or in a folder or a module of the package."""
        return place == self.wing or Path(self.file).is_relative_to(f"{SOURCE}/{place}")

    def among(self, known: Sequence[dict[str, Any]]) -> bool:
        """Whether the list of equivalent mutants has it, with its line where others are none."""
        own = {**vars(self), "line": self.text}
        return any(all(own.get(key, each[key]) == each[key] for key in each) for each in known)

    @property
    def wing(self) -> str:
        """The folder of the package, or ``ground`` for the modules beside the folders."""
        inner = Path(self.file).relative_to(SOURCE).parts
        return inner[0] if len(inner) > 1 else "ground"


def changed(node: ast.AST) -> Iterator[tuple[Any, str]]:
    """Yield the parts of a node that a mutant changes, each with what stands there instead."""
    match node:
        case ast.Compare(left=left, ops=ops, comparators=comparators):
            for place, op in enumerate(ops):
                others = [*ops[:place], OTHER[type(op)](), *ops[place + 1 :]]
                yield node, ast.unparse(ast.Compare(left, others, comparators))
        case ast.BoolOp(op=op, values=values):
            yield node, ast.unparse(ast.BoolOp(OTHER[type(op)](), values))
        case ast.BinOp(left, op, right) if not any(map(_is_text, (left, right))):
            yield node, ast.unparse(ast.BinOp(left, OTHER[type(op)](), right))
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            yield node, ast.unparse(operand)
        case ast.Constant(value=bool(value)):
            yield node, str(not value)
        case ast.Constant(value=int(value)):
            yield from ((node, str(value + 1)), (node, str(value - 1)))
        case ast.Slice(lower=lower, upper=upper):
            yield from ((bound, "None") for bound in (lower, upper) if bound)
        case ast.Return(value=ast.expr() as value) if ast.unparse(value) not in ("None", "False"):
            yield value, "None"
        case (
            ast.Expr(value=ast.Call())
            | ast.Assign(targets=[ast.Attribute() | ast.Subscript()])
            | ast.AugAssign()
            | ast.Raise()
            | ast.Continue()
            | ast.Break()
        ):
            yield node, "pass"


def _is_text(node: ast.expr) -> bool:
    """Whether it is a text that is written out: what is joined to it is no number."""
    return isinstance(node, ast.JoinedStr) or isinstance(getattr(node, "value", 0), str | bytes)


def inner(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the parts of a node in which a mutant may be."""
    match node:
        case ast.JoinedStr() | ast.Raise() | ast.Assert() | ast.keyword(arg="strict"):
            pass
        case ast.If(test=ast.Name(id="TYPE_CHECKING"), orelse=orelse):
            yield from orelse
        case ast.Assign(targets=[ast.Name(id="__all__")]):
            pass
        case ast.AnnAssign(annotation=annotation, value=value):
            yield from (value,) if value and ast.unparse(annotation) != "TypeAlias" else ()
        case ast.FunctionDef(args=arguments, body=body):
            yield from filter(None, (*arguments.defaults, *arguments.kw_defaults))
            yield from body
        case ast.ClassDef(body=body):
            yield from body
        case ast.match_case(guard=guard, body=body):
            yield from filter(None, (guard, *body))
        case _:
            yield from ast.iter_child_nodes(node)


def _compiled(node: ast.AST, file: str) -> bool:
    """Whether numba compiles a function: in the kernel those have no types."""
    return isinstance(node, ast.FunctionDef) and "/kernel/" in file and node.returns is None


def mutants_of(file: str, text: bytes, *, compiled: bool = False) -> Iterator[Mutant]:
    """Yield all mutants of a file, of what Python runs or of what numba compiles."""
    lines = text.splitlines(keepends=True)
    starts = [0, *accumulate(map(len, lines))]
    equal: Counter[tuple[str, str, str, str]] = Counter()

    def below(
        node: Any, name: str, within: str, *, early: bool, inside: bool = False
    ) -> Iterator[Mutant]:
        if isinstance(node, ast.stmt) and early:
            name = next(_names(node), name)
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            within = f"{within}.{node.name}".lstrip(".")
        for part, after in changed(node) if inside == compiled else ():
            if early and "|" in ast.unparse(part):  # of types
                continue
            start = starts[part.lineno - 1] + part.col_offset
            end = starts[part.end_lineno - 1] + part.end_col_offset
            before = ast.unparse(part)
            line = lines[part.lineno - 1].decode().strip()
            equal[line, before, after, within] += 1
            nth = equal[line, before, after, within]
            where = file, part.lineno, start, end
            yield Mutant(*where, before, after, name, early, line, within, nth)
        for part in inner(node):
            in_compiled = inside or _compiled(part, file)
            if compiled or not in_compiled:
                function = isinstance(node, ast.FunctionDef) and isinstance(part, ast.stmt)
                outside = isinstance(node, ast.Module | ast.ClassDef)
                early_too = not function and (early or outside)
                yield from below(part, name, within, early=early_too, inside=in_compiled)

    yield from below(ast.parse(text), "", "", early=True)


def _names(statement: ast.stmt) -> Iterator[str]:
    """Yield the names to which a statement gives a value."""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef):
        yield statement.name
    for node in ast.walk(statement):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id


def with_all(text: bytes, mutants: dict[int, Mutant]) -> bytes:
    """The text of a file with mutants, by their numbers, each behind its question."""
    edits = list[tuple[int, int, int, str]]()
    for number, each in mutants.items():
        if each.after == "pass":
            edits.append((each.start, 1, -len(text), f"if not _mutated({number}): "))
        else:
            before = f"(({each.after}) if _mutated({number}) else ("
            edits.append((each.start, 1, -each.end, before))
            edits.append((each.end, 0, -each.start, "))"))
    pieces, done = list[bytes](), 0
    for place, _, _, new in sorted(edits):
        pieces += (text[done:place], new.encode())
        done = place
    return b"".join((*pieces, text[done:]))


def drawn(every: Iterable[Mutant], seed: int) -> list[Mutant]:
    """One mutant of each line, in an order that is drawn."""
    by_line: dict[tuple[str, int], list[Mutant]] = defaultdict(list)
    for mutant in every:
        by_line[mutant.file, mutant.line].append(mutant)
    chance = random.Random(seed)
    order = list(by_line.values())
    chance.shuffle(order)
    return [chance.choice(each) for each in order]


class Copy:
    """A copy of the project, with an environment of its own and mutants by their numbers."""

    def __init__(self, place: Path, workers: int) -> None:
        self.tree = place / "tree"
        self.workers = workers
        self.python = self.tree / ".venv/bin/python"
        self.seconds: dict[str, float] = defaultdict(float)

    def make(self, texts: dict[str, bytes], mutants: dict[int, Mutant]) -> None:
        """Copy all files that git knows or would take, put the mutants in, generate the schemas."""
        shutil.rmtree(self.tree, ignore_errors=True)
        command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        listed = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
        for name in filter(None, listed.stdout.split("\0")):
            if (ROOT / name).exists():
                (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / name, self.tree / name, follow_symlinks=False)
        for file, text in texts.items():
            of_file = {number: each for number, each in mutants.items() if each.file == file}
            if of_file:
                (self.tree / file).write_bytes(with_all(text, of_file))
        venv.create(self.tree / ".venv", with_pip=False)
        packages = next((self.tree / ".venv/lib").glob("python*/site-packages"))
        paths = [self.tree / "src", *(each for each in sys.path if "site-packages" in each)]
        lines = (*map(str, paths), "import mutants_pytest")
        packages.joinpath("copy.pth").write_text("\n".join(lines) + "\n")
        shutil.copy(self.tree / "benchmarks/mutants_pytest.py", packages)
        script = self.python.with_name("allworlds")
        script.write_text(
            f"#!{self.python}\nimport sys\nfrom allworlds.cli import main\nsys.exit(main())\n"
        )
        script.chmod(0o755)
        schemas = f"from pathlib import Path as P; main(P('{SOURCE}/schemas'))"
        code = f"from allworlds.reports.schemas import main; {schemas}"
        subprocess.run([self.python, "-c", code], cwd=self.tree, check=True)

    def pytest(self, *arguments: str, worker: int = 0, **environment: str) -> list[list[Any]]:
        """Run tests, and return what they note."""
        notes = self.tree.with_name(f"notes-{worker}.jsonl")
        notes.write_text("")
        subprocess.run(
            [self.python, "-m", "pytest", "-q", "-p", "mutants_pytest", *arguments],
            cwd=self.tree,
            check=False,
            stdin=subprocess.DEVNULL,
            stdout=notes.with_name("pytest.txt").open("a"),
            stderr=subprocess.STDOUT,
            env={**os.environ, "MUTANTS_NOTES": str(notes), **environment},
        )
        return [json.loads(line) for line in notes.read_text().splitlines()]

    def meet(self, mutants: dict[int, Mutant], arguments: Sequence[str]) -> None:
        """Run the quick tests without a mutant, and give to each mutant the tests that meet it."""
        notes = self.pytest(*arguments)
        users: dict[str, set[str]] = defaultdict(set)
        failed = set[str]()
        for kind, *words in notes:
            if kind == "uses":
                users[words[1]].add(words[0])
            elif kind == "took":
                self.seconds[words[0]] += words[1]
                failed |= {words[0]} if words[2] else set()
        if not self.seconds:
            sys.exit(f"mutants: no test has run: see {self.tree.with_name('pytest.txt')}")
        for test in failed:
            del self.seconds[test]
        for kind, *words in notes:
            if kind == "met":
                mutant = mutants[words[0]]
                mutant.early |= not words[1]
                mutant.tests |= (users.get(words[1]) or {words[1]}) & self.seconds.keys()
        print(f"{len(self.seconds)} tests pass without a mutant, {len(failed)} fail", flush=True)

    def chosen(self, mutant: Mutant, seconds: float) -> list[str]:
        """The tests to run with a mutant, in their order."""
        own = f"/test_{Path(mutant.file).stem}.py::"
        module = mutant.file.removeprefix("src/").removesuffix(".py").replace("/", ".")
        early = mutant.early and mutant.name
        naming = self._files_that_name(mutant.name, module) if early else set()
        tests = {
            test
            for test in self.seconds
            if test in mutant.tests or own in test or test.partition("::")[0] in naming
        }
        variants: Counter[str] = Counter()
        order = list[tuple[bool, bool, int, float, str]]()
        for test in sorted(tests, key=lambda each: (self.seconds[each], each)):
            kind = test.partition("[")[0]
            meets = test in mutant.tests
            order.append((own not in test, not meets, variants[kind], self.seconds[test], test))
            variants[kind] += 1
        chosen = list[str]()
        for *_, test in sorted(order):
            seconds -= self.seconds[test]
            if seconds > 0:
                chosen.append(test)
        files = list(dict.fromkeys(test.partition("::")[0] for test in chosen))
        return sorted(chosen, key=lambda each: files.index(each.partition("::")[0]))

    def _files_that_name(self, *names: str) -> set[str]:
        """The files of tests that have one of these names in them, or in a text beside them."""
        found = set[str]()
        for path in self.tree.joinpath("tests").rglob("test_*.py"):
            texts = (each.read_text() for each in (path, path.with_suffix(".txt")) if each.exists())
            if any(name in text for text in texts for name in names):
                found.add(str(path.relative_to(self.tree)))
        return found

    def try_all(self, mutants: dict[int, Mutant], seconds: float) -> None:
        """Try mutants after the collection of tests; those that are met before it, from anew."""
        to_try = []
        for number, mutant in mutants.items():
            tests = self.chosen(mutant, seconds)
            mutant.tried = len(tests)
            deadline = 30 + 8 * sum(self.seconds[test] for test in tests)
            to_try.append((number, tests, deadline))
        self._try(mutants, to_try)
        for number, tests, deadline in to_try:
            mutant = mutants[number]
            if mutant.early and not mutant.killed_by:
                files = sorted({test.partition("::")[0] for test in tests})
                self._try(mutants, [(number, tests, deadline)], *files, MUTANT=str(number))

    def _try(self, mutants: dict[int, Mutant], to_try: Any, *files: str, **active: str) -> None:
        def part(worker: int) -> list[list[Any]]:
            mine = self.tree.with_name(f"to_try-{worker}.json")
            mine.write_text(json.dumps(to_try[worker :: self.workers]))
            return self.pytest("-x", *files, worker=worker, MUTANTS_TO_TRY=str(mine), **active)

        with ThreadPoolExecutor(self.workers) as pool:
            parts = pool.map(part, range(min(self.workers, len(to_try))))
            notes = [*chain.from_iterable(parts)]
        ended = {words[0]: words[1] for kind, *words in notes if kind == "ended"}
        killers = {words[0]: words[1] for kind, *words in notes if kind == "killed"}
        for number, _, _ in to_try:
            killer = killers.get(number) or ended.get(number, "the collection of tests")
            mutants[number].killed_by = killer
            name = f"{mutants[number].file}:{mutants[number].line}"
            print(f"{name}: {killer or 'SURVIVES'}", flush=True)


# ---- The kernel ----

KERNEL = f"{SOURCE}/engines/kernel"
OF_LOGS = {"_follow", "_note", "_find_map", "count"}
"""Functions of these modules that neither engine of Algorithm 1 calls."""
KERNEL_SECONDS = 120
"""The time after which a mutant is killed: the right engines take some 20 seconds."""


def of_kernel() -> Iterator[Mutant]:
    """Yield the mutants of what numba compiles of the engines of Algorithm 1."""
    from interpreted import MODULES

    for name in MODULES:
        file = f"{KERNEL}/{name}.py"
        for mutant in mutants_of(file, (ROOT / file).read_bytes(), compiled=True):
            if mutant.within not in OF_LOGS:
                yield mutant


def try_kernel(mutant: Mutant) -> None:
    """Ask the engines with a mutant, in a fork, which may never end."""
    from interpreted import seen

    text = (ROOT / mutant.file).read_bytes()
    after = mutant.after if mutant.after == "pass" else f"({mutant.after})"
    source = b"".join((text[: mutant.start], after.encode(), text[mutant.end :])).decode()
    reads, writes = os.pipe()
    pid = os.fork()
    if pid == 0:
        resource.setrlimit(resource.RLIMIT_DATA, (2 << 30, 2 << 30))
        signal.alarm(KERNEL_SECONDS)
        with suppress(MemoryError, RecursionError):
            os.write(writes, (seen({Path(mutant.file).stem: source}) or "-").encode())
        os._exit(0)
    os.close(writes)
    with open(reads, "rb") as said:  # noqa: PTH123  # a descriptor
        answer = said.read().decode()
    os.waitpid(pid, 0)
    mutant.killed_by = {"": "the deadline, or the limit of memory", "-": ""}.get(answer, answer)
    print(f"{mutant.file}:{mutant.line}: {mutant.killed_by or 'SURVIVES'}", flush=True)


def table(mutants: Sequence[Mutant], known: Sequence[dict[str, Any]]) -> str:
    """The numbers of each wing and of all."""
    text = f"{'':12}{'mutants':>9}{'killed':>9}{'survive':>9}{'equivalent':>12}\n"
    for wing in (*sorted({each.wing for each in mutants}), "all"):
        of_wing = [each for each in mutants if wing in (each.wing, "all")]
        killed = sum(bool(each.killed_by) for each in of_wing)
        equivalent = sum(not each.killed_by and each.among(known) for each in of_wing)
        survive = len(of_wing) - killed - equivalent
        share = killed / max(killed + survive, 1)
        text += f"{wing:12}{len(of_wing):9}{killed:9}{survive:9}{equivalent:12}{share:9.1%}\n"
    return text


def _tested(options: argparse.Namespace) -> dict[int, Mutant]:
    """Draw mutants, and try with tests those that are met."""
    paths = sorted((ROOT / SOURCE).rglob("*.py"))
    texts = {str(each.relative_to(ROOT)): each.read_bytes() for each in paths}
    every = (each for file, text in texts.items() for each in mutants_of(file, text))
    asked = (each for each in every if not options.wing or any(map(each.is_in, options.wing)))
    mutants = dict(enumerate(drawn(asked, options.seed)[: options.number], start=1))
    with tempfile.TemporaryDirectory() as temporary:
        copy = Copy((options.place or Path(temporary)).resolve(), options.workers)
        copy.make(texts, mutants)
        copy.meet(mutants, options.pytest)
        met = {number: each for number, each in mutants.items() if each.tests or each.early}
        copy.try_all(met, options.seconds)
    return mutants


def main() -> int:
    """Draw, try and count."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--number", type=int, default=60, help="how many mutants")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kernel", action="store_true", help="of the compiled engines alone")
    parser.add_argument("--wing", action="append", default=[], help="of these places alone")
    parser.add_argument("--in", dest="place", type=Path, help="keep the copy here")
    parser.add_argument("--out", type=Path, help="write a JSON document here")
    parser.add_argument("--seconds", type=float, default=60, help="tests of one mutant at most")
    parser.add_argument("--workers", type=int, default=1, help="how many mutants at a time")
    parser.add_argument("pytest", nargs="*", help="for the run without a mutant, as -- -n auto")
    options = parser.parse_args()
    known = tomllib.loads(EQUIVALENT.read_text())["mutant"]
    if options.kernel:
        sys.path[:0] = [str(ROOT / "tests/support/mutants"), str(ROOT / "proofs/coq")]
        mutants = dict(enumerate(drawn(of_kernel(), options.seed)[: options.number], start=1))
        for each in mutants.values():
            try_kernel(each)
    else:
        mutants = _tested(options)
    alive = [each for each in mutants.values() if not each.killed_by and not each.among(known)]
    for each in alive:
        met = f"{each.tried} tests" if each.tried or options.kernel else "no test meets it"
        print(f"\n{each.file}:{each.line} ({met})\n- {each.before}\n+ {each.after}")
    print(f"\n{table(list(mutants.values()), known)}")
    if options.out:
        rows = [{**vars(each), "tests": len(each.tests)} for each in mutants.values()]
        options.out.write_text(json.dumps({"seed": options.seed, "mutants": rows}, indent=1))
    return bool(alive)


if __name__ == "__main__":
    sys.exit(main())
