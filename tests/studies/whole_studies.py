"""What studies draw, try, find and tell of their progress, whole.

``RENEW=1 pytest tests/studies/test_whole_studies.py`` writes the texts anew; what then differs is
to be meant, and told in the commit.
"""

import json
from contextlib import chdir
from pathlib import Path

import allworlds
from allworlds.documents.document import replace
from allworlds.engines.single import subject_of
from allworlds.engines.units import Sample, Scope, Shard
from allworlds.judging.rules import Rules
from allworlds.maps import MapClass, from_cycles, named_map
from allworlds.maps.classes import Extent
from allworlds.studies.fuzz import breeding
from allworlds.studies.fuzz.given_maps import MapsRequest, refuted_in
from allworlds.studies.fuzz.sample_sweep import FuzzRequest, FuzzSweep, scope_of
from allworlds.studies.fuzz.sampling import Batch, SmallBatch, batches, waves
from allworlds.studies.fuzz.shrinking import shrink
from allworlds.world import Directional, World, world_named
from listeners import Hears
from recorded_texts import Texts
from studies.whole_explorers import loop_at_once, stays, walks_for_ever, wrong_from

STUDIES = Texts(Path(__file__).parent / "whole_studies")
case = STUDIES.case


def whole(name):
    """The text of a case."""
    with chdir(STUDIES.folder.parents[2]):  # from there findings name the files of explorers
        return "".join(f"{text}\n" for text in STUDIES.cases[name]())


def as_json(result):
    """The document of a result, with a line for each entry."""
    document = result.to_json()
    document.pop("version", None)
    lines = (f"  {key}: {json.dumps(value)}" for key, value in document.items())
    return "\n".join([type(result).__name__, *lines])


def told(study, *given, **options):
    """The document of a study, after all that a listener has heard of it."""
    heard = Hears()
    result = study(*given, listener=heard, **options)
    units = [of for *_, of in heard.stages]
    return "\n".join([f"{heard.heard} {units}", *heard.notices, as_json(result)])


def world_line(map_, places):
    """A map in one line, with the places of the lighthouse."""
    return f"{map_.sigma} {map_.alpha} {[(number, str(place)) for number, place in places]}"


# ---------------------------------------------------------------- random worlds


@case
def draws():
    for runs in (1, 15, 16, 17, 63, 64, 65, 300):
        yield f"{runs}: {[*waves(runs)]}"
    sample = Sample(40, 3, 2, Shard(0, 1), ("sparse", "dense"))
    yield str([each.key for each in batches(sample)])
    yield str([(each.first, each.last) for each in batches(sample, 16, 37)])
    for index in range(3):
        part = Sample(40, 3, 2, Shard(index, 3), ("sparse",))
        yield str([(each.first, each.last) for each in batches(part)])
        bred = [each.drawn for each in breeding.bred_of(part, range(0, 2048, 256))]
        yield str([(each.first, each.last) for each in bred])
    for name, least in (("maps", 1), ("simple", 3)):
        extent = Extent(MapClass(name), 5)
        for mix in ((), ("sparse", "dense", "sparse")):
            drawn = [*Batch(1, 2, 9, mix, least).placed(extent, Directional)]
            yield from (world_line(*each) for each in drawn)
        yield from (world_line(*each) for each in SmallBatch(4, ()).placed(extent, Directional))
    few = Extent(MapClass("maps"), 2)
    yield from (world_line(*each) for each in SmallBatch(4, ()).placed(few, Directional))


@case
def breeds():
    extent = Extent(MapClass("maps"), 5)
    drawn = Batch(1, 0, 12, ("sparse", "dense"), 3)
    pool = breeding._Pool(breeding.Bred(drawn), extent, Directional)
    for number, (map_, _) in enumerate(drawn.placed(extent, Directional)):
        pool.add(map_, [("a.py", 1), ("a.py", number % 5), ("a.py", number % 7)])
    for _ in range(2):
        yield from (world_line(*each) for each in pool.bred())


@case
def waves_of_samples():
    """The levels of a sample, with the units of worlds that are bred."""
    for explore in ("algorithm1", stays):
        for options in ({"runs": 255}, {"runs": 1024, "shard": (1, 2)}, {"runs": 5}):
            request = FuzzRequest(explore, edges=6, seed=3, **options)
            subject = subject_of(request.explore, request.limits)
            scope = scope_of(request, request.rules(subject))
            for level in FuzzSweep(request, scope, subject).levels():
                keys = [unit.key for unit in level.units]
                yield f"{level.edges}, {level.worlds} runs, {level.of}: {keys}"


