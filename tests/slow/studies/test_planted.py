"""Planted slips: the benchmark tells rightly which show, and the mixture finds them."""

import pytest

from allworlds.studies.fuzz.sample_sweep import fuzz
from studies.test_planted import options, planted


@pytest.mark.parametrize(
    ("slip", "part", "size"),
    # The smallest by exhaustion.
    [
        ("a degree of 6", "uniform", (3, 1)),
        ("3 parallel edges", "dense", (3, 2)),
        ("two alike to depth 3", "ring", (1, 2)),
    ],
)
def test_from_50_edges_a_finding_shrinks_to_the_smallest_world(slip, part, size):
    explore = planted.explorer(planted.SLIPS[slip](planted.DepthFirst))
    sample = {"edges": 52, "min_edges": 48, "runs": 1, "mix": [part], "bound": "none"}
    (finding,) = fuzz(explore, **sample).findings
    assert finding.key[:2] == size


@pytest.mark.slowest
def test_most_findings_of_50_edges_and_more_end_at_the_smallest_world():
    sample = options(old=False, edges=60, min_edges=48, runs=64, shrink=3)
    ends = [*planted.shrunk(sample, "depth-first")]
    # Those whose smallest world, by exhaustion, has up to 3 edges.
    assert [slip for slip, *_ in sorted(ends)] == [
        "3 parallel edges",
        "a degree of 6",
        "a second loop at v0",
        "two alike to depth 3",
    ]
    right = sum(size == reached for _, size, reached, *_ in ends)
    assert right >= 0.8 * len(ends)
