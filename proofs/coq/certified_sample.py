"""The extracted programs and the package, compared in a sample of worlds with 5 to 9 edges.

    python proofs/coq/certified.py --sample [RUNS] [--units 51] [--seed 0] [--policy P] [--edges 9]

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

In a single world that kernel decides nothing.  So units are drawn, too, under each policy a third:
prefixes of the enumeration, the worlds behind which differ in what is decided on the way.  The
kernel has no log of a single world, but its sums over a unit must be those of ``examine``, and

- its worlds those that the package lists, by number and by fingerprint;
- their costs those of the extracted programs, which run in every world of the unit: by sum, by the
  largest, and by the worlds that cost more than each of some bounds, the least of which all exceed;
- none broken, as the extracted judge finds every answer right.

Exit code 1: they disagree; 2: a program is missing; 3: undecided.
"""

from __future__ import annotations

import argparse
import json
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from itertools import accumulate, islice
from pathlib import Path
from random import Random
from typing import Any, TypeAlias

from msgspec import Struct

from allworlds.documents.document import replace
from allworlds.engines.compiled_engine import level_of
from allworlds.engines.kernel.arrays import Level, Sums
from allworlds.engines.kernel.engine import judge, walk
from allworlds.engines.units import LevelUnit, drawn_units
from allworlds.explorers.loading import load
from allworlds.judging.episode import Answered, Episode, play
from allworlds.judging.laws.bounds import paper_bound
from allworlds.judging.laws.law_table import Case
from allworlds.judging.rules import Rules
from allworlds.maps import CombinatorialMap, MapClass, rooted_code, unrooted_code
from allworlds.maps.classes import Extent
from allworlds.maps.combinatorial import numbering
from allworlds.maps.count_source import completions
from allworlds.maps.enumeration import FINGERPRINTS, Gluing, fingerprint, history, prefixes
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
UNITS = 51
"""The number of units, if none is given."""
SMALL, LARGE = 200, 800
"""The largest numbers of worlds of a unit: of most units, and of each third one."""
BOUNDS = 6
"""The number of bounds by which the costs in a unit are told apart, at most."""

Draw: TypeAlias = Callable[[int, Random], CombinatorialMap]
Walk: TypeAlias = Callable[..., Sums]


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


def level_asked(edges: int, policy: str, vertices: int | None = None) -> Level:
    """The kernel's question for a level, of worlds with at most so many vertices."""
    extent = Extent(MapClass.MAPS, edges, vertices)
    return level_of("algorithm1", Rules(policy=policy), extent, edges)


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
    piece = piece_of(map_)
    (counts,) = judge(piece.level(policy), piece.unit.prefix).counts
    places = map_.degree_at[0]
    found = piece_apart(piece, policy)
    if (counts.worlds, counts.traversals, counts.largest) != (1, places * cost, cost):
        found.append(f"examine counts {counts.traversals} traversals, not {places} times {cost}")
    return found


# ---- One unit ----


class Piece(Struct, frozen=True):
    """A unit of the worlds of an extent."""

    unit: LevelUnit
    extent: Extent

    def level(self, policy: str) -> Level:
        """The kernel's question."""
        return level_asked(self.unit.edges, policy, self.extent.vertices)


def piece_of(map_: CombinatorialMap) -> Piece:
    """The piece with this world alone."""
    m = map_.edge_count
    return Piece(LevelUnit(m, history(map_)), Extent(MapClass.MAPS, m))


def pieces(edges: int, random: Random) -> Iterator[Piece]:
    """An endless sequence of pieces, of which each third one is drawn as its worlds are.

    In the others vertices have one degree, where that is possible: so darts look alike, and tests
    are long.  Every other of these has few vertices: so the last one has many darts.
    """
    while True:
        m = random.choice(range(min(FEWEST, edges), edges + 1))
        every = Extent(MapClass.MAPS, m)
        yield Piece(next(drawn_units(every, m, SMALL, random)), every)
        few = Extent(MapClass.MAPS, m, random.choice((2, 3, 4)))
        for extent, most in ((every, LARGE), (few, SMALL)):
            yield Piece(LevelUnit(m, alike(extent, most, random)), extent)


def units_drawn(seed: int, policy: str, edges: int) -> Iterator[Piece]:
    """The pieces for a seed, whatever the number of runs."""
    return pieces(edges, Random(f"units {seed} {policy} {edges}"))


def alike(extent: Extent, most: int, random: Random) -> tuple[int, ...]:
    """A prefix with at most so many worlds, of whose new vertices most have the same degree."""
    degree = random.choice((2, 3, 4, 5))
    gluing = Gluing(extent.edges, extent.map_class, extent.vertices)
    prefix = list[int]()
    while not prefix or completions(gluing) > most:
        ways = [(way, after) for way, after in gluing.successors() if completions(after)]
        if not prefix:
            wished = [each for each in ways if each[0] in (-1, -2)]
        elif random.random() < 3 / 4:
            wished = [each for each in ways if each[0] == -degree]
        else:
            wished = [each for each in ways if each[0] >= 0]
        decision, gluing = random.choice(wished or ways)
        prefix.append(decision)
    return tuple(prefix)


