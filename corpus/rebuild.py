"""Write every file of the corpus and its manifest anew from the recipes below."""

import hashlib
import json
from pathlib import Path
from typing import Any

import allworlds
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.maps.build import from_cycles, from_rotation, lattice, named_map
from allworlds.studies.ambiguity.members import twins
from allworlds.studies.check.exhaustive import check
from allworlds.world.lighthouses.marked import Directional, Position
from allworlds.world.world import World

HERE = Path(__file__).parent

# name: map, pointed dart, provenance, (edges, vertices, faces, genus, automorphisms, cost).
# The numbers of the map are elementary; the cost is that of an independent implementation of
# Algorithm 1 with the same policy.
WORLDS = {
    "loop": (named_map("loop"), 0, "the smallest map with one vertex", (1, 1, 2, 0, 2, 1)),
    "edge": (named_map("edge"), 0, "the smallest map with two vertices", (1, 2, 1, 0, 2, 1)),
    "two-loops-plane": (
        named_map("two-loops-plane"),
        0,
        "with its twin on the torus the smallest pair that position alone does not tell apart",
        (2, 1, 3, 0, 2, 2),
    ),
    "two-loops-torus": (
        named_map("two-loops-torus"),
        0,
        "the twin of two-loops-plane",
        (2, 1, 1, 1, 4, 2),
    ),
    "theta": (named_map("theta"), 0, "three parallel edges in the plane", (3, 2, 3, 0, 6, 8)),
    "theta-torus": (
        named_map("theta-torus"),
        0,
        "three parallel edges on the torus",
        (3, 2, 1, 1, 6, 6),
    ),
    "dipole-4": (named_map("dipole-4"), 2, "four parallel edges in the plane", (4, 2, 4, 0, 8, 14)),
    "dipole-5": (
        named_map("dipole-5"),
        0,
        "five parallel edges in the plane",
        (5, 2, 5, 0, 10, 22),
    ),
    "k4": (named_map("k4"), 0, "the tetrahedron", (6, 4, 4, 0, 12, 35)),
    "k4-torus": (
        named_map("k4-torus"),
        0,
        "K4 on the torus, with faces of 4 and 8 darts",
        (6, 4, 2, 1, 4, 31),
    ),
    "wheel-4": (
        named_map("wheel-4"),
        0,
        "the wheel with four spokes, from its hub",
        (8, 5, 5, 0, 4, 56),
    ),
    "cube": (named_map("cube"), 0, "the cube", (12, 8, 6, 0, 24, 152)),
    "lattice-with-holes": (
        lattice(4, 4, 0.1, 7),
        0,
        "a lattice of 4 x 4 vertices without 10 % of its edges, as in Fig. 3",
        (22, 16, 8, 0, 1, 178),
    ),
    "fig2-step": (
        from_cycles(["ab", "acd", "bec", "de"]),
        0,
        "Fig. 2: the smallest simple planar world in whose exploration a loop is closed after "
        "other hypotheses were rejected, and a vertex is added after all were (enumeration)",
        (5, 4, 3, 0, 2, 22),
    ),
    "fig1-left": (
        named_map("fig1-left"),
        0,
        "a candidate for Fig. 1, whose drawing is not known: planar, simple, n = 9, m = 14",
        (14, 9, 7, 0, 2, 212),
    ),
    "fig1-right": (named_map("fig1-right"), 0, "the twin of fig1-left", (14, 9, 7, 0, 2, 198)),
}

# name: two maps whose vertex 0 is marked, provenance.
PAIRS = {
    "two-loops": (
        named_map("two-loops-plane"),
        named_map("two-loops-torus"),
        "the smallest pair that position alone does not tell apart",
    ),
    "k4": (
        named_map("k4"),
        from_rotation([[1, 2, 3], [0, 2, 3], [0, 3, 1], [0, 1, 2]]),
        "one of the smallest simple pairs, m = 6: K4 in the plane, and on the torus with faces of "
        "3 and 9 darts",
    ),
    "hexagon-triangles": (
        from_rotation([[1, 4], [0, 6, 2], [1, 3], [2, 4], [0, 3, 5], [4, 6], [5, 1]]),
        from_rotation([[1, 4], [0, 3, 2], [1, 3], [2, 1], [0, 6, 5], [4, 6], [5, 4]]),
        "the smallest simple planar pair: a vertex joined to opposite corners of a hexagon, and "
        "one joining two triangles",
    ),
    "fig1": (
        named_map("fig1-left"),
        named_map("fig1-right"),
        "a candidate for Fig. 1, whose drawing is not known",
    ),
}

