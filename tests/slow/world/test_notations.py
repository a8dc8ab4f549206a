"""Files of worlds: what is written is read back, what cannot be told or read is refused by name."""

import pytest

from world.test_notations import growth


@pytest.mark.parametrize("notation", ["planar_code"])
def test_memory_does_not_grow_with_a_file_that_streams(notation, tmp_path):
    assert growth(notation, tmp_path, 100, 1000) < 0.5
