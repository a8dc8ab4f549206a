"""Assertions for authors' test suites: what they let pass, and what they say when they fail."""

import sys
from inspect import signature
from traceback import walk_tb
from types import SimpleNamespace

import pytest

from allworlds import testing
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from allworlds.explorers.builtin.explorer_table import BUILT_IN
from allworlds.inputs.checks import InputError
from allworlds.maps import rooted_code
from allworlds.outcome import Interrupted
from allworlds.strategies import sampled_maps
from allworlds.studies.check.exhaustive import check
from allworlds.testing import (
    AtLevel,
    assert_conforms,
    assert_explores,
    conformance,
    known_hard_maps,
    levels_of,
)
from allworlds.world import worlds

pytestmark = pytest.mark.usefixtures("without_workers")

MUTANTS = {mutant.name: mutant for mutant in WRONG_EXPLORERS}
RIGHT = BUILT_IN["algorithm1"].explore


def wrong(name="mirror-image"):
    return MUTANTS[name].explorer()


@pytest.fixture
def cached(tmp_path, monkeypatch):
    """A corpus as the plugin names it."""
    plugin = SimpleNamespace(corpus_of_test=lambda: tmp_path / "past")
    monkeypatch.setitem(sys.modules, "_allworlds_pytest", plugin)
    return tmp_path / "past"


def test_a_wrong_one_fails_with_the_smallest_finding_and_its_picture():
    with pytest.raises(AssertionError) as failed:
        assert_explores(wrong(), edges=4, corpus=None)
    text = str(failed.value)
    assert "breaks the law 'pose' in a world with 2 edges" in text
    assert "\nThe world\n" in text
    assert "╭" in text
    assert text.startswith("REFUTED: law pose is broken; ")  # all that a short summary has


def test_a_check_that_says_nothing_is_no_pass():
    def stays(first):
        return None
        yield

    with pytest.raises(AssertionError, match="INCONCLUSIVE: the time limit"):
        assert_explores(RIGHT, edges=3, engine="python", time_limit=1e-9, corpus=None)
    with pytest.raises(AssertionError, match="no-estimate"):
        assert_explores(stays, edges=1, corpus=None)


def test_bad_options_are_refused_as_everywhere():
    with pytest.raises(InputError, match="class"):
        assert_explores(RIGHT, map_class="planr", corpus=None)
    with pytest.raises(InputError, match="edges"):
        levels_of({"edges": 0})


def test_levels_are_those_of_the_extent():
    assert [*levels_of({})] == [1, 2, 3, 4]
    assert [*levels_of({"edges": 2})] == [1, 2]
    assert [*levels_of({"vertices": 3, "map_class": "simple"})] == [1, 2, 3]


def test_a_finding_is_kept_and_tried_first_and_forgotten_when_it_is_fixed(cached):
    with pytest.raises(AssertionError):
        assert_explores(wrong(), edges=4)
    (kept,) = cached.iterdir()
    with pytest.raises(AssertionError) as failed:
        assert_explores(wrong(), edges=4)
    assert "0 worlds" in str(failed.value), "the past finding was enough"
    assert [*cached.iterdir()] == [kept]
    assert_explores(RIGHT, edges=3)
    assert [*cached.iterdir()] == []


def test_a_corpus_of_ones_own_keeps_everything(tmp_path):
    with pytest.raises(AssertionError):
        assert_explores(wrong(), edges=3, corpus=tmp_path)
    (kept,) = tmp_path.iterdir()
    assert_explores(RIGHT, edges=3, corpus=tmp_path)
    assert [*tmp_path.iterdir()] == [kept]


def test_a_level_tells_only_of_its_own_findings(cached):
    assert AtLevel(1, {})(wrong()).worlds == 2
    with pytest.raises(AssertionError, match="Finding 1"):
        AtLevel(2, {})(wrong())
    with pytest.raises(AssertionError) as failed:
        AtLevel(3, {"corpus": None})(wrong())
    assert str(failed.value) == (
        "REFUTED: law pose is broken already in a world with 2 edges: see the test edges-2"
    )


def test_an_interrupt_is_no_verdict(monkeypatch):
    report = replace(check(edges=1), ending=Interrupted())
    monkeypatch.setattr("allworlds.testing.check", lambda *_, **__: report)
    with pytest.raises(KeyboardInterrupt):
        assert_explores(RIGHT, edges=1, corpus=None)


def test_the_kit_has_a_part_for_each_thing_that_is_tried():
    names = [str(part) for part in conformance(RIGHT, edges=3)]
    assert names == [
        "known-hard-maps",
        *(f"edges-{level}" for level in (1, 2, 3)),
        "every-schedule",
        "drawn-maps",
    ]
    assert "every-schedule" not in map(str, conformance("algorithm1"))
    (every,) = (part for part in conformance(RIGHT, edges=3) if str(part) == "every-schedule")
    assert (every.play.keywords["edges"], every.play.keywords["schedules"]) == (2, "all")


