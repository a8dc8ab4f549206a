"""Every study that goes through worlds: interrupted, resumed, merged and limited, it says the same.

The documents are compared byte for byte, so that the order of their keys counts, too.
"""

from pathlib import Path
from types import SimpleNamespace

import pytest

from allworlds import ambiguity, check, compare, count, fuzz, team, worst
from allworlds.engines import sweep
from allworlds.verbs import VERBS
from kept_jobs import EXPLORERS
from listeners import Hears

pytestmark = [pytest.mark.usefixtures("compiled", "without_workers")]

TEAM = Path(__file__).parents[1] / "support" / "teams.py"
WRONG = f"{EXPLORERS / 'wrong.py'}"

SWEEPS = {
    "check": lambda **more: check(edges=3, engine="python", **more),
    "check refuted": lambda **more: check(
        f"{WRONG}:here_of_another", edges=3, max_findings=3, **more
    ),
    "worst": lambda **more: worst(edges=4, **more),
    "check all": lambda **more: check(edges=2, schedules="all", **more),
    "compare": lambda **more: compare("algorithm1", "folding", edges=3, **more),
    "compare refuted": lambda **more: compare(
        "algorithm1", f"{WRONG}:here_of_another", edges=3, **more
    ),
    "compare one world": lambda **more: compare(
        "algorithm1", "folding", family="lattice:3x3", **more
    ),
    "compare --to": lambda **more: compare(
        "algorithm1", "folding-oldest", family=["lattice", "cubic"], to=30, draws=2, **more
    ),
    "fuzz": lambda **more: fuzz(edges=7, runs=600, **more),
    "fuzz refuted": lambda **more: fuzz(f"{WRONG}:everywhere", edges=4, runs=600, **more),
    "count": lambda **more: count(edges=4, **more),
    "count simple": lambda **more: count(vertices=4, map_class="simple", **more),
    "ambiguity census": lambda **more: ambiguity.census(edges=4, **more),
    "team": lambda **more: team(f"{TEAM}:walks", edges=3, budget=9, **more),
}
"""Small jobs by their verb, and what is special about them."""

KINDS = ("check refuted", "worst", "compare", "compare --to", "fuzz", "count", "ambiguity census")
"""One for each way of going through worlds; the others are left to the slow tests."""


def test_every_verb_with_a_sweep_is_tried():
    words = {" ".join(name.split()[:2]) for name in SWEEPS} | {name.split()[0] for name in SWEEPS}
    assert {verb.name for verb in VERBS if verb.swept} <= words


@pytest.mark.parametrize("name", KINDS)
def test_a_time_limit_that_is_over_at_once_leaves_it_undecided(name):
    cut = SWEEPS[name](time_limit=1e-9)
    refuted = bool(getattr(cut, "findings", ()))
    assert cut.exit_code == (1 if refuted else 3)


def test_what_was_finished_before_is_progress_too(tmp_path):
    first, again = Hears(), Hears()
    for listener in (first, again):
        check(edges=3, engine="python", run=tmp_path / "run", listener=listener)
    assert again.heard == first.heard
    assert {total for _, total, _ in again.heard} == {done for *_, done in again.heard}


def test_of_a_large_level_each_unit_is_equally_likely_to_be_in_the_sample(monkeypatch):
    asked, more = [], 3
    monkeypatch.setattr(sweep, "randrange", lambda below: asked.append(below) or below - 1)
    level = SimpleNamespace(edges=sweep.SMALL + 1, units=range(sweep.DRAWN + more))
    swept, drawn = SimpleNamespace(_is_kept=lambda *_: False), []
    assert [*sweep.Sweep._undone(swept, level, None, drawn)] == [*level.units]
    assert asked == [sweep.DRAWN + 1 + index for index in range(more)]
    assert drawn == [*range(sweep.DRAWN)]
