"""Partition refinement: classes of indistinguishable elements, by Hopcroft's algorithm."""

from __future__ import annotations

from collections.abc import Hashable, Sequence


def coarsest_partition(
    labels: Sequence[Hashable], permutations: Sequence[Sequence[int]]
) -> list[int]:
    """For each element its block in the coarsest partition that the permutations respect.

    Elements of one block have equal labels, and each permutation takes a block into a block.
    Blocks are numbered from 0 in an order that is fixed by the arguments, and has no meaning.

    Args:
        labels: one for each element ``0..n-1``.
        permutations: each of the elements.

    Cost: O(n log n) for each permutation.  Source: Hopcroft 1971 ('process the smaller
    half').
    """
    return _Partition(labels).refined(permutations)


class _Partition:
    """Blocks as intervals of one array: block ``b`` is ``elements[first[b]:past[b]]``."""

    def __init__(self, labels: Sequence[Hashable]) -> None:
        groups: dict[Hashable, list[int]] = {}
        for element, label in enumerate(labels):
            groups.setdefault(label, []).append(element)
        self.elements = [element for group in groups.values() for element in group]
        self.place = [0] * len(labels)
        self.block = [0] * len(labels)
        self.first: list[int] = []
        self.past: list[int] = []
        for place, element in enumerate(self.elements):
            self.place[element] = place
        end = 0
        for number, group in enumerate(groups.values()):
            self.first.append(end)
            end += len(group)
            self.past.append(end)
            for element in group:
                self.block[element] = number

    def refined(self, permutations: Sequence[Sequence[int]]) -> list[int]:
        inverses = [_inverse(permutation) for permutation in permutations]
        # What splits by the largest block splits by the others too.
        sizes = [past - first for first, past in zip(self.first, self.past, strict=True)]
        largest = sizes.index(max(sizes))
        waiting = [block for block in range(len(sizes)) if block != largest]
        while waiting:
            splitter = waiting.pop()
            members = self.elements[self.first[splitter] : self.past[splitter]]
            for inverse in inverses:
                waiting += self.split([inverse[element] for element in members])
        return self.block

    def split(self, chosen: Sequence[int]) -> list[int]:
        """Split every block into its chosen and its other elements; the new blocks.

        The smaller half of a block becomes the new one.  Cost: O(len(chosen)).
        """
        elements, place, block, first = self.elements, self.place, self.block, self.first
        border: dict[int, int] = {}  # the chosen elements of a block lie before its border
        for x in chosen:
            b = block[x]
            here, there = place[x], border.get(b, first[b])
            y = elements[there]
            elements[here], elements[there] = y, x
            place[y], place[x] = here, there
            border[b] = there + 1
        new = []
        for b, middle in border.items():
            start, end = first[b], self.past[b]
            if middle == end:
                continue
            if middle - start <= end - middle:
                first[b], end = middle, middle
            else:
                self.past[b], start = middle, middle
            new.append(len(first))
            for x in elements[start:end]:
                block[x] = len(first)
            first.append(start)
            self.past.append(end)
        return new


def _inverse(permutation: Sequence[int]) -> list[int]:
    inverse = [0] * len(permutation)
    for x, y in enumerate(permutation):
        inverse[y] = x
    return inverse
