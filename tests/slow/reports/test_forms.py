"""The forms of the verbs that take longer."""

import pytest

from reports import test_forms as quick

pytestmark = [
    pytest.mark.usefixtures("without_workers"),
    pytest.mark.parametrize("verb", quick.SLOW),
]


def test_a_verb_with_rows_writes_every_form_and_fits_80_columns(verb, cli, tmp_path, monkeypatch):
    quick.test_a_verb_with_rows_writes_every_form_and_fits_80_columns(
        verb, cli, tmp_path, monkeypatch
    )


def test_each_column_of_a_verbs_rows_has_one_type_whatever_is_missing(verb, cli, tmp_path):
    quick.test_each_column_of_a_verbs_rows_has_one_type_whatever_is_missing(verb, cli, tmp_path)
