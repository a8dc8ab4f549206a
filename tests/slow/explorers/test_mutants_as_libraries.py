"""Every wrong explorer in a shared library: the same law, in the same smallest world."""

import pytest

from allworlds import check
from allworlds.corpus.explorers import WRONG_EXPLORERS
from allworlds.document.struct import replace
from explorers.test_mutants_as_libraries import same

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.long
@pytest.mark.parametrize("mutant", WRONG_EXPLORERS, ids=lambda mutant: mutant.name)
def test_every_wrong_explorer_in_a_library_is_killed_in_the_same_world(mutant):
    same(mutant, "kernel")


@pytest.mark.long
@pytest.mark.parametrize("mutant", WRONG_EXPLORERS, ids=lambda mutant: mutant.name)
def test_every_wrong_explorer_in_python_is_killed_by_compiled_code_in_the_same_world(mutant):
    name = f"allworlds.corpus.explorers:{mutant.name.replace('-', '_')}"
    (ours,) = check(name, edges=4, engine="kernel").findings
    (theirs,) = check(name, edges=4, engine="python").findings
    assert ours.law == theirs.law
    if ours.law != "nondeterministic":
        assert replace(ours, seen="", detail="") == replace(theirs, seen="", detail="")
