"""Libraries for tests, each built once in a run of the tests."""

import hashlib
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import pytest

import allworlds.explorers.shared_library

PROJECT = Path(__file__).parents[2]
EXAMPLES = PROJECT / "examples"
FOR_TESTS = Path(__file__).parent / "explorers_for_tests"
HEADER = Path(allworlds.explorers.shared_library.__file__).parent
FOLDER = Path(tempfile.mkdtemp(prefix="allworlds-"))

COMPILERS = {
    ".c": ["cc", "-std=gnu99", "-Wall", "-Wextra", "-Werror", "-O2", "-shared", "-fPIC"],
    ".cpp": ["c++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-O2", "-shared", "-fPIC"],
    ".rs": ["rustc", "-O", "--crate-type", "cdylib"],
}
"""What builds a source, by the end of its name."""


@cache
def built(source: Path, *options: str) -> str:
    """The library that a source is built to; skips where there is no compiler."""
    compiler, *arguments = COMPILERS[source.suffix]
    if shutil.which(compiler) is None:
        pytest.skip(f"there is no {compiler}")
    name = hashlib.sha256(repr((str(source), options)).encode()).hexdigest()[:16]
    library = FOLDER / f"{source.stem}-{name}.so"
    if source.suffix != ".rs":
        arguments = [*arguments, "-I", str(HEADER)]
    command = [compiler, *arguments, "-o", str(library), str(source), *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert not done.returncode, done.stderr
    return str(library)


def example(name: str) -> str:
    """The library of an example."""
    return built(EXAMPLES / name)


def quotient(**named: int) -> str:
    """A library that answers with a quotient of one dart."""
    source = FOR_TESTS / "quotient.c"
    return built(source, *[f"-D{name}={value}" for name, value in named.items()])


def attack(code: str, **named: str) -> str:
    """A library that is right in every world with one edge, but does this where v0 has degree 1."""
    source = FOR_TESTS / "native.c"
    given = {"ATTACK": code, **named}
    return built(source, *[f"-D{name}={value}" for name, value in given.items()], "-lpthread")


ATTACKS = {
    "raise(SIGSEGV)": ("crash", "signal 11"),
    "abort()": ("crash", "signal 6"),
    "exit(0)": ("crash", "exit code 0"),
    "for (;;) pause()": ("timeout", "silent for"),
    "grow()": ("crash", "signal 11"),
    "count = 1000000": ("no-estimate", "1000000 darts"),
    "count = -1": ("no-estimate", "-1 darts"),
    "count = 3": ("no-estimate", "no map"),
    "here_is = 2": ("no-estimate", "here = 2"),
    "memset(action + 1, 1, 1 << 13)": ("crash", "signal 11"),
    "*far_away() = 1": ("crash", "signal 11"),
    "in_another_thread(wait_for_ever, 0)": ("crash", "left behind"),
    "kind = 0": ("illegal-action", "kind 0"),
    "kind = 77": ("illegal-action", "kind 77"),
    "kind = ALLWORLDS_AMBIGUOUS": ("illegal-action", "no function allworlds_quotient"),
    "kind = ALLWORLDS_DROP": ("illegal-action", "Drop"),
    "kind = ALLWORLDS_CHECKPOINT; count = 1 << 20": ("illegal-action", "1048576 darts"),
    "if (fork() == 0) for (;;) pause()": ("", ""),
    "in_another_thread(do_nothing, 1)": ("", ""),
}
"""What is done in the edge, and the law that it breaks there."""
