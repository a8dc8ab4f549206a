"""Functions of the package refuse bad arguments with a line that names them."""

import pytest

import allworlds
import small
from allworlds import strategies
from allworlds.inputs.checks import InputError
from allworlds.world import Directional, World

EDGE = World(small.EDGE, Directional(0))


def check(**options):
    return lambda: allworlds.check(**{"edges": 1, **options})


def fuzz(**options):
    return lambda: allworlds.fuzz(**{"edges": 1, "runs": 1, **options})


def run(**options):
    return lambda: allworlds.run("algorithm1", EDGE, **options)


def search(**options):
    least = {"lighthouse": "position", "vertices": 1, "edges": 1}
    return lambda: allworlds.search(**{**least, **options})


BAD = [
    (check(edges="3"), "edges = '3'"),
    (check(edges=2.0), "edges = 2.0"),
    (check(edges=True), "edges = True"),
    (check(vertices="2"), "vertices = '2'"),
    (check(map_class=None), "class None"),
    (check(lighthouse=3), "lighthouse = 3"),
    (check(policy=3), "policy = 3"),
    (check(policy=""), "policy ''"),
    (check(schedules=[]), "schedules []"),
    (check(bound=""), "bound ''"),
    (check(bound=2.0), "bound = 2.0"),
    (check(bound=False), "bound = False"),
    (check(bound=2, laws=["map"]), "bound '2' has no effect"),
    (check(laws=()), "laws = ()"),
    (check(laws=[3]), "law 3"),
    (check(laws="map"), "laws = 'map'"),
    (check(laws=3), "laws = 3"),
    (check(laws=[[]]), "law []"),
    (check(step_budget="5"), "step_budget = '5'"),
    (check(shard="0/1"), "shard = '0/1'"),
    (check(shard=3), "shard = 3"),
    (check(shard=(0, True)), "shard N = True"),
    (check(workers="2"), "workers = '2'"),
    (check(workers=1.5), "workers = 1.5"),
    (check(workers=None), "workers = None"),
    (check(answer_timeout="1"), "answer-timeout = '1'"),
    (check(time_limit=True), "time-limit = True"),
    (check(memory=0.5), "memory = 0.5"),
    (check(max_findings=2.5), "max-findings = 2.5"),
    (check(engine=3), "engine 3"),
    (check(corpus=""), "corpus = ''"),
    (check(corpus=3), "corpus = 3"),
    (fuzz(edges="3"), "edges = '3'"),
    (fuzz(runs=1.0), "runs = 1.0"),
    (fuzz(seed="x"), "seed = 'x'"),
    (fuzz(bound=""), "bound ''"),
    (run(bound=""), "bound ''"),
    (run(laws=()), "laws = ()"),
    (run(choices="0"), "choices = '0'"),
    (run(choices=[0.0]), "choices[0] = 0.0"),
    (run(choices=3), "choices = 3"),
    (lambda: allworlds.run("algorithm1", "teta"), "world 'teta'"),
    (lambda: allworlds.worlds(edges="3"), "edges = '3'"),
    (lambda: allworlds.worlds(edges=1, places="some"), "places 'some'"),
    (lambda: allworlds.count(edges="3"), "edges = '3'"),
    (lambda: allworlds.count(edges=True), "edges = True"),
    (lambda: allworlds.worst(edges=2.0), "edges = 2.0"),
    (lambda: allworlds.worst(edges=1, workers="2"), "workers = '2'"),
    (lambda: allworlds.worst(edges=1, transit=""), "transit ''"),
    (lambda: allworlds.replay("finding.json"), "finding = 'finding.json'"),
    (lambda: allworlds.explain(None), "finding = None"),
    (lambda: allworlds.twins(EDGE, 4), "world = 4 is no World"),
    (lambda: allworlds.twins("k4", "k7"), "world 'k7'"),
    (lambda: allworlds.ambiguity.class_of(4), "world = 4 is no World"),
    (lambda: allworlds.ambiguity.class_of(EDGE, limit="9"), "limit = '9'"),
    (lambda: allworlds.ambiguity.census(edges=1.0), "edges = 1.0"),
    (search(lighthouse=3), "lighthouse 3"),
    (search(edges="1"), "edges = '1'"),
    (search(degree_marked=1.0), "degree-marked = 1.0"),
    (search(motions="1"), "motions = '1'"),
    (search(motions=[1.0], percepts=["1A"]), "motion = 1.0"),
    (search(motions=[1], percepts=[1]), "percept = 1"),
    (search(solver=""), "solver = ''"),
    (search(out=""), "out = ''"),
    (search(time_limit="1"), "time-limit = '1'"),
    (lambda: strategies.maps(max_edges="3"), "max_edges = '3'"),
]


@pytest.mark.parametrize(("call", "named"), BAD, ids=[named for _, named in BAD])
def test_a_bad_argument_is_refused_by_name(call, named):
    with pytest.raises(InputError) as refusal:
        call()
    assert named in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_an_integer_is_a_bound():
    report = allworlds.check("algorithm1", edges=2, bound=1)
    assert (report.verdict, report.findings[0].law) == ("refuted", "bound")
    assert report.asked.rules.the_bound.name == "1"
    assert allworlds.run("algorithm1", EDGE, bound=1).finding is None
    assert allworlds.run("algorithm1", EDGE, bound=-1).finding.law == "bound"


def test_what_counts_as_an_integer_is_one():
    import numpy as np

    assert allworlds.count(edges=np.int64(2)).to_json() == allworlds.count(edges=2).to_json()
