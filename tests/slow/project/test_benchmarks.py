"""The programs that measure run, and say what is wrong with what they are given."""

import importlib
import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


@pytest.mark.slowest
@pytest.mark.usefixtures("compiled")
def test_the_program_that_measures_sets_others_beside_the_engines():
    line = [sys.executable, ROOT / "benchmarks/rounds.py", "--edges=4", "--rounds=1"]
    told = subprocess.run([*line, "--peer=a@3=true"], check=True, capture_output=True).stdout
    document = json.loads(told)
    names = [row["name"] for row in document["contenders"]]
    assert names == ["kernel", "kernel-2", "count", "judge", "python", "a"]
    assert document["contenders"][-1]["worlds"] == 74  # OEIS A000698
    assert [row["to"] for row in document["ratios"]] == names[1:]
    failed = subprocess.run([*line, "--peer=culprit=false"], check=False, capture_output=True)
    assert b"'culprit'" in failed.stderr


@pytest.mark.slowest
def test_mutants_are_drawn_by_their_seed_and_all_fit_into_the_source(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "benchmarks")
    mutants = importlib.import_module("mutants")
    files = ROOT / "src/allworlds/judging/laws", ROOT / "src/allworlds/maps"
    paths = [path for folder in files for path in sorted(folder.rglob("*.py"))]
    texts = {str(path.relative_to(ROOT)): path.read_bytes() for path in paths}
    every = [one for file, text in texts.items() for one in mutants.mutants_of(file, text)]
    drawn = mutants.drawn(every, 1)
    assert drawn == mutants.drawn(every, 1) != mutants.drawn(every, 2)
    assert {one.wing for one in drawn} == {"judging", "maps"}
    for file, text in texts.items():
        of_file = {n: one for n, one in enumerate(drawn) if one.file == file}
        changed = mutants.with_all(text, of_file)
        compile(changed, file, "exec")
        assert changed.count(b"_mutated(") == len(of_file)
