"""Mutants of the code by which the compiled engine embeds an S: its tests find each of them."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import allworlds

ROOT = Path(__file__).parents[3]
PACKAGE = Path(allworlds.__file__).parent
TESTS = ROOT / "tests" / "engines" / "test_embedding.py"

MUTANTS = {
    "an edge that was never walked": (" or not walked >> true & 1:", ":"),
    "the robot anywhere": ("if judged.to[here] != dart:", "if False:"),
    "another rotation": ("if unlike(sigma, address_of(judged.sigma)) & before or ", "if "),
    "another degree": ("return met if true == judged.to[first] else darts", "return met"),
    "one vertex for two": ("if judged.taken >> true & 1:", "if False:"),
    "a partner of another": (" or byte_of(alpha, e) != d:", ":"),
    "edges miscounted": ("judged.explored += size(changed)", "judged.explored += 2"),
}

pytestmark = [pytest.mark.long, pytest.mark.no_cover]  # each mutant takes the compiler anew


@pytest.mark.parametrize("mutant", [None, *MUTANTS])
def test_a_damaged_embedding_fails_the_tests_of_it(mutant, tmp_path):
    copy = tmp_path / "allworlds"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    if mutant:
        file = copy / "engines" / "kernel" / "embedding.py"
        text, (right, wrong) = file.read_text(encoding="utf-8"), MUTANTS[mutant]
        assert text.count(right) == 1
        file.write_text(text.replace(right, wrong), encoding="utf-8")
    command = [sys.executable, "-m", "pytest", str(TESTS), "-q", "-x", "-p", "no:cacheprovider"]
    done = subprocess.run(
        [*command, "-c", str(ROOT / "pyproject.toml"), "-n", "0", "--no-cov"],
        env={**os.environ, "PYTHONPATH": str(tmp_path), "NUMBA_CACHE_DIR": str(tmp_path / "cache")},
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == (1 if mutant else 0), done.stdout[-2000:]
    assert ("1 failed" in done.stdout) == bool(mutant)
