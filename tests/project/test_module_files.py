"""Where the tests of a module are: ``test_MODULE.py`` in the folder of a wing, if there is one."""

from pathlib import Path

TESTS = Path(__file__).parents[1]
SOURCE = TESTS.parent / "src" / "allworlds"

MOST_WITHOUT = 106
"""Modules whose tests are in files that are named by a topic alone; fewer, never more."""

HAVE_ONE = {"engine_table", "judge", "lanes", "law_table", "players", "units"}
"""Some of those that may do most harm."""


def without(modules, files):
    """The modules that no file of tests is named by."""
    return sorted(set(modules) - {file.removeprefix("test_") for file in files})


def test_no_more_modules_are_without_a_file_of_tests():
    modules = [path.stem for path in SOURCE.rglob("*.py") if not path.stem.startswith("__")]
    left = without(modules, [path.stem for path in TESTS.rglob("test_*.py")])
    assert len(left) <= MOST_WITHOUT, f"without a file of tests: {', '.join(left)}"
    assert not HAVE_ONE & set(left)


def test_a_module_without_one_is_found():
    assert without(["lane", "lanes"], ["test_lanes"]) == ["lane"]
