"""The weakest sensors: the coarsenings of a finest sensor that suffice and are minimal.

At each dart the finest sensor shows the degree and one *feature*; a percept has the number of the
feature as its marks.  A coarsening is a sensor that shows one letter for several features.  A
coarsening suffices if no two worlds with different rooted maps look alike under it.  A coarsening
is minimal if no coarser one suffices.
"""

from collections.abc import Iterator, Sequence
from dataclasses import KW_ONLY, dataclass
from typing import Annotated, Any, NamedTuple, TypeAlias

from typing_extensions import override

from allworlds.documents import document as doc
from allworlds.documents.report import Report
from allworlds.inputs import checks, requests
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.protocol.actions import Percept
from allworlds.studies.ambiguity import sensed_classes as many
from allworlds.studies.ambiguity.members import ensure_motions_decide
from allworlds.studies.ambiguity.side_by_side import AlikePair, ManyWorldsOptions, worlds_of_level
from allworlds.studies.scopes import FileDigests, GivenCount, as_scope
from allworlds.world.lighthouses import base, kinds
from allworlds.world.selection import tried_kind
from allworlds.world.world import World

MOST_FEATURES = 8
"""The most features of a finest sensor: eight features have 4,140 coarsenings, nine have 21,147."""

SHAPE = 'a lighthouse whose marks are numbers of its features, as in features = ("away", "door")'

Letters: TypeAlias = tuple[int, ...]
"""A coarsening: for each feature the letter that a robot senses in its place.

Letters are the numbers 0, 1, ... in the order of their first occurrence.
"""


class WeakestRequest(ManyWorldsOptions, kw_only=False):
    """Request of ``ambiguity weakest``: a sensor whose coarsenings are compared, and the worlds.

    The sensor in the request is the finest one.  A coarsening shows one letter for several of its
    features.
    """

    finest: Annotated[kinds.GivenLighthouse, requests.Argument("", "FILE.py:Finest", f"{SHAPE}.")]
    _: KW_ONLY


Blocks: TypeAlias = Annotated[
    doc.Some[doc.Some[doc.Text]], doc.about("the features, those of one letter together")
]


class RefutedSensor(doc.Document):
    """A coarsening that does not suffice: two worlds with different rooted maps look alike."""

    letters: Blocks
    edges: Annotated[doc.Positive, doc.about("of the larger of the two worlds")]
    twins: Annotated[AlikePair, doc.about("two worlds that look alike")]


class MinimalSensor(doc.Document):
    """A coarsening that suffices, while no coarser one suffices.

    If two letters of this coarsening are merged into one, the result is a coarser sensor, which is
    listed in ``refuted``.  ``below`` has the index, from 0 on, of each such sensor in ``refuted``.
    """

    letters: Blocks
    below: Annotated[
        tuple[doc.Natural, ...],
        doc.about("the numbers in `refuted` of those in which two of its letters are one"),
    ]


@doc.with_options(ManyWorldsOptions)
class WeakestScope(doc.Document):
    """The scope of a search for the weakest sensors."""

    finest: Annotated[doc.Text, doc.about("the finest sensor")]
    given: GivenCount
    sha256: FileDigests


class AmbiguityWeakest(Report, kw_only=True):
    """Report of 'ambiguity weakest'.

    All coarsenings of a finest sensor, compared in the same worlds.  A coarsening shows one letter
    in place of several features of the finest sensor.  It suffices if no two worlds with different
    rooted maps look alike under it.

    A coarsening is compared first in the worlds that refuted earlier coarsenings.  If these worlds
    do not refute it, it is compared in all worlds; ``tried`` counts the coarsenings for which this
    was done.
    """

    scope: WeakestScope
    features: Annotated[doc.Some[doc.Text], doc.about("what the finest sensor tells apart")]
    coarsenings: Annotated[doc.Positive, doc.about("the partitions of the features")]
    sufficient: Annotated[doc.Natural, doc.about("how many of them suffice in the scope")]
    tried: Annotated[
        doc.Natural, doc.about("how many were looked at in every world, until two looked alike")
    ]
    minimal: Annotated[
        tuple[MinimalSensor, ...], doc.about("the minimal ones that suffice, fewest letters first")
    ]
    refuted: Annotated[tuple[RefutedSensor, ...], doc.about("their lower neighbours")]
    extent: doc.NotInDocument[Extent]


