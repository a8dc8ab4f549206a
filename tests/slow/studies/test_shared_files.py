"""A file with the explorer and with code that judges it: what is lost, and the scope says so."""

import shutil
from pathlib import Path

import pytest

from studies.test_shared_files import HONEST, checked

MODELS = {"where": "everything", "task": "judge", "lighthouse": "Beacon"}


@pytest.mark.slowest
def test_a_model_that_only_imports_from_the_file_of_the_explorer_is_as_dangerous(folder, tmp_path):
    (tmp_path / "models.py").write_text("from attack import judge\n")
    assert checked("attack", "task", "models.py:judge")[:2] == ("holds", "attack.py")


@pytest.mark.slowest
@pytest.mark.parametrize(("option", "name"), MODELS.items())
def test_a_model_in_a_file_of_its_own_judges_as_it_should(folder, option, name):
    assert checked("explorers", option, f"models.py:{name}")[:2] == ("refuted", "")


@pytest.mark.slowest
@pytest.mark.parametrize(("option", "name"), MODELS.items())
def test_the_attack_is_lost_where_nobody_who_judges_loads_it(folder, option, name):
    assert checked("attack", option, f"models.py:{name}")[:2] == ("refuted", "")


ATTACK = Path(__file__).parents[2] / "attacks" / "reaching" / "shares_its_file.py"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    shutil.copy(ATTACK, tmp_path / "attack.py")
    (tmp_path / "models.py").write_text(HONEST)
    (tmp_path / "explorers.py").write_text(HONEST)
    monkeypatch.chdir(tmp_path)


@pytest.mark.slowest
@pytest.mark.parametrize(
    ("option", "name"),
    [("task", "judge"), ("where", "everything"), ("lighthouse", "Beacon")],
)
def test_an_explorer_in_the_file_of_its_model_can_make_the_verdict_and_the_scope_says_so(
    folder, option, name
):
    verdict, shared, shown = checked("attack", option, f"attack.py:{name}")
    assert (verdict, shared) == ("holds", "attack.py")
    assert "attack.py holds the explorer, and code that judges it" in shown
