"""How fast worlds are compared and classified, with the naive refinement in the same run.

    python benchmarks/ambiguity.py [--repeats N] [--edges M]

Printed are medians; nothing is asserted but that both refinements find the same classes.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable, Hashable, Sequence
from functools import partial

from allworlds.maps import CombinatorialMap, family, named_map, project
from allworlds.studies.ambiguity import census, class_of
from allworlds.world import Position, World

# On a cycle the naive refinement takes as many rounds as there are vertices.
BESIDE = ("cycle:500", "lattice:50x51", "random:5000", "dense:101")
ALONE = ("cycle:5000",)


def seconds(work: Callable[[], object], repeats: int) -> float:
    """The median of the wall times of the work."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def naive(labels: Sequence[Hashable], map_: CombinatorialMap) -> list[int]:
    """Moore's refinement: every dart is looked at again until nothing changes."""
    number = {label: i for i, label in enumerate(dict.fromkeys(labels))}
    classes = [number[label] for label in labels]
    while True:
        signs = [
            (c, classes[s], classes[a])
            for c, s, a in zip(classes, map_.sigma, map_.alpha, strict=True)
        ]
        found = {sign: i for i, sign in enumerate(dict.fromkeys(signs))}
        if len(found) == len(set(classes)):
            return classes
        classes = [found[sign] for sign in signs]


def beside_the_naive(name: str, repeats: int) -> str:
    """One line: both refinements of one world, and how many times as long the naive one took."""
    world = World(family(name), Position(0))
    labelled = (world.map, world.percepts, 0)
    mine, theirs = project(labelled).classes, naive(world.percepts, world.map)
    if not len(set(mine)) == len(set(theirs)) == len(set(zip(mine, theirs, strict=True))):
        raise SystemExit(f"the refinements of {name} differ: this measures nothing")
    fast = seconds(lambda: project(labelled), repeats)
    slow = seconds(lambda: naive(world.percepts, world.map), repeats)
    darts = len(world.map.sigma)
    return f"{name:<16}{darts:>7} darts  {fast:8.3f} s  naive {slow:8.3f} s  x {slow / fast:6.1f}"


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--edges", type=int, default=6)
    options = parser.parse_args()
    print("refinement, position")
    for name in BESIDE:
        print(" ", beside_the_naive(name, options.repeats))
    for name in ALONE:
        world = World(family(name), Position(0))
        labelled = (world.map, world.percepts, 0)
        taken = seconds(partial(project, labelled), options.repeats)
        print(f"  {name:<16}{len(labelled.labels):>7} darts  {taken:8.3f} s")
    wheel = World(named_map("wheel-4"), Position(0))
    taken = seconds(lambda: class_of(wheel), options.repeats)
    print(f"class of the wheel with four spokes: {taken:.4f} s")
    taken = seconds(lambda: census(edges=options.edges), 1)
    print(f"census of all maps with at most {options.edges} edges, one process: {taken:.2f} s")


if __name__ == "__main__":
    main()
