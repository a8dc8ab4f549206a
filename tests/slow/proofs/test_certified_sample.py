"""The sample of larger worlds with the kernels, and with the programs that Coq extracts."""

import subprocess
import sys
from itertools import islice
from pathlib import Path

import pytest

from proofs import test_certified_sample as quick

PROGRAM = Path(__file__).parents[3] / "proofs" / "coq" / "certified.py"
pytestmark = pytest.mark.usefixtures("compiled")
samples, kernels = quick.samples, quick.kernels


@pytest.mark.slowest
def test_the_interpreted_kernel_is_the_compiled_one(kernels, samples):
    right = kernels.WrongKernel("right", "", "COST = 0xFFFFF", "COST = 0xFFFFF").walk()
    for policy in samples.POLICIES:
        for piece in islice(kernels.larger_pieces(policy), 100):
            asked = piece.level(policy), piece.unit.prefix
            assert right(*asked) == samples.walk(*asked)


@pytest.mark.slowest
def test_wrong_kernels_that_are_right_in_small_worlds_are_seen_in_the_sample(kernels):
    assert len(kernels.WRONG_KERNELS) == 12
    for wrong in kernels.WRONG_KERNELS:
        assert kernels.seen_in(wrong, kernels.small_pieces()) is None, wrong.name
        assert kernels.seen_in(wrong, kernels.larger_pieces(wrong.policy)), wrong.name


def test_the_most_expensive_worlds_of_a_level_are_found_among_all(samples):
    from random import Random

    found = samples.most_expensive(5, "fifo", Random(1))
    assert {map_.vertex_count for map_ in found} == {1, 2, 3, 4, 5, 6}
    _, case = samples.log_of("", samples.World(found[1]), quick.ALGORITHM1, "fifo")
    rows = [samples.walk(samples.level_asked(5, "fifo"), p) for p in samples.prefixes(5)]
    largest = {}
    for row in rows:
        for counts in row.counts:
            largest[counts.vertices] = max(largest.get(counts.vertices, 0), counts.largest)
    assert len(case.walk) == largest[found[1].vertex_count]


@pytest.mark.slowest
@pytest.mark.skipif(
    not PROGRAM.with_name("runs").exists(),
    reason="not built: make -C proofs/coq explorer",
)
def test_the_extracted_programs_agree_with_the_package_in_a_sample():
    command = [sys.executable, str(PROGRAM), "--sample", "120", "--units", "9"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    assert run.stdout.count("  0 differ\n") == 3
    assert run.stdout.endswith("AGREE\n")
