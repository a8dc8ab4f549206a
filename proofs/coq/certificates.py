"""Every bisimulation that is kept as a file, made a theorem of Coq by computation.

    python certificates.py [--limit SECONDS]

reads the pairs of worlds in fig1, smallest-pairs and natural-lighthouse of ../certificates and in
../../corpus/pairs, writes Certificates.v into build/, and compiles it: one theorem a pair, that
no explorer finds the maps of both worlds, by `certified_map_impossible` from the classes of darts
in the file.  `make theorems` must have been run.  Exit code 1: a certificate does not prove its
pair.
Standard library only.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

HERE = Path(__file__).resolve().parent
KEPT = HERE.parent / "certificates"
CORPUS = HERE.parents[1] / "corpus" / "pairs"

HEAD = """(* Written by certificates.py from the files named below. *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model NumberedWorlds Impossibility Twins.
"""

THEOREM = """
(* {source} *)
Definition {name}_left := {left}.
Definition {name}_right := {right}.
Definition {name}_darts : seq (nat * nat) := [:: {pairs}].

Theorem {name}_impossible :
  no_explorer_maps_both {percept} {name}_left {name}_right.
Proof. by apply: (@certified_map_impossible _ _ _ _ {name}_darts); vm_compute. Qed.
"""


def kept_pairs() -> Iterator[tuple[str, dict, str]]:
    """Every pair on file: where it stands, the document, and what the robot senses there."""
    for folder in ("fig1", "smallest-pairs"):
        path = KEPT / folder / "pairs.json"
        for name, document in json.loads(path.read_text(encoding="utf-8")).items():
            yield f"{folder} {name}", document, "position_percept"
    path = KEPT / "natural-lighthouse" / "pair.json"
    document = json.loads(path.read_text(encoding="utf-8"))
    yield "natural-lighthouse", document, "degree_percept"
    for path in sorted(CORPUS.glob("*.json")):
        document = json.loads(path.read_text(encoding="utf-8"))
        yield f"corpus {path.stem}", document, "position_percept"


def theorem(source: str, document: dict, percept: str) -> str:
    """The theorem of one pair; darts of one class are related."""
    left, right = document.get("pair") or document["worlds"]
    mine, theirs = document["bisimulation"]
    related = [(d, e) for d, p in enumerate(mine) for e, q in enumerate(theirs) if p == q]
    return THEOREM.format(
        source=source,
        name=re.sub(r"\W", "_", source),
        left=_numbered(left),
        right=_numbered(right),
        pairs="; ".join(f"({d}, {e})" for d, e in related),
        percept=percept,
    )


def _numbered(world: dict) -> str:
    sigma, alpha = ("; ".join(map(str, world[key])) for key in ("sigma", "alpha"))
    return f"NumberedMap [:: {sigma}] [:: {alpha}] {world.get('start', 0)}"


def main() -> int:
    """Write the file, compile it, and say what it proves."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--limit", type=int, default=120, help="seconds of CPU for coqc")
    limit = parser.parse_args().limit
    build = HERE / "build"
    build.mkdir(exist_ok=True)
    pairs = list(kept_pairs())
    target = build / "Certificates.v"
    target.write_text(HEAD + "".join(theorem(*pair) for pair in pairs), encoding="utf-8")
    flags = ["-w", "-notation-overridden", "-Q", str(HERE), "Allworlds"]
    command = [str(HERE / "limit"), str(limit), "coqc", *flags, str(target)]
    compiled = subprocess.run(command, check=False)
    if compiled.returncode:
        print(f"a certificate does not prove its pair: see {target}", file=sys.stderr)
        return 1
    for source, _, _ in pairs:
        print(f"no explorer finds the maps of both worlds of: {source}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
