"""A distribution that offers an explorer, a lighthouse, a task and a predicate as entry points."""

import os
import subprocess
import sys

import pytest

MODULE = """
from dataclasses import dataclass

from allworlds import Lighthouse, Move, Percept


def hasty(first):
    for _ in range(3):
        yield Move(1)
    return "here"


@dataclass(frozen=True)
class Parity(Lighthouse):
    dart: int
    modulus: int = 2

    @classmethod
    def places(cls, map_, start):
        for bearing in range(map_.degree_at[start]):
            yield cls(map_.turn(start, bearing))

    def sensed(self, map_, here):
        if map_.vertex_of[here] != map_.vertex_of[self.dart]:
            return Percept(map_.degree_at[here])
        return Percept(map_.degree_at[here], 1, map_.offset(here, self.dart) % self.modulus)


def says(word):
    return lambda world, transcript, answer: None if answer == word else f"{answer} is said"


def small(degree):
    return lambda map_: max(map_.degrees) <= degree
"""
POINTS = """
[allworlds.explorers]
my-explorer = my_explorers:hasty

[allworlds.lighthouses]
my-parity = my_models:Parity

[allworlds.tasks]
my-word = my_models:says

[allworlds.predicates]
my-small = my_models:small
"""


@pytest.fixture
def installed(tmp_path):
    """A folder of packages with one more distribution, as pip leaves it."""
    packages = tmp_path / "packages"
    described = packages / "throw_away-1.0.dist-info"
    described.mkdir(parents=True)
    (packages / "my_explorers.py").write_text(MODULE)
    (packages / "my_models.py").write_text(MODULE)
    (described / "METADATA").write_text("Metadata-Version: 2.1\nName: throw-away\nVersion: 1.0\n")
    (described / "entry_points.txt").write_text(POINTS)

    def allworlds(*words):
        done = subprocess.run(
            [sys.executable, "-m", "allworlds", *map(str, words)],
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(packages)},
            capture_output=True,
            text=True,
            check=False,
        )
        return done.returncode, done.stdout, done.stderr

    return allworlds


@pytest.mark.parametrize(
    ("option", "name", "offered"),
    [
        ("--lighthouse", "my-harbour", "my-parity"),
        ("--task", "my-letter", "my-word"),
        ("--where", "my-big", "my-small"),
    ],
)
def test_a_name_that_nobody_offers_is_refused_with_those_that_are(installed, option, name, offered):
    code, out, err = installed("check", option, name, "--edges", 1)
    assert (code, out) == (2, "")
    assert len(err.splitlines()) == 1
    assert f"'{name}' is not one of" in err
    assert offered in err
