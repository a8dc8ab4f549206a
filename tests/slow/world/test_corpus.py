import pytest

from small import long
from world import test_corpus as quick
from world.test_corpus import entries


@pytest.mark.no_cover
@pytest.mark.parametrize("most", [long(6)])
@entries("counts")
def test_the_enumeration_gives_the_known_numbers(entry, most):
    quick.test_the_enumeration_gives_the_known_numbers(entry, most)
