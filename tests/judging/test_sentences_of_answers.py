"""Every sentence about an answer that is wrong, or was guessed, is true, and said where it is due.

What is true is found here anew, by trying all: of the world's permutations, the walk and the
answer this module knows no more than the explanation has to tell.
"""

import random
import re
from functools import cache

from allworlds.judging.explanations.by_law import GUESSED
from allworlds.maps import (
    CombinatorialMap,
    contracted,
    deleted,
    isomorphism,
    rooted_isomorphism,
    rooted_maps,
)
from allworlds.protocol.actions import Estimate, Move, Percept
from allworlds.studies.explain import explain
from allworlds.studies.run import run
from allworlds.words import listed, plural, size
from allworlds.world import Directional, World
from small import all_maps

MAPS = all_maps(3)
CHIRAL = [each for each in rooted_maps(4) if not isomorphism(each, each.mirrored())][::40]
"""Maps that are no mirror images of themselves: the smallest ones have four edges."""


def turned(map_, dart, k):
    """The dart ``k`` places further clockwise."""
    for _ in range(k % map_.degree_at[dart]):
        dart = map_.sigma[dart]
    return dart


def places_between(map_, dart, other):
    """How many places clockwise the other dart of the vertex lies."""
    return next(k for k in range(map_.degree_at[dart]) if turned(map_, dart, k) == other)


def walk_from(map_, dart, motions):
    trail = [dart]
    for k in motions:
        trail.append(map_.alpha[turned(map_, trail[-1], k)])
    return trail


@cache
def owners(map_):
    """For each dart the number of its vertex: vertices are numbered by their smallest darts."""
    owner = {}
    for dart in map_.darts:
        around = dart
        while around not in owner:
            owner[around] = len(set(owner.values())) if around == dart else owner[dart]
            around = map_.sigma[around]
    return owner


def percept_at(map_, dart, north):
    """Sensed by who came by a dart, where the lighthouse points along ``north``."""
    owner = owners(map_)
    degree = map_.degree_at[dart]
    if owner[dart] != owner[north]:
        return Percept(degree)
    return Percept(degree, 1, next(k for k in range(degree) if turned(map_, dart, k) == north))


