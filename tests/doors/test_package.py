"""The files of the package, its metadata, and the modules that it loads."""

import os
import re
import subprocess
import sys
import tomllib
from importlib.metadata import metadata, requires
from pathlib import Path

import allworlds
from package_contents import NEEDED, flaws

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]

NOT_FOR_EXPLORERS = (
    "distributed",
    "hypothesis",
    "llvmlite",
    "numba",
    "pysat",
    "sympy",
    "z3",
)
"""What who checks an explorer of one's own does not need."""

EXPLORER = """
from allworlds.explorers.builtin.algorithm1 import algorithm1


def explore(first, *, choices):
    return (yield from algorithm1(first, choices=choices))
"""


def run_without_heavy_ones(tmp_path, *arguments):
    """``allworlds`` in a folder with an explorer, where no process can import what is heavy."""
    (tmp_path / "mine.py").write_text(EXPLORER)
    poison = tmp_path / "poison"
    for name in NOT_FOR_EXPLORERS:
        (poison / name).mkdir(parents=True)
        (poison / name / "__init__.py").write_text(f"raise RuntimeError('{name} was imported')")
    path = os.pathsep.join([str(poison), str(Path(allworlds.__file__).parents[1])])
    return subprocess.run(
        [sys.executable, "-P", "-m", "allworlds", *arguments],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )


def test_where_they_cannot_be_imported_the_verbs_that_need_them_say_so(tmp_path):
    done = run_without_heavy_ones(
        tmp_path,
        "ambiguity",
        "search",
        *["--lighthouse", "position", "--vertices", "1", "--edges", "2"],
    )
    assert done.returncode == 70
    assert "z3 was imported" in done.stderr


def test_a_list_of_files_without_a_needed_one_or_with_a_remainder_is_refused():
    for kind, needed in NEEDED.items():
        assert flaws(kind, needed) == []
        assert flaws(kind, needed[1:]) == [f"{needed[0]} is missing"]
    wheel = NEEDED["wheel"]
    for remainder in ("allworlds/__pycache__/a.pyc", "allworlds/x.so"):
        assert flaws("wheel", [*wheel, remainder]) == [f"{remainder} is a remainder"]
    assert flaws("wheel", [*wheel, "tests/a.py"]) == ["tests would be installed beside the package"]
    assert flaws("sdist", [*NEEDED["sdist"], "tests/.hypothesis/x"])


def test_what_is_needed_in_the_source_distribution_is_there():
    assert all((ROOT / name).is_file() for name in NEEDED["sdist"])
    assert all((ROOT / "src" / name).is_file() for name in NEEDED["wheel"][:-1])
    included = set(
        tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["hatch"][
            "build"
        ]["targets"]["sdist"]["include"]
    )
    # Hatchling adds the licence, the readme and pyproject.toml by itself.
    assert {name.partition("/")[0] for name in NEEDED["sdist"]} - included == {
        "LICENSE",
        "README.md",
    }


def test_the_citation_names_the_version_and_no_address_that_is_not_known():
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    said = dict(re.findall(r"^([a-z-]+): (.+)$", text, re.MULTILINE))
    assert said["cff-version"] == "1.2.0"
    assert said["version"] == allworlds.__version__
    assert said["title"] == PROJECT["name"]
    assert said["license"] == PROJECT["license"]
    assert re.findall(r"^  - ([\w ]+)$", text, re.MULTILINE) == PROJECT["keywords"]
    assert ("urls" in PROJECT) == ("repository-code" in said)


def test_the_classifiers_name_every_version_of_python_that_is_legal():
    told = {c.rpartition(" ")[2] for c in PROJECT["classifiers"] if "Python :: 3." in c}
    assert told == {"3.11", "3.12", "3.13"}
    assert PROJECT["requires-python"] == ">=3.11"
    known = metadata("allworlds")
    assert known["Requires-Python"] == PROJECT["requires-python"]
    assert len([each for each in requires("allworlds") or [] if "extra ==" not in each]) == len(
        PROJECT["dependencies"]
    )