# By the number of edges, from 1 on; fingerprints by it, and by the number of vertices, from 1 on.
COUNTS: dict[str, dict[str, Any]] = {
    "maps": {
        "provenance": "rooted: OEIS A000698 shifted; unrooted: OEIS A170946; fingerprints: two "
        "compiled enumerations that share no code but the fingerprint, and to 7 edges a third one "
        "in Python",
        "rooted": [2, 10, 74, 706, 8162, 110410],
        "unrooted": [2, 5, 20, 107, 870],
        "fingerprints": {
            "6": [
                "27c06bee1110015b",
                "226957fdf4d372d3",
                "214ac88c872e82db",
                "60b47e7317277b6",
                "9d40f9939ad209d",
                "ab4d218ec9ad294",
                "304d28e5c8c39233",
            ],
            "7": [
                "1923ac98f02c86bd",
                "36f1c164e7ee3ebe",
                "3eed8f4b8535f9c9",
                "2f5a534d49ab3480",
                "39752ed084778503",
                "20725ff99c2174ea",
                "9bca01d33fe1925",
                "6f0c29311d3c7a2",
            ],
            "8": [
                "139d41251bfe6e4f",
                "1320190d41204889",
                "18bca22fc69a6250",
                "39822fc64427d6d8",
                "1440e1a34367f7d8",
                "29b32e4a8bef56c2",
                "312ab7beda01355e",
                "2590ffc6958ed68e",
                "11a123f084a28817",
            ],
        },
    },
    "planar": {
        "provenance": "rooted: OEIS A000168 (Tutte 1963); unrooted: OEIS A006384",
        "rooted": [2, 9, 54, 378, 2916, 24057],
        "unrooted": [2, 4, 14, 57],
    },
    "simple": {
        "provenance": "labelled rotation systems of connected simple graphs summed over graphs",
        "rooted": [1, 2, 6, 23],
        "unrooted": [1, 1, 3, 5],
    },
}

DUDEK_BOUND = "3*n*(n-1)//2 + (m-n+1)*(5*n+2*D-4)"

# name: options of the check, provenance, what must come out; "dearest" by the number of edges.
CHECKS: dict[str, tuple[dict[str, object], str, dict[str, object]]] = {
    "dudek91-simple": (
        {"explore": "dudek91", "edges": 5, "map_class": "simple"},
        "right in simple worlds (Dudek, Jenkin, Milios, Wilkes 1991), within its own bound",
        {"verdict": "holds", "bound": DUDEK_BOUND, "worlds": 140, "runs": 140},
    ),
    "dudek91-simple-all-schedules": (
        {"explore": "dudek91", "edges": 4, "map_class": "simple", "schedules": "all"},
        "whichever dart leaves U",
        {"verdict": "holds", "bound": DUDEK_BOUND, "worlds": 32, "runs": 32},
    ),
    "dudek91-maps": (
        {"explore": "dudek91", "edges": 4},
        "no marker at a vertex tells apart the two maps of one vertex with two loops",
        {"verdict": "refuted", "smallest": ["map", 2, 1]},
    ),
    "dfs": (
        {"explore": "dfs", "edges": 4},
        "every edge there and back once, at most",
        {"verdict": "holds", "bound": "2*m", "worlds": 792, "runs": 792},
    ),
    "quotient": (
        {"explore": "quotient", "edges": 3},
        "a map exactly where the class has one member",
        {"verdict": "holds", "worlds": 86, "runs": 86},
    ),
    "folding": (
        {"explore": "folding", "edges": 4},
        "a log whose folding has no open dart is the map",
        {"verdict": "holds", "worlds": 792, "runs": 3684},
    ),
    "folding-oldest": (
        {"explore": "folding-oldest", "edges": 4},
        "the same on another fair way",
        {"verdict": "holds", "worlds": 792, "runs": 3684},
    ),
    "algorithm1-position": (
        {"explore": "algorithm1", "edges": 2, "lighthouse": "position"},
        "Algorithm 1 robbed of the bearing",
        {"verdict": "refuted"},
    ),
    "algorithm1-none": (
        {"explore": "algorithm1", "edges": 2, "lighthouse": "none"},
        "Algorithm 1 robbed of the marker",
        {"verdict": "refuted"},
    ),
}


