"""A real browser, in which a page may complain of nothing and fetch nothing."""

import shutil
from contextlib import contextmanager

import pytest

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser"))), None)
OPTIONS = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
]
DESK = {"width": 1280, "height": 900}


@pytest.fixture(scope="session")
def sync_api():
    """The driver of browsers."""
    return pytest.importorskip("playwright.sync_api", reason="needs the extra 'browser'")


@pytest.fixture(scope="session")
def browser(sync_api):
    if CHROMIUM is None:
        pytest.skip("there is no Chromium")
    with sync_api.sync_playwright() as driver:
        opened = driver.chromium.launch(executable_path=CHROMIUM, args=OPTIONS)
        yield opened
        opened.close()


@pytest.fixture
def visit(browser):
    """Opens a file; what the console complains of is an error, and so is a request."""

    @contextmanager
    def visited(file, size=DESK, **options):
        context = browser.new_context(viewport=size, **options)
        page, complaints = context.new_page(), []
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on(
            "request", lambda r: None if r.url.startswith("file:") else complaints.append(r.url)
        )
        page.goto(file.as_uri())
        yield page
        context.close()
        assert complaints == []

    return visited
