"""Lighthouses by their names: where each may stand, and what is sensed there, read off as code.

A name is ``KIND[:OPTION,...]``, or several of these with ``+`` between them.  Known are the kinds
of ``KINDS``; a sensor of a user's own is not, and neither is what it shows.  The features of a
finest sensor are known by their names, if all of them are in ``FEATURES``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, product
from typing import Any

from lrat import Refused
from maps import Map, numbering, orbit, vertex_count

Percept = tuple[int, int, Any]
"""What is sensed at a dart: the degree, the marks, and the bearing or None."""

KINDS = ("none", "position", "directional", "door", "word", "compass", "cluster", "natural")
KINDS = (*KINDS, "labels", "told")
AT_V0 = ("position", "directional", "door", "word", "cluster", "natural")
"""Those that stand at one dart."""
COMPASS_TO = 3
"""The edges of the largest maps in which a compass is tried at every place."""
MAY_START_ANYWHERE = ("directional", "door", "cluster")
FEATURES = ("away", "neighbour", "here", "other", "next", "behind", "door")
"""Darts by their place relative to the door: each is the last of these kinds to which it belongs.

away: any; neighbour: at a vertex with an edge to v0; here, other: at v0; next: clockwise after
the door; behind: the other end of the door's edge.
"""


@dataclass(frozen=True)
class Part:
    """One lighthouse: its kind, and its options as a document has them."""

    kind: str
    options: dict[str, Any]

    def places(self, map_: Map, start: int) -> Iterator[dict[str, Any]]:
        """Every place in the map from this start, as a document has it."""
        sigma, around = map_[0], _vertices(map_, start)
        if self.kind in {"none", "told"}:
            yield {}
        elif self.kind == "labels":
            yield {"darts": [vertex[0] for vertex in around]}
        elif self.kind == "compass":
            wanted = None if len(sigma) <= 2 * COMPASS_TO else 1
            for choice in islice(product(*around), wanted):
                yield {"darts": sorted(choice)}
        elif self.kind == "position":
            yield {"dart": start}
        else:
            anywhere = self.options.get("start") == "any"
            for home in [vertex[0] for vertex in around] if anywhere else [start]:
                for dart in orbit(sigma, home):
                    if self._may_stand(map_, home, dart):
                        yield {"dart": dart}

    def _may_stand(self, map_: Map, home: int, dart: int) -> bool:
        sigma, alpha = map_
        here, there = orbit(sigma, home), orbit(sigma, alpha[dart])
        if self.kind == "cluster":
            joining = sum(alpha[each] in there for each in here)
            return alpha[dart] not in here and not (self.options.get("single") and joining > 1)
        if self.kind == "natural":
            degrees = [len(vertex) for vertex in _vertices(map_, home)]
            alone = degrees.count(len(here)) == 1 == degrees.count(len(there))
            first = next(each for each in here if alpha[each] in there)
            return alone and len(here) != len(there) and dart == first
        return True

    def sensed(self, map_: Map, place: dict[str, Any]) -> list[Percept]:
        """For each dart what is sensed there."""
        sigma, alpha = map_
        found: list[Percept] = [(len(orbit(sigma, dart)), 0, None) for dart in range(len(sigma))]
        if self.kind in {"none", "told", "natural"}:
            return found
        if self.kind in {"compass", "labels"}:
            for number, dart in enumerate(place["darts"], 1):
                marks = number if self.kind == "labels" else 0
                for at, bearing in _bearings(sigma, dart):
                    found[at] = (found[at][0], marks, bearing)
            return found
        if self.kind == "cluster":
            for at in orbit(sigma, alpha[place["dart"]]):
                found[at] = (found[at][0], 2, None)
        home = _bearings(sigma, place["dart"])
        letters = word_of(self.options.get("pattern", "10*"), len(home))
        for at, bearing in home:
            marks = letters[bearing] if self.kind in {"door", "word"} else 1
            found[at] = (len(home), marks, bearing if self.kind == "directional" else None)
        return found

    def told(self, map_: Map, place: dict[str, Any]) -> Any:
        """The value that is told before the start; None if there is none."""
        sigma, alpha = map_
        if self.kind == "natural":
            return len(orbit(sigma, alpha[place["dart"]]))
        if self.kind == "told":
            return tuple((name, TOLD[name](map_)) for name in sorted(self.options["names"]))
        return None


@dataclass(frozen=True)
class Lighthouse:
    """One lighthouse, or several together."""

    parts: tuple[Part, ...]

    def places(self, map_: Map, start: int) -> list[list[dict[str, Any]]]:
        """Every place in the map from this start: for each part its own."""
        return [list(each) for each in product(*(part.places(map_, start) for part in self.parts))]

    def shown(self, map_: Map, place: Sequence[dict[str, Any]]) -> tuple[list[Percept], Any]:
        """For each dart what is sensed there, and what is told: one part at most has each."""
        both = list(zip(self.parts, place, strict=True))
        columns = zip(*(part.sensed(map_, at) for part, at in both), strict=True)
        sensed = [
            (
                each[0][0],
                max(marks for _, marks, _ in each),
                next((bearing for *_, bearing in each if bearing is not None), None),
            )
            for each in columns
        ]
        heard = (part.told(map_, at) for part, at in both)
        return sensed, next((each for each in heard if each is not None), None)

    def place_in(self, document: Any) -> list[dict[str, Any]]:
        """The place of a document's lighthouse.

        Raises:
            Refused: if it is another one, or no lighthouse.
        """
        kind = "+".join(part.kind for part in self.parts)
        parts = document["parts"] if len(self.parts) > 1 else [document]
        if document["kind"] != kind or len(parts) != len(self.parts):
            raise Refused(f"the lighthouse of a world is {document['kind']}, not {kind}")
        found = []
        for part, each in zip(self.parts, parts, strict=True):
            names = {"dart", "darts"} & {*each}
            rest = {name: value for name, value in each.items() if name not in names}
            if rest != {"kind": part.kind, **part.options}:
                raise Refused(f"the lighthouse of a world is {rest}, not {part}")
            found.append({name: each[name] for name in names})
        return found


def known(name: str) -> Lighthouse | None:
    """The lighthouse of a name; None for one of a user's own.

    Raises:
        Refused: if it has an option that its kind does not have.
    """
    parts = [each.partition(":") for each in name.split("+")]
    if any(kind not in KINDS for kind, _, _ in parts):
        return None
    return Lighthouse(tuple(Part(kind, _options(kind, rest)) for kind, _, rest in parts))


def _options(kind: str, text: str) -> dict[str, Any]:
    """The options as a document has them: a usual value is left out, but for words and numbers."""
    if kind == "word":
        pattern = text.removeprefix("pattern=") or "12"
        if not re.fullmatch(r"[0-9]+\*?[0-9]*", pattern, re.ASCII):
            raise Refused(f"{pattern!r} is no pattern of letters")
        return {"pattern": pattern}
    if kind == "told":
        names = text.removeprefix("names=").split(",") if text else ["n", "m"]
        if not {*names} <= {*TOLD}:
            raise Refused(f"{text!r} are no numbers that can be told")
        return {"names": names}
    found: dict[str, Any] = {}
    for item in filter(None, text.split(",")):
        if item == "start=any" and kind in MAY_START_ANYWHERE:
            found["start"] = "any"
        elif item == "single=true" and kind == "cluster":
            found["single"] = True
        elif (kind, item) != ("cluster", "single=false") and item != "start=v0":
            raise Refused(f"{item!r} is no option of a {kind} lighthouse that is known here")
    return found


def word_of(pattern: str, degree: int) -> list[int]:
    """For each bearing the letter: the pattern is repeated, or the letter before its star is."""
    before, star, after = pattern.partition("*")
    if star:
        fill = before[-1] * max(0, degree - len(before) + 1 - len(after))
        pattern = before[:-1] + fill + after
    return [int(c) for c in (pattern * degree)[:degree]]


def features_in(map_: Map, door: int, features: Sequence[str]) -> list[int]:
    """For each dart the number of its feature.

    Raises:
        Refused: if a dart has none of them.
    """
    sigma, alpha = map_
    home = orbit(sigma, door)
    near = {dart for each in home for dart in orbit(sigma, alpha[each])}
    found = []
    for dart in range(len(sigma)):
        holds = {
            "away": True,
            "neighbour": dart in near,
            "here": dart in home,
            "other": dart in home,
            "next": dart == sigma[door],
            "behind": dart == alpha[door],
            "door": dart == door,
        }
        names = [name for name in FEATURES if holds[name] and name in features]
        if not names:
            raise Refused(f"dart {dart} has none of the features {', '.join(features)}")
        found.append(features.index(names[-1]))
    return found


def _vertices(map_: Map, start: int) -> list[list[int]]:
    """The vertices, and the darts of each, as a walk from the start meets them."""
    around: dict[int, list[int]] = {}
    for dart in numbering(*map_, start):
        around.setdefault(min(orbit(map_[0], dart)), []).append(dart)
    return list(around.values())


def _bearings(sigma: Sequence[int], dart: int) -> list[tuple[int, int]]:
    """The darts of a vertex, each with the bearing of this one: the steps clockwise to it."""
    around = orbit(sigma, dart)
    return [(at, -place % len(around)) for place, at in enumerate(around)]


def _genus(map_: Map) -> int:
    sigma, alpha = map_
    faces = vertex_count(([sigma[e] for e in alpha], alpha))
    return (2 - vertex_count(map_) + len(sigma) // 2 - faces) // 2


def _diameter(map_: Map) -> int:
    sigma, alpha = map_
    longest = 0
    for dart in range(len(sigma)):
        reached, steps = {*orbit(sigma, dart)}, 0
        while len(reached) < len(sigma):
            reached |= {other for each in [*reached] for other in orbit(sigma, alpha[each])}
            steps += 1
        longest = max(longest, steps)
    return longest


TOLD: dict[str, Callable[[Map], int]] = {
    "n": vertex_count,
    "m": lambda map_: len(map_[0]) // 2,
    "d": _diameter,
    "g": _genus,
}
"""The numbers that can be told, by their names."""
