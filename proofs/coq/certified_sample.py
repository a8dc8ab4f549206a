"""The extracted programs and the package, compared in a sample of worlds with 5 to 9 edges.

    python proofs/coq/certified.py --sample [RUNS] [--seed 0] [--policy POLICY] [--edges 9]

draws so many runs of Algorithm 1, 2,000 of them if no number is given, under each policy a third of
them, always the same ones for a seed: half of the worlds uniformly among all rooted maps with so
many edges; the others are trees, worlds with one vertex, worlds of the highest genus, worlds behind
a path, and the most expensive ones; each with a bearing that is drawn.  In each of them

- the log and the answer of the package's explorer, of the extracted explorer behind its pipe, and
  of the extracted explorer in the extracted model (``ocaml/runs.ml``) are one text, byte for byte;
- the extracted checker finds it right within exactly as many motions as the package has counted,
  and without an answer within one less;
- the extracted judge and the package's say the same of its answer, of the answer with the robot in
  another dart, and of one with two edges crossed;
- the compiled judge's ``examine`` plays it at every bearing at that cost, and the kernel that walks
  on demand counts the same.

That kernel has no log of a single world: so one of its units is drawn for every hundred runs, and
its sums must be those of ``examine``, and those of the extracted programs, which run in every world
of the unit.  Exit code 1: they disagree; 2: a program is missing; 3: undecided.
"""

from __future__ import annotations

import argparse
import json
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import accumulate, islice
from pathlib import Path
from random import Random
from typing import Any, TypeAlias

from allworlds.engines.compiled_engine import level_of
from allworlds.engines.kernel.engine import judge, walk
from allworlds.engines.kernel.records import Level, Rows
from allworlds.engines.units import LevelUnit, drawn_units
from allworlds.explorers.loading import load
from allworlds.judging.episode import Answered, Episode, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.law_table import Case
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap, MapClass, rooted_code
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import numbering
from allworlds.maps.enumeration import history, prefixes
from allworlds.protocol.actions import Estimate, Percept, Player
from allworlds.protocol.choices import Choices, policy_named
from allworlds.world import Directional, World
from certified_checker import agreement, answered_by, not_lost, outcome

COQ = Path(__file__).resolve().parent
POLICIES = ("fifo", "lifo", "nearest")
FEWEST, MOST = 5, 9
"""The numbers of edges, of which every world with at most four is met by other comparisons."""
WHOLE = 7
"""The largest level whose most expensive worlds are looked for among all of its worlds."""
AT_A_TIME = 500
"""The number of runs that the programs are given at once."""
RUNS_A_UNIT, OF_A_UNIT = 100, 200
"""The number of runs for which a unit is drawn, and the largest number of its worlds."""

Draw: TypeAlias = Callable[[int, Random], CombinatorialMap]
Walk: TypeAlias = Callable[[Level, Sequence[int]], Rows]


# ---- The sample ----


def uniform(edges: int, random: Random) -> CombinatorialMap:
    """A map that is each rooted map with so many edges with the same probability.

    Of its (2m)! numberings as many keep the root and have the edges of ``alpha`` as of any other.
    """
    sigma = list(range(2 * edges))
    while True:
        random.shuffle(sigma)
        alpha = [dart ^ 1 for dart in range(2 * edges)]
        if len(numbering(sigma, alpha, 0)) == 2 * edges:  # connected
            return _rooted(sigma, alpha)


def tree(edges: int, random: Random) -> CombinatorialMap:
    """A plane tree, each with the same probability: the way round it, up and down."""
    steps = [1] * edges + [-1] * (edges + 1)
    random.shuffle(steps)
    heights = list(accumulate(steps))
    low = heights.index(min(heights)) + 1
    alpha, above = [0] * (2 * edges), list[int]()
    for side, step in enumerate([*steps[low:], *steps[:low]][:-1]):
        if step > 0:
            above.append(side)
        else:
            alpha[side] = other = above.pop()
            alpha[other] = side
    return _rooted([(other + 1) % (2 * edges) for other in alpha], alpha)


