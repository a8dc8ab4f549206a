"""SARIF, held to the schema of the standard (tests/data, of OASIS) and to what the schema leaves
out: that all that is named exists, and that the walk goes along edges of the graph."""

import pytest

from allworlds.studies.check.exhaustive import check
from reports.test_sarif import run_of

pytestmark = pytest.mark.usefixtures("without_workers")


@pytest.mark.parametrize(
    ("explorer", "options"),
    [
        ("exec:true", {}),
        ("exec:python3 -m this", {}),
        ("algorithm1", {"lighthouse": "position"}),
    ],
    ids=["on the PATH", "a module", "built in"],
)
def test_a_result_without_a_file_has_a_location_that_says_so(explorer, options):
    """GitHub refuses a whole log if one of its results has no location with a URI."""
    (result,) = run_of(check(explorer, edges=2, **options))["results"]
    (location,) = result["locations"]
    place = location["physicalLocation"]
    assert place["artifactLocation"] == {"uri": "no%20file%20associated%20with%20this%20alert"}
    assert place["region"] == {"startLine": 1}
    for text in result["message"].values():
        assert "No file with the explorer's code is known" in text.partition("\n")[0]
