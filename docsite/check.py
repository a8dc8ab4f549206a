"""Whether the built site loads nothing from other hosts, and lists what it links to there.

``python docsite/check.py build/site``: exit code 1, and a line for each address, if not.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path

LISTED = "reference/links.html"
"""The page on which the links to other hosts are listed."""

ELSEWHERE = re.compile(r"^\s*(?:https?:)?//", re.IGNORECASE)
IN_STYLES = re.compile(r"(?:url\(|@import)\s*['\"]?\s*((?:https?:)?//[^'\")\s;]+)", re.IGNORECASE)
NAMED_ONLY = {"canonical", "alternate", "license", "author", "next", "prev"}
"""What a ``link`` can be without anything being loaded."""


class Reader(HTMLParser):
    """The addresses on other hosts that a page loads, and those that it links to."""

    def __init__(self) -> None:
        super().__init__()
        self.loaded: list[str] = []
        self.linked: list[str] = []
        self._in_style = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note the addresses of an element."""
        given = {name: value or "" for name, value in attrs}
        self._in_style = tag == "style"
        addresses = [given.get(name, "") for name in ("src", "data", "poster", "action")]
        addresses += [
            part.split()[0] for part in given.get("srcset", "").split(",") if part.split()
        ]
        addresses += IN_STYLES.findall(given.get("style", ""))
        if tag in ("image", "use"):
            addresses += [given.get("href", ""), given.get("xlink:href", "")]
        if tag == "link" and not NAMED_ONLY & set(given.get("rel", "").split()):
            addresses.append(given.get("href", ""))
        self.loaded += [address for address in addresses if ELSEWHERE.match(address)]
        if tag == "a" and ELSEWHERE.match(given.get("href", "")):
            self.linked.append(given["href"])

    def handle_data(self, data: str) -> None:
        """Note what a style loads."""
        if self._in_style:
            self.loaded += IN_STYLES.findall(data)


def read(text: str) -> Reader:
    """The addresses on other hosts that are in a page."""
    reader = Reader()
    reader.feed(text)
    return reader


def faults(site: Path) -> Iterator[str]:
    """A line for each address that is loaded from another host, or linked to and not listed."""
    pages = {path: read(path.read_text(encoding="utf-8")) for path in sorted(site.rglob("*.html"))}
    if not pages:
        yield f"{site} holds no page"
        return
    listed = set(pages[site / LISTED].linked) if site / LISTED in pages else set()
    for path, page in pages.items():
        name = path.relative_to(site)
        yield from (f"{name} loads {address}" for address in page.loaded)
        yield from (
            f"{name} links to {address}, which {LISTED} does not list"
            for address in sorted(set(page.linked) - listed)
        )
    for path in sorted(site.rglob("*.css")):
        for address in IN_STYLES.findall(path.read_text(encoding="utf-8")):
            yield f"{path.relative_to(site)} loads {address}"


if __name__ == "__main__":
    found = list(faults(Path(sys.argv[1])))
    print("\n".join(found) or "nothing is loaded from other hosts, and every link out is listed")
    sys.exit(bool(found))
