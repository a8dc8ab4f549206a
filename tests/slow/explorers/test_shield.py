"""The shield: it makes right whatever is inside, at a constant times the cost of the better."""

import sys

import pytest

import allworlds
from allworlds.corpus.explorers import EQUIVALENT_EXPLORERS, WRONG_EXPLORERS
from explorers import test_shield as quick
from explorers.test_shield import STRANGERS
from small import slowest

mine = quick.mine


@pytest.mark.slowest
@pytest.mark.early
def test_an_explorer_that_does_not_yield_is_silent_with_a_shield_too(mine):
    report = allworlds.check(f"shield:{mine}:explore", edges=2, answer_timeout=1)
    (finding,) = report.findings
    assert (finding.law, finding.confirmed) == ("timeout", True)
    again = allworlds.replay(allworlds.Finding.from_json(finding.to_json()), answer_timeout=1)
    assert again.exit_code == 0


@pytest.mark.slowest
def test_a_silent_program_is_silent_with_a_shield_too(tmp_path):
    name = f"shield:{program(tmp_path, silent=True)}"
    report = allworlds.check(name, edges=1, answer_timeout=1)
    assert [finding.law for finding in report.findings] == ["timeout"]


@pytest.mark.slowest
@pytest.mark.parametrize("edges", [3, slowest(4)])
@pytest.mark.parametrize("mutant", [*WRONG_EXPLORERS, *EQUIVALENT_EXPLORERS], ids=lambda m: m.name)
def test_every_wrong_explorer_is_made_right(mutant, edges):
    quick.test_every_wrong_explorer_is_made_right(mutant, edges)


@pytest.mark.slowest
@pytest.mark.parametrize("edges", [3])
@pytest.mark.parametrize("stranger", STRANGERS, ids=lambda s: s.__name__)
def test_whatever_is_inside_the_map_is_right(stranger, edges):
    quick.test_whatever_is_inside_the_map_is_right(stranger, edges)


@pytest.mark.parametrize("name", ["algorithm1", "{mine}:spinning"])
def test_it_is_asked_for_by_name(name, mine):
    quick.test_it_is_asked_for_by_name(name, mine)


PROGRAM = """
import json, sys, time
for line in sys.stdin:
    if {silent}:
        time.sleep(60)
    print(json.dumps({{"move": 1}}), flush=True)
"""


def program(tmp_path, silent):
    file = tmp_path / "program.py"
    file.write_text(PROGRAM.format(silent=silent))
    return f"exec:{sys.executable} -I {file}"


@pytest.mark.slowest
@pytest.mark.processes
def test_a_program_can_have_one(tmp_path):
    name = program(tmp_path, silent=False)
    assert allworlds.shield(name) == f"shield:{name}"
    assert allworlds.check(allworlds.shield(name), edges=2).verdict.value == "holds"