@dataclass(frozen=True)
class Coarser(base.Lighthouse):
    """A coarser sensor: a robot senses letters in place of the features of the finest sensor.

    Attributes:
        finest: the lighthouse of the finest sensor, at its place.
        letters: the letter of each feature; several features can have the same letter.  Features
            are what the finest sensor shows at darts besides the degree.
    """

    finest: base.Lighthouse
    letters: Letters

    kind = "coarser"

    @classmethod
    def places(cls, map_: CombinatorialMap, start: Dart) -> Iterator[base.Lighthouse]:  # noqa: ARG003
        """Yield nothing: a coarser sensor is made from a placed lighthouse of the finest sensor."""
        yield from ()

    @override
    def check(self, map_: CombinatorialMap, start: Dart) -> None:
        self.finest.check(map_, start)

    @override
    def sensed(self, map_: CombinatorialMap, here: Dart) -> Percept:
        percept = self.finest.sensed(map_, here)
        return Percept(percept.degree, self.letters[percept.marks])


class FinestLevel(NamedTuple):
    """The worlds with one number of edges, under the finest sensor.

    Attributes:
        worlds: the rooted maps, each once for every place of the lighthouse.
        arrays: the same worlds as arrays; the percepts in these arrays have only the degree.
        features: for each dart the number of the feature that the finest sensor shows there.
        roots: for each world the number of its rooted map: equal numbers mean equal rooted maps.
    """

    worlds: list[many.LitMap]
    arrays: many.SensedWorlds
    features: many.Matrix
    roots: list[int]

    def looks(self, letters: Letters, indices: Sequence[int]) -> Iterator[bytes]:
        """Yield a code for each of the worlds with these indices.

        Two worlds have equal codes if and only if they look alike to a robot that senses by the
        coarsening with these letters.
        """
        import numpy as np

        some = self.arrays.chosen(indices)
        sensed = np.array(letters)[self.features[indices]] << many.BITS | some.sensed
        coarser = some._replace(sensed=sensed)
        return many.rooted_codes(coarser, many.classes(coarser), np.zeros(len(indices), np.int64))


WorldAt: TypeAlias = tuple[int, int]
"""A world, as the index of its level and its index in that level."""


def partitions(count: int) -> list[Letters]:
    """Every coarsening of a sensor with ``count`` features, ascending by number of letters."""
    found: list[Letters] = [()]
    for _ in range(count):
        found = [(*one, letter) for one in found for letter in range(max(one, default=-1) + 2)]
    return sorted(found, key=lambda letters: (max(letters), letters))


def lower(letters: Letters) -> list[Letters]:
    """The next coarser coarsenings: each merges two letters of this coarsening into one.

    This coarsening is ``letters``; see :data:`Letters`.
    """
    count, found = max(letters) + 1, list[Letters]()
    for other in range(count):
        for one in range(other):
            names: dict[int, int] = {}
            joined = (one if letter == other else letter for letter in letters)
            found.append(tuple(names.setdefault(letter, len(names)) for letter in joined))
    return found


class Refuter:
    """A search for two worlds with different rooted maps that look alike under a coarsening.

    Such worlds refute the coarsening: it does not suffice.  The worlds that refuted earlier
    coarsenings are tried first, then all worlds.

    Args:
        levels: all worlds under the finest sensor.

    Attributes:
        tried: the number of coarsenings for which all worlds were tried.
        pairs: the pairs of worlds that have refuted a coarsening.
    """

    def __init__(self, levels: Sequence[FinestLevel]) -> None:
        self.levels, self.tried = levels, 0
        self.pairs = dict[tuple[WorldAt, WorldAt], None]()

    def pair(self, letters: Letters) -> tuple[WorldAt, WorldAt] | None:
        """Return two worlds with different rooted maps that look alike under a coarsening.

        ``letters`` is the coarsening.  A world is returned as two numbers: the index of its level,
        and its index in the level.  Return None if there are no such worlds.
        """
        known = sorted({index for pair in self.pairs for index in pair})
        if pair := self._alike(letters, known):
            return pair
        self.tried += 1
        every = ((i, k) for i, level in enumerate(self.levels) for k in range(len(level.roots)))
        pair = self._alike(letters, [*every])
        if pair:
            self.pairs[pair] = None
        return pair

    def _alike(self, letters: Letters, worlds: Sequence[WorldAt]) -> tuple[WorldAt, WorldAt] | None:
        """The first two of ``worlds`` that look alike and have different rooted maps, or None.

        They look alike to a robot that senses by the coarsening ``letters``.
        """
        first: dict[bytes, WorldAt] = {}
        for i, level in enumerate(self.levels):
            indices = [index for number, index in worlds if number == i]
            for index, look in zip(indices, level.looks(letters, indices), strict=True):
                at, number = first.setdefault(look, (i, index))
                if self.levels[at].roots[number] != level.roots[index]:
                    return (at, number), (i, index)
        return None


