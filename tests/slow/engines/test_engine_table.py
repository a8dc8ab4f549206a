import pytest

from allworlds import check
from allworlds.engines.compiled_engine import AGREED
from allworlds.engines.kernel.capabilities import COMPILING
from allworlds.outcome import Verdict
from engines import test_engine_table as quick
from engines.test_engine_table import Stopper
from native_libraries import attack, example

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.mark.slowest
def test_auto_takes_the_kernel_from_five_edges_on_wherever_it_can():
    assert check(edges=4).engine == "python"
    assert check(edges=5).engine == "kernel"
    report = check(edges=6)
    assert report.engine == "kernel"
    assert report.exit_code == 0
    assert report.worlds == 2 + 10 + 74 + 706 + 8162 + 110410
    assert check(vertices=3, map_class="simple", edges=6).engine == "kernel"
    assert check(edges=5, vertices=2, policy="random:1").engine == "python"


@pytest.mark.slowest
def test_both_judges_of_a_library_count_and_find_the_same():
    library = f"native:{example('c/algorithm1.c')}"
    compiled, general = (check(library, edges=2, engine=each) for each in ("kernel", "python"))
    assert (compiled.rows, compiled.exit_code) == (general.rows, 0)
    wrong = f"native:{attack('abort()')}"
    law, other = (check(wrong, edges=2, engine=each).findings for each in ("kernel", "python"))
    assert [found.key for found in law] == [found.key for found in other]


@pytest.mark.slowest
def test_ctrl_c_leaves_the_finished_levels():
    listener = Stopper(after=50_000)
    report = check(edges=8, engine="kernel", workers=2, listener=listener)
    assert report.interrupted
    assert report.exit_code == 130
    assert report.levels == (1, 2, 3, 4, 5)
    assert listener.worlds < 1_000_000


@pytest.mark.slowest
def test_a_time_limit_is_kept():
    report = check(edges=10, engine="kernel", workers=2, time_limit=2.5)
    assert report.verdict is Verdict.INCONCLUSIVE
    assert report.exit_code == 3
    assert "2.5 s" in report.ending.reason
    assert report.levels == tuple(range(1, len(report.levels) + 1))


def test_threads_do_not_change_the_report():
    one, three = (check(edges=6, engine="kernel", workers=n).to_json() for n in (1, 3))
    assert one == three


@pytest.mark.slowest
@pytest.mark.parametrize("name", [*("everywhere", "here_of_another", "raises")])
def test_both_judges_of_a_users_explorer_count_and_find_the_same(name):
    quick.test_both_judges_of_a_users_explorer_count_and_find_the_same(name)


@pytest.mark.slowest
@pytest.mark.parametrize("kept", [False, True])
def test_which_engine_is_taken_does_not_depend_on_what_is_compiled(monkeypatch, kept):
    monkeypatch.setattr("allworlds.engines.compiled_engine.is_compiled", lambda _: kept)
    apart = []
    monkeypatch.setattr("allworlds.engines.kernel.engine.compile_apart", apart.append)
    listener = Stopper()
    AGREED.clear()
    assert check(edges=5, vertices=2, listener=listener).engine == "kernel"
    assert listener.notices == ([] if kept else [COMPILING])
    assert apart == ([] if kept else ["algorithm1"])
