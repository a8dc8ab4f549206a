"""The pytest plugin, in test runs of its own."""

import subprocess
import sys

import pytest

import allworlds.testing  # what a run of pytester loads it forgets; the package stays the same one
from allworlds.cli.app import command_line
from allworlds.reports.formats import text

pytest_plugins = ["pytester"]
pytestmark = pytest.mark.usefixtures("without_workers")

MARKED = """
import pytest

@pytest.mark.allworlds(edges=3)
def test_mine(explores):
    explores("algorithm1")
"""

REFUTED = """
import pytest

@pytest.mark.allworlds(edges=2)
def test_mine(explores):
    def stays(first):
        return None
        yield
    explores(stays)
"""


@pytest.fixture(scope="module")
def loaded():
    """Modules that a run of pytester would load itself, and forget while others still use them."""
    text(allworlds.check(lambda _: (yield 0), edges=1), 80)
    command_line()


@pytest.fixture
def tests(pytester, loaded):
    """A run of pytest over one file."""
    assert allworlds.testing

    def run(text, *arguments):
        pytester.makepyfile(text)
        return pytester.runpytest_inprocess("-p", "no:cov", "-p", "no:randomly", *arguments)

    return run


def test_a_mark_makes_one_test_for_each_number_of_edges(tests):
    result = tests(MARKED, "-v")
    result.assert_outcomes(passed=3)
    result.stdout.fnmatch_lines([f"*::test_mine?edges-{level}? PASSED*" for level in (1, 2, 3)])


def test_ids_can_be_selected(tests):
    tests(MARKED, "-k", "edges-2").assert_outcomes(passed=1, deselected=2)


def test_a_refuted_explorer_fails_with_the_picture_and_no_traceback_of_ours(tests):
    result = tests(REFUTED)
    result.assert_outcomes(failed=2)
    text = result.stdout.str()
    assert "breaks the law 'no-estimate' in a world with 1 edge and 1 vertex" in text
    assert " ╭─╮\nE       (0 1)" in text
    assert "REFUTED: law no-estimate is broken already in a world with 1 edge" in text
    assert "testing.py" not in text


def test_findings_are_kept_in_the_cache_each_test_its_own(tests, pytester):
    tests(REFUTED)
    kept = sorted(pytester.path.glob(".pytest_cache/d/allworlds/*/*.json"))
    assert len(kept) == 2
    assert len({file.parent for file in kept}) == 2
    assert all("test_mine-edges-" in file.parent.name for file in kept)
    result = tests(REFUTED)
    assert "0 worlds, 0 runs" in result.stdout.str()


def test_without_a_cache_nothing_is_kept(tests, pytester):
    tests(REFUTED, "-p", "no:cacheprovider").assert_outcomes(failed=2)
    assert not [*pytester.path.glob(".pytest_cache/d/allworlds/*")]


def test_a_test_that_checks_nothing_with_the_fixture_fails(tests):
    text = """
    import pytest

    @pytest.mark.allworlds(edges=1)
    def test_forgets(explores):
        pass

    @pytest.mark.allworlds(edges=1)
    def test_skips(explores):
        pytest.skip("not today")

    @pytest.fixture
    def checked(explores):
        return explores("algorithm1")

    @pytest.mark.allworlds(edges=1)
    def test_has_it_checked(checked):
        assert checked.runs == 3

    def test_without_it():
        pass
    """
    result = tests(text)
    result.assert_outcomes(passed=2, failed=1, skipped=1)
    result.stdout.fnmatch_lines(["*test_forgets*never calls it, so that nothing has been checked*"])


def test_an_assertion_needs_no_mark(tests, pytester):
    text = """
    from allworlds.testing import assert_explores

    def test_mine():
        def stays(first):
            return None
            yield
        assert_explores(stays, edges=1)
    """
    result = tests(text)
    result.assert_outcomes(failed=1)
    assert "breaks the law 'no-estimate'" in result.stdout.str()
    assert len([*pytester.path.glob(".pytest_cache/d/allworlds/*/*.json")]) == 1


def test_the_fixture_alone_tries_the_default(tests):
    result = tests("def test_mine(explores): explores('algorithm1')", "--collect-only", "-q")
    assert [line for line in result.outlines if "::" in line] == [
        f"{result.outlines[0].partition('[')[0]}[edges-{level}]" for level in (1, 2, 3, 4)
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "@pytest.mark.allworlds(edges=2)\ndef test_mine(): pass",
            "test_mine is marked 'allworlds', but does not take the fixture 'explores'",
        ),
        (
            "@pytest.mark.allworlds(4)\ndef test_mine(explores): pass",
            "takes keywords alone, such as edges=4, not 4",
        ),
        (
            "@pytest.mark.allworlds(edges=0)\ndef test_mine(explores): pass",
            "the mark of test_mine has edges = 0",
        ),
        (
            "@pytest.mark.allworld(edges=2)\ndef test_mine(explores): pass",
            "test_mine is marked 'allworld'; did you mean 'allworlds'?",
        ),
        (
            "@pytest.mark.Allworlds(edges=2)\ndef test_mine(explores): pass",
            "test_mine is marked 'Allworlds'; did you mean 'allworlds'?",
        ),
    ],
)
def test_a_mark_that_means_nothing_is_an_error(tests, text, said):
    result = tests(f"import pytest\n{text}\n", "-W", "ignore::pytest.PytestUnknownMarkWarning")
    result.assert_outcomes(errors=1)
    assert said in result.stdout.str()


def test_a_mark_of_a_module_leaves_other_tests_alone(tests):
    text = """
    import pytest
    pytestmark = pytest.mark.allworlds(edges=1)

    def test_other(): pass

    def test_mine(explores): explores("algorithm1")
    """
    tests(text).assert_outcomes(passed=2)


def test_the_mark_is_known_and_told(tests):
    result = tests(MARKED, "--strict-markers", "--markers")
    result.stdout.fnmatch_lines(["@pytest.mark.allworlds(edges=4, ?*options): one test for each*"])


def test_the_plugin_loads_nothing_of_the_package():
    code = (
        "import sys, _allworlds_pytest;"
        "sys.exit(any(name.partition('.')[0] == 'allworlds' for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_typo_in_the_mark_is_told_with_what_was_meant(tests):
    result = tests(MARKED.replace("edges=3", "edgs=3"))
    assert result.ret != 0
    result.stdout.fnmatch_lines(
        ["*the mark of test_mine has an unknown option 'edgs'; did you mean 'edges'?*"]
    )


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (
            "explores('algorithm1', lighthous='labels')",
            "explores(...) has an unknown option 'lighthous'; did you mean 'lighthouse'?",
        ),
        (
            "explores('algorithm1', lighthouse='directionel')",
            "explores(...): lighthouse 'directionel' is not one of ",
        ),
        ("explores('algorithm2')", "explores(...): explorer 'algorithm2' is not one of "),
        (
            "explores('algorithm1', edges=3)",
            "'edges' is an option of the mark: @pytest.mark.allworlds(edges=3)",
        ),
    ],
)
def test_bad_input_of_the_fixture_is_one_line(tests, call, said):
    result = tests(f"def test_mine(explores): {call}", "-k", "edges-1")
    result.assert_outcomes(failed=1, deselected=3)
    failed = [line for line in result.outlines if line.startswith("E ")]
    assert [line for line in result.outlines if line.startswith(said)]
    assert not failed
    assert "testing.py" not in result.stdout.str()
