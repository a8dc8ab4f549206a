"""Checks every claim of this directory from its files alone, without a solver.

    python proofs/check.py [--only CLAIM]...

prints a table.  Exit code 0: everything holds; 1: a claim fails, or a file is not the one that
was committed; 2: a file is missing, or there is no such claim.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib.util
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path

from lrat import Refused

HERE = Path(__file__).resolve().parent
CLAIMS = ["fig1", "cycles", "no-twins-directional", "smallest-pairs", "natural-lighthouse"]


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


def altered(claim: str, manifest: dict[str, str]) -> list[str]:
    """The claim's files that differ from those whose digests the manifest holds."""
    mine = {name: digest for name, digest in manifest.items() if name.startswith(f"{claim}/")}
    if not mine:
        raise Refused(f"the manifest names no file of {claim}")
    return [
        name
        for name, digest in mine.items()
        if hashlib.sha256((HERE / name).read_bytes()).hexdigest() != digest
    ]


def judged(claim: str) -> tuple[str, list[str]]:
    """``holds`` or ``FAILS``, and what was checked or what is wrong."""
    try:
        manifest = json.loads((HERE / "manifest.json").read_bytes())
        changed = altered(claim, manifest)
        said = checker(claim)(HERE / claim)
    except Refused as error:
        return "FAILS", [str(error)]
    except (ValueError, KeyError, IndexError, TypeError, AttributeError) as error:
        return "FAILS", [f"a file has not the form that is expected: {error!r}"]
    if changed:
        return "FAILS", [f"{name} is not the file that was committed" for name in changed]
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