class Truth:
    """A finding, and what is true of it."""

    def __init__(self, finding):
        self.law, self.log, self.answer = finding.law, finding.transcript, finding.seen
        self.map, self.start = finding.world.map, finding.world.start
        self.motions = [action.k for action in self.log.actions]
        self.sensed = self.log.percepts
        self.walk = walk_from(self.map, self.start, self.motions)
        self.robot = self.walk[-1]
        self.owner = owners(self.map)

    def vertex(self, dart):
        return f"v{self.owner[dart]}"

    def place(self, dart):
        return f"{self.vertex(dart)}, dart {dart}"

    def left(self, dart, step):
        """When before a step the robot was last at the vertex of a dart."""
        last = max(i for i in range(step) if self.owner[self.walk[i]] == self.owner[dart])
        if last == step - 1:
            return "which it had just left"
        return f"which it had left at step {last + 1}"

    # ------------------------------------------------------------ the walk in the answer

    def parting(self):
        """The step at which a walk in the answer diverges, what it means there, and its misfits.

        Of all walks with these motions it is the one that agrees for longest, of equals the one
        that ends at ``here``, then the one whose degrees agree for longest.  Any but that one
        diverges at its end at the latest, where it leaps there.
        """
        trails = [walk_from(self.answer.map, d, self.motions) for d in self.answer.map.darts]
        trails.sort(key=lambda trail: (trail[-1] != self.answer.here, -self._degrees(trail)))
        ends = [[*trail[:-1], self.answer.here] for trail in trails]
        to_here, *others = map(self._diverges, ends)
        leaping = [found for found in others if found[0] < len(self.walk)]
        return max([to_here, *leaping], key=lambda found: found[0])

    def _degrees(self, trail):
        alike = [
            self.answer.map.degree_at[dart] == percept.degree
            for dart, percept in zip(trail, self.sensed, strict=True)
        ]
        return [*alike, False].index(False)

    def _diverges(self, trail):
        map_, bearing = self.answer.map, self.sensed[0].bearing
        expected = [Percept(map_.degree_at[dart]) for dart in trail]
        if bearing < map_.degree_at[trail[0]]:  # else there is no dart that it can point along
            north = turned(map_, trail[0], bearing)
            expected = [percept_at(map_, dart, north) for dart in trail]
        misfits = [i for i, each in enumerate(expected) if each != self.sensed[i]]
        pairs = set()
        for step, (robot, belief) in enumerate(zip(self.walk, trail, strict=True)):
            means = next((a for a, b in pairs if b == belief), None)
            fresh = self.owner[robot] not in {self.owner[dart] for dart in self.walk[:step]}
            pairs |= {
                (turned(self.map, robot, k), turned(map_, belief, k))
                for k in range(self.map.degree_at[robot])
            }
            one_to_one = all(len(pairs) == len({pair[i] for pair in pairs}) for i in (0, 1))
            if step in misfits or not one_to_one:
                return step, means, fresh, misfits, expected
        return len(trail), None, False, misfits, expected

    def told_parting(self):
        """The sentences about the walk in the answer."""
        step, means, fresh, misfits, expected = self.parting()
        if step == len(self.walk):
            fits = (
                "The answer is another world that fits the whole log: nothing that the robot "
                "sensed tells the two worlds apart, so the answer was guessed."
            )
            return [fits, *self.told_open_darts()]

        def misfit(at):
            if not any(each.marks for each in expected):
                lacks = (
                    f"the answer has {expected[at]}, and its map has no place for the lighthouse"
                )
                return f"the robot sensed '{self.sensed[at]}', where {lacks}"
            return (
                f"the robot sensed '{self.sensed[at]}', where the answer predicts '{expected[at]}'"
            )

        robot, here = self.walk[step], misfit(step) if step in misfits else ""
        vertex = self.vertex(robot)
        if step == 0:
            return [f"The world and the answer differ at the start, at {vertex}: {here}."]
        first = f"At step {step} the robot "
        first += f"came to {vertex} for the first time, " if fresh else f"was back at {vertex}, "
        first += "" if fresh else f"{self.left(robot, step)}, "
        if means == (None if fresh else robot):
            return [f"{first.removesuffix(', ')}. In the answer this is so, too, but {here}."]
        if means is None:
            first += "but its answer takes this vertex for a new one"
        elif self.owner[means] == self.owner[robot]:
            first += f"but in its answer it came in by dart {means}, in truth by dart {robot}"
        else:
            first += f"but its answer takes this vertex for {self.vertex(means)}, "
            first += self.left(means, step)
        if here:
            return [f"{first}: {here}."]
        if misfits:
            later = f"The answer is first contradicted at step {misfits[0]}: "
            return [f"{first}.", f"{later}{misfit(misfits[0])}."]
        short = (
            "Every percept fits the answer, too: the walk was too short to tell the two maps apart."
        )
        return [f"{first}.", short, *self.told_open_darts()]

    # ------------------------------------------------------------ what the log proves

    def told_open_darts(self):
        """Classes of (time, place in the rotation): equal where the log proves it."""
        degrees = [percept.degree for percept in self.sensed]
        spots = [(i, j) for i, degree in enumerate(degrees) for j in range(degree)]
        of = {spot: spot for spot in spots}

        def merge(a, b):
            if of[a] == of[b]:
                return False
            old, new = of[b], of[a]
            of.update((spot, new) for spot in spots if of[spot] == old)
            return True

        same = [
            ((0, (self.sensed[0].bearing + j) % degrees[0]), (i, (each.bearing + j) % degrees[i]))
            for i, each in enumerate(self.sensed)
            if each.marks
            for j in range(degrees[i])
        ]
        edges = [((i, k % degrees[i]), (i + 1, 0)) for i, k in enumerate(self.motions)]
        edges += [(b, a) for a, b in edges]
        while True:
            new = [merge(a, b) for a, b in same]
            new += [merge(b, d) for a, b in edges for c, d in edges if of[a] == of[c]]
            following = {(i, j): (i, (j + 1) % degrees[i]) for i, j in spots}
            pairs = [(a, b) for a in spots for b in spots if of[a] == of[b]]
            new += [merge(following[a], following[b]) for a, b in pairs]
            if not any(new):
                break
        known = {of[a] for a, _ in edges}
        dart = {spot: turned(self.map, self.walk[spot[0]], spot[1]) for spot in spots}
        open_ = sorted({dart[spot] for spot in spots if of[spot] not in known})
        if not open_:
            return []
        names = [f"dart {each} of {self.vertex(each)}" for each in open_]
        if len(names) > 3:
            names = [*names[:3], plural(len(names) - 3, "other dart")]
        lead = "lead" if len(names) > 1 else "leads"
        told = [f"After this walk it is not known where {listed(names)} {lead}."]
        copies = {}
        for i, robot in enumerate(self.walk):
            copies.setdefault(self.vertex(robot), set()).add(
                min(of[i, j] for j in range(degrees[i]))
            )
        twice = [f"{v} by {len(c)} paths" for v, c in sorted(copies.items()) if len(c) > 1]
        if twice:
            one = "each of these" if len(twice) > 1 else "this"
            told.append(
                f"The robot came to {listed(twice)}, and the log does not show that {one} was "
                "always the same vertex."
            )
        return told

    # ------------------------------------------------------------ one difference

    def mirrored(self):
        inverse = [0] * len(self.answer.map.sigma)
        for dart, following in enumerate(self.answer.map.sigma):
            inverse[following] = dart
        return CombinatorialMap(inverse, self.answer.map.alpha)

    def bearings_fit(self, way):
        """Whether the percepts are those of the answer, if bearings are counted that way round."""
        map_ = self.answer.map
        (trail,) = (
            trail
            for dart in map_.darts
            if (trail := walk_from(map_, dart, self.motions))[-1] == self.answer.here
        )
        taken, seen = set(), {}
        for i, (dart, percept) in enumerate(zip(trail, self.sensed, strict=True)):
            edge = frozenset({dart, map_.alpha[dart]}) if i else None
            counts = edge not in taken or self.law == "pose"
            taken.add(edge)
            if not counts:
                continue
            if map_.degree_at[dart] != percept.degree:
                return False
            pointed = percept.bearing
            if pointed is not None:
                pointed = turned(map_, dart, way * pointed)
            seen.setdefault(owners(map_)[dart], set()).add((percept.marks, pointed))
        return all(len(each) == 1 for each in seen.values())

    def glued(self, map_):
        """The maps in which two edges are glued otherwise, with the darts that have moved."""
        for a, b in map_.edges:
            for c, d in map_.edges:
                if {a, b} == {c, d}:
                    continue
                for x, y, u, v in ((a, c, b, d), (a, d, b, c)):
                    alpha = [*map_.alpha]
                    alpha[x], alpha[y], alpha[u], alpha[v] = y, x, v, u
                    if joined(map_.sigma, alpha):
                        yield CombinatorialMap(map_.sigma, alpha)

    def difference(self):
        """The kind of the one difference, as it is looked for."""
        answer, world = self.answer.map, self.map
        if rooted_isomorphism(self.mirrored(), self.answer.here, world, self.robot):
            return "mirror"
        if isomorphism(self.mirrored(), world):
            return "mirror map"
        if self.bearings_fit(-1) and not self.bearings_fit(1):
            return "bearings"
        if any(isomorphism(each, world) for each in self.glued(answer)):
            return "crossed"
        if answer.edge_count == world.edge_count:
            fewer = [deleted(world, d) for d, _ in world.edges]
            without = filter(None, (deleted(answer, d) for d, _ in answer.edges))
            moved = any(same(each, other) for other in without for each in fewer)
            return "misplaced" if moved else "sizes"
        for taking, lacking, more in (
            (deleted, "missing", "too many"),
            (contracted, "two for one", "one for two"),
        ):
            if any(same(taking(world, d), answer) for d, _ in world.edges):
                return lacking
            if any(same(taking(answer, d), world) for d, _ in answer.edges):
                return more
        return "sizes"


