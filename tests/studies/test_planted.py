"""Planted slips: the benchmark tells rightly which show, and the mixture finds them."""

import argparse
import importlib.util
from pathlib import Path

import pytest

from allworlds.engines.limits import Limits
from allworlds.engines.single import subject_of
from allworlds.judging.referee import Examiner
from allworlds.judging.rules import Rules
from allworlds.protocol.choices import Choices
from allworlds.studies.fuzz.sample_sweep import fuzz
from allworlds.world.lighthouses import kinds

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("planted", ROOT / "benchmarks/planted.py")
planted = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(planted)

EACH = ("belief after 1", "belief after 3", "3 parallel edges", "two alike to depth 3")


def options(**given):
    return argparse.Namespace(
        **{"edges": 12, "runs": 16, "seed": 5, "mix": None, "limit": 9e9, "hard": False} | given
    )


@pytest.mark.parametrize("old", [False, True])
@pytest.mark.parametrize("name", planted.EXPLORERS)
def test_the_slips_that_show_in_a_world_are_those_that_refute(name, old):
    kind, lighthouse = planted.EXPLORERS[name]
    rules = Rules(lighthouse=lighthouse, bound="none")
    examiners = {
        slip: Examiner(subject_of(planted.explorer(planted.SLIPS[slip](kind)), Limits()), rules)
        for slip in EACH
    }
    every = set()
    for world in planted.sample(options(old=old), kinds.lighthouse_kind(lighthouse).as_class):
        if world is not None:
            refuted = {
                s for s, each in examiners.items() if each.examine(world, Choices()).violation
            }
            assert refuted == {*EACH} & planted.wrong_in(kind, world)
            every |= refuted
    assert every


def test_at_least_9_of_10_planted_slips_are_found(capsys):
    planted.main(["--edges=60", "--runs=40", "--seed=3"])
    *_, last = capsys.readouterr().out.splitlines()
    assert last == "54 of 54 are found: 100%"


def test_the_first_run_that_is_wrong_is_the_one_that_fuzz_refutes():
    kind, _ = planted.EXPLORERS["algorithm1"]
    first = planted.first_wrong(options(old=False), "algorithm1")[0]["belief after 1"]
    explore = planted.explorer(planted.believing(kind, 1))
    sample = {"edges": 12, "seed": 5, "bound": "none"}
    assert first > 1
    assert not fuzz(explore, runs=first - 1, **sample).findings
    assert fuzz(explore, runs=first, **sample).findings
