"""The effect of deleting, contracting and moving on the counts of a map."""

from hypothesis import find
from hypothesis.strategies import integers, tuples

from allworlds.maps import contracted, deleted
from allworlds.strategies import maps
from laws.test_surgery import MANY


def test_deleting_is_not_contracting():
    def differ(pair):
        map_, dart = pair
        dart %= len(map_.sigma)
        less, other = deleted(map_, dart), contracted(map_, dart)
        return less is not None and other is not None and less.genus != other.genus

    map_, _ = find(tuples(maps(), integers(0, 11)), differ, settings=MANY)
    assert map_.genus == 1