def same(one, other):
    return one is not None and bool(isomorphism(one, other))


def joined(sigma, alpha):
    reached = {0}
    while more := {p[d] for d in reached for p in (sigma, alpha)} - reached:
        reached |= more
    return len(reached) == len(sigma)


def numbers(text):
    return [int(word) for word in re.findall(r"\d+", text)]


def joining(truth, text):
    """Whether 'joins dart a with b and dart c with d' is so in the answer, if not in the world."""
    a, b, c, d, e, f, g, h = numbers(text)
    alpha = [*truth.map.alpha]
    so = {(e, alpha[e]), (g, alpha[g])} == {(e, f), (g, h)} and {a, b, c, d} == {e, f, g, h}
    alpha[a], alpha[b], alpha[c], alpha[d] = b, a, d, c
    ordered = a < b and c < d and a < c and e < f and g < h and e < g
    return so and ordered and same(CombinatorialMap(truth.map.sigma, alpha), truth.answer.map)


def exchange(truth, text):
    """Whether the answer is the world in which two darts of that vertex are exchanged."""
    x, y, vertex = numbers(text)
    alpha = [*truth.map.alpha]
    a, b = alpha[x], alpha[y]
    alpha[x], alpha[y], alpha[a], alpha[b] = b, a, y, x
    at = truth.owner[x] == truth.owner[y] == vertex and x < y
    return at and same(CombinatorialMap(truth.map.sigma, alpha), truth.answer.map)


