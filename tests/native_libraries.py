"""Libraries for tests, each built once in a run of the tests."""

import hashlib
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import pytest

import allworlds.libraries

PROJECT = Path(__file__).parents[1]
EXAMPLES = PROJECT / "examples"
HEADER = Path(allworlds.libraries.__file__).parent
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


def attack(code: str, **named: str) -> str:
    """A library that is right in every world with one edge, but does this where v0 has degree 1."""
    source = Path(__file__).parent / "explorers_for_tests" / "native.c"
    given = {"ATTACK": code, **named}
    return built(source, *[f"-D{name}={value}" for name, value in given.items()], "-lpthread")
