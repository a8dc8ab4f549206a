"""The blocks of the pages whose commands take more than some seconds."""

import pytest

from docs import test_blocks as quick

PAGES = [page for page in quick.PAGES if quick.own_blocks(page)]

shell = quick.shell


def does_what_it_says(page, shell, tmp_path, monkeypatch):
    quick.test_every_block_of_the_page_does_what_the_page_says(page, shell, tmp_path, monkeypatch)


@pytest.mark.early  # the longest of all
@pytest.mark.parametrize("page", [page for page in PAGES if page in quick.SLOW])
def test_every_block_of_the_page_does_what_the_page_says(page, shell, tmp_path, monkeypatch):
    does_what_it_says(page, shell, tmp_path, monkeypatch)


@pytest.mark.slowest
@pytest.mark.parametrize("page", [page for page in PAGES if page in quick.SLOWEST])
def test_every_block_of_the_slowest_pages_does_what_the_page_says(
    page, shell, tmp_path, monkeypatch
):
    does_what_it_says(page, shell, tmp_path, monkeypatch)