def elsewhere(truth, text):
    a, b = numbers(text)
    less = deleted(truth.map, a)
    return truth.map.alpha[a] == b and any(
        same(deleted(truth.answer.map, d), less) for d, _ in truth.answer.map.edges
    )


def lacking(truth, text):
    a, b = numbers(text)
    return truth.map.alpha[a] == b and same(deleted(truth.map, a), truth.answer.map)


def merged(truth, text):
    ends = re.findall(r"v\d+", text)
    return any(
        same(contracted(truth.map, a), truth.answer.map)
        for a, b in truth.map.edges
        if ends == [truth.vertex(a), truth.vertex(b)]
    )


def sizes(truth, text):
    world, answer = (size(m.edge_count, m.vertex_count) for m in (truth.map, truth.answer.map))
    if world == answer:
        return text == f"The answer has {world}, as the world has, but is another map."
    return text == f"The world has {world}, the answer {answer}."


def always(*_):
    return True


BEARINGS = (
    "The explorer seems to count bearings anticlockwise: read so, the percepts show all edges "
    "as the answer has them. A bearing counts the darts clockwise, from the dart by which the "
    "robot arrives to the pointed dart."
)
ONLY = "The answer differs from the world only in this: "
PAIRS = "dart # with # and dart # with #"
DIFFERENCES = {
    "mirror": (
        "mirror image",
        "The answer is a mirror image: with sigma reversed it would be right.",
        always,
    ),
    "mirror map": (
        "mirror image",
        "The answer's map is the world's mirror image: its sigma goes anticlockwise.",
        always,
    ),
    "bearings": (
        "bearings anticlockwise",
        BEARINGS,
        always,
    ),
    "crossed": (
        "edges crossed",
        f"{ONLY}(it joins {PAIRS}, but the world joins {PAIRS}|darts # and # of v# are exchanged).",
        lambda truth, text: (joining if "joins" in text else exchange)(truth, text),
    ),
    "misplaced": (
        "edge misplaced",
        (
            "Only one edge is wrong: the edge of darts # and # of the world is elsewhere in the "
            "answer."
        ),
        elsewhere,
    ),
    "missing": (
        "edge missing",
        "The answer lacks one edge of the world: the edge of darts # and #.",
        lacking,
    ),
    "two for one": (
        "one vertex for two",
        "The answer takes v# and v# for one vertex, and lacks an edge between them.",
        merged,
    ),
    "too many": (
        "edge too many",
        "The answer has one edge too many; without this edge it is the world's map.",
        always,
    ),
    "one for two": (
        "two vertices for one",
        "The answer takes one vertex for two, with an edge between them.",
        always,
    ),
    "sizes": ("", "The (world|answer) has .*", sizes),
}


def findings_of(number, seed, law):
    """Findings of robots that walk at random and answer at random."""
    chance = random.Random(seed)
    while number:
        map_ = chance.choice(MAPS[2:])
        answer = chance.choice(MAPS) if law == "map" else map_
        motions = [chance.randrange(4) for _ in range(chance.randrange(9))]
        here = chance.choice(answer.darts)
        end = walk_from(map_, 0, motions)[-1]
        if law == "folding":
            here = end
        elif law == "map" and chance.random() < 0.2:
            map_ = chance.choice(CHIRAL)
            end = walk_from(map_, 0, motions)[-1]
            answer, here = map_.mirrored(), chance.choice((end, *map_.darts[:2]))

        def explore(_, answer=answer, here=here, motions=motions):
            for k in motions:
                yield Move(k)
            return Estimate(answer, here)

        world = World(map_, Directional(chance.choice(map_.vertices[0])), 0)
        finding = run(explore, world, bound="none").finding
        if finding and finding.law == law:
            number -= 1
            yield finding