def one_vertex(edges: int, random: Random) -> CombinatorialMap:
    """A map with one vertex, each with the same probability."""
    order = list(range(2 * edges))
    random.shuffle(order)
    sigma = [0] * (2 * edges)
    for i, dart in enumerate(order):
        sigma[order[i - 1]] = dart
    return _rooted(sigma, [dart ^ 1 for dart in range(2 * edges)])


def highest_genus(edges: int, random: Random) -> CombinatorialMap:
    """A map of the highest genus, half of m rounded down, each with the same probability."""
    while True:
        map_ = uniform(edges, random)
        if map_.genus == edges // 2:
            return map_


def behind_a_path(edges: int, random: Random) -> CombinatorialMap:
    """A uniform map behind a path, from whose other end the robot starts: every test is long."""
    length = random.randrange(1, edges)
    end = uniform(edges - length, random)
    sigma, alpha, at = list(end.sigma), list(end.alpha), 0
    for _ in range(length):
        out = len(sigma)
        sigma += [sigma[at], out + 1]
        sigma[at] = out
        alpha += [out + 1, out]
        at = out + 1
    return CombinatorialMap(*rooted_code(sigma, alpha, at))


def _rooted(sigma: Sequence[int], alpha: Sequence[int]) -> CombinatorialMap:
    return CombinatorialMap(*rooted_code(sigma, alpha, 0))


def most_expensive(edges: int, policy: str, random: Random) -> list[CombinatorialMap]:
    """By number of vertices the worlds that cost most: of all, or of pieces that are drawn."""
    level = level_asked(edges, policy)
    if edges <= WHOLE:
        units = list(prefixes(edges))
    else:
        pieces = drawn_units(Extent(MapClass.MAPS, edges), edges, 50_000, random)
        units = [unit.prefix for unit in islice(pieces, 20)]
    found: dict[int, tuple[int, CombinatorialMap]] = {}
    for prefix in units:
        rows = walk(level, prefix)
        costs = {counts.vertices: counts.largest for counts in rows.counts}
        for n, sigma, alpha, _ in rows.most_expensive:
            if n not in found or costs[n] > found[n][0]:
                found[n] = costs[n], CombinatorialMap(sigma, alpha)
    return [map_ for _, map_ in found.values()]


KINDS: dict[str, Draw] = {
    "uniform": uniform,
    "trees": tree,
    "one vertex": one_vertex,
    "highest genus": highest_genus,
    "behind a path": behind_a_path,
}


def sample(runs: int, edges: int, policy: str, random: Random) -> Iterator[tuple[str, World]]:
    """Draw so many worlds, each with its kind."""
    sizes = range(min(FEWEST, edges), edges + 1)
    dearest = [map_ for m in sizes for map_ in most_expensive(m, policy, random)]
    for number in range(runs):
        kind = (*KINDS, "most expensive", *["uniform"] * 4)[number % 10]
        draw, m = KINDS.get(kind), random.choice(sizes)
        map_ = draw(m, random) if draw else random.choice(dearest)
        bearing = random.randrange(map_.degree_at[0])
        yield kind, World(map_, Directional(map_.turn(0, bearing)))


# ---- One run, by all of them ----


def line(**values: object) -> str:
    """The values as the extracted programs write them."""
    return json.dumps(values, separators=(",", ":")) + "\n"


def _percept(percept: Percept) -> tuple[int, int | None]:
    return percept.degree, percept.bearing


def estimate_shown(estimate: Estimate) -> dict[str, Any]:
    """An answer as the extracted programs write it."""
    return {**estimate.map.to_json(), "here": estimate.here}


def log_of(name: str, world: World, player: Player, policy: str) -> tuple[str, Case]:
    """The log and the answer of a run, as a line that goes on with the finding; and the run.

    Raises:
        NoVerdict: if a process is lost, or is silent.
    """
    budget = 8 * paper_bound(world.map.vertex_count, world.map.edge_count) + 100
    episode: Episode = play(world, player, Choices(policy_named(policy)), budget)
    not_lost(name, episode.ending)
    answer = episode.ending.answer if isinstance(episode.ending, Answered) else None
    log = episode.walk
    case = Case(log, episode.checkpoints, answer)
    shown = line(
        first=_percept(log.first),
        steps=[(action.k, _percept(percept)) for action, percept in log.steps],  # type: ignore[union-attr]  # there is nothing to be dropped
        estimate=None if answer is None else estimate_shown(answer),
        end=case.walk.here,
    )
    return shown.rstrip("}\n"), case


