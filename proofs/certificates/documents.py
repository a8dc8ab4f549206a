"""JSON files, read strictly: every value that is not exactly what is expected is refused.

A pair is ``{"pair": [WORLD, WORLD], "bisimulation": [classes, classes]}`` with a class for each
dart of either world.  A WORLD is ``{"sigma", "alpha", "start", "lighthouse"}``; the lighthouse
has its ``kind`` and, if it has reference darts, ``dart`` or (compass) ``darts``.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import lrat
from lrat import Refused
from maps import World, orbit, require_map

Pair = tuple[list[World], list[list[int]]]


def read_json(path: Path) -> Any:
    """The value in a JSON file.

    Raises:
        Refused: naming the file, if it is no JSON, is nested too deeply, or has a name twice
            in one object, or a number that is no integer.
    """
    text = lrat.read(path)
    try:
        return json.loads(
            text, object_pairs_hook=once, parse_float=_integer, parse_constant=_integer
        )
    except RecursionError:
        raise Refused(f"{path.name} is nested too deeply to be read") from None
    except ValueError as error:
        raise Refused(f"{path.name} is no JSON: {error}") from None
    except Refused as error:
        raise Refused(f"{path.name}: {error}") from None


def once(items: list[tuple[str, Any]]) -> dict[str, Any]:
    """The object of these names and values, if each name stands there once."""
    names = [name for name, _ in items]
    for name in names:
        if names.count(name) > 1:
            raise Refused(f"the name {name!r} stands twice in one object")
    return dict(items)


def _integer(text: str) -> int:
    raise Refused(f"the number {text} is no integer")


def members(value: Any, names: set[str], what: str) -> dict[str, Any]:
    """The object, if it has exactly these names."""
    if not isinstance(value, dict) or set(value) != names:
        raise Refused(f"{what} is no object with the names {', '.join(sorted(names))} alone")
    return value


def pair_of(value: Any, lighthouse: str) -> Pair:
    """The two worlds of a pair under this lighthouse, and their classes.

    Raises:
        Refused: saying what is amiss.
    """
    entry = members(value, {"pair", "bisimulation"}, "a pair")
    if not isinstance(entry["pair"], list) or len(entry["pair"]) != 2:
        raise Refused("a pair has not two worlds")
    worlds = [world_of(world, lighthouse) for world in entry["pair"]]
    if not isinstance(entry["bisimulation"], list) or len(entry["bisimulation"]) != 2:
        raise Refused("a bisimulation has not classes of two worlds")
    return worlds, [integers(classes, "the classes") for classes in entry["bisimulation"]]


def world_of(value: Any, lighthouse: str) -> World:
    """The world under this lighthouse.

    Raises:
        Refused: saying what is amiss.
    """
    world = members(value, {"sigma", "alpha", "start", "lighthouse"}, "a world")
    sigma, alpha = integers(world["sigma"], "sigma"), integers(world["alpha"], "alpha")
    require_map(sigma, alpha)
    start = _dart(world["start"], sigma, "start")
    has = {"none": set(), "compass": {"darts"}}.get(lighthouse, {"dart"})
    shown = members(world["lighthouse"], {"kind", *has}, "the lighthouse")
    if shown["kind"] != lighthouse:
        raise Refused(f"the lighthouse is {shown['kind']!r}, not {lighthouse!r}")
    named = [shown["dart"]] if "dart" in shown else shown.get("darts", [])
    darts = [_dart(dart, sigma, "a reference dart") for dart in integers(named, "darts")]
    if "dart" in has and darts[0] not in orbit(sigma, start):
        raise Refused(f"the reference dart {darts[0]} is not at the start's vertex")
    if "darts" in has:
        there = sorted(min(orbit(sigma, dart)) for dart in darts)
        if there != [d for d in range(len(sigma)) if d == min(orbit(sigma, d))]:
            raise Refused("a vertex has not exactly one reference dart")
    return World(sigma, alpha, start, lighthouse, tuple(darts))


def integers(value: Any, what: str) -> list[int]:
    """The list, if it is one of integers."""
    if not isinstance(value, list) or any(type(number) is not int for number in value):
        raise Refused(f"{what}: not a list of integers")
    return value


def _dart(value: Any, sigma: list[int], what: str) -> int:
    if type(value) is not int or not 0 <= value < len(sigma):
        raise Refused(f"{what} is {value!r}, but the darts are 0 to {len(sigma) - 1}")
    return value
