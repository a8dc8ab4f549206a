import pytest

from allworlds.checker import check, replay, run
from allworlds.counter import count
from allworlds.maps.build import named_map
from allworlds.reports import check_text, count_text, finding_text, replay_text, run_text
from allworlds.world import Directional, World


def lazy(first):
    from allworlds.explorers import algorithm1

    answer = yield from algorithm1(first)
    return answer if first.degree != 2 else None


def single_edge(first):
    from allworlds import CombinatorialMap, Estimate

    return Estimate(CombinatorialMap((0, 1), (1, 0)), 0)
    yield


def texts():
    options = {"engine": "python", "edges": 2}
    for explore in (
        "algorithm1",
        lambda f: (yield from lazy(f)),
        lambda f: (yield from single_edge(f)),
    ):
        report = check(explore, **options)
        yield lambda width, report=report: check_text(report, width)
        for finding in report.findings:
            yield lambda width, finding=finding: finding_text(finding, width)
            again = replay(finding, explore)
            yield lambda width, again=again: replay_text(again, width)
            fixed = replay(finding, "algorithm1")
            yield lambda width, fixed=fixed: replay_text(fixed, width)
    every = check("algorithm1", schedules="all", **options)
    yield lambda width: check_text(every, width)
    stopped = check("algorithm1", engine="python", edges=8, time_limit=0.5)
    yield lambda width: check_text(stopped, width)
    shard = check("algorithm1", shard=(1, 2), **options)
    yield lambda width: check_text(shard, width)
    for name in ("k4", "theta-torus"):
        told = run("algorithm1", World(named_map(name), Directional(0)))
        yield lambda width, told=told: run_text(told, width)
    yield lambda width: count_text(count(edges=3), width)


@pytest.fixture(scope="module")
def every_text():
    return list(texts())


@pytest.mark.parametrize("width", [40, 100, 200])
def test_no_line_ends_with_blanks(every_text, width):
    for text in every_text:
        for line in text(width).splitlines():
            assert line == line.rstrip(), repr(line)


def test_the_text_says_what_was_checked():
    text = check_text(check("algorithm1", engine="python", edges=2), 100)
    assert "HOLDS" in text
    assert "12 worlds, 30 runs" in text
    for law in ("map", "pose", "invariant-1", "variant", "folding", "bound (paper)"):
        assert law in text
    assert "at most 2 edges" in text
    assert "log-series of permutations" in text


def test_the_text_of_an_incomplete_check_says_so():
    text = check_text(check("algorithm1", engine="python", edges=8, time_limit=0.5), 100)
    assert "INCONCLUSIVE" in text
    assert "NOT complete" in text


def test_the_text_of_a_shard_defers_the_gate():
    text = check_text(check("algorithm1", engine="python", edges=2, shard=(0, 2)), 100)
    assert "shard 0/2" in text
    assert "deferred to the merge" in text
