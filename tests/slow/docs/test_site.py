"""The parts of the site of the documents; ``nox -s docs`` and CI build the site itself."""

import re
import subprocess
import sys
import tomllib
from contextlib import suppress
from importlib.metadata import PackageNotFoundError, distribution, packages_distributions

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import allworlds
from docs.test_site import ROOT
from docsite_modules import load


@pytest.mark.slowest
def test_every_live_page_has_a_name_of_its_own_and_is_written_and_linked(tmp_path):
    pictures = load("pictures")
    names = [live.name for live in [*pictures.lives(), *pictures.walks()]]
    assert len(names) == len(set(names))
    text = pictures._walks(pictures.walks())
    for live in pictures.walks()[:3]:
        pictures._made(live, tmp_path)
        page = tmp_path / f"{live.name}.html"
        assert page.stat().st_size <= pictures.LARGEST
        assert "<svg" in page.read_text(encoding="utf-8")
        assert f"](live/{live.name}.html)" in text
    wrong = pictures.Live("x", "run no-world", "")
    with pytest.raises(Exception, match="run no-world ends with 2"):
        pictures._made(wrong, tmp_path)


PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


LOADING = """
import importlib, pkgutil, sys


class Refusal:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {refused!r}:
            raise ModuleNotFoundError(f"not in the extra docs: {{name}}")


sys.meta_path.insert(0, Refusal())
import allworlds
for module in pkgutil.iter_modules(allworlds.__path__, "allworlds."):
    if not module.name.endswith("__main__"):
        door = importlib.import_module(module.name)
        print(*(getattr(door, name) for name in getattr(door, "__all__", ())))
"""


def distributions(lines, extras=(), found=None):
    """The names of all distributions that these requirements lead to."""
    found = {"allworlds"} if found is None else found
    for requirement in map(Requirement, lines):
        name, marker = canonicalize_name(requirement.name), requirement.marker
        if marker and not any(marker.evaluate({"extra": extra}) for extra in ("", *extras)):
            continue
        if name == "allworlds":
            for extra in requirement.extras:
                distributions(PROJECT["optional-dependencies"][extra], found=found)
        elif name not in found:
            found.add(name)
            with suppress(PackageNotFoundError):  # as mkdocs, where the extra is not installed
                distributions(distribution(name).requires or (), requirement.extras, found)
    return found


@pytest.mark.slowest
def test_the_extra_of_the_site_has_all_that_the_names_it_shows_are_loaded_with():
    needed = [*PROJECT["dependencies"], *PROJECT["optional-dependencies"]["docs"]]
    found = distributions(needed)
    refused = {
        module
        for module, names in packages_distributions().items()
        if not found & {canonicalize_name(name) for name in names}
    }
    code = LOADING.format(refused=refused)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "pytest" in refused


@pytest.mark.slowest
def test_every_name_of_the_reference_is_found_by_reading():
    griffe = pytest.importorskip("griffe", reason="the extra docs is not installed")
    package = griffe.load("allworlds", search_paths=[str(ROOT / "src")])
    text = "".join(load("generated").pages().values())
    named = re.findall(r"^::: allworlds\.(.+)$", text, re.MULTILINE)
    assert len(named) > len(allworlds.__all__)
    for name in named:
        found = package[name]
        assert found.final_target if found.is_alias else found
