"""Every wrong explorer in a shared library: the same law, in the same smallest world."""

import pytest

from allworlds import check
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.documents.document import replace
from native_libraries import PROJECT, built

SOON_KILLED = ("lucky-guess", "crashes-at-leaves", "no-answer", "drops-markers")

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.slowest
@pytest.mark.parametrize("mutant", WRONG_EXPLORERS, ids=lambda mutant: mutant.name)
def test_every_wrong_explorer_in_a_library_is_killed_in_the_same_world(mutant):
    same(mutant, "kernel")


@pytest.mark.slowest
@pytest.mark.parametrize("mutant", WRONG_EXPLORERS, ids=lambda mutant: mutant.name)
def test_every_wrong_explorer_in_python_is_killed_by_compiled_code_in_the_same_world(mutant):
    name = f"allworlds.corpus.explorers:{mutant.name.replace('-', '_')}"
    (ours,) = check(name, edges=4, engine="kernel").findings
    (theirs,) = check(name, edges=4, engine="python").findings
    assert ours.law == theirs.law
    if ours.law != "nondeterministic":
        assert replace(ours, seen="", detail="") == replace(theirs, seen="", detail="")


HERE = PROJECT / "tests" / "support" / "explorers_for_tests"


def twin(mutant):
    name = f"allworlds.corpus.explorers:{mutant.name.replace('-', '_')}"
    words = (f'-DFOLDER="{HERE}"', f'-DEXPLORER="{name}"')
    return f"native:{built(HERE / 'shim.c', *words)}", name


def same(mutant, engine):
    library, name = twin(mutant)
    (ours,) = check(library, edges=4, engine=engine).findings
    (theirs,) = check(name, edges=4, engine="python").findings
    assert ours.law == theirs.law
    if ours.law != "nondeterministic":
        assert (ours.world, ours.place) == (theirs.world, theirs.place)
        assert ours.confirmed


@pytest.mark.slowest
@pytest.mark.parametrize(
    "mutant", [m for m in WRONG_EXPLORERS if m.name in SOON_KILLED], ids=lambda m: m.name
)
def test_a_wrong_explorer_in_a_library_is_killed_in_the_same_world(mutant):
    same(mutant, "python")
