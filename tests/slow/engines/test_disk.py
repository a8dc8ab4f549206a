"""A disk that is full, or can only be read: what was finished stays, and one line says so."""

import json
import os
import resource
import subprocess
import sys
from contextlib import contextmanager

import pytest

from allworlds import check
from allworlds.studies.merge import DoneOf, status

EDGES = 4
UNITS = 20
WHOLE = DoneOf(done=UNITS, all=UNITS)
CHECK = [sys.executable, "-m", "allworlds", "check", "--edges", str(EDGES), "--engine", "python"]


def checked(run, **more):
    """The exit code of a check, its document without what is volatile, and stderr."""
    done = subprocess.run(
        [*CHECK, "--json", "--run", run], capture_output=True, text=True, check=False, **more
    )
    document = json.loads(done.stdout) if done.stdout else {}
    document.pop("made_by", None)
    return done.returncode, document, done.stderr


@contextmanager
def disk(path, kilobytes):
    """A file system of its own that holds so little."""
    path.mkdir()
    mounted("-t", "tmpfs", "-o", f"size={kilobytes}k", "none", path)
    try:
        yield path
    finally:
        subprocess.run(["umount", "-l", path], check=True)


def mounted(*words):
    try:
        done = subprocess.run(["mount", *words], capture_output=True, text=True, check=False)
    except OSError as error:
        pytest.skip(f"there is no mount: {error}")
    if done.returncode:
        pytest.skip(f"nothing can be mounted: {done.stderr}")


@pytest.mark.slowest
def test_a_full_disk_loses_nothing_that_was_finished(tmp_path):
    whole = check(edges=EDGES).to_json()
    with disk(tmp_path / "disk", 180) as small:
        run = small / "run"
        code, document, said = checked(run)
        assert (code, document) == (0, whole)
        assert "takes no more: database or disk is full; what it holds is kept" in said
        assert said.count("\n") == 1
        kept = status(run)
        assert (kept.state, 0 < kept.units.done < UNITS) == ("unfinished", True)
        mounted("-o", "remount,ro", small)
        assert checked(run) == (
            2,
            {},
            f"allworlds: run directory '{run}' cannot be written: Read-only file system\n",
        )
        assert status(run).units == kept.units
        mounted("-o", "remount,rw,size=2m", small)
        assert checked(run) == (0, whole, "")
        assert status(run).units == WHOLE


def test_a_directory_on_a_disk_that_is_full_already_is_refused(tmp_path):
    with disk(tmp_path / "disk", 8) as small:
        code, document, said = checked(small / "run")
        assert (code, document) == (2, {})
        assert "cannot be used: database or disk is full" in said
        assert said.count("\n") == 1


@pytest.mark.slowest
def test_a_file_that_may_not_grow_loses_nothing_that_was_finished(tmp_path):
    """A limit on the size of files takes the place of a small file system."""
    whole = check(edges=EDGES).to_json()
    run = tmp_path / "run"

    def little():
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, resource.RLIM_INFINITY))

    code, document, said = checked(run, preexec_fn=little)
    assert (code, document) == (0, whole)
    assert "takes no more" in said
    assert said.count("\n") == 1
    kept = status(run).units.done
    assert 0 < kept < UNITS
    assert checked(run) == (0, whole, "")
    assert status(run).units == WHOLE


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_directory_that_may_not_be_written_is_refused(tmp_path):
    check(edges=1, run=tmp_path / "run")
    (tmp_path / "run").chmod(0o500)
    (tmp_path / "run" / "lock").chmod(0o400)
    try:
        code, document, said = checked(tmp_path / "run")
    finally:
        (tmp_path / "run").chmod(0o700)
    assert (code, document, said.count("\n")) == (2, {}, 1)
    assert "cannot be written: Permission denied" in said
