"""Every signal that ends a check, while an explorer hangs and while all is well."""

import signal

import pytest

from cli import test_cli as quick

start = quick.start


@pytest.mark.slowest
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize(("explorer", "edges"), [("hang", "3"), ("right", "9")])
def test_an_interrupt_leaves_a_report_and_no_worker(start, tmp_path, number, explorer, edges):
    quick.test_an_interrupt_leaves_a_report_and_no_worker(start, tmp_path, number, explorer, edges)
