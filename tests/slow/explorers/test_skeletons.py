"""Every skeleton is built, run and refuted, until it is filled in.  Nothing is overwritten."""

import json
import shutil

import pytest

from allworlds.explorers.languages import LANGUAGES
from allworlds.studies.init import init
from explorers import test_skeletons as quick

shell = quick.shell


@pytest.mark.long
@pytest.mark.parametrize("lang", [lang for lang in LANGUAGES if lang != "python"])
def test_the_test_of_a_skeleton_fails_with_the_picture(lang, shell, tmp_path):
    ready(lang)
    init(tmp_path / "mine", lang=lang)
    command = LANGUAGES[lang].test
    if command == "npm test":  # which comes with Node, but not everywhere
        command = json.loads((tmp_path / "mine" / "package.json").read_text())["scripts"]["test"]
    tested = shell(command, tmp_path / "mine")
    assert tested.returncode in (1, 2), tested.stderr
    assert "breaks the law 'map'" in tested.stdout


def ready(lang):
    """Skip where a program is missing that the language needs."""
    for program in LANGUAGES[lang].needs:
        if shutil.which(program) is None:
            pytest.skip(f"there is no {program}")


@pytest.mark.long
@pytest.mark.parametrize("lang", ["python", "c", "javascript", "rust"])
def test_a_skeleton_builds_and_is_refuted_in_a_picture(lang, shell, tmp_path):
    ready(lang)
    made = shell(f"allworlds init mine --lang {lang}")
    assert made.returncode == 0, made.stderr
    command = next(line for line in made.stdout.splitlines() if line.startswith("  cd mine && "))
    checked = shell(command)
    assert checked.returncode == 1, checked.stdout + checked.stderr
    assert "breaks the law 'map' in a world with 1 edge and 1 vertex" in checked.stdout
    assert " ╭─╮\n(0 1)\n" in checked.stdout
    if lang == "c":
        assert "warning" not in checked.stderr
