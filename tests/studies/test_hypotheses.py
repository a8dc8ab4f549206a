"""The hypotheses that are heard in a run, held against the world."""

import pytest

from allworlds import run, worlds
from allworlds.document.struct import replace
from allworlds.judging.findings.walks import true_trail
from allworlds.protocol.actions import Percept
from allworlds.studies.check.exhaustive import check
from allworlds.studies.run.hypotheses import TELLING, hypotheses_in

LIGHTHOUSES = dict(zip(TELLING, ("directional", "cluster:single=true", "natural"), strict=True))


def runs(explorer, edges, **options):
    for world in worlds(edges=edges, lighthouse=LIGHTHOUSES[explorer]):
        yield run(explorer, world, **options)


@pytest.mark.parametrize(
    ("explorer", "edges"),
    [("algorithm1", 3), ("algorithm1-cluster", 3)],
)
def test_a_hypothesis_is_right_just_where_it_is_true(explorer, edges):
    right = wrong = 0
    # Where an explorer gets a world wrong, which natural lighthouses allow, nothing is promised.
    for told in (one for one in runs(explorer, edges) if one.finding is None):
        map_ = told.world.map
        trail = true_trail(told.world, told.outcome.episode.transcript)
        for test in hypotheses_in(told):
            # What is supposed at the beginning is so if and only if the test ends well.
            assert (test.supposed[0] == trail[test.first]) is test.right
            assert map_.degree_at[test.supposed[0]] == map_.degree_at[trail[test.first]]
            if test.right:
                assert test.supposed == tuple(trail[test.first : test.last + 1])
            right += test.right
            wrong += not test.right
    assert right > 10
    assert wrong or explorer == "algorithm1-natural"


def test_they_are_as_many_as_a_check_has_witnesses():
    heard = [
        test.right
        for world in worlds(edges=3, places="all")
        for test in hypotheses_in(run("algorithm1", world))
    ]
    seen = check(edges=3).to_json()["witnesses"]
    assert sum(heard) == seen["case-3"]
    assert len(heard) - sum(heard) == seen.get("case-1", 0) + seen.get("case-2", 0)


def test_on_the_way_what_is_supposed_would_be_sensed_so_up_to_the_last_step():
    seen = 0
    for told in runs("algorithm1", 3):
        percepts = told.outcome.episode.transcript.percepts
        for test in hypotheses_in(told):
            for step in range(test.first + 1, test.last):
                expected = told.world.percepts[test.supposed[step - test.first]]
                assert expected == percepts[step]
                seen += 1
            if not test.right and test.last > test.first:
                assert told.world.percepts[test.supposed[-1]] != percepts[test.last]
    assert seen


def test_where_s_has_gone_wrong_nothing_is_told_of_it():
    runs_of = [run("algorithm1-cluster", w) for w in worlds(edges=3, lighthouse="cluster")]
    wrong = [told for told in runs_of if told.finding]
    assert wrong
    for told in wrong:
        assert len(hypotheses_in(told)) < 10


def test_an_explorer_that_does_not_tell_has_none_and_neither_has_one_that_walks_otherwise():
    assert hypotheses_in(run("folding", "k4-torus")) == ()
    told = run("algorithm1", "k4-torus")
    assert hypotheses_in(told)
    episode = told.outcome.episode
    (action, percept), *steps = episode.transcript.steps
    other = Percept(percept.degree + 1, percept.marks, percept.bearing)
    tampered = replace(episode.transcript, steps=((action, other), *steps))
    outcome = replace(told.outcome, episode=replace(episode, transcript=tampered))
    assert hypotheses_in(replace(told, outcome=outcome)) == ()


def test_other_schedules_are_heard_as_they_were_chosen():
    for policy in ("lifo", "nearest", "random:3"):
        told = run("algorithm1", "k4-torus", policy=policy)
        trail = true_trail(told.world, told.outcome.episode.transcript)
        tests = hypotheses_in(told)
        assert tests
        for test in tests:
            assert (test.supposed[0] == trail[test.first]) is test.right
