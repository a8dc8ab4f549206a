from numba import njit

from allworlds.engines.kernel.bits import highest, lowest, size


@njit
def compiled(mask):
    return lowest(mask), highest(mask), size(mask)


def test_compiled_and_interpreted_sets_are_the_same():
    for mask in [*range(1, 300), 1 << 40, (1 << 40) + 5, (1 << 62) + (1 << 61)]:
        elements = [i for i in range(63) if mask >> i & 1]
        expected = (elements[0], elements[-1], len(elements))
        assert (lowest(mask), highest(mask), size(mask)) == expected
        assert compiled(mask) == expected
