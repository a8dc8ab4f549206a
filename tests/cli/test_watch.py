"""check --watch: what is done when is told by the tests, and not by the clock."""

import os

import pytest

from allworlds.cli.check import watched

pytestmark = pytest.mark.usefixtures("without_workers")

STAYS = "def explore(first):\n    return None\n    yield\n"
RAISES = "def explore(first):\n    raise ValueError\n    yield\n"
RIGHT = "from allworlds.explorers.builtin.algorithm1 import algorithm1 as explore\n"
ENDS = "an interrupt"


@pytest.fixture
def file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path / "watched_explorer.py"


@pytest.fixture
def meanwhile(monkeypatch, file):
    """A function that plans the events between looks at the file: saved text, removal, the end."""

    def happens(*events):
        left = iter(events)

        def sleep(_seconds):
            event = next(left)
            if event is ENDS:
                raise KeyboardInterrupt
            if event == "removed":
                file.unlink()
            elif event:
                before = file.stat().st_mtime_ns if file.exists() else 0
                file.write_text(event)
                os.utime(file, ns=(before + 10**9, before + 10**9))

        monkeypatch.setattr("allworlds.cli.check.sleep", sleep)
        return left

    return happens


WATCH = ["check", "watched_explorer.py:explore", "--edges", "2", "-q", "--watch"]


def test_what_is_saved_is_checked_again(cli, file, meanwhile):
    file.write_text(STAYS)
    left = meanwhile("", RAISES, "", "", RIGHT, "", ENDS)
    code, out, err = cli(*WATCH)
    assert [line.split(";")[0] for line in out.splitlines()] == [
        "REFUTED: law no-estimate is broken",
        "REFUTED: law crash is broken",
        "HOLDS: 12 worlds, 30 runs, 67 traversals: no law is broken",
    ]
    assert code == 0
    assert err.count("watched_explorer.py: it is checked again whenever it is saved") == 3
    assert next(left, None) is None


def test_what_was_found_is_tried_first(cli, file, meanwhile, tmp_path):
    file.write_text(STAYS)
    meanwhile(STAYS + "# saved\n", "", ENDS)
    corpus = tmp_path / "past"
    code, out, _ = cli(*WATCH, "--corpus", corpus)
    first, second = out.splitlines()
    assert code == 1
    assert "2 worlds, 3 runs" in first
    assert "0 worlds, 0 runs" in second, "the past finding was enough"
    assert len([*corpus.iterdir()]) == 1


def test_a_file_that_is_half_saved_or_gone_is_waited_for(cli, file, meanwhile):
    file.write_text(STAYS)
    meanwhile("removed", "", "def explore(", "", RIGHT, "", ENDS)
    code, out, err = cli(*WATCH)
    assert code == 0
    assert out.splitlines()[-1].startswith("HOLDS")
    assert len(out.splitlines()) == 2
    assert "does not import: SyntaxError" in err


def test_what_is_no_explorer_at_the_beginning_is_refused(file, refused):
    assert "cannot be watched" in refused("check", "--watch", "--edges", "1")
    assert "cannot be watched" in refused(*WATCH)
    file.write_text("def explore(")
    assert "does not import" in refused(*WATCH)
    assert "watch cannot be given with run" in refused(*WATCH, "--run", "kept")


def test_a_check_that_is_interrupted_ends_the_watch(file):
    file.write_text(STAYS)
    assert watched("watched_explorer.py", lambda: 130) == 130


def test_a_saved_model_is_read_again(cli, file, meanwhile, tmp_path):
    # The file that is saved here is that of the judge, of the predicate and of the lighthouse.
    (tmp_path / "ends.py").write_text(STAYS)
    model = (
        "from allworlds import Lighthouse\n\n\nclass Lamp(Lighthouse):\n    @classmethod\n"
        "    def places(cls, map_, start):\n        yield cls()\n\n\n"
        "def few(map_):\n    return map_.edge_count < 2\n\n\n"
        "def judge(world, transcript, answer):\n    return None\n"
    )
    file.write_text(model)
    meanwhile(
        *(model.replace("return None", "return 'never'"), ""),
        *(model.replace("< 2", "< 3"), ""),
        *(model.replace("return None", "return 5"), ""),
        *(model.replace("yield cls()", "yield from (cls(), cls())"), "", ENDS),
    )
    name = "watched_explorer.py"
    models = ["--lighthouse", f"{name}:Lamp", "--where", f"{name}:few", "--task", f"{name}:judge"]
    _, out, err = cli("check", "ends.py:explore", "--edges", "2", "-q", "--watch", *models)
    assert [line.partition(" runs")[0] for line in out.splitlines()] == [
        "HOLDS: 2 worlds, 2",
        "REFUTED: law task is broken; 2 worlds, 2",
        "HOLDS: 12 worlds, 12",
    ]
    assert "returns 5, no text and not None" in err
    assert "the place Lamp() is there twice" in err