def answers_near(answer: Estimate, random: Random) -> list[Estimate]:
    """The answer, one with the robot in another dart, and one with two edges crossed."""
    alpha, darts = list(answer.map.alpha), len(answer.map.alpha)
    a, b = random.sample(range(darts), 2)
    if alpha[a] != b:
        c, d = alpha[a], alpha[b]
        alpha[a], alpha[b], alpha[c], alpha[d] = b, a, d, c
    crossed = CombinatorialMap.trusted(answer.map.sigma, alpha)
    return [
        answer,
        Estimate(answer.map, random.randrange(darts)),
        Estimate(crossed, answer.here),
    ]


def level_asked(edges: int, policy: str) -> Level:
    """The kernel's question for a level."""
    return level_of("algorithm1", Rules(policy=policy), Extent(MapClass.MAPS, edges), edges)


def runs_agree(
    every: Sequence[tuple[str, World]], policy: str, players: Sequence[Player], random: Random
) -> tuple[list[str], Counter[str]]:
    """Differences in these runs, in words, and the judge's verdicts."""
    apart: list[str] = []
    asked, logs, cases, judged, verdicts = [], [], [], [], []
    for kind, world in every:
        where = f"{kind}: {line(**world.to_json()).strip()}"
        (log, case), (piped, _) = (
            log_of(name, world, player, policy)
            for name, player in zip(("algorithm1", "the extracted explorer"), players, strict=True)
        )
        if log != piped:
            apart.append(f"{where}: the extracted explorer walks or answers otherwise")
        if not isinstance(case.estimate, Estimate):
            apart.append(f"{where}: no answer")
            continue
        cost, (place,) = len(case.walk), [case.walk.first.bearing]
        apart += [f"{where}: {what}" for what in kernels_apart(world.map, policy, cost)]
        map_ = world.map.to_json()
        asked += [line(**map_, place=place, limit=limit) for limit in (cost, cost - 1)]
        logs.append((where, log))
        cases.append(case)
        for near in answers_near(case.estimate, random):
            judged.append(line(world=map_, estimate=estimate_shown(near), end=case.walk.here))
            again = Case(case.walk, case.checkpoints, near)
            verdicts.append(again.answer)
    answers = answered_by(COQ / "runs", asked, policy)
    for (where, log), within, short in zip(logs, answers[::2], answers[1::2], strict=True):
        if within != log + ',"finding":"right"}':
            apart.append(f"{where}: the extracted model has another log, or another verdict")
        if not short.endswith(',"finding":"none"}'):
            apart.append(f"{where}: right within one motion less")
    said = [json.loads(each)["verdict"] for each in answered_by(COQ / "judge", judged)]
    for i, (verdict, ours) in enumerate(zip(said, verdicts, strict=True)):
        if verdict != ours:
            apart.append(f"{logs[i // 3][0]}: the judge says {ours}, the extracted one {verdict}")
    return apart, Counter(said)


def kernels_apart(map_: CombinatorialMap, policy: str, cost: int) -> list[str]:
    """Differences of the compiled judge and of the kernel that walks on demand, in a world."""
    unit = LevelUnit(map_.edge_count, history(map_))
    (counts,) = judge(level_asked(unit.edges, policy), unit.prefix).counts
    places = map_.degree_at[0]
    found = unit_apart(unit, policy)
    if (counts.worlds, counts.traversals, counts.largest) != (1, places * cost, cost):
        found.append(f"examine counts {counts.traversals} traversals, not {places} times {cost}")
    return found


# ---- One unit ----


