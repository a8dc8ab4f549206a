"""Writes the formulas, proofs and pairs of the claims.  The producer: the checkers use none of it.

    python proofs/certificates/produce.py [CLAIM...] [--solver PATH]

and the manifest of all claims.  Needs the package with its extra ``proofs``, or a CaDiCaL 2 or
later.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import lzma
import tempfile
from itertools import permutations, product
from pathlib import Path
from typing import Any

from allworlds import search
from allworlds.maps import from_cycles, from_rotation
from allworlds.studies.ambiguity.twin_search import bisimulation
from allworlds.world import Natural, Position, World
from allworlds.world.bisimulation import flaw, same_world_from

HERE = Path(__file__).resolve().parent
CAPTION = {"motions": (1, 1, 2, 2, 1), "percepts": ("3A", "3A", "3A", "3A", "4P")}


def searched(folder: Path, prefix: str, solver: str | None, **bounds: Any) -> list[World]:
    """The pair of a search, or none and for every level formula and proof in the folder."""
    with tempfile.TemporaryDirectory() as out:
        result = search(out=out, solver=solver, **bounds)
        if result.pair:
            return list(result.pair)
        if result.certificate is None:
            raise SystemExit(f"no certificate: {result.notices}")
        for decided in result.levels:
            name = f"{prefix}m{decided.sizes.two.edges}"
            _compress(decided.formula, folder / f"{name}.cnf.xz")
            assert decided.proof is not None
            _compress(decided.proof, folder / f"{name}.lrat.xz")
    return []


def _compress(source: Path, target: Path) -> None:
    target.write_bytes(lzma.compress(source.read_bytes(), preset=9 | lzma.PRESET_EXTREME))


def entry(worlds: list[World]) -> dict[str, Any]:
    """A pair and its bisimulation, as the checkers read them."""
    classes = bisimulation(*worlds)
    if flaw(worlds, classes):
        raise SystemExit(f"{worlds} do not look alike")
    return {"pair": [world.to_json() for world in worlds], "bisimulation": list(classes)}


def write(path: Path, document: Any) -> None:
    """A JSON file, a line for each list."""
    text = json.dumps(document, indent=1)
    path.write_text(text + "\n", encoding="ascii")


def no_twins_directional(solver: str | None) -> None:
    """The proofs that no two worlds up to five edges look alike with a directional lighthouse."""
    folder = HERE / "no-twins-directional"
    if searched(folder, "", solver, lighthouse="directional", vertices=6, edges=5):
        raise SystemExit("a pair with a directional lighthouse")


def smallest_pairs(solver: str | None) -> None:
    """The three smallest pairs, and that there are no smaller ones."""
    folder = HERE / "smallest-pairs"
    pairs = {}
    for name, below, edges in (("maps", 1, 2), ("simple", 5, 6), ("planar-simple", 7, 8)):
        asked = {"lighthouse": "position", "map_class": name, "vertices": edges + 1}
        searched(folder, f"{name}-", solver, edges=below, **asked)
        pairs[name] = entry(searched(folder, "", solver, edges=edges, **asked))
    write(folder / "pairs.json", pairs)


def fig1(solver: str | None) -> None:
    """The candidates for Fig. 1, and that the caption does not fit planar drawings of the wheel."""
    folder = HERE / "fig1"
    asked = {"lighthouse": "position", "map_class": "planar-simple", "degree_marked": 4}
    asked |= {"degree_others": 3, **CAPTION}
    searched(folder, "search-", solver, vertices=5, edges=8, **asked)
    found = searched(folder, "", solver, vertices=9, edges=14, **asked)
    write(folder / "pairs.json", {"planar-simple": entry(found), "wheel": entry(wheels())})


def wheels() -> list[World]:
    """The wheel with four spokes in the plane, and the first drawing of it that looks alike."""
    rims = [[0, (i - 2) % 4 + 1, i % 4 + 1] for i in range(1, 5)]
    plane = World(from_rotation([[1, 2, 3, 4], *rims]), Position(0))
    for hub in permutations([2, 3, 4]):
        for turned in product((1, -1), repeat=4):
            around = [rim[::turn] for rim, turn in zip(rims, turned, strict=True)]
            drawn = World(from_rotation([[1, *hub], *around]), Position(0))
            alike = flaw((plane, drawn), bisimulation(plane, drawn)) is None
            if alike and same_world_from(plane, drawn) is None:
                return [plane, drawn]
    raise SystemExit("no drawing of the wheel looks like another")


def natural_lighthouse(_solver: str | None) -> None:
    """v1 with rotation p0 x0 y0 p1 x1 y1; x0 meets y0 (plane) or y1 (torus)."""
    plane = from_cycles(["pq", "pxxqyy"])
    torus = from_cycles(["pq", "pxyqyx"])
    worlds = [World(map_, Natural(0)) for map_ in (plane, torus)]
    write(HERE / "natural-lighthouse" / "pair.json", entry(worlds))


def write_manifest() -> None:
    """The SHA-256 digest of every file that a checker reads."""
    claims = [path.parent for path in HERE.glob("*/checker.py")]
    kinds = (".xz", ".json", ".smt2")
    files = sorted(p for claim in claims for p in claim.iterdir() if p.suffix in kinds)
    digests = {str(p.relative_to(HERE)): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}
    write(HERE / "manifest.json", digests)


PRODUCERS = {
    "fig1": fig1,
    "natural-lighthouse": natural_lighthouse,
    "no-twins-directional": no_twins_directional,
    "smallest-pairs": smallest_pairs,
}


def main() -> None:
    """The claims that are named."""
    parser = argparse.ArgumentParser(description="Write formulas, proofs and pairs.")
    parser.add_argument("claims", nargs="*", metavar="CLAIM", help=", ".join(PRODUCERS))
    parser.add_argument("--solver")
    options = parser.parse_args()
    for claim in options.claims:
        if claim not in PRODUCERS:
            parser.error(f"no claim {claim}; legal is {', '.join(PRODUCERS)}")
    for claim in options.claims:
        PRODUCERS[claim](options.solver)
    write_manifest()


if __name__ == "__main__":
    main()
