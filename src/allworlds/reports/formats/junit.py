"""The cases of a telling as JUnit XML, which most CI services show."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Mapping
from xml.etree import ElementTree as ET

from allworlds.reports.file_format import Format
from allworlds.reports.plain_text import text_of
from allworlds.reports.telling import ToldResult
from allworlds.verbs import CASES
from allworlds.words import escaped

WIDTH = 100
_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit(telling: ToldResult) -> str:
    """A document with one suite."""
    assert telling.suite is not None
    suite = telling.suite()
    results = Counter(case.result for case in suite.cases)
    totals = {
        "tests": str(len(suite.cases)),
        "failures": str(results["failure"]),
        "errors": str(results["error"]),
    }
    root = ET.Element("testsuites", {"name": f"allworlds {suite.verb}", **totals})
    # The schemas of services have this number at a suite, and not at the root.
    skipped = {"skipped": str(results["skipped"])}
    made = ET.SubElement(root, "testsuite", {"name": _legal(suite.name), **totals, **skipped})
    _add_properties(made, suite.properties)
    for case in suite.cases:
        element = ET.SubElement(
            made, "testcase", {"classname": f"allworlds.{suite.verb}", "name": _legal(case.name)}
        )
        if case.result == "passed":
            continue
        message = {"message": _legal(case.message)}
        kind = {} if case.result == "skipped" else {"type": case.kind}
        told = _legal(text_of(case.sections, WIDTH))
        ET.SubElement(element, case.result, {**message, **kind}).text = told or None
    ET.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root, "unicode") + "\n"


def _add_properties(suite: ET.Element, told: Mapping[str, object]) -> None:
    properties = ET.SubElement(suite, "properties")
    for name, value in told.items():
        text = value if isinstance(value, str) else json.dumps(value)
        ET.SubElement(properties, "property", {"name": name, "value": _legal(text)})


def _legal(text: str) -> str:
    """The text with control characters as numbers, and without others that XML does not allow."""
    return _FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", escaped(text))


FORMAT = Format(junit, ".xml", (CASES,))
