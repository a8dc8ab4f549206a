"""The draws of a sample: waves, batches and their random worlds."""

from collections.abc import Iterator
from contextlib import suppress
from itertools import count
from random import Random

from msgspec import Struct
from msgspec.structs import replace

from allworlds.engines.units import Sample
from allworlds.inputs.checks import InputError, show
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap
from allworlds.maps.mixture import HISTORIES, default_mix, generator, rerooted
from allworlds.notations.given import Placed
from allworlds.world.lighthouses.base import Lighthouse

RUNS_PER_BATCH = 8
"""The runs that one worker does at a time."""

RUNS_OF_FIRST_WAVE = 16
"""The runs of the first wave.  A wrong explorer in a world with 50 edges may go on until its budget
of some 500,000 traversals: 64 draws with 40 to 60 edges took more than six minutes of a processor.
"""

REJECTED_BEFORE_HISTORIES = 100
"""The number of maps of one part that are rejected before histories are used."""

REJECTED_BEFORE_REFUSAL = 2000
"""The number of maps that are rejected before a condition is refused."""


def waves(runs: int) -> Iterator[tuple[int, int]]:
    """The first run of each wave, and the first of the next: 0, 16, 64, 256, ..."""
    begin = 0
    while begin < runs:
        end = min(max(RUNS_OF_FIRST_WAVE, 4 * begin), runs)
        yield begin, end
        begin = end


def batches(sample: Sample, begin: int = 0, end: int | None = None) -> "Iterator[Batch]":
    """These runs of the sample in pieces, or the part of its shard: every so manieth piece.

    They do not depend on the number of workers or shards.

    Args:
        sample: the whole, or the part of a shard.
        begin: the first run, the first one of a piece.
        end: the run after the last one; by default all.
    """
    end, portion = sample.runs if end is None else end, sample.portion
    for first in range(begin, end, RUNS_PER_BATCH):
        if first // RUNS_PER_BATCH % portion.count == portion.index:
            last = min(first + RUNS_PER_BATCH, end)
            yield Batch(sample.seed, first, last, sample.mix, sample.min_edges)


SMALL, SMALL_RUNS = 4, 8
"""The edges, and the number, of the worlds that are tried before the sample."""


class SmallBatch(Struct, frozen=True):
    """Small worlds of the mixture, whatever the least number of edges is; none if there are none.

    Who walks for ever is found there with some hundred traversals.
    """

    seed: int
    mix: tuple[str, ...]

    @property
    def key(self) -> str:
        """Key in a run directory: ``SEED/small``."""
        return f"{self.seed}/small"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """One world a run, as of a batch."""
        small = replace(extent, edges=min(SMALL, extent.levels[-1]))
        with suppress(InputError):  # the condition may admit none
            yield from Batch(self.seed, 0, SMALL_RUNS, self.mix).placed(small, kind)


class Batch(Struct, frozen=True):
    """The runs ``first .. last - 1`` of the sample with that seed and least number of edges."""

    seed: int
    first: int
    last: int
    mix: tuple[str, ...]
    min_edges: int = 1

    @property
    def key(self) -> str:
        """Key of the batch in a run directory: ``SEED/FIRST``."""
        return f"{self.seed}/{self.first}"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[Placed]:
        """One world a run: a random map with a random place of the lighthouse.

        The parts of the mixture come in turn, and each has a sequence of its own: it is the same
        whatever else there is in the mixture.  A map that is not of the extent, or is too small, is
        drawn again; a part that brings none for long gives way to random histories of the class.
        """
        mix = self.mix or default_mix(extent)
        for run in range(self.first, self.last):
            turn, at = divmod(run, len(mix))
            number = turn * mix.count(mix[at]) + mix[:at].count(mix[at])
            random = Random(f"{mix[at]}/{self.seed}/{number}")  # noqa: S311  # reproducible
            map_ = self._drawn(extent, mix[at], random)
            places = list(enumerate(kind.places(map_, 0)))
            yield map_, [random.choice(places)] if places else []

    def _drawn(self, extent: Extent, part: str, random: Random) -> CombinatorialMap:
        """A map of the extent; by a history where the part brings none for long.

        Raises:
            InputError: if histories bring none for long that the condition admits.
        """
        generators = generator(part, extent), generator(HISTORIES, extent)
        size = random.randint(self.min_edges, extent.levels[-1])
        for tries in count():
            map_ = rerooted(generators[tries >= REJECTED_BEFORE_HISTORIES](size, random), random)
            large = map_.edge_count >= self.min_edges
            if large and extent.map_class.includes(map_) and extent.admits(map_):
                return map_
            if extent.where is not None:
                if tries == REJECTED_BEFORE_REFUSAL:
                    break
                size = random.randint(self.min_edges, extent.levels[-1])
        assert extent.where is not None
        raise InputError(
            f"where {show(extent.where.name)}: {tries + 1} maps of the class {extent.map_class} "
            f"with {self.min_edges} to {extent.levels[-1]} edges were drawn, and it is true of "
            "none; legal is one that is true of more of them"
        )