@requests.answers(WeakestRequest)
def weakest(request: WeakestRequest) -> AmbiguityWeakest:
    """Find the minimal coarsenings of a finest sensor that suffice.

    Coarsenings are tried from the coarsest on. A coarsening that is finer than a sufficient one
    suffices, too; any other coarsening is tried first in the worlds that refuted earlier ones, and
    then in every world.

    Raises:
        InputError: naming the offending option and what would be legal.

    Cost: some seconds for 200 coarsenings and up to 4 edges.
    """
    kind = request.lighthouse_of_given(tried_kind(request.finest))
    features = _features(kind)
    refuter = Refuter([*_levels(request, kind, len(features))])
    minimal, sufficient, refuted = list[Letters](), set[Letters](), dict[Letters, Any]()
    for letters in (every := partitions(len(features))):
        if any(below in sufficient for below in lower(letters)):
            sufficient.add(letters)
        elif pair := refuter.pair(letters):
            refuted[letters] = pair
        else:
            sufficient.add(letters)
            minimal.append(letters)
    shown = [*dict.fromkeys(below for letters in minimal for below in lower(letters))]

    def blocks(letters: Letters) -> tuple[tuple[str, ...], ...]:
        both = [*zip(letters, features, strict=True)]
        return tuple(tuple(f for of, f in both if of == i) for i in range(max(letters) + 1))

    def refuted_sensor(letters: Letters) -> RefutedSensor:
        found = [refuter.levels[i].worlds[index] for i, index in refuted[letters]]
        worlds = [World(map_, lighthouse, 0) for map_, lighthouse in found]
        coarser = [World(map_, Coarser(lighthouse, letters), 0) for map_, lighthouse in found]
        edges = max(map_.edge_count for map_, _ in found)
        twins = AlikePair.of(worlds, coarser)
        return RefutedSensor(letters=blocks(letters), edges=edges, twins=twins)

    return AmbiguityWeakest(
        scope=as_scope(WeakestScope, request, finest=kind.name),
        features=features,
        coarsenings=len(every),
        sufficient=len(sufficient),
        tried=refuter.tried,
        minimal=tuple(
            MinimalSensor(letters=blocks(one), below=tuple(map(shown.index, lower(one))))
            for one in minimal
        ),
        refuted=tuple(map(refuted_sensor, shown)),
        extent=request.extent,
    )


def _features(kind: kinds.LighthouseKind) -> tuple[str, ...]:
    """The names of the features of a sensor: what a robot can sense at a dart besides the degree.

    Raises:
        InputError: if the sensor has no features, or too many.
    """
    ensure_motions_decide(kind, "sensors are compared by motions alone")
    features: Any = getattr(kind.as_class, "features", None)
    texts = isinstance(features, tuple | list) and all(isinstance(f, str) and f for f in features)
    if not texts or not 1 <= len({*features}) == len(features) <= MOST_FEATURES:
        raise checks.InputError(
            f"{checks.show(str(kind))} has features = {checks.show(features)}; legal is {SHAPE}, "
            f"with up to {MOST_FEATURES} different names"
        )
    return tuple(features)


def _levels(
    request: WeakestRequest, kind: kinds.LighthouseKind, count: int
) -> Iterator[FinestLevel]:
    """Yield the worlds of each level under the finest sensor; a level without worlds is left out.

    Args:
        request: the request, which names the worlds.
        kind: the kind of lighthouse of the finest sensor.
        count: the number of features of this sensor.

    Raises:
        InputError: if a percept has a bearing, or marks that are not the number of a feature; or if
            the lighthouse tells the robot a value before the start (:meth:`Lighthouse.told`).
    """
    import numpy as np

    number: dict[CombinatorialMap, int] = {}
    for edges in request.extent.levels:
        found = worlds_of_level(request, request.extent, edges, kind)
        worlds = [world for some in found for world in some]
        arrays, one = many.matrices(worlds), 1 << many.BITS
        features, bearings = arrays.sensed >> 2 * many.BITS, arrays.sensed >> many.BITS & one - 1
        for index, dart in np.argwhere((bearings > 0) | (features >= count))[:1]:
            odd = worlds[index][1].percepts(worlds[index][0])[dart]
            raise checks.InputError(f"{checks.show(str(kind))} senses {odd}; legal is {SHAPE}")
        if told := [each for each in arrays.told if each is not None]:
            raise checks.InputError(f"{checks.show(str(kind))} tells {told[0]}; legal is {SHAPE}")
        roots = [number.setdefault(map_, len(number)) for map_, _ in worlds]
        if worlds:
            degrees = arrays.sensed & one - 1
            yield FinestLevel(worlds, arrays._replace(sensed=degrees), features, roots)
