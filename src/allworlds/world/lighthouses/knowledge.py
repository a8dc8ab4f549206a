"""Numbers of the world that the robot is told before the start."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar

from allworlds.document import Different, Text, about, narrowed
from allworlds.inputs import show
from allworlds.maps import CombinatorialMap, Dart
from allworlds.world.lighthouses.base import InvalidWorld, PlacelessLighthouse

TOLD: dict[str, Callable[[CombinatorialMap], int]] = {
    "n": lambda map_: map_.vertex_count,
    "m": lambda map_: map_.edge_count,
    "d": lambda map_: map_.diameter,
    "g": lambda map_: map_.genus,
}
"""The numbers that can be told, by their names: of vertices, of edges, the diameter, the genus."""


@dataclass(frozen=True, slots=True)
class Knowledge(PlacelessLighthouse):
    """A lighthouse without marks: the robot is told some numbers of the world.

    Sensed: the degree alone.  ``told`` holds the numbers by their names: n (vertices), m (edges),
    d (diameter), g (genus); n and m where none is named.
    """

    names: Annotated[Different[Text], narrowed(minItems=1), about("of the numbers: n, m, d, g")]

    kind: ClassVar[str] = "told"
    keys: ClassVar[tuple[str, ...]] = ("names",)
    usually: ClassVar[tuple[str, ...]] = ("n", "m")

    @classmethod
    def with_options(cls, options: Mapping[str, str]) -> type[Knowledge]:
        """The kind that tells the numbers with these names."""
        for name, value in options.items():
            if value:
                raise InvalidWorld(f"{show(f'{name}={value}')} is not one of {', '.join(TOLD)}")
        return _kind_with(_names(tuple(options)))

    @classmethod
    def with_its_options(cls) -> Knowledge:
        """The lighthouse with the options of the kind."""
        return Knowledge(cls.usually)

    def check(self, map_: CombinatorialMap, start: Dart) -> None:  # noqa: ARG002  # any map
        """Names of numbers; every map and every start will do."""
        _names(self.names)

    def told(self, map_: CombinatorialMap) -> dict[str, int]:
        """The numbers by their names."""
        return {name: TOLD[name](map_) for name in self.names}

    @property
    def written(self) -> str:
        """With the names."""
        return f"{self.kind}:{','.join(self.names)}"

    @classmethod
    def at(cls, names: object) -> Knowledge:  # type: ignore[override]  # its only field
        """The one that tells these."""
        return cls(_names(names))


@cache
def _kind_with(names: tuple[str, ...]) -> type[Knowledge]:
    """The kind whose usual lighthouse tells these."""
    return type(Knowledge.__name__, (Knowledge,), {"usually": names})


def _names(names: Any) -> tuple[str, ...]:
    """Names of numbers, each once; else raises InvalidWorld."""
    legal = f"legal are {', '.join(TOLD)}, as in told:n,m"
    if not isinstance(names, list | tuple) or not names:
        raise InvalidWorld(f"the lighthouse told tells {show(names)}; {legal}")
    for name in names:
        if not isinstance(name, str) or name not in TOLD or names.count(name) > 1:
            raise InvalidWorld(f"the lighthouse told tells {show(name)}, each once; {legal}")
    return tuple(names)
