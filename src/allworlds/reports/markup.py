"""Elements of HTML and SVG, and their text."""

from __future__ import annotations

import json
import re
from typing import TypeAlias
from xml.etree import ElementTree as ET

from allworlds.words import escaped, harmless_json

Child: TypeAlias = ET.Element | str
"""Possible children of an element."""

# HTML allows neither control characters nor non-characters, and UTF-8 no half of a pair.
_FORBIDDEN = re.compile(
    "[^\t\n\r\x20-\x7e\xa0-\ud7ff\ue000-\ufdcf\ufdf0-\ufffd\U00010000-\U0010ffff]"
    f"|[{''.join(chr(plane << 16 | low) for plane in range(1, 17) for low in (0xFFFE, 0xFFFF))}]"
)
_INLINE = frozenset(
    {"a", "b", "bdi", "code", "button", "span", "title", "td", "th", "dt", "text", "tspan"}
)


def tag(name: str, /, *children: Child, **attributes: str | float | None) -> ET.Element:
    """An element with its children.

    An attribute's name is written with ``_`` for ``-`` and may end in ``_``; one that is None
    is left out.  Nothing else than a newline stands between elements that are no part of a
    line.
    """
    element = ET.Element(name)
    for key, value in attributes.items():
        if value is not None:
            element.set(key.rstrip("_").replace("_", "-"), legal(escaped(str(value))))
    last: ET.Element | None = None
    for child in children:
        if isinstance(child, ET.Element):
            element.append(child)
            last = child
        elif last is None:
            element.text = (element.text or "") + legal(escaped(child))
        else:
            last.tail = (last.tail or "") + legal(escaped(child))
    if name not in _INLINE:
        element.tail = "\n"
    return element


def record(document: object, /, **attributes: str) -> ET.Element:
    """A block of data that holds a JSON document; no text in it can end the block."""
    text = harmless_json(json.dumps(document, indent=1))
    for sign in "<>&":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return raw("script", text, type="application/json", **attributes)


def raw(name: str, text: str, /, **attributes: str) -> ET.Element:
    """A ``script`` or ``style``, whose text a browser reads unescaped."""
    if "</" in text or "<!--" in text:
        raise ValueError(f"the text of a {name} would end it")
    element = tag(name, **attributes)
    element.text = text
    return element


def legal(text: str) -> str:
    """The text with a replacement for each character that HTML does not allow."""
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", text)


def document(root: ET.Element) -> str:
    """The text of a page."""
    return "<!DOCTYPE html>\n" + ET.tostring(root, "unicode", method="html") + "\n"
