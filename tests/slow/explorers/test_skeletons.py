"""Every skeleton is built, run and refuted, until it is filled in.  Nothing is overwritten."""

import json

import pytest

from allworlds.explorers.languages import LANGUAGES
from allworlds.studies.init import init
from explorers import test_skeletons as quick
from explorers.test_skeletons import ready

shell = quick.shell


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


@pytest.mark.parametrize("lang", ["c", "javascript", "rust"])
def test_a_skeleton_builds_and_is_refuted_in_a_picture(lang, shell, tmp_path):
    quick.test_a_skeleton_builds_and_is_refuted_in_a_picture(lang, shell, tmp_path)
