"""Every attack with one worker and with two, and the same where compiled code judges."""

import json
import os
import signal

import pytest

import processes
from attacks import test_attacks as quick
from attacks.reading import attacks
from attacks.test_attacks import judged, placed

scene = quick.scene


def weight(later, workers):
    """The marks of an attack: whether it is a later one, and the workers."""
    return pytest.mark.slowest if later or workers == 2 else ()


def is_for_compiled_code(attack):
    """Whether it is on who plays, or on what is played twice, and the kernel can judge it."""
    kinds = ("state", "reaching", "dying", "libraries")
    # What is left to the Python engine, what names its engine, and what looks for worlds alone.
    others = {"--memory", "--engine", "--where", "--schedules"}
    return attack.file.parent.name in kinds and not attack.signal and not others & {*attack.options}


def tried():
    """Each attack with 1 and with 2 workers, but for the quick run.

    Where both engines can judge, every other file is left to ``nox -s full`` here, and the others
    in :func:`tried_in_compiled_code`.
    """
    for place, attack in enumerate(attacks()):
        elsewhere = is_for_compiled_code(attack) and place % 2 == 0
        for number, function in enumerate(attack.verdicts):
            for workers in (1, 2):
                if attack.quick != workers:
                    marks = weight(number or elsewhere, workers)
                    name = f"{attack.name}-{function or 'exec'}-{workers}"
                    yield pytest.param(attack, function, workers, marks=marks, id=name)


@pytest.mark.slowest
@pytest.mark.early
@pytest.mark.parametrize(("attack", "function", "workers"), [*tried()])
def test_an_attack_gets_its_verdict_and_leaves_nothing_behind(attack, function, workers, scene):
    quick.test_an_attack_gets_its_verdict_and_leaves_nothing_behind(
        attack, function, workers, scene
    )


def tried_in_compiled_code():
    """Each attack wherever the kernel can judge.

    Libraries alone are tried with two workers, too: only with them does compiled code also play.
    """
    for place, attack in enumerate(attacks()):
        if is_for_compiled_code(attack):
            for number, function in enumerate(attack.verdicts):
                for workers in (1, 2) if attack.file.parent.name == "libraries" else (1,):
                    name = f"{attack.name}-{function or 'exec'}-{workers}"
                    marks = weight(number or place % 2, workers)
                    yield pytest.param(attack, function, workers, marks=marks, id=name)


@pytest.mark.slowest
@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize(("attack", "function", "workers"), [*tried_in_compiled_code()])
def test_an_attack_gets_the_same_verdict_where_compiled_code_judges(
    attack, function, workers, scene
):
    words = placed(attack, function, scene)
    process = scene.start("check", *words, "--workers", workers, "--json", "--engine", "kernel")
    code, out = scene.ended(process)
    judged(attack.verdicts[function], code, out, scene.said())


WAITS = """
import os, time
from pathlib import Path
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    if not Path("go").exists():
        Path("waiting").write_text(str(os.getpid()))
        os.rename("waiting", "ready")
        while not Path("go").exists():
            time.sleep(0.01)
    return (yield from algorithm1(first))
"""


@pytest.mark.slowest
def test_a_right_explorer_is_not_refuted_by_who_kills_its_player(scene):
    scene.place.joinpath("waits.py").write_text(WAITS)
    words = ["waits.py:explore", "--edges", 2, "--workers", 1, "--answer-timeout", 600, "--json"]
    process = scene.start("check", *words)
    assert processes.wait((scene.place / "ready").exists)
    os.kill(int((scene.place / "ready").read_text()), signal.SIGKILL)
    (scene.place / "go").touch()
    code, out = scene.ended(process)
    report = judged("holds", code, out, scene.said())
    assert (len(report["remarks"]), report["runs"]) == (1, 30)


RIGHT = """
from allworlds.explorers.builtin.algorithm1 import algorithm1

def explore(first):
    return (yield from algorithm1(first))
"""


@pytest.mark.slowest
def test_what_was_found_in_another_scope_refutes_nothing_in_this_one(scene):
    scene.place.joinpath("right.py").write_text(RIGHT)

    def check(*options):
        words = ["right.py:explore", *options, "--corpus", "corpus", "--workers", 1, "--json"]
        code, out = scene.ended(scene.start("check", *words))
        return code, json.loads(out)

    code, report = check("--edges", 2, "--bound", 1)
    assert (code, [found["law"] for found in report["findings"]]) == (1, ["bound"])
    code, report = check("--edges", 2)
    assert (code, report["verdict"], report["runs"]) == (0, "holds", 30)
    assert len(report["corpus"]["beyond_scope"]) == 1
