"""Beyond the paper: which sensors suffice in place of the directional lighthouse."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from pathlib import Path

from allworlds import CombinatorialMap, World, ambiguity
from allworlds.ambiguity import sensors, weakest
from allworlds.claims import Found, Means, Picture, truth
from allworlds.maps import unrooted_code

SENSORS = Path(__file__).with_name("sensors.py")


def own(name: str) -> str:
    """The lighthouse of that name in ``sensors.py``."""
    return f"{SENSORS}:{name}"


def suffices(word: str) -> bool:
    """Theorem 1, for one degree: the word is no proper power, and not blank throughout."""
    powers = (word[:p] * (len(word) // p) for p in range(1, len(word)))
    return word not in powers and set(word) != {"0"}


def words_to(degree: int) -> list[str]:
    """Every word of the letters 0 and 1, or 1 and 2, with so many letters at most."""
    lengths = range(1, degree + 1)
    found = ("".join(w) for n in lengths for two in ("01", "12") for w in product(two, repeat=n))
    return [*dict.fromkeys(found)]


def primitive_words(_: Means, *, degree: int, edges: int) -> Found:
    """Compare Theorem 1 with every world in which v0 has as many doors as the word has letters."""
    words = words_to(degree)
    rows = sensors(*(own(f"AtDegree:word={word}") for word in words), edges=edges).rows
    found = {word: row.sufficient for word, row in zip(words, rows, strict=True)}
    # A word that is no power must suffice. The twins of a power may be larger.
    beyond = [word for word in words if found[word] and not suffices(word)]
    right = all(found[word] for word in words if suffices(word))
    witnesses = {
        "words that suffice": sum(map(suffices, words)),
        "words with twins": sum(not enough for enough in found.values()),
        "worlds": sum(row.worlds for row in rows),
    }
    return Found(truth(right), witnesses, {"powers whose twins are larger": len(beyond)})


def powers_have_twins(_: Means, *, powers: Sequence[Sequence[int]]) -> Found:
    """Build the two worlds of the proof for words u^k; as a control with a direction."""
    alike, apart, edges, pictures = 0, 0, [], []
    for k, p in powers:
        word = ("2" * (p - 1) + "1") * k
        maps = [of_power(k, p, joined=joined) for joined in (False, True)]
        one, other = (World(map_, own(f"AtDegree:word={word}")) for map_ in maps)
        alike += ambiguity.twins(one, other).twins
        apart += ambiguity.twins(*(World(map_, "directional") for map_ in maps)).distinguishable
        edges.append(one.map.edge_count)
        pictures += [Picture(f"k = {k}, p = {p}, {x}", w) for x, w in (("A", one), ("B", other))]
    witnesses = {"pairs": len(powers), "told apart with a direction": apart}
    truly = alike == apart == len(powers)
    return Found(truth(truly), witnesses, {"edges": edges}, tuple(pictures[:2]))


def of_power(k: int, p: int, *, joined: bool) -> CombinatorialMap:
    """v0 with kp doors, joined by p edges to each of k vertices with two doors more.

    These two are a loop, or joined to the next vertex and the one before.
    """
    size = p + 2
    sigma = [(i + 1) % (k * p) for i in range(k * p)]
    alpha = [0] * (2 * k * (p + 1))
    for i in range(k):
        first, following = k * p + i * size, k * p + (i + 1) % k * size
        sigma += [first + (j + 1) % size for j in range(size)]
        last, before = first + size - 1, (following if joined else first) + size - 2
        for a, b in [(i * p + j, first + j) for j in range(p)] + [(last, before)]:
            alpha[a], alpha[b] = b, a
    return CombinatorialMap(sigma, alpha)


def door_suffices(_: Means, *, edges: int) -> Found:
    """Every world with a door, from every start at v0; as a control with the position alone."""
    door, position = sensors("door", "position", edges=edges).rows
    twins = position.twins
    different = twins and len({unrooted_code(world.map) for world in twins.worlds}) == len(
        twins.worlds
    )
    witnesses = {"worlds": door.worlds, "alike with the position alone": position.ambiguous}
    return Found(truth(door.sufficient and bool(different)), witnesses)


def directional_not_minimal(_: Means, *, edges: int) -> Found:
    """What a door shows follows from what a direction shows, not the other way, and suffices."""
    report = sensors("door", "directional", edges=edges)
    door, directional = report.rows
    less = ("door", "directional") in report.coarser and len(report.coarser) == 1
    witnesses = {"worlds": directional.worlds}
    return Found(truth(less and door.sufficient and report.minimal == ("door",)), witnesses)


def door_minimal(_: Means, *, edges: int, degrees: Sequence[int]) -> Found:
    """A door that is not seen at one degree has twins; as a control the door."""
    names = [own(f"DoorBut:degree={degree}") for degree in degrees]
    *rows, door = sensors(*names, "door", edges=edges).rows
    firsts = [row.first for row in rows]
    truly = door.sufficient and not any(row.sufficient for row in rows)
    return Found(truth(truly), {"sensors": len(rows)}, {"edges of the twins": firsts})


def weakest_sensors(_: Means, *, edges: int) -> Found:
    """Every coarsening of six kinds of darts: whether one of one bit is minimal, and numbers."""
    report = weakest(own("Features"), edges=edges)
    bits = sum(len(one.letters) == 2 for one in report.minimal)
    numbers = [report.coarsenings, report.sufficient, len(report.minimal), bits]
    witnesses = {"refuted lower neighbours": len(report.refuted)}
    figures = {"coarsenings, sufficient, minimal, of one bit": numbers}
    return Found(truth(bits > 0), witnesses, figures)
