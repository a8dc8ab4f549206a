"""Checks what ``allworlds ambiguity search`` has written, without the package and without a solver.

    python proofs/certificates/searched.py DIR --lighthouse position --vertices 6 --edges 5

with the options of that search.  If DIR has a ``pair.json``, its two worlds must be as asked for,
different, and look alike.  If not, every level must have the formula that is meant and an LRAT
proof that it has no model.  Prints one line, ``VERIFIED: ...`` (exit code 0) or ``REFUSED: ...``
(1); 2: a file is missing.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from documents import pair_of, read_json
from lrat import Refused
from lrat_claims import refuted
from maps import (
    World,
    is_planar,
    is_simple,
    moved,
    orbit,
    require_bisimulation,
    vertex_count,
    world_code,
)
from world_clauses import CLASSES, LIGHTHOUSES, Asked, Size, size_of


def levels(asked: Asked, vertices: int, edges: int) -> Iterator[tuple[Size, Size]]:
    """The sizes of two worlds within the bounds; those that no world can have are left out.

    Looking alike is symmetric, so the second world has no fewer edges; where v0 is marked it
    has no more either (README.md, 'Two worlds of one size').
    """
    sizes = [size for m in range(1, edges + 1) if (size := size_of(asked, m, vertices))]
    for two in sizes:
        for one in sizes:
            if one.edges == two.edges or (one.edges < two.edges and not asked.v0_is_marked):
                yield one, two


def file_name(sizes: tuple[Size, Size]) -> str:
    """The name of a level's files: ``m4n1to5``, or ``m3n2-m4n1to5`` for two sizes."""
    names = [
        f"m{size.edges}n{size.fewest}" + (f"to{size.most}" if size.most > size.fewest else "")
        for size in sizes
    ]
    return "-".join(dict.fromkeys(names))


def check(folder: Path, asked: Asked, vertices: int, edges: int) -> str:
    """Verify the files of a search, and return in one sentence what holds.

    Raises:
        Refused: saying what is wrong.
    """
    if (folder / "pair.json").exists():
        return _pair(folder / "pair.json", asked, vertices, edges)
    clauses = formulas = 0
    for sizes in levels(asked, vertices, edges):
        name = file_name(sizes)
        files = folder / f"{name}.cnf", folder / f"{name}.lrat"
        clauses += refuted(*files, asked, sizes)
        formulas += 1
    if formulas == 0:
        raise Refused("no world has these sizes, so there is nothing to verify")
    return f"no pair: {formulas} formulas are those meant; LRAT, {clauses:,} clauses derived"


def _pair(path: Path, asked: Asked, vertices: int, edges: int) -> str:
    pair, classes = pair_of(read_json(path), asked.lighthouse)
    require_bisimulation(pair, classes)
    for world in pair:
        _require_asked(world, asked, vertices, edges)
    if world_code(pair[0]) == world_code(pair[1]):
        raise Refused("the two worlds are the same")
    sizes = [f"m = {len(w.sigma) // 2}, n = {vertex_count(w.map)}" for w in pair]
    return f"two different worlds look alike: {' and '.join(dict.fromkeys(sizes))}"


def _require_asked(world: World, asked: Asked, vertices: int, edges: int) -> None:
    home = orbit(world.sigma, world.start)
    others = {len(orbit(world.sigma, d)) for d in range(len(world.sigma)) if d not in home}
    if len(world.sigma) > 2 * edges or vertex_count(world.map) > vertices:
        raise Refused("a world is larger than the bounds")
    if (asked.simple and not is_simple(world.map)) or (asked.planar and not is_planar(world.map)):
        raise Refused(f"a world is not of the class {asked.map_class}")
    if asked.marked not in {None, len(home)} or (asked.others and others - {asked.others}):
        raise Refused("a vertex has another degree than is asked for")
    dart = world.start
    for motion, degree, at_v0 in asked.walk:
        dart = moved(world.map, dart, motion)
        elsewhere = asked.v0_is_marked and (dart in home) != at_v0
        if len(orbit(world.sigma, dart)) != degree or elsewhere:
            raise Refused("the walk senses something else than is asked for")


def main(arguments: Sequence[str]) -> int:
    """One line on stdout, and the exit code."""
    parser = argparse.ArgumentParser(description="Check what a search for twins has written.")
    parser.add_argument("folder", type=Path, metavar="DIR")
    parser.add_argument("--lighthouse", choices=LIGHTHOUSES, required=True)
    parser.add_argument("--class", dest="map_class", choices=CLASSES, default="maps")
    parser.add_argument("--vertices", type=int, required=True)
    parser.add_argument("--edges", type=int, required=True)
    parser.add_argument("--degree-marked", type=int)
    parser.add_argument("--degree-others", type=int)
    parser.add_argument("--motions", default="", help="1,1,2,2,1")
    parser.add_argument("--percepts", default="", help="3A,3A,3A,3A,4P")
    options = parser.parse_args(arguments)
    try:
        walk = _walk(options.motions, options.percepts)
        degrees = options.degree_marked, options.degree_others
        asked = Asked(options.lighthouse, options.map_class, *degrees, walk)
        print(f"VERIFIED: {check(options.folder, asked, options.vertices, options.edges)}")
    except Refused as error:
        print(f"REFUSED: {error}")
        return 1
    except OSError as error:
        print(f"searched.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    return 0


def _walk(motions: str, percepts: str) -> tuple[tuple[int, int, bool], ...]:
    if not re.fullmatch(r"(-?\d+(,-?\d+)*)?", motions):
        raise Refused(f"--motions {motions}: not like 1,1,2")
    if not re.fullmatch(r"(\d+[AP](,\d+[AP])*)?", percepts):
        raise Refused(f"--percepts {percepts}: not like 3A,3A,4P")
    turns = [int(motion) for motion in motions.split(",") if motion]
    sensed = [(int(text[:-1]), text[-1] == "P") for text in percepts.split(",") if text]
    if len(turns) != len(sensed):
        raise Refused(f"{len(turns)} motions and {len(sensed)} percepts: one after each motion")
    return tuple((turn, *percept) for turn, percept in zip(turns, sensed, strict=True))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
