"""Writes the table and the pictures of ``sensors.md``: ``python sensor_table.py``.

The table is what ``allworlds ambiguity sensors`` finds; the words beside it stand here.
"""

from __future__ import annotations

import re
from pathlib import Path

from allworlds.ambiguity import AmbiguitySensors, sensors

HERE = Path(__file__).parent
PAGE = HERE / "sensors.md"
EDGES = 4

WORDS = {
    "directional": "at v0 the bearing of the door",
    "door": "whether one has come in by the door",
    "word:12*": "at v0, and whether the bearing is 0",
    "word:122*": "the same, written otherwise",
    "sensors.py:Half": "at v0, and whether the door is to the left or to the right",
    "sensors.py:Distance": "at v0, and how far the door is, on whichever side",
    "sensors.py:BothEnds": "both ends of the door's edge, with different letters",
    "sensors.py:Bit?of=behind": "whether one has come out by the door",
    "sensors.py:Bit?of=behind-door-next": "the same, or in by the door or the next one",
    "sensors.py:Bit?of=neighbour-other": "at a neighbour of v0, or in by another door",
    "sensors.py:Bit?of=neighbour-door-next": "at a neighbour of v0, or in by the door or the next",
    "word:01*": "at v0, and not by the door",
    "word:1": "at v0 (position)",
    "word:12": "at v0, and the parity of the bearing",
    "word:123": "at v0, and the bearing modulo 3",
    "word:1234": "at v0, and the bearing modulo 4",
    "sensors.py:BothEnds?behind=1": "both ends of the door's edge, with one letter",
    "sensors.py:Face": "every dart of the door's face",
    "sensors.py:Glow": "at v0, or at a neighbour of it",
    "sensors.py:CameFrom": "at v0, and whether one was there before the last motion",
    "sensors.py:TwoMarkers": "one marker at v0, and one at the vertex behind the door",
    "sensors.py:TwoMarkers?second=2": "the same with different markers",
    "none": "the degree alone",
}
"""What is sensed besides the degree, by the name of the sensor."""

SHOWN = ("word:1", "word:01*", "sensors.py:BothEnds?behind=1")
"""The sensors of which the smallest twins are drawn."""


def found(names: tuple[str, ...] = tuple(WORDS), edges: int = EDGES) -> AmbiguitySensors:
    """What the command finds for these sensors, in the folder of their file."""
    return sensors(
        *(name.replace("sensors.py", f"{HERE}/sensors.py") for name in names), edges=edges
    )


def table(report: AmbiguitySensors) -> str:
    """The rows, in Markdown."""
    lines = [
        "| sensor | sensed besides the degree | suffices | m | maps |",
        "|---|---|---|--:|--:|",
    ]
    for row in report.rows:
        name = row.lighthouse.replace(f"{HERE}/", "")
        enough = "**minimal**" if row.lighthouse in report.minimal else "yes"
        answer = [enough, "", ""] if row.sufficient else ["no", str(row.first), str(row.ambiguous)]
        lines.append(f"| {' | '.join([f'`{name}`', WORDS[name], *answer])} |")
    return "\n".join(lines)


def pictures(report: AmbiguitySensors) -> str:
    """The smallest twins of some sensors, each in a block."""
    found = str(report).replace(f"{HERE}/", "").split("\nWorlds that look alike under ")[1:]
    sections = [section.partition("\n\n") for section in found]
    drawn = []
    for name in SHOWN:
        (body,) = (body for head, _, body in sections if f"'{name}'" in " ".join(head.split()))
        drawn.append(f"`{name}`:\n\n```text\n{body.rstrip()}\n```")
    return "\n\n".join(drawn)


def written(page: str, name: str, part: str) -> str:
    """The page with another text in a part of that name."""
    begin, end = f"<!-- {name}: written by sensor_table.py -->", f"<!-- end of {name} -->"
    return re.sub(
        f"{begin}.*?{end}", lambda _: f"{begin}\n\n{part}\n\n{end}", page, flags=re.DOTALL
    )


if __name__ == "__main__":
    seen = found()
    text = PAGE.read_text(encoding="utf-8")
    text = written(text, "table", table(seen))
    PAGE.write_text(written(text, "twins", pictures(seen)), encoding="utf-8")