def test_of_a_wrong_map_the_difference_and_the_parting_are_told_as_they_are():
    met = set()
    for finding in findings_of(240, 5, "map"):
        truth, told = Truth(finding), explain(finding)
        difference, parting = truth.difference(), truth.told_parting()
        met.add(difference)
        step = truth.parting()[0]
        assert told.step == (None if step == len(truth.walk) else step)
        assert told.sentences[-len(parting) :] == (*parting,), finding
        first = told.sentences[: -len(parting)]
        name, pattern, is_true = DIFFERENCES[difference]
        if difference == "sizes" and told.step is None:
            assert (first, told.slip) == ((), GUESSED)
            continue
        assert re.fullmatch(pattern.replace("#", r"\d+"), first[0]), (first, difference)
        assert len(first) == 1
        assert is_true(truth, first[0]), first
        assert told.slip == (name or None)
        assert told.answer == truth.answer
    assert met == {*DIFFERENCES}


WHERE = (
    r"the robot stands at (v\d+, dart \d+); the answer says (?:(v\d+, dart (\d+))|dart (\d+) of "
    r"the same vertex, (\d+ darts?) too far (anticlockwise|clockwise))\."
    r"( Dart (\d+) is the other end of the edge by which the robot came\.)?"
    r"( As the map is symmetric, (\d+ other darts?) would be right besides dart (\d+)\.)?"
)


def test_of_a_wrong_pose_it_is_told_where_the_robot_is_and_where_it_believes_to_be():
    met = set()
    for finding in findings_of(160, 2, "pose"):
        truth, told = Truth(finding), explain(finding)
        map_, robot, parting = truth.map, truth.robot, truth.told_parting()
        assert told.sentences[-len(parting) :] == (*parting,)
        first, *more = told.sentences[: -len(parting)]
        mirror = rooted_isomorphism(truth.mirrored(), truth.answer.here, map_, robot)
        bearings = truth.bearings_fit(-1) and not truth.bearings_fit(1)
        head = "The map is right, but 'here' is wrong: "
        if mirror:
            head = "Either 'here' is wrong, or sigma of the answer goes anticlockwise: "
            if bearings:
                head = (
                    "Either 'here' is wrong, or sigma of the answer goes anticlockwise, or the "
                    "bearings are counted anticlockwise: "
                )
            assert more == [
                (
                    "This world is its own mirror image, so a run here cannot show which mistake "
                    "was made."
                )
            ]
        else:
            assert more == ([f"Or: {BEARINGS}"] if bearings else [])
        assert first.startswith(head), first
        found = re.fullmatch(WHERE, first.removeprefix(head))
        assert found, first
        stands, place, other, dart, far, way, back, end, _, alike, besides = found.groups()
        said = int(other or dart)
        assert stands == truth.place(robot)
        # The dart is one that 'here' can stand for, at the robot's vertex where there is one.
        images = [
            d
            for d in map_.darts
            if rooted_isomorphism(truth.answer.map, truth.answer.here, map_, d)
        ]
        assert said in images
        near = [d for d in images if truth.owner[d] == truth.owner[robot]]
        if near:
            step, means, *_ = truth.parting()
            nearest = min(near, key=lambda d: places_between(map_, d, robot))
            at_the_end = step == len(truth.walk) - 1 and means in near
            assert said == (means if at_the_end else nearest)
            count = int(far.split()[0])
            assert far == plural(count, "dart")
            assert 2 * count <= map_.degree_at[robot]
            ends = {"clockwise": (robot, said), "anticlockwise": (said, robot)}[way]
            assert turned(map_, ends[0], count) == ends[1]
        else:
            assert place == truth.place(said)
        came = said == map_.alpha[robot] and len(truth.motions) > 0
        assert bool(back) == came
        assert not back or int(end) == said
        symmetries = sum(bool(rooted_isomorphism(map_, robot, map_, d)) for d in map_.darts)
        assert alike == (plural(symmetries - 1, "other dart") if symmetries > 1 else None)
        assert besides == (str(robot) if symmetries > 1 else None)
        slip = "off by a turn" if near else "another vertex"
        assert told.slip == ("bearings anticlockwise" if bearings and not mirror else slip)
        met |= {(bool(near), way, bool(back), bool(alike)), bool(mirror), bool(bearings)}
    assert len(met) > 10


def test_of_a_guess_the_open_darts_and_another_world_are_told():
    for finding in findings_of(60, 3, "folding"):
        truth, told = Truth(finding), explain(finding)
        other = told.other.map
        guessed, another, *more = told.sentences
        assert guessed == (
            "The log does not determine the map, so the answer, right or not, was guessed."
        )
        assert another == (
            f"Another world agrees with the log as well: one with "
            f"{size(other.edge_count, other.vertex_count)}, in which the robot would have sensed "
            "the same."
        )
        assert more == truth.told_open_darts()
        assert more
        assert told.step is told.answer is None
