import json
from pathlib import Path

import pytest

from allworlds.documents.document import replace
from allworlds.explorers.builtin.algorithm1 import algorithm1
from allworlds.inputs.checks import InputError
from allworlds.judging.findings.finding import Finding, canonical_world, place_of
from allworlds.maps import named_map
from allworlds.protocol.actions import Checkpoint
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run import replay, run
from allworlds.world import Directional, World, worlds
from processes import PATIENCE

EXPLORERS = Path(__file__).parents[1] / "support" / "explorers_for_tests"


def lazy(first):
    return (yield from algorithm(first)) if first.degree > 2 else None


def algorithm(first):
    from allworlds.explorers.builtin.algorithm1 import algorithm1

    return (yield from algorithm1(first))


@pytest.fixture(scope="module")
def finding():
    return check(lambda first: (yield from lazy(first)), edges=1).findings[0]


@pytest.fixture(scope="module")
def one_schedule():
    """The finding of an explorer that one schedule of four makes wrong."""
    return check(f"{EXPLORERS / 'wrong.py'}:one_schedule", schedules="all", edges=1).findings[0]


def test_a_finding_survives_its_json(finding):
    document = finding.to_json()
    again = Finding.from_json(json.dumps(document))
    assert again.to_json() == document
    assert again.key == finding.key


def test_a_checkpoint_before_the_first_step_is_told(finding):
    assert "step" not in finding.to_json()
    at_once = replace(finding, step=0)
    assert at_once.to_json()["step"] == 0
    assert Finding.from_json(at_once.to_json()).step == 0


def test_the_findings_of_all_numberings_are_one_finding():
    map_ = named_map("k4")
    findings = set()
    for names in ([*range(12)], [*reversed(range(12))], [(5 * d + 3) % 12 for d in range(12)]):
        world = World(map_, Directional(map_.turn(0, 2))).relabelled(names)
        canonical = canonical_world(world)
        assert canonical.start == 0
        assert place_of(canonical) == place_of(world) == 2
        findings.add(canonical)
    assert len(findings) == 1


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"version": 1}, "of version 1; this program reads 2"),
        ({"explorer": 3}, "3"),
        ({"law": "luck"}, "luck"),
        ({"world": []}, r"\[\]"),
        ({"options": []}, "options"),
        ({"options": {"policy": 3}}, "policy"),
        ({"options": {"policy": "nonsense"}}, "nonsense"),
        ({"options": {"bound": "n +"}}, "n +"),
        ({"options": {"laws": "map"}}, "map"),
        ({"options": {"step_budget": True}}, "True"),
        ({"choices": [-1]}, "-1"),
        ({"choices": [True]}, "True"),
        ({"transcript": []}, "transcript"),
    ],
)
def test_a_document_that_is_no_finding_is_refused(finding, change, named):
    with pytest.raises(InputError, match=named):
        Finding.from_json({**finding.to_json(), **change})


def test_choices_before_an_error_are_recorded():
    def explore(first, choices):
        choices.pick("abc", of="edge")
        raise ValueError
        yield

    assert check(explore, edges=1, policy="lifo").findings[0].choices == (2,)


def test_the_recorded_choices_are_honoured(one_schedule, wrong):
    again = replay(Finding.from_json(one_schedule.to_json()))
    assert (again.outcome, again.again.outcome.choices) == ("reproduced", (1, 0))
    assert replay(one_schedule, wrong("right")).outcome == "fixed"
    assert replay(one_schedule, algorithm).exit_code == 5


def test_choices_of_an_explorer_that_takes_none_are_refused_unless_it_is_named(wrong):
    finding = check(wrong("everywhere"), edges=1).findings[0]
    assert replay(finding).notice == ""
    finding = replace(finding, choices=(0, 0))
    with pytest.raises(InputError, match=r"\[0, 0\], but .*:everywhere takes no choices"):
        replay(finding)
    named = replay(finding, wrong("everywhere"))
    assert named.outcome == "reproduced"
    assert "none was asked for" in named.notice


def test_a_report_of_one_run_is_a_finding_too(finding):
    report = run(lambda first: (yield from lazy(first)), finding.world).to_json()
    assert Finding.from_json(report).key == finding.key


@pytest.mark.processes
@pytest.mark.early
@pytest.mark.processes
def test_all_zero_choices_are_told_where_another_policy_would_choose_otherwise(wrong, clock):
    world = next(worlds(edges=1))
    told = run(
        wrong("hang_after_choices"), world, policy="lifo", choices=[0, 0], answer_timeout=PATIENCE
    )
    assert told.finding.choices == (0, 0)
    assert "--choices 0,0" in told.finding.reproduce


@pytest.mark.parametrize("key", ["expected", "seen"])
def test_a_value_of_a_finding_that_is_none_is_named(key):
    (finding,) = check("allworlds.corpus.explorers:pose_lost", edges=2).findings
    document = finding.to_json() | {key: [1]}
    said = rf"{key} is a rooted map, an integer or a text, not \[1\]"
    with pytest.raises(InputError, match=said):
        Finding.from_json(json.dumps(document))


HUGE = 10**5000  # more digits than Python turns into text


@pytest.mark.parametrize(
    ("shown", "kept"),
    [
        (Checkpoint((0, 1), (1, 0), HUGE), ((0, 1), (1, 0), 0)),
        (Checkpoint((HUGE, 1), (1, 0), 0), ((), (), 0)),
        (Checkpoint((0, 1), (-1, 0), 1), ((), (), 1)),
    ],
)
def test_a_checkpoint_with_what_is_no_dart_is_a_finding_that_can_be_written(shown, kept):
    def explore(first):
        yield shown
        return (yield from algorithm1(first))

    (finding,) = check(explore, edges=1).findings
    assert finding.law == "invariant-1"
    again = Finding.from_json(json.dumps(finding.to_json()))
    assert (again.believed.sigma, again.believed.alpha, again.believed.here) == kept


@pytest.mark.parametrize("value", ["text", "", 0, -3])
def test_what_was_expected_may_be_a_text_or_a_number(finding, value):
    again = Finding.from_json(finding.to_json() | {"expected": value, "seen": value})
    assert (again.expected, again.seen) == (value, value)


@pytest.mark.parametrize("value", [1.5, None, [1]])
def test_what_was_expected_is_nothing_else(finding, value):
    with pytest.raises(InputError, match=r"^expected is a rooted map, an integer or a text, not "):
        Finding.from_json(finding.to_json() | {"expected": value})


def test_a_report_of_another_schema_is_refused_by_its_number(finding):
    report = {"schema": 1, "findings": [finding.to_json()]}
    with pytest.raises(InputError, match=r"^report of schema 1; this program reads 2$"):
        Finding.from_json(report)
