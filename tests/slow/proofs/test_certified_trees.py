"""Certificates for Coq's kernel: what is written of a program, and that it is what it does."""

import pytest

from proofs import test_certified_trees as quick
from proofs.test_certified_trees import COQ

trees = quick.trees
written = quick.written

UNRULY = """
import os, time
from allworlds.explorers.builtin.algorithm1 import algorithm1

begun = []


def never(first):
    while True:
        pass
    yield


def from_the_sixth_on(first):
    begun.append(first)
    if len(begun) > 5:
        time.sleep(60)
    return (yield from algorithm1(first))


def leaves(first):
    os._exit(3)
    yield


def hungry(first):
    hoard = bytearray(1 << 34)
    return (yield from algorithm1(first))
"""
"""Explorers that a process is needed for."""


@pytest.mark.parametrize(
    ("name", "law", "written_down"),
    [
        ("never", "timeout: silent for 0.5 s", False),
        ("from_the_sixth_on", "timeout: silent for 0.5 s", False),
        ("leaves", "crash: the end of the process (exit code 3)", False),
        ("hungry", "crash in 30 runs: coqc will refuse the file", True),
    ],
)
def test_an_explorer_is_played_where_it_does_no_harm_and_its_silence_is_waited_out_once(
    written, tmp_path, name, law, written_down
):
    (tmp_path / "unruly.py").write_text(UNRULY)
    limits = ["--answer-timeout", "0.5", "--memory", "4096", "--edges", "2"]
    code, text, said = written(f"{tmp_path}/unruly.py:{name}", *limits)
    assert code == 1
    assert said.count("NO ANSWER") == 1
    assert law in said
    assert (text is not None) == written_down


@pytest.mark.slowest
def test_a_program_that_is_silent_is_waited_for_in_one_run(written):
    code, text, said = written("--exec", "sleep 60", "--answer-timeout", "0.5", "--edges", "4")
    assert (code, text) == (1, None)
    assert said == "NO ANSWER  timeout: silent for 0.5 s; no file is written\n"


@pytest.mark.slowest
def test_coq_and_the_package_say_the_same_of_every_mutant(trees):
    if not (COQ / "DecisionTrees.vo").exists():
        pytest.skip("not built: make -C proofs/coq")
    names = [mutant.name for mutant in trees.WRONG_EXPLORERS]
    assert trees.certificates_agree(2, names)
