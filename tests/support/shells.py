"""A shell in which `allworlds` and `python` are those under test."""

import os
import subprocess
import sys
from pathlib import Path

import allworlds

PROGRAMS = {"python": "", "python3": "", "allworlds": "-m allworlds"}
CHANGES_WHAT_IS_PRINTED = ("CI", "BUILD_NUMBER", "GITHUB_ACTIONS", "PYTEST_ADDOPTS", "COLUMNS")
SECONDS = 600


def shell_in(folder, programs):
    """A function that runs a command in the folder, or in another one.

    The programs under test are written into the new directory ``programs``.
    """
    programs.mkdir()
    for name, start in PROGRAMS.items():
        program = programs / name
        program.write_text(f'#!/bin/sh\nexec "{sys.executable}" {start} "$@"\n')
        program.chmod(0o755)
    environment = {
        **os.environ,
        "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": str(Path(allworlds.__file__).parents[1]),
    }
    for name in CHANGES_WHAT_IS_PRINTED:
        environment.pop(name, None)

    def run(command, where=folder):
        return subprocess.run(
            ["bash", "-c", command],
            cwd=where,
            env=environment,
            capture_output=True,
            encoding="utf-8",
            timeout=SECONDS,
            check=False,
        )

    return run
