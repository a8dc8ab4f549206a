"""The share of lines and branches that the tests run, measured where ``COVERED`` is set.

By SlipCover, which takes its marks out of what has run.  coverage.py, which traces, makes the tests
take three times as long on Python 3.11.

Left out are the kernel, which is compiled, and what other processes run.
"""

import importlib.util
import json
import os
import sys
from importlib.machinery import PathFinder
from pathlib import Path

import pytest


class Marking:
    """Finds the modules of the package, and marks them.

    pytest would rewrite them first, where the package is installed: its distribution has a plugin.
    """

    def __init__(self, marks, files):
        self.marks, self.files = marks, files

    def find_spec(self, name, path=None, target=None):
        from slipcover.importer import SlipcoverLoader

        if name.partition(".")[0] != "allworlds":
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec and spec.origin and self.files.matches(spec.origin):
            spec.loader = SlipcoverLoader(self.marks, spec.loader, spec.origin)
        return spec


class Covered:
    """A plugin of pytest; it marks what is imported after it was made.

    Args:
        least: the least share of lines and branches, in percent.
    """

    def __init__(self, least):
        import slipcover

        package = Path(importlib.util.find_spec("allworlds").origin).parent
        files = slipcover.FileMatcher([package], ["*/engines/kernel/*"])
        self.slipcover, self.least, self.found = slipcover, least, None
        self.marks = slipcover.Slipcover(
            source=[str(package)], omit=files.omit, branch=True, immediate=True
        )
        sys.meta_path.insert(0, Marking(self.marks, files))

    def add(self, found):
        """What another process of these tests has run, too."""
        if self.found is None:
            self.found = found
        else:
            self.slipcover.merge_coverage(self.found, found)

    @property
    def share(self):
        return self.found["summary"]["percent_covered"]

    def pytest_testnodedown(self, node):
        if "covered" in getattr(node, "workeroutput", ()):  # a worker that was lost has none
            self.add(json.loads(node.workeroutput["covered"]))

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session):
        if hasattr(session.config, "workeroutput"):
            session.config.workeroutput["covered"] = json.dumps(self.marks.get_coverage())
            return
        self.add(self.marks.get_coverage())
        if self.share < self.least and session.exitstatus == 0:
            session.exitstatus = 1

    def pytest_terminal_summary(self, terminalreporter):
        self.slipcover.print_coverage(self.found, outfile=terminalreporter, skip_covered=True)
        terminalreporter.write_line(f"covered: {self.share:.2f} %, at least {self.least:g} %")


LEAST = 95.0
"""The least share of lines and branches, in percent: its one place."""

COVERED = Covered(LEAST) if "COVERED" in os.environ else None
