"""The weight of an installation on the page of it, against the packages installed here."""

import re
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import pytest
from packaging.requirements import Requirement

PAGE = (Path(__file__).parents[2] / "docs/install.md").read_text(encoding="utf-8")
SAID = {
    "z3": ("z3-solver",),
    "numpy": ("numpy",),
    "networkx": ("networkx",),
}


COMPILER = ("numba", "llvmlite")


def needed(name, found):
    """The names of all distributions without which that one is not complete."""
    if name not in found:
        found.add(name)
        for line in distribution(name).requires or ():
            requirement = Requirement(line)
            if requirement.marker is None or requirement.marker.evaluate({"extra": ""}):
                needed(requirement.name, found)
    return found


def weight(names):
    """The files of these distributions, in megabytes."""
    files = [entry.locate() for name in names for entry in distribution(name).files or ()]
    return sum(file.stat().st_size for file in files if file.exists()) / 1e6


def test_the_page_says_what_an_installation_weighs():
    told = re.search(
        r"An installation weighs (\d+) MB: (.*?); .*? (\d+)\. .* adds (\d+)", PAGE, re.DOTALL
    )
    total, parts, own = (
        int(told[1]),
        dict(re.findall(r"([a-z][\w ]*?) (\d+)", told[2])),
        int(told[3]),
    )
    assert set(parts) == set(SAID)
    try:
        everything = needed("allworlds", set()) - {"allworlds"}
    except PackageNotFoundError as missing:  # as in a checkout that is not installed
        pytest.skip(f"not installed: {missing}")
    assert int(told[4]) == pytest.approx(weight(COMPILER), rel=0.25)
    assert not everything & {*COMPILER}
    for name, names in SAID.items():
        assert int(parts[name]) == pytest.approx(weight(names), rel=0.25), name
    assert total == pytest.approx(weight(everything) + own, rel=0.25)
