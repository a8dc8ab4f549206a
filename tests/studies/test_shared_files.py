"""A file with the explorer and with code that judges it: what is lost, and the scope says so."""

import json
import subprocess
import sys

import pytest

import allworlds
from allworlds.reports.formats import text

HONEST = """
from allworlds import Estimate, Lighthouse, Percept
from allworlds.maps import named_map


def everything(map_):
    return True


def judge(world, transcript, answer):
    return "nothing is ever right"


class Beacon(Lighthouse):
    @classmethod
    def places(cls, map_, start):
        yield cls()

    def sensed(self, map_, here):
        return Percept(map_.degree_at[here])


def explore(first):
    return Estimate(named_map("loop"), 0)
    yield
"""


def checked(explorer, option, model):
    """The verdict, the scope's file, and the text of a check in a process of its own.

    The attack changes what judges in the process that loads the model: here all other tests run.
    """
    command = [sys.executable, "-m", "allworlds", "check", f"{explorer}.py:explore", "--edges=2"]
    command.append(f"--{option}={model}")
    document, shown = (
        subprocess.run([*command, *more], capture_output=True, text=True, check=False).stdout
        for more in (["--json"], [])
    )
    report = json.loads(document)
    return report["verdict"], report["scope"].get("shared_file", ""), " ".join(shown.split())


@pytest.fixture
def modules(tmp_path, monkeypatch):
    """Files that import from one another, and are named as no other module of these tests is."""
    for name, content in {
        "shared_walker": HONEST + "\n\ndef other(first):\n    return 1\n    yield\n",
        "shared_judge": "from shared_walker import judge as theirs\n\n\n"
        "def judge(world, transcript, answer):\n    return theirs(world, transcript, answer)\n",
        "shared_alone": "def judge(world, transcript, answer):\n    return None\n",
    }.items():
        (tmp_path / f"{name}.py").write_text(content)
        monkeypatch.delitem(sys.modules, name, raising=False)
    monkeypatch.setattr(sys, "path", [*sys.path])
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", ["shared_walker", "shared_judge"])
def test_a_file_that_a_model_loads_only_by_imports_is_shared_too(modules, name):
    report = allworlds.check("shared_walker.py:explore", edges=1, task=f"{name}.py:judge")
    assert report.scope.shared_file == "shared_walker.py"


def test_every_verb_that_judges_runs_names_the_shared_file_and_no_other_file(modules):
    options = {"edges": 1, "task": "shared_judge.py:judge"}
    checked = allworlds.check("shared_walker.py:explore", **options)
    assert checked.scope.shared_file == "shared_walker.py"
    assert "trust shared_walker.py holds" in " ".join(text(checked, 100).split())
    compared = allworlds.compare("shared_walker.py:explore", "dfs", **options)
    assert [one.shared_file for one in compared.explorers] == ["shared_walker.py", ""]
    assert "trust shared_walker.py holds" in " ".join(text(compared, 100).split())
    apart = allworlds.check("shared_walker.py:explore", edges=1, task="shared_alone.py:judge")
    assert apart.scope.shared_file == ""


def test_a_merge_elsewhere_names_the_shared_file_and_loads_no_file(modules, tmp_path, monkeypatch):
    job = {"edges": 1, "task": "shared_judge.py:judge"}
    for i in range(2):
        allworlds.check("shared_walker.py:explore", shard=(i, 2), run=f"run-{i}", **job)
    runs = [tmp_path / f"run-{i}" for i in range(2)]
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    monkeypatch.setattr(sys, "path", [each for each in sys.path if each != str(tmp_path)])
    assert allworlds.merge(*runs).scope.shared_file == "shared_walker.py"
