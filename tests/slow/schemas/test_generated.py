"""The schemas and the package's door are what the classes and tables say."""

import pytest

from allworlds.reports.schemas import main, schemas


@pytest.mark.slowest
def test_the_schemas_of_an_earlier_build_do_not_stay(tmp_path):
    (tmp_path / "luck.schema.json").write_text("{}")
    main(tmp_path)
    assert {file.name.removesuffix(".schema.json") for file in tmp_path.iterdir()} == {*schemas()}