def test_algorithm_1_conforms():
    assert_conforms(RIGHT, edges=2, drawn=5, drawn_edges=5, corpus=None)


@pytest.mark.parametrize("part", ["edges-2", "drawn-maps"])
def test_a_wrong_explorer_fails_each_part_that_goes_far_enough(part):
    parts = {str(part): part for part in conformance(wrong(), drawn=8, drawn_edges=6)}
    with pytest.raises(AssertionError, match="Finding 1: mutants:mirror-image breaks"):
        parts[part]()


def test_a_drawn_finding_is_shrunk_to_the_smallest_of_all():
    part = conformance(wrong(), drawn=5, drawn_edges=7)[-1]
    with pytest.raises(AssertionError, match="'pose' in a world with 2 edges and 1 vertex"):
        part()


def test_a_schedule_that_is_wrong_is_found():
    def last_schedule(first, *, choices):
        answer = yield from RIGHT(first, choices=choices)
        return None if any(choices.record) else answer

    part = {str(part): part for part in conformance(last_schedule, edges=2)}["every-schedule"]
    assert_explores(last_schedule, edges=2, corpus=None)
    with pytest.raises(AssertionError, match="no-estimate"):
        part()


def test_known_hard_maps_are_different_and_hard():
    maps = known_hard_maps()
    assert len(maps) == len({rooted_code(map_.sigma, map_.alpha, 0) for map_ in maps})
    assert len(maps) > 20


def test_a_sample_is_the_same_every_time():
    assert sampled_maps("planar", 6, 9) == sampled_maps("planar", 6, 9)
    assert len(sampled_maps("maps", 6, 9)) == 9
    assert max(map_.edge_count for map_ in sampled_maps("maps", 6, 30)) <= 6


@pytest.fixture
def cubic_alone(tmp_path, monkeypatch):
    """An explorer that is right in cubic maps, and in no other."""
    (tmp_path / "cubic.py").write_text(
        "from allworlds.explorers.builtin.algorithm1 import algorithm1\n\n\n"
        "def explore(first, *, choices):\n"
        "    assert first.degree == 3\n"
        "    return (yield from algorithm1(first, choices=choices))\n"
    )
    monkeypatch.chdir(tmp_path)
    return "cubic.py:explore"


def test_the_drawn_maps_of_the_kit_keep_a_condition(cubic_alone):
    *_, last = conformance(cubic_alone, edges=3, drawn=2, drawn_edges=6, where="cubic")
    last()
    *_, last = conformance(cubic_alone, edges=3, drawn=2, drawn_edges=6, where="eulerian")
    with pytest.raises(AssertionError, match="crash"):
        last()


def test_given_worlds_are_tried_in_place_of_all(cubic_alone):
    given = worlds(edges=3, where="cubic")
    assert assert_explores(cubic_alone, worlds=given).worlds == 5
    with pytest.raises(AssertionError, match="crash"):
        assert_explores(cubic_alone, worlds=worlds(edges=1))


HIDDEN = {
    *("assert_explores", "__call__", "assert_conforms", "assert_lighthouse"),
    *("_known", "_drawn", "_assert_no", "_assert_holds"),
}


def frames_of_ours(call):
    """The frames of the module in the traceback of what is raised: names, and whether hidden."""
    with pytest.raises(AssertionError) as error:
        call()
    frames = [frame for frame, _ in walk_tb(error.value.__traceback__)]
    own = [frame for frame in frames if frame.f_code.co_filename == testing.__file__]
    return [(each.f_code.co_name, each.f_locals.get("__tracebackhide__")) for each in own]


def test_a_failure_shows_the_authors_own_lines_alone(monkeypatch):
    explorer = wrong()
    monkeypatch.setattr(testing.selection, "flaws_of", lambda *_: ["it senses less"])
    calls = [
        lambda: assert_explores(explorer, edges=2),
        lambda: AtLevel(2, {})(explorer),
        lambda: assert_conforms(explorer, edges=2),
        lambda: testing.assert_lighthouse("door"),
        *(
            part
            for part in conformance(explorer, edges=1, drawn=4, drawn_edges=4)
            if "-maps" in str(part)
        ),
    ]
    found = [frame for call in calls for frame in frames_of_ours(call)]
    assert {hidden for _, hidden in found} == {True}, found
    assert {name for name, _ in found} == HIDDEN


def test_by_default_the_kit_is_as_large_as_its_page_says():
    given = {name: each.default for name, each in signature(conformance).parameters.items()}
    assert (given["edges"], given["drawn"], given["drawn_edges"]) == (4, 50, 10)
