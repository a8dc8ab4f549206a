"""Your model in 20 lines: each file of ``examples/models`` does what its commands say."""

import ast
import re
import shlex
from pathlib import Path

import pytest

from allworlds.cli.app import call

ROOT = Path(__file__).parents[2]
MODELS = ROOT / "examples" / "models"
PAGE = ROOT / "docs" / "how-to" / "models.md"
NAMES = sorted(path.name for path in MODELS.glob("*.py"))
COMMAND = re.compile(r"^    \$ allworlds (.+)\n    ([A-Z]+)$", re.MULTILINE)
EXIT = {"HOLDS": 0, "REFUTED": 1}
MOST = 40
"""Lines of code of a file; its explorer alone has some 20."""

pytestmark = pytest.mark.usefixtures("without_workers")


def told(name):
    """The docstring of a file, as it stands there."""
    return ast.get_docstring(ast.parse((MODELS / name).read_text(encoding="utf-8")), clean=False)


CASES = [(name, *case) for name in NAMES for case in COMMAND.findall(told(name))]


@pytest.mark.parametrize(("name", "command", "verdict"), CASES)
def test_a_model_of_the_field_does_what_its_commands_say(
    name, command, verdict, monkeypatch, capfd
):
    monkeypatch.chdir(MODELS)
    code = call([*shlex.split(command), "-q"])
    assert (code, capfd.readouterr().out.split(":")[0]) == (EXIT[verdict], verdict)


@pytest.mark.parametrize("name", NAMES)
def test_a_model_has_its_source_a_right_and_a_wrong_case_and_its_place_on_the_page(name):
    text = told(name)
    source = text.partition("\nSource: ")[2].partition("\n\n")[0]
    assert re.search(r"\b(18|19|20)\d\d\b|\bours\b", source)  # a year is that of a publication
    assert [verdict for _, verdict in COMMAND.findall(text)] == ["HOLDS", "REFUTED"]
    body = (MODELS / name).read_text(encoding="utf-8").partition(text)[2]
    assert len([line for line in body.splitlines() if line.strip()]) <= MOST
    assert f"(../../examples/models/{name})" in PAGE.read_text(encoding="utf-8")


def test_there_are_twelve():
    assert len(NAMES) == 12
