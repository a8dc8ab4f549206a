"""No change of a pair that says something else is accepted.

The claims' own checkers are called, which know nothing of digests: so what is asked is whether a
producer that is wrong would be noticed, not whether a file is the one that was committed.
"""

import json
import random

import pytest

SEED = 18
PAIRS = ["fig1/pairs.json", "smallest-pairs/pairs.json", "natural-lighthouse/pair.json"]
OTHERS = [-1, -8, 1, 2, 3, 8, 10**30, True, None, 0.0, "0", "xyz", [], {}, [0], [[0]]]


def places(value, path=()):
    """The path to every part of a document."""
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value)
    for key, part in items if not isinstance(value, str) else ():
        if isinstance(part, dict | list):
            yield from places(part, (*path, key))
        else:
            yield (*path, key)


def part_at(document, path):
    for key in path:
        document = document[key]
    return document


def changed_at(document, path, value):
    document = json.loads(json.dumps(document))
    if not path:
        return value
    part_at(document, path[:-1])[path[-1]] = value
    return document


def is_harmless(document, path, value):
    """Another start that looks the same, or another dart for the same mark of v0."""
    if path[-1:] not in {("start",), ("dart",)} or type(value) is not int or value < 0:
        return False
    at = path.index("pair")
    world, classes = (
        part_at(document, (*path[:at], name, path[at + 1])) for name in ("pair", "bisimulation")
    )
    around = [world["start"]]
    while world["sigma"][around[-1]] != around[0]:
        around.append(world["sigma"][around[-1]])
    return value in around and (path[-1] == "dart" or classes[value] == classes[world["start"]])


def accepted_changes(checkers, checker_of, proofs, name, tries):
    """Changes of one part that are accepted; all, or so many, chosen by the seed."""
    require_pairs = checker_of(name.split("/")[0]).require_pairs
    document = json.loads((proofs / name).read_text())
    changes = [(path, value) for path in places(document) for value in OTHERS]
    if tries is not None and tries < len(changes):
        changes = random.Random(f"{SEED} {name}").sample(changes, tries)
    require_pairs(document)
    for path, value in changes:
        old = part_at(document, path)
        if type(old) is type(value) and old == value:
            continue
        try:
            require_pairs(changed_at(document, path, value))
        except checkers("lrat").Refused:
            continue
        yield document, path, value


@pytest.mark.parametrize("name", PAIRS)
def test_no_change_of_one_part_of_a_pair_is_accepted_but_a_harmless_one(
    checkers, checker_of, proofs, name
):
    tries = None if name.startswith("natural") else 400
    for document, path, value in accepted_changes(checkers, checker_of, proofs, name, tries):
        assert is_harmless(document, path, value), (path, value)


def natural(proofs_):
    return json.loads((proofs_ / "natural-lighthouse" / "pair.json").read_text())


def relabelled(document):
    """World 2 is world 1 with other names of the darts."""
    world = document["pair"][0]
    size = len(world["sigma"])
    names = [(d + 3) % size for d in range(size)]
    back = [names.index(d) for d in range(size)]
    document["pair"][1] = {
        **{p: [names[world[p][back[d]]] for d in range(size)] for p in ("sigma", "alpha")},
        "start": names[world["start"]],
        "lighthouse": {"kind": "natural", "dart": names[world["lighthouse"]["dart"]]},
    }
    document["bisimulation"][1] = [document["bisimulation"][0][back[d]] for d in range(size)]


def set_in(index, key, value):
    return lambda document: document["pair"][index].update({key: value})


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (relabelled, "the two worlds are the same"),
        (lambda d: d.update(bisimulation=[[0] * 8] * 2), "does not behave as its class"),
        (lambda d: d["pair"][0]["alpha"].__setitem__(0, 0), "permutation"),
        (lambda d: d["pair"][0]["sigma"].__setitem__(0, 0), "permutation"),
        (lambda d: d["bisimulation"][1].pop(), "not one class for each dart"),
        (set_in(1, "start", 3), "is not at the start's vertex"),
        (set_in(0, "start", -8), "start is -8, but the darts are 0 to 7"),
        (set_in(0, "start", 8), "start is 8, but the darts are 0 to 7"),
        (set_in(0, "start", "0"), "start is '0', but the darts"),
        (set_in(0, "start", value=True), "start is True, but the darts"),
        (set_in(0, "more", 1), "with the names alpha, lighthouse, sigma, start alone"),
        (set_in(0, "sigma", "10345672"), "sigma: not a list of integers"),
        (set_in(0, "lighthouse", {"kind": "xyz", "dart": 0}), "is 'xyz', not 'natural'"),
        (set_in(0, "lighthouse", {"kind": "none", "dart": 0}), "is 'none', not 'natural'"),
        (set_in(0, "lighthouse", {"kind": "natural"}), "with the names dart, kind alone"),
        (lambda d: d["pair"].append(d["pair"][0]), "not two worlds"),
        (lambda d: d["pair"].reverse(), "does not behave|plane and one on the torus"),
        (lambda d: d.clear(), "with the names bisimulation, pair alone"),
    ],
)
def test_a_damaged_pair_is_refused_by_what_is_amiss(checkers, checker_of, proofs, damage, message):
    document = natural(proofs)
    damage(document)
    with pytest.raises(checkers("lrat").Refused, match=message):
        checker_of("natural-lighthouse").require_pairs(document)


def test_the_pair_of_another_claim_is_refused(checkers, checker_of, proofs):
    refused = checkers("lrat").Refused
    pairs = {name: json.loads((proofs / name).read_text()) for name in PAIRS[:2]}
    figure, smallest = pairs.values()
    for wrong in (
        {**smallest, "simple": smallest["maps"]},
        {**smallest, "planar-simple": smallest["simple"]},
        {**smallest, "maps": figure["wheel"]},
    ):
        with pytest.raises(refused):
            checker_of("smallest-pairs").require_pairs(wrong)
    for wrong in (
        {**figure, "wheel": figure["planar-simple"]},
        {**figure, "planar-simple": figure["wheel"]},
        {**figure, "wheel": {part: figure["wheel"][part][::-1] for part in figure["wheel"]}},
    ):
        with pytest.raises(refused):
            checker_of("fig1").require_pairs(wrong)
