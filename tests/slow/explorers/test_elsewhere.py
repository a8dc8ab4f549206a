"""A robot that starts elsewhere, in every world with up to 4 edges, from every start."""

import pytest

import allworlds


@pytest.mark.slowest
def test_the_robot_finds_the_map_from_everywhere_to_four_edges():
    report = allworlds.check("elsewhere:algorithm1", edges=4)
    # Of m edges there are 2, 10, 74, 706 rooted maps (OEIS A000698), each with 2m places.
    assert (report.verdict.value, report.worlds) == ("holds", 2 + 10 + 74 + 706)
    assert report.runs == 2 * 2 + 10 * 4 + 74 * 6 + 706 * 8
    assert (report.scope.lighthouse, report.scope.bound) == (
        "directional:start=any",
        "paper + 8*D**d",
    )


@pytest.mark.slowest
@pytest.mark.parametrize("inside", ["algorithm1-door", "algorithm1-cluster"])
def test_so_do_the_explorers_of_other_lighthouses_to_three_edges(inside):
    assert allworlds.check(f"elsewhere:{inside}", edges=3).verdict.value == "holds"


def test_algorithm_1_alone_is_refuted_and_the_finding_is_replayed():
    report = allworlds.check("algorithm1", edges=2, lighthouse="directional:start=any")
    (finding,) = report.findings[:1]
    assert finding.law == "budget"
    assert finding.world.lighthouse.start == "any"
    again = allworlds.Finding.from_json(finding.to_json())
    assert allworlds.replay(again).outcome == "reproduced"
