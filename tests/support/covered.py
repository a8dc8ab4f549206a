"""The share of lines and branches that the tests run, where ``COVERED`` says what it must be.

By SlipCover, which takes its marks out of what has run.  coverage.py, which traces, makes the tests
take three times as long on Python 3.11.

Left out are the kernel, which is compiled, and what other processes run.
"""

import importlib.util
import json
import os
from pathlib import Path

import pytest


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
        self.marks = slipcover.Slipcover(source=[str(package)], omit=files.omit, branch=True)
        slipcover.ImportManager(self.marks, files).__enter__()

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


COVERED = Covered(float(os.environ["COVERED"])) if "COVERED" in os.environ else None
