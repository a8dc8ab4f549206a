"""The files of the package, its metadata, and the modules that it loads."""

import pytest

from doors.test_package import run_without_heavy_ones


@pytest.mark.slowest
@pytest.mark.parametrize("workers", ["1", "2"])
def test_an_explorer_of_ones_own_is_checked_without_numba_and_z3_in_every_process(
    workers, tmp_path
):
    done = run_without_heavy_ones(
        tmp_path, "check", "mine.py", "--edges", "3", "--workers", workers, "-o", "page.html"
    )
    assert done.returncode == 0, done.stderr
    assert "HOLDS      86 worlds" in done.stdout
    assert "was imported" not in done.stderr
