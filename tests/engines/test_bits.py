from numba import njit

from allworlds.engines.kernel.compiling import highest, lowest, size


@njit
def compiled(mask):
    return lowest(mask), highest(mask), size(mask)


def test_sets_have_a_least_and_a_greatest_element_and_a_size():
    for mask in [*range(1, 300), 1 << 40, (1 << 40) + 5, (1 << 62) + (1 << 61)]:
        elements = [i for i in range(63) if mask >> i & 1]
        assert compiled(mask) == (elements[0], elements[-1], len(elements))
