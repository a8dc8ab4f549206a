"""Proofs for all sizes: certificates checked from their files, and proofs in Coq.

Both are in a folder of the sources (``proofs``), which an installation does not have. If it is not
found, or Coq is not installed, the claims are reported as not checked.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from allworlds.evidence.claims.claim_types import Checks, Found, Means, NotChecked, truth

NO_FOLDER = "they are in the folder proofs of a clone of the sources: --proofs DIR"
COMPILED = shutil.ignore_patterns("*.vo*", "*.glob", ".*.aux", ".depend")
CLOSED = "Closed under the global context"


def certificate(means: Means, *, claim: str) -> Found | NotChecked:
    """Check one claim by ``check.py``, from its files alone.

    That code shares nothing with this package.
    """
    if means.proofs is None:
        return NotChecked(NO_FOLDER)
    command = [sys.executable, str(means.proofs / "check.py"), "--only", claim]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    lines = [line for line in ended.stdout.splitlines()[1:] if line.strip()]
    said = [re.sub(rf"^{claim}\s+\S+\s+\S+", "", line).strip() for line in lines]
    if ended.returncode not in (0, 1):
        return NotChecked(ended.stderr.strip() or f"check.py ended with code {ended.returncode}")
    return Found(truth(ended.returncode == 0), {"statements": len(said)}, told="; ".join(said))


def theorem(means: Means, *, names: list[str]) -> Found | NotChecked:
    """Theorems of the proofs in Coq: the files compile, and no theorem rests on an axiom.

    ``Statements.v`` has the statement of each of them, and compiles only if that is what is proved.
    """
    if means.proofs is None:
        return NotChecked(NO_FOLDER)
    if means.budget != "full":
        return NotChecked("it takes minutes: --budget full")
    if shutil.which("coqc") is None or shutil.which("make") is None:
        return NotChecked("Coq is not installed")
    built = _assumptions((means.proofs / "coq").resolve())
    if isinstance(built, str):
        return Found("refuted", {"theorems": len(names)}, told=built)
    missing = [name for name in names if built.get(name) != CLOSED]
    told = f"not proved without axioms: {', '.join(missing)}" if missing else ""
    return Found(truth(not missing), {"theorems": len(names)}, told=told)


@cache
def _assumptions(sources: Path) -> dict[str, str] | str:
    """By theorem what Coq prints that it rests on; or how its build failed.

    A copy is built from its sources, so that no compiled file that lies about is believed; once
    for all claims.  Cost: some minutes.
    """
    with TemporaryDirectory(prefix="allworlds-coq-") as directory:
        copy = Path(directory) / "coq"
        shutil.copytree(sources, copy, ignore=COMPILED)
        command = ["make", "--no-print-directory", "-C", str(copy), "-j2", "assumptions"]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    if ended.returncode:
        lines = [*ended.stdout.splitlines(), *ended.stderr.splitlines()]
        return f"make assumptions failed: {' / '.join(lines[-5:])}"
    return dict(re.findall(r"^(\w+): (.+)$", ended.stdout, re.MULTILINE))


CHECKS: Checks = {
    **dict.fromkeys(
        (
            "cert-fig1",
            "cert-cycles",
            "cert-no-twins-directional",
            "cert-smallest-pairs",
            "cert-natural-lighthouse",
        ),
        certificate,
    ),
    **dict.fromkeys(
        (
            "coq-algorithm1",
            "coq-invariant",
            "coq-tests",
            "coq-bound",
            "coq-no-information",
            "coq-position",
            "coq-cycles-needed",
            "coq-laying",
            "coq-cluster",
            "coq-natural",
            "coq-folding",
            "coq-lower-bounds",
            "coq-2m",
            "coq-checker",
            "coq-shield",
            "coq-mass-formula",
            "coq-bouquets",
            "coq-corridors",
            "coq-certificates",
        ),
        theorem,
    ),
}
