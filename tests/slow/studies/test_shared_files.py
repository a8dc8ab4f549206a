"""A file with the explorer and with code that judges it: what is lost, and the scope says so."""

import pytest

from studies import test_shared_files as quick
from studies.test_shared_files import checked

folder = quick.folder

MODELS = {"where": "everything", "task": "judge", "lighthouse": "Beacon"}


def test_a_model_that_only_imports_from_the_file_of_the_explorer_is_as_dangerous(folder, tmp_path):
    (tmp_path / "models.py").write_text("from attack import judge\n")
    assert checked("attack", "task", "models.py:judge")[:2] == ("holds", "attack.py")


@pytest.mark.parametrize(("option", "name"), MODELS.items())
def test_a_model_in_a_file_of_its_own_judges_as_it_should(folder, option, name):
    assert checked("explorers", option, f"models.py:{name}")[:2] == ("refuted", "")


@pytest.mark.parametrize(("option", "name"), MODELS.items())
def test_the_attack_is_lost_where_nobody_who_judges_loads_it(folder, option, name):
    assert checked("attack", option, f"models.py:{name}")[:2] == ("refuted", "")


@pytest.mark.parametrize(
    ("option", "name"),
    [("where", "everything"), ("lighthouse", "Beacon")],
)
def test_an_explorer_in_the_file_of_its_model_can_make_the_verdict_and_the_scope_says_so(
    folder, option, name
):
    quick.test_an_explorer_in_the_file_of_its_model_can_make_the_verdict_and_the_scope_says_so(
        folder, option, name
    )