def piece_apart(piece: Piece, policy: str, walked: Walk = walk) -> list[str]:
    """Differences between the sums of the kernel on demand and of ``examine``, in words."""
    level, unit = piece.level(policy), piece.unit
    examined, rows = judge(level, unit.prefix), walked(level, unit.prefix)
    names = [
        name for name in Sums.__struct_fields__ if getattr(examined, name) != getattr(rows, name)
    ]
    return [f"unit {unit.key}: {name} of examine and of the kernel on demand" for name in names]


Costs: TypeAlias = Sequence[tuple[CombinatorialMap, int]]


def extracted_apart(piece: Piece, policy: str, walked: Walk = walk) -> tuple[list[str], int]:
    """Differences from the extracted programs, world by world, and the number of worlds."""
    unit = piece.unit
    maps = list(unit.maps(piece.extent))
    asked = [
        line(
            **map_.to_json(),
            place=number % map_.degree_at[0],
            limit=paper_bound(map_.vertex_count, unit.edges),
        )
        for number, map_ in enumerate(maps)
    ]
    runs = [json.loads(answer) for answer in answered_by(COQ / "runs", asked, policy)]
    found = [
        f"unit {unit.key}: {run['finding']} in {map_.to_json()}"
        for map_, run in zip(maps, runs, strict=True)
        if run["finding"] != "right"
    ]
    costs = [(map_, len(run["steps"])) for map_, run in zip(maps, runs, strict=True)]
    level = piece.level(policy)
    rows = walked(level, unit.prefix)
    counted = {
        c.vertices: [c.worlds, c.fingerprint, c.traversals_rooted, c.largest] for c in rows.counts
    }
    if counted != (sums := sums_of(costs)):
        found.append(f"unit {unit.key}: extracted {sums}, the kernel on demand {counted}")
    if rows.broken:
        found.append(f"unit {unit.key}: the kernel on demand finds a world broken")
    for bounds in bounds_between(costs):
        table = [[[bounds.get(n, 0)]] for n in range(len(level.bounds))]
        broken = walked(replace(level, bounds=table), unit.prefix, keep=len(maps)).broken
        if [(each.sigma, each.alpha) for each in broken] != dearer(costs, bounds):
            found.append(f"unit {unit.key}: other worlds cost more than {bounds}")
    return found, len(maps)


def sums_of(costs: Costs) -> dict[int, list[int]]:
    """By vertices: how many worlds, their fingerprints, the sum of their costs, and the largest."""
    sums: dict[int, list[int]] = {}
    for map_, cost in costs:
        row = sums.setdefault(map_.vertex_count, [0, 0, 0, 0])
        row[0] += 1
        row[1] = (row[1] + fingerprint(map_)) % FINGERPRINTS
        row[2] += cost
        row[3] = max(row[3], cost)
    return sums


def bounds_between(costs: Costs) -> Iterator[dict[int, int]]:
    """Some bounds by vertices, from one that every world exceeds to the cost below the largest."""
    different = {
        n: sorted({cost for map_, cost in costs if map_.vertex_count == n})
        for n in {map_.vertex_count for map_, _ in costs}
    }
    for i in range(BOUNDS):
        yield {n: every[i * len(every) // BOUNDS] - 1 for n, every in different.items()}


def dearer(costs: Costs, bounds: dict[int, int]) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
    """The worlds that cost more, of those that differ by their roots the least."""
    least: dict[Any, Any] = {}
    for map_, cost in costs:
        if cost > bounds[map_.vertex_count]:
            kind, code = (
                unrooted(map_),
                (map_.vertex_count, *rooted_code(map_.sigma, map_.alpha, 0)),
            )
            least[kind] = min(code, least.get(kind, code))
    return [(sigma, alpha) for _, sigma, alpha in sorted(least.values())]


unrooted = cache(unrooted_code)


# ---- All ----


def sample_agrees(runs: int, units: int, seed: int, edges: int, policy: str) -> bool:
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
    worlds = 0
    for piece in islice(units_drawn(seed, policy, edges), units):
        found, many = extracted_apart(piece, policy)
        apart += piece_apart(piece, policy) + found
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
    parser.add_argument("--units", type=int, default=UNITS, help="how many (%(default)s)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--policy", choices=POLICIES, help="this one only")
    parser.add_argument("--edges", type=int, default=MOST, help="the most")
    options = parser.parse_args(arguments)
    if min(options.sample, options.units) < 1 or not 1 <= options.edges <= 12:
        parser.error("at least one run and one unit expected, and 1 to 12 edges")
    policies = [options.policy] if options.policy else POLICIES
    runs, units = (-(-each // len(policies)) for each in (options.sample, options.units))
    asked = runs, units, options.seed, options.edges
    return outcome(*(partial(sample_agrees, *asked, each) for each in policies))