@case
def samples():
    for options in (
        {"edges": 5, "runs": 20},
        {"edges": 5, "min_edges": 3, "runs": 70, "seed": 2, "mix": ("sparse", "dense")},
        {"edges": 4, "runs": 40, "shard": (0, 2)},
        {"edges": 4, "runs": 40, "shard": (1, 2)},
        {"edges": 4, "runs": 6, "where": "cubic"},
        {"edges": 3, "runs": 6, "map_class": "simple"},
    ):
        yield told(allworlds.fuzz, "algorithm1", **options)
    for explore in (stays, wrong_from(3, 3), walks_for_ever):
        yield told(allworlds.fuzz, explore, edges=5, runs=20)


def shrunk(name, condition, map_class="maps"):
    """What is tried and reached from a map, if exactly the worlds with a property refute."""
    map_ = named_map(name)
    first = allworlds.run(stays, World(map_, next(Directional.places(map_, 0)), 0)).finding
    asked = []

    def refute(picked):
        given = [each for one in picked for each in one.worlds]
        asked.append([len(one.worlds) for one in picked])
        found = [
            replace(first, world=world, at=place, choices=())
            for world, place in given
            if condition(world)
        ]
        return min(found, key=lambda each: each.key, default=None)

    scope = Scope(Extent(MapClass.named(map_class), 12), Rules())
    steps = [each.key[:4] for each in shrink(first, scope, refute)]
    return f"{name}, {len(asked)} times: {asked[:60]}\n" + "\n".join(map(str, steps))


@case
def shrinking():
    yield shrunk("k4", lambda world: world.map.vertex_count >= 3)
    yield shrunk("wheel-5", lambda world: world.map.edge_count >= 7)
    yield shrunk("cube", lambda world: True, "simple")
    yield shrunk("k4-torus", lambda world: world.map.genus)
    yield shrunk("theta", lambda world: False)
    yield shrunk("star-16", lambda world: False)
    yield shrunk("star-17", lambda world: False)
    yield shrunk("wheel-9", lambda world: max(world.map.degrees) > 4)
    maps = [named_map("k4"), from_cycles([[*"llab"], [*"abc"], [*"cd"], ["d"]])]
    for given in ((2, 1), (9, 1)):
        found = refuted_in(maps, MapsRequest(wrong_from(*given)))
        yield as_json(found) if found else "no finding"
    for condition in ({"map_class": "simple"}, {"where": "cubic"}):
        found = refuted_in(maps, MapsRequest(wrong_from(2), **condition))
        yield as_json(found) if found else "no finding"


# ---------------------------------------------------------------- comparisons


@case
def comparisons():
    both = ("algorithm1", "folding")
    yield told(allworlds.compare, *both, edges=2)
    yield told(allworlds.compare, *both, edges=3, shard=(1, 3), by="world")
    yield told(allworlds.compare, *both, edges=3, where="cubic")
    yield told(allworlds.compare, "algorithm1", stays, edges=2)
    yield told(allworlds.compare, *both, family="prism:3")
    yield told(allworlds.compare, "algorithm1", "dfs", vertices=3, map_class="simple")


@case
def growth():
    yield told(allworlds.compare, "algorithm1", "dfs", family="strip,prism", to=24, draws=2)
    yield told(allworlds.compare, "dfs", family="prism", to=12)
    yield told(allworlds.compare, stays, "algorithm1", loop_at_once, family="strip", to=13, draws=1)
    yield told(allworlds.compare, "algorithm1", stays, family="torus", to=18, draws=3, places=2)
    yield told(allworlds.compare, "dfs", "algorithm1", family="dense", to=60, draws=6, places=1)


# ---------------------------------------------------------------- worlds that look alike


@case
def ambiguity():
    yield told(allworlds.ambiguity.census, edges=3)
    yield told(allworlds.ambiguity.census, edges=4, lighthouse="none", shard=(1, 2))
    yield told(allworlds.ambiguity.sensors, "position", "door", "none", edges=2)
    for name in ("edge", "theta", "wheel-4", "cycle-3"):
        for lighthouse in ("position", "directional"):
            yield as_json(allworlds.ambiguity.class_of(world_named(name, lighthouse)))
    for one, other in (("cycle-2", "cycle-4"), ("theta", "theta-torus"), ("k4", "k4-torus")):
        for lighthouse in ("none", "position", "directional"):
            pair = [world_named(name, lighthouse) for name in (one, other)]
            yield as_json(allworlds.twins(*pair))


@case
def numbers():
    yield told(allworlds.count, edges=3)
    yield told(allworlds.count, edges=3, shard=(1, 2))
    yield told(allworlds.count, map_class="simple", vertices=3)
    yield told(allworlds.worst, edges=2)
    yield told(allworlds.check, "algorithm1", edges=2, engine="python")
    yield told(allworlds.check, stays, edges=2, max_findings=3)
    yield told(allworlds.check, wrong_from(2, 2), edges=3, max_findings=2)
