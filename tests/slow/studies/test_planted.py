import pytest

from studies.test_planted import options, planted


@pytest.mark.long
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
