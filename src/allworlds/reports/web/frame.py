"""The frame of every page: its security policy, style, script and data."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from hashlib import sha256
from importlib.resources import files
from typing import Any, NamedTuple
from xml.etree import ElementTree as ET

from msgspec import Struct

from allworlds.reports.rendering import document, raw, record, tag
from allworlds.version import __version__


class Own(NamedTuple):
    """Style and script of one page: its style is added, its script replaces that of walks."""

    style: str
    script: str


class Page(Struct, frozen=True):
    """Content of a page; the frame is the same for all.

    Attributes:
        title: what was done.
        subject: to whom.
        verdict: in a word, in a sentence, and as its name, by which it has its colour;
            None without one.
        sections: the page.
        summary: the document of the report, which the page holds too.
        own: what the page has of its own; without it, keys step along its walks.
    """

    title: str
    subject: str
    verdict: tuple[str, str, str] | None
    sections: Sequence[ET.Element]
    summary: Mapping[str, Any]
    own: Own | None = None


LARGEST = 1_000_000
"""Bytes of a page.  A document with which it would be larger is left out, and the page says so."""


def framed(page: Page) -> str:
    """The page as an HTML document that refers to no other file.

    Its own style and script are allowed by their hashes, and nothing else is.
    """
    whole = _framed(page, page.summary)
    return whole if len(whole.encode()) <= LARGEST else _framed(page, None)


def _framed(page: Page, summary: Mapping[str, Any] | None) -> str:
    style = _own("style.css") + (page.own.style if page.own else "")
    script = _own("fit.js") + (page.own.script if page.own else _own("script.js"))
    title, said = f"{page.title}: {page.subject}", []
    if page.verdict:
        word, text, name = page.verdict
        title = f"{page.title}: {word}, {page.subject}"
        said = [tag("p", tag("b", word), " ", tag("span", text), class_=f"verdict {name}")]
    policy = f"default-src 'none'; style-src {_hash(style)}; script-src {_hash(script)}"
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=f"{policy}; {_REFUSED}"),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("meta", name="referrer", content="no-referrer"),
        tag("title", title),
        raw("style", style),
    )
    records, held = [], "is too large to hold its report: --json prints it"
    if summary is not None:
        records = [record(summary, class_="report", id="report-json")]
        held = "holds its data as JSON"
    body = tag(
        "body",
        tag("header", tag("h1", page.title, ": ", tag("bdi", page.subject)), *said),
        tag("main", *page.sections),
        tag("footer", tag("p", f"{_MADE} This page needs no network, and {held}.")),
        *records,
        raw("script", script),
    )
    return document(tag("html", head, body, lang="en"))


_MADE = f"Made by allworlds {__version__}."
_REFUSED = "base-uri 'none'; form-action 'none'"


def _own(name: str) -> str:
    return (files("allworlds.reports.web") / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'"
