"""What is looked at before it is used: paths, and functions that would end the process."""

import os

import pytest

from allworlds.inputs import checks
from allworlds.inputs.checks import exit_code_kept, is_loop_of_links


def test_a_loop_of_links_leads_to_no_file(tmp_path):
    (tmp_path / "file").touch()
    (tmp_path / "link").symlink_to(tmp_path / "file")
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    (tmp_path / "one").symlink_to(tmp_path / "other")
    (tmp_path / "other").symlink_to(tmp_path / "one")
    loops = ("loop", "one", "other")
    assert all(is_loop_of_links(tmp_path / name) is True for name in loops)
    names = ("file", "link", "missing", "file/inside", "a\0b")
    assert all(is_loop_of_links(f"{tmp_path}/{name}") is False for name in names)


def test_a_function_that_ends_the_process_is_refused_in_this_one_alone(monkeypatch):
    called = []

    def end(*values, **keywords):
        called.append((values, keywords))
        return "the end"

    monkeypatch.setitem(checks.ENDINGS, "_exit", end)
    with exit_code_kept():
        with pytest.raises(SystemExit, match=r"^os\._exit\(3\) would end the process$"):
            os._exit(3)
        with pytest.raises(SystemExit, match=r"^os\._exit\(4\) would end the process$"):
            os._exit(status=4)
        with pytest.raises(SystemExit, match=r"^os\.execv\('a'\) would end the process$"):
            os.execv("a", ["b"])
        assert called == []
        monkeypatch.setattr(checks._Kept, "process", os.getpid() + 1)  # as in a copy by fork
        assert os._exit(5, status=6) == "the end"
        assert called == [((5,), {"status": 6})]
