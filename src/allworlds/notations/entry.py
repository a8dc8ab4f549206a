"""One world of a file, as a reader of its notation hands it over."""

from __future__ import annotations

from typing import Any

from msgspec import Struct

from allworlds.maps.combinatorial import CombinatorialMap, Dart
from allworlds.world.labels import PLAIN, Labels


class Entry(Struct, frozen=True):
    """A map of a file, with its labels.

    Attributes:
        map: its darts are numbered as its notation lists them.
        labels: the name of the world in the file, and those of its vertices.
        start: the dart that the robot faces, if the file fixes it.
        lighthouse: the JSON object of the lighthouse that stands there, if the file fixes it.
    """

    map: CombinatorialMap
    labels: Labels = PLAIN
    start: Dart | None = None
    lighthouse: Any = None