def unit_apart(unit: LevelUnit, policy: str, walked: Walk = walk) -> list[str]:
    """Differences between the sums of the kernel on demand and of ``examine``, in words."""
    level = level_asked(unit.edges, policy)
    examined, rows = judge(level, unit.prefix), walked(level, unit.prefix)
    names = [
        name for name in Rows.__struct_fields__ if getattr(examined, name) != getattr(rows, name)
    ]
    return [f"unit {unit.key}: {name} of examine and of the kernel on demand" for name in names]


def sums_apart(unit: LevelUnit, policy: str) -> tuple[list[str], int]:
    """Differences from the extracted programs, world by world, and the number of worlds."""
    rows = walk(level_asked(unit.edges, policy), unit.prefix)
    maps = list(unit.maps(Extent(MapClass.MAPS, unit.edges)))
    limit = [paper_bound(map_.vertex_count, unit.edges) for map_ in maps]
    asked = [
        line(**map_.to_json(), place=0, limit=most) for map_, most in zip(maps, limit, strict=True)
    ]
    sums: dict[int, list[int]] = {}
    found = []
    for map_, answer in zip(maps, answered_by(COQ / "runs", asked, policy), strict=True):
        run = json.loads(answer)
        row = sums.setdefault(map_.vertex_count, [0, 0, 0])
        row[0] += 1
        row[1] += len(run["steps"])
        row[2] = max(row[2], len(run["steps"]))
        if run["finding"] != "right":
            found.append(f"unit {unit.key}: {run['finding']} in {map_.to_json()}")
    counted = {c.vertices: [c.worlds, c.traversals_rooted, c.largest] for c in rows.counts}
    if counted != sums:
        found.append(f"unit {unit.key}: extracted {sums}, the kernel on demand {counted}")
    return found, len(maps)


# ---- All ----


def sample_agrees(runs: int, seed: int, edges: int, policy: str) -> bool:
    """Whether nothing differs in the sample."""
    start, random = time.process_time(), Random(f"{seed} {policy} {edges}")
    certified = load(f"exec:{COQ / 'explorer'} {policy} directional")
    players = load("algorithm1").player(), certified.player()
    apart, verdicts, kinds = list[str](), Counter[str](), Counter[str]()
    every = sample(runs, edges, policy, random)
    with certified.running():
        while some := list(islice(every, AT_A_TIME)):
            found, said = runs_agree(some, policy, players, random)
            apart += found
            verdicts += said
            kinds.update(kind for kind, _ in some)
    of_kinds = ", ".join(f"{kind} {count:,}" for kind, count in kinds.items())
    said = ", ".join(f"{verdict} {count:,}" for verdict, count in sorted(verdicts.items()))
    print(f"sample, {policy}, seed {seed}: {runs:,} runs ({of_kinds})")
    print(f"  the judges on {verdicts.total():,} answers: {said}")
    worlds, units = 0, max(1, runs // RUNS_A_UNIT)
    for _ in range(units):
        m = random.choice(range(min(FEWEST, edges), edges + 1))
        unit = next(drawn_units(Extent(MapClass.MAPS, m), m, OF_A_UNIT, random))
        found, many = sums_apart(unit, policy)
        apart += unit_apart(unit, policy) + found
        worlds += many
    seconds = time.process_time() - start
    print(f"  {units} units with {worlds:,} worlds; {seconds:.0f} s of this process")
    print(f"  {len(apart)} differ" + "".join(f"\n    {what}" for what in apart[:5]))
    return agreement(
        not apart, set(verdicts) == {"right", "pose", "map"}, "a verdict did not come up"
    )


def compare_sample(arguments: Sequence[str]) -> int:
    """The exit code: see the head of this file."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--sample", type=int, nargs="?", const=2000, metavar="RUNS", required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--policy", choices=POLICIES, help="this one only")
    parser.add_argument("--edges", type=int, default=MOST, help="the most")
    options = parser.parse_args(arguments)
    if options.sample < 1 or not 1 <= options.edges <= 12:
        parser.error("at least one run expected, and 1 to 12 edges")
    policies = [options.policy] if options.policy else POLICIES
    runs = -(-options.sample // len(policies))
    return outcome(
        *(partial(sample_agrees, runs, options.seed, options.edges, each) for each in policies)
    )
