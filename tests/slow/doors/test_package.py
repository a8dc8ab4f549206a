"""The files of the package, its metadata, and the modules that it loads."""

import pytest

from doors import test_package as quick


@pytest.mark.parametrize("workers", ["2"])
def test_an_explorer_of_ones_own_is_checked_without_numba_and_z3_in_every_process(
    workers, tmp_path
):
    quick.test_an_explorer_of_ones_own_is_checked_without_numba_and_z3_in_every_process(
        workers, tmp_path
    )
