"""The draws of a sample, which are random worlds, in batches and in waves.

A *batch* is some runs that one worker does at a time.  A *wave* is several batches; after a wave
with a finding the search ends.  The *mixture* has several parts; each part is one way to draw a
random map.  The part ``histories`` makes a map edge by edge, as the enumeration of all maps of a
class does, with a random choice at each step; so its maps are in the class.
"""

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
from allworlds.notations.given import MapWithPlaces
from allworlds.world.lighthouses.base import Lighthouse

RUNS_PER_BATCH = 8
"""The number of runs that a worker does at a time."""

RUNS_OF_FIRST_WAVE = 16
"""The number of runs in the first wave.  It is small, since a wrong explorer in a world of 50 edges
may use all of its some 500,000 traversals: 64 draws with 40 to 60 edges took over six minutes.
"""

REJECTED_BEFORE_HISTORIES = 100
"""The number of rejected maps after which the part ``histories`` draws in place of another part."""

REJECTED_BEFORE_REFUSAL = 2000
"""The number of rejected maps after which the condition of a request is refused."""


def waves(runs: int) -> Iterator[tuple[int, int]]:
    """Yield the waves of a sample of ``runs`` runs, which have the numbers 0, 1, 2, ...

    A wave is a pair: the number of its first run, and the number of the run after its last one.
    The first waves are (0, 16) and (16, 64); each later wave has three times as many runs as all
    waves before it together, except the last wave, which ends with the sample.
    """
    begin = 0
    while begin < runs:
        end = min(max(RUNS_OF_FIRST_WAVE, 4 * begin), runs)
        yield begin, end
        begin = end


def batches(sample: Sample, begin: int = 0, end: int | None = None) -> "Iterator[Batch]":
    """Yield the batches of a sample; shard i of k has the batches i, i + k, i + 2k, ...

    The sample is cut into the same batches for every number of workers and of shards.

    Args:
        sample: the sample; its field ``portion`` is the shard whose batches are yielded.
        begin: the number of the first run; it must be a multiple of :data:`RUNS_PER_BATCH`.
        end: the number of the run after the last one; None stands for the end of the sample.
    """
    end, portion = sample.runs if end is None else end, sample.portion
    for first in range(begin, end, RUNS_PER_BATCH):
        if first // RUNS_PER_BATCH % portion.count == portion.index:
            last = min(first + RUNS_PER_BATCH, end)
            yield Batch(sample.seed, first, last, sample.mix, sample.min_edges)


SMALL, SMALL_RUNS = 4, 8
"""Of the small worlds that are tried before a sample: the most edges, and the number of runs."""


class SmallBatch(Struct, frozen=True):
    """The batch of small random worlds that is tried before a sample, in shard 0 alone.

    The batch shows whether the explorer walks for ever: a small world shows this after some hundred
    traversals, a large one after many more.  The small worlds may have fewer edges than the
    sample's ``min_edges``.  ``seed`` and ``mix`` are those of the sample.
    """

    seed: int
    mix: tuple[str, ...]

    @property
    def key(self) -> str:
        """The key under which a run directory keeps the batch: the seed, and ``small``."""
        return f"{self.seed}/small"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """Yield for each run a random map with few edges, and a random place of the lighthouse.

        There are :data:`SMALL_RUNS` runs.  The maps have at most :data:`SMALL` edges.  Apart from
        this, the maps, the items and the parameters are those of :meth:`Batch.placed`.  If no map
        for a run is found, because the condition of ``extent`` is true of too few small maps, this
        method ends without an error; nothing is yielded for this run and for later ones.
        """
        small = replace(extent, edges=min(SMALL, extent.levels[-1]))
        with suppress(InputError):  # the condition may admit none
            yield from Batch(self.seed, 0, SMALL_RUNS, self.mix).placed(small, kind)


class Batch(Struct, frozen=True):
    """The runs from ``first`` to ``last - 1`` of a sample.

    ``seed``, ``mix`` and ``min_edges`` are those of the sample: its seed, the parts of the mixture
    that take turns, and the least number of edges.
    """

    seed: int
    first: int
    last: int
    mix: tuple[str, ...]
    min_edges: int = 1

    @property
    def key(self) -> str:
        """The key under which a run directory keeps the batch: seed and number of the first run."""
        return f"{self.seed}/{self.first}"

    def placed(self, extent: Extent, kind: type[Lighthouse]) -> Iterator[MapWithPlaces]:
        """Yield for each run a random map, and a list with a random place of the lighthouse.

        An item is a pair: the map, and a list.  The list has one entry, which is also a pair: the
        number of the place, and the lighthouse at this place.  If the map has no place, the list is
        empty.

        The parts of the mixture take turns.  Each part has its own sequence of random maps, which
        does not depend on the other parts.  A map is rejected, and another one is drawn, if the map
        is too small, is not in the class or does not satisfy the condition.  After
        :data:`REJECTED_BEFORE_HISTORIES` rejected maps for a run, the part ``histories`` draws for
        this run; its maps are rejected, too, if they do not satisfy the condition.

        Args:
            extent: the class, the condition and the largest number of edges of the maps.
            kind: the kind of the lighthouse.

        Raises:
            InputError: if the condition is true of too few maps; see :meth:`_drawn`.
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
        """A random map of the class, with at least ``min_edges`` edges, that meets the condition.

        A drawn map is rejected, and another map is drawn, if the map is too small, is not in the
        class or fails the condition.  After :data:`REJECTED_BEFORE_HISTORIES` rejected maps the
        part ``histories`` draws in place of ``part``.  Every map of ``histories`` is in the class
        and has enough edges, so only the condition can reject it.

        Args:
            extent: the class, the condition and the largest number of edges.
            part: the name of a part of the mixture, which is a way to draw a random map.
            random: the source of the random numbers.

        Raises:
            InputError: if ``extent`` has a condition, and more than :data:`REJECTED_BEFORE_REFUSAL`
                maps were rejected.
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
            f"where {show(extent.where.name)}: {tries + 1} maps of the class '{extent.map_class}' "
            f"with {self.min_edges} to {extent.levels[-1]} edges were drawn, and the condition is "
            "true of none; legal is a condition that is true of more maps"
        )
