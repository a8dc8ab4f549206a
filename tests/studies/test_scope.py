"""The scope of every study that goes through worlds: what was asked, as it took effect."""

from pkgutil import resolve_name

import pytest

from allworlds import ambiguity, check, compare, count, fuzz
from allworlds.inputs.requests import in_scope
from allworlds.judging.rules import RuleOptions
from allworlds.notations.given import GivenOptions
from allworlds.reports.formats import text
from allworlds.verbs import VERBS
from allworlds.world.lighthouses.kinds import lighthouse_kind
from plan_files import as_json, write

pytestmark = pytest.mark.usefixtures("without_workers")

ALL_RULES = {
    "task": "cover",
    "policy": "lifo",
    "bound": "7*m",
    "laws": ["bound"],
    "step_budget": 90,
}
"""A value for every rule that is not its default."""

WORLDS = {"edges": 2, "where": "trees", "lighthouse": "compass", "map_class": "simple"}

STUDIES = {
    "check": lambda **more: check("dfs", **more),
    "fuzz": lambda **more: fuzz("dfs", runs=3, seed=4, **more),
    "compare": lambda **more: compare("dfs", "algorithm1", **more),
    "count": lambda **more: count(**{key: more[key] for key in more if key != "lighthouse"}),
    "ambiguity census": ambiguity.census,
}
JUDGED = ("check", "fuzz", "compare")

GIVEN = {one.option for one in in_scope(GivenOptions)}
"""Options of given worlds, which a document leaves out where they are not said."""

PLACES = "every place up to 3 edges; beyond, the compass at the smallest dart of each vertex alone"


def flat(words):
    return " ".join(words.split())


def of_all(report):
    """The scope, and what is told of each explorer beside it."""
    document = report.to_json()
    return [document["scope"] | one for one in document.get("explorers", [{}])]


def test_every_study_that_is_told_of_here_is_tried():
    swept = {verb.name for verb in VERBS if verb.swept}
    assert swept - {"worst", "team"} == {*STUDIES}  # which has no such options


@pytest.mark.parametrize("name", STUDIES)
def test_the_worlds_that_were_asked_for_are_told_in_document_and_text(name):
    report = STUDIES[name](**WORLDS)
    said = flat(text(report, 100))
    for scope in of_all(report):
        assert (scope["class"], scope["edges"], scope["where"]) == ("simple", 2, "trees")
        assert name == "count" or scope["lighthouse"] == "compass"
    assert "of the class 'simple', trees, with at most 2 edges" in said
    assert name == "count" or "compass" in said


@pytest.mark.parametrize("name", JUDGED)
def test_every_rule_is_told_in_document_and_text(name):
    assert {*ALL_RULES} == {one.name for one in in_scope(RuleOptions)}
    report = STUDIES[name](edges=2, **ALL_RULES)
    for scope in of_all(report):
        effective = {**ALL_RULES, "laws": ["task", "bound"]}
        assert {key: scope[key] for key in effective} == effective
    said = flat(text(report, 100))
    for words in ("cover", "lifo", "7*m", "--step-budget 90"):
        assert words in said


@pytest.mark.parametrize("name", STUDIES)
def test_every_option_of_the_worlds_and_of_the_rules_is_a_key_of_the_scope(name):
    (verb,) = [verb for verb in VERBS if verb.name == name]
    request = resolve_name(verb.path).request
    keys = of_all(STUDIES[name](edges=2, where="trees"))[0].keys()
    keys |= of_all(STUDIES[name](edges=2))[0].get("sample") or {}
    assert {one.option for one in in_scope(request)} - GIVEN - {"task"} <= {*keys}


@pytest.mark.parametrize("name", ["check", "compare", "ambiguity census"])
def test_every_option_of_given_worlds_is_a_key_of_the_scope_where_it_is_said(name, tmp_path):
    file = write(tmp_path / "theta.json", as_json("theta"))
    drawn = tmp_path / "edge.gml"
    ends = (f"node [ id {i} graphics [ x {i} y 0 ] ]" for i in (0, 1))
    drawn.write_text(f"graph [ {' '.join(ends)} edge [ source 0 target 1 ] ]")
    said = (
        {"worlds": file, "order": "anticlockwise"},
        {"worlds": drawn, "y": "up"},
        {"graph": "theta", "embeddings": "all"},
    )
    for options in said:
        scope = of_all(STUDIES[name](edges=3, **options))[0]
        assert {*scope} & GIVEN == {*options}
    assert not GIVEN & {*of_all(STUDIES[name](edges=1))[0]}


@pytest.mark.parametrize("name", [name for name in STUDIES if name != "count"])
def test_places_that_are_not_tried_are_told_from_the_size_on_where_they_are_left_out(name):
    whole, partial = (STUDIES[name](edges=edges, lighthouse="compass") for edges in (3, 4))
    assert not any("places" in {key for key in scope if scope[key]} for scope in of_all(whole))
    assert all(scope["places"] == PLACES for scope in of_all(partial))
    assert PLACES in flat(text(partial, 100))
    assert PLACES not in flat(text(whole, 100))


def test_of_two_lighthouses_the_places_of_both_are_told():
    both = lighthouse_kind("position+compass").as_class
    assert both.tried_in_maps_of(4) == PLACES
    assert (
        both.tried_in_maps_of(3) == lighthouse_kind("position").as_class.tried_in_maps_of(9) == ""
    )