def write(folder: str, name: str, document: object) -> dict[str, str]:
    """Write a document; its file and digest."""
    path = HERE / folder / f"{name}.json"
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return {"file": f"{folder}/{name}.json", "sha256": digest}


def world_entries() -> list[dict[str, object]]:
    """The named worlds."""
    keys = ("edges", "vertices", "faces", "genus", "automorphisms", "cost")
    return [
        {
            "name": name,
            "kind": "world",
            **write("worlds", name, World(map_, Directional(dart)).to_json()),
            "provenance": provenance,
            "expected": {"verdict": "holds", **dict(zip(keys, numbers, strict=True))},
        }
        for name, (map_, dart, provenance, numbers) in WORLDS.items()
    ]


def elsewhere(document: dict[str, Any]) -> dict[str, Any]:
    """The document without the place of this checkout in its traceback."""
    here = str(Path(allworlds.__file__).parents[1])
    detail = document.get("detail")
    return {**document, "detail": detail.replace(here, "src")} if detail else document


def finding_entries() -> list[dict[str, object]]:
    """The smallest finding of every mutant."""
    entries = list[dict[str, object]]()
    for mutant in WRONG_EXPLORERS:
        name = f"allworlds.corpus.explorers:{mutant.name.replace('-', '_')}"
        finding = check(name, edges=4).uninterrupted().findings[0]
        entries.append(
            {
                "name": f"mutant-{mutant.name}",
                "kind": "finding",
                **write("findings", mutant.name, elsewhere(finding.to_json())),
                "provenance": f"the smallest world that refutes this mutant: {mutant.breaks}",
                "expected": {"law": finding.law, "outcome": "reproduced"},
            }
        )
    return entries


def pair_entries() -> list[dict[str, object]]:
    """Pairs that no motion tells apart under position, with their bisimulations."""
    entries = list[dict[str, object]]()
    for name, (left, right, provenance) in PAIRS.items():
        worlds = [World(map_, Position(0)) for map_ in (left, right)]
        document = {
            "worlds": [world.to_json() for world in worlds],
            "bisimulation": twins(*worlds).to_json()["bisimulation"],
        }
        entries.append(
            {
                "name": f"pair-{name}",
                "kind": "pair",
                **write("pairs", name, document),
                "provenance": provenance,
                "expected": {"twins": True},
            }
        )
    return entries


def count_entries() -> list[dict[str, object]]:
    """The known numbers of maps."""
    return [
        {
            "name": f"counts-{name}",
            "kind": "counts",
            **write("counts", name, {"class": name, **numbers}),
            "provenance": numbers["provenance"],
            "expected": {"agrees": True},
        }
        for name, numbers in COUNTS.items()
    ]


def check_entries() -> list[dict[str, object]]:
    """Checks of explorers, with the verdict that each must get."""
    return [
        {
            "name": f"check-{name}",
            "kind": "check",
            **write("checks", name, options),
            "provenance": provenance,
            "expected": {"verdict": "holds", **expected},
        }
        for name, (options, provenance, expected) in CHECKS.items()
    ]


if __name__ == "__main__":
    entries = [*world_entries(), *finding_entries(), *pair_entries(), *count_entries()]
    entries += check_entries()
    manifest = {"schema": 1, "entries": entries}
    (HERE / "manifest.json").write_text(json.dumps(manifest, indent=1) + "\n", encoding="utf-8")
