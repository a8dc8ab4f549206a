"""Claims of papers that proofs decide: certificates checked from their files, theorems in Coq.

A paper's ``claims.py`` puts this folder on its path.  Where the folder or Coq is missing, the
claims are reported as not checked.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from allworlds.claims import Found, Means, NotChecked, truth

PROOFS = Path(__file__).resolve().parent
COMPILED = shutil.ignore_patterns("*.vo*", "*.glob", ".*.aux", ".depend")
CLOSED = "Closed under the global context"


def certificate(_: Means, *, claim: str) -> Found | NotChecked:
    """Check one claim by ``check.py``, from its files alone.

    That code shares nothing with the package.
    """
    command = [sys.executable, str(PROOFS / "certificates" / "check.py"), "--only", claim]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = [line for line in ended.stdout.splitlines()[1:] if line.strip()]
    said = [re.sub(rf"^{claim}\s+\S+\s+\S+", "", line).strip() for line in lines]
    if ended.returncode not in (0, 1):
        return NotChecked(ended.stderr.strip() or f"check.py ended with code {ended.returncode}")
    return Found(truth(ended.returncode == 0), {"statements": len(said)}, told="; ".join(said))


def theorem(means: Means, *, names: list[str]) -> Found | NotChecked:
    """Check that the theorems compile as ``Statements.v`` states them, and rest on no axiom."""
    return theorems_in(means, PROOFS / "coq", names)


def theorems_in(means: Means, folder: Path, names: list[str]) -> Found | NotChecked:
    """Check theorems of the proofs in a folder, whose ``make assumptions`` says what they rest on.

    A copy is built from its sources, so that no compiled file that lies about is believed.
    Cost: some minutes, once for all claims.
    """
    if means.budget != "full":
        return NotChecked("it takes minutes: --budget full")
    if shutil.which("coqc") is None or shutil.which("make") is None:
        return NotChecked("Coq is not installed")
    built = _assumptions(folder.resolve())
    if isinstance(built, str):
        return Found("refuted", {"theorems": len(names)}, told=built)
    missing = [name for name in names if built.get(name) != CLOSED]
    told = f"not proved without axioms: {', '.join(missing)}" if missing else ""
    return Found(truth(not missing), {"theorems": len(names)}, told=told)


@cache
def _assumptions(folder: Path) -> dict[str, str] | str:
    """The axioms that Coq prints for each theorem; or how the build failed."""
    with TemporaryDirectory(prefix="allworlds-coq-") as directory:
        base = Path(directory) / "proofs" / "coq"
        shutil.copytree(PROOFS / "coq", base, ignore=COMPILED)
        copy = base
        if folder != PROOFS / "coq":  # a paper's, which builds on the base
            copy = Path(directory) / "papers" / folder.parent.name / folder.name
            shutil.copytree(folder, copy, ignore=COMPILED)
        command = ["make", "--no-print-directory", "-C", str(copy), "-j2", "assumptions"]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode:
        lines = [*ended.stdout.splitlines(), *ended.stderr.splitlines()]
        return f"make assumptions failed: {' / '.join(lines[-5:])}"
    return dict(re.findall(r"^(\w+): (.+)$", ended.stdout, re.MULTILINE))
