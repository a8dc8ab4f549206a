"""Checks every claim of this directory from its files alone, without a solver.

    python proofs/certificates/check.py [--only CLAIM]...

prints a table.  Exit code 0: everything holds; 1: a claim fails, or a file is not the one that
was committed; 2: a file is missing, or there is no such claim.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib.util
import sys
import time
from collections.abc import Callable
from pathlib import Path

from documents import read_json
from lrat import Refused

HERE = Path(__file__).resolve().parent
CLAIMS = [
    "fig1",
    "cycles",
    "no-twins-directional",
    "smallest-pairs",
    "natural-lighthouse",
]
CERTIFICATES = (".xz", ".json", ".smt2")
"""How the names of the files end that the manifest has the digests of."""


def checker(claim: str) -> Callable[[Path], list[str]]:
    """The function ``check`` of the claim's ``checker.py``."""
    path = HERE / claim / "checker.py"
    specification = importlib.util.spec_from_file_location(f"{claim}_checker", path)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    check: Callable[[Path], list[str]] = module.check
    return check


def require_committed(claim: str) -> None:
    """Raise Refused unless the claim's certificates are those of the manifest, digest by digest.

    Raises:
        Refused: naming a file that differs, or is in only one of the two places.
    """
    manifest = read_json(HERE / "manifest.json")
    if not isinstance(manifest, dict):
        raise Refused("manifest.json is no object")
    there = {path.name: path for path in (HERE / claim).iterdir() if path.suffix in CERTIFICATES}
    named = {name.partition("/")[2] for name in manifest if name.startswith(f"{claim}/")}
    for name in sorted(there.keys() | named):
        if name not in named:
            raise Refused(f"{claim}/{name} is not in the manifest")
        if name not in there:
            raise Refused(f"{claim}/{name} is in the manifest, but it is not there")
        digest = hashlib.sha256(there[name].read_bytes()).hexdigest()
        if digest != manifest[f"{claim}/{name}"]:
            raise Refused(f"{claim}/{name} is not the file that was committed")


def judged(claim: str) -> tuple[str, list[str]]:
    """``holds`` or ``FAILS``, and what was checked or what is wrong.

    What the files say is looked at first, and the digests then: so a file that was changed
    gets the reason why it proves nothing, if there is one.
    """
    try:
        said = checker(claim)(HERE / claim)
        require_committed(claim)
    except Refused as error:
        return "FAILS", [str(error)]
    except (ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError) as error:
        return "FAILS", [f"a file has not the form that is expected: {error!r}"]
    return "holds", said


def main(arguments: list[str]) -> int:
    """The table, and the exit code."""
    parser = argparse.ArgumentParser(description="Check the claims without a solver.")
    parser.add_argument("--only", action="append", choices=CLAIMS, metavar="CLAIM")
    claims = parser.parse_args(arguments).only or CLAIMS
    failed = False
    print(f"{'claim':<22}{'verdict':<9}{'seconds':>7}  what was checked")
    for claim in claims:
        began = time.perf_counter()
        try:
            verdict, said = judged(claim)
        except OSError as error:
            print(f"check.py: {error.filename}: {error.strerror}", file=sys.stderr)
            return 2
        failed = failed or verdict != "holds"
        seconds = f"{time.perf_counter() - began:.1f}"
        for i, sentence in enumerate(said):
            print(
                f"{claim:<22}{verdict:<9}{seconds:>7}  {sentence}"
                if i == 0
                else " " * 40 + sentence
            )
        sys.stdout.flush()
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
