"""Commands that keep run directories, as several rooms look at them."""

import json
from pathlib import Path

EXPLORERS = Path(__file__).parent / "explorers_for_tests"

JOBS = {
    "check": "check --edges 3 --engine python",
    "check-compiled": "check --edges 5 --engine kernel",
    "check-refuted": f"check {EXPLORERS / 'wrong.py'}:everywhere --edges 3 --max-findings 5",
    "check-planar": "check --class planar --edges 3",
    "worst": "worst --edges 4",
    "census": "ambiguity census --edges 4",
    "census-simple": "ambiguity census --class simple --vertices 4",
}
"""Commands that take a run directory; each looks at hundreds of worlds."""


def stable(text):
    """A document without what differs from run to run."""
    document = json.loads(text)
    del document["made_by"]
    return document


def reporting(cli):
    """A function that runs a command and returns its exit code, its document, and stderr."""

    def run(command, *more):
        code, out, err = cli(*command.split(), *more, "--json")
        return code, stable(out), err

    return run
