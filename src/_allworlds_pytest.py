"""The pytest plugin of allworlds: a mark, and the fixture that goes with it.

The plugin stands beside the package and not in it, and imports the package only when a test needs
it.  So the plugin costs nothing if it is not used, and the coverage of the package itself can be
measured from its first line on.
"""

import hashlib
import re
from collections.abc import Callable, Iterator
from difflib import get_close_matches
from pathlib import Path
from typing import Any

import pytest

MARK = "allworlds"
FIXTURE = "explores"
TOLD = (
    "allworlds(edges=4, **options): one test for each number of edges, in which the fixture "
    "'explores' checks an explorer; options are those of allworlds.check"
)

_current: list[pytest.Item] = []


def pytest_configure(config: pytest.Config) -> None:
    """Register the mark with pytest."""
    config.addinivalue_line("markers", TOLD)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Make one test for each number of edges."""
    definition = metafunc.definition
    if FIXTURE not in metafunc.fixturenames:
        if any(mark.name == MARK for mark in definition.own_markers):
            pytest.fail(
                f"{definition.name} is marked '{MARK}', but does not take the fixture "
                f"'{FIXTURE}': def {definition.name}({FIXTURE}): {FIXTURE}(my_explorer)",
                pytrace=False,
            )
        return
    mark = definition.get_closest_marker(MARK) or _misspelt(definition)
    if mark and mark.args:
        pytest.fail(
            f"the mark of {definition.name} takes keywords alone, such as edges=4, not "
            f"{', '.join(map(repr, mark.args))}",
            pytrace=False,
        )
    from allworlds.inputs.checks import InputError
    from allworlds.testing import levels_of, unknown_option

    if mark and (told := unknown_option(mark.kwargs)):
        pytest.fail(f"the mark of {definition.name} has {told}", pytrace=False)
    try:
        levels = levels_of(mark.kwargs if mark else {})
    except InputError as error:
        pytest.fail(f"the mark of {definition.name} has {error}", pytrace=False)
    metafunc.parametrize(FIXTURE, levels, ids=[f"edges-{edges}" for edges in levels], indirect=True)


def _misspelt(definition: pytest.Item) -> None:
    """Fail a test that has no mark of ours, but one with nearly its name."""
    for mark in definition.iter_markers():
        if get_close_matches(mark.name.lower(), [MARK], cutoff=0.85):
            pytest.fail(
                f"{definition.name} is marked '{mark.name}'; did you mean '{MARK}'?", pytrace=False
            )


class _Explores:
    """The value of the fixture: a level, and whether it was called."""

    def __init__(self, level: Callable[..., Any]) -> None:
        self._level = level
        self.asked = False

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        __tracebackhide__ = True
        from allworlds.inputs.checks import InputError
        from allworlds.testing import unknown_option

        self.asked = True
        if "edges" in options:
            pytest.fail(
                f"'edges' is an option of the mark: @pytest.mark.{MARK}(edges={options['edges']})",
                pytrace=False,
            )
        if told := unknown_option(options):
            pytest.fail(f"{FIXTURE}(...) has {told}", pytrace=False)
        try:
            return self._level(*arguments, **options)
        except InputError as error:
            pytest.fail(f"{FIXTURE}(...): {error}", pytrace=False)


@pytest.fixture
def explores(request: pytest.FixtureRequest) -> Callable[..., Any]:
    """The fixture: ``explores(my_explorer)`` asserts that it is right in every world of the level.

    The mark ``allworlds`` says how many edges the worlds have, and how runs are judged.
    """
    from allworlds.testing import AtLevel

    mark = request.node.get_closest_marker(MARK)
    return _Explores(AtLevel(request.param, mark.kwargs if mark else {}))


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Iterator[object]:
    """Fail a test that has the fixture and never calls it."""
    result = yield
    level = pyfuncitem.funcargs.get(FIXTURE)
    if isinstance(level, _Explores) and not level.asked:
        pytest.fail(
            f"{pyfuncitem.name} takes the fixture '{FIXTURE}' and never calls it, so that nothing "
            f"has been checked: {FIXTURE}(my_explorer)",
            pytrace=False,
        )
    return result


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Note which test is running, so that its past findings are found."""
    _current.append(item)
    try:
        return (yield)
    finally:
        _current.pop()


def corpus_of_test() -> Path | None:
    """The directory of the running test's past findings in pytest's cache; None without a cache.

    Each test has a directory of its own, so that tests can run side by side.
    """
    cache = getattr(_current[-1].config, "cache", None) if _current else None
    if cache is None:
        return None
    name = _current[-1].nodeid
    digest = hashlib.sha256(name.encode()).hexdigest()[:8]
    readable = re.sub(r"[^\w.-]+", "-", name)[-60:].strip("-")
    return Path(cache.mkdir(MARK)) / f"{readable}-{digest}"
