"""Checks the twins that ``allworlds ambiguity sensors`` and ``weakest`` write, without the package.

    allworlds ambiguity sensors position word:12 --edges 4 -o twins.json
    python proofs/sensor_twins.py twins.json

Each two worlds must be different, starts included, and look alike: darts of one class sense the
same, and sigma and alpha lead from them to darts of one class.  A sensor that does not suffice must
have two; of a minimal one each two letters taken together must be refuted.  What is sensed is
compared with the lighthouse where its kind is known here; else it is what the file says.  That the
others suffice is not checked.  Prints a line for each two worlds, and ``VERIFIED`` (exit code 0) or
``REFUSED: ...`` (1); 2: there is no such file.
"""

from __future__ import annotations

import json
import sys
from itertools import combinations
from pathlib import Path
from typing import Any

from documents import integers, once
from lrat import Refused
from maps import code, orbit, require_map

Percept = tuple[int, int, Any]


def word_of(lighthouse: dict[str, Any], degree: int) -> list[int] | None:
    """For each bearing the letter at the marked vertex; None where bearings are sensed as such."""
    kind = lighthouse["kind"]
    pattern = {"position": "1", "door": "10*"}.get(kind) or str(lighthouse.get("pattern", "12"))
    before, star, after = pattern.partition("*")
    if star:
        fill = before[-1] * max(0, degree - len(before) + 1 - len(after))
        pattern = before[:-1] + fill + after
    return None if kind == "directional" else [int(c) for c in (pattern * degree)[:degree]]


def sensed_under(lighthouse: dict[str, Any], sigma: list[int]) -> list[Percept] | None:
    """For each dart what is sensed there; None under a lighthouse of the user's own."""
    degrees = [len(orbit(sigma, dart)) for dart in range(len(sigma))]
    found: list[Percept] = [(degree, 0, None) for degree in degrees]
    if lighthouse["kind"] == "none":
        return found
    if lighthouse["kind"] not in {"position", "directional", "door", "word"}:
        return None
    home = orbit(sigma, lighthouse["dart"])
    word = word_of(lighthouse, len(home))
    for back, dart in enumerate([home[0], *reversed(home[1:])]):
        found[dart] = (len(home), word[back], None) if word else (len(home), 1, back)
    return found


def check_pair(pair: Any) -> str:
    """Verify two worlds, and return their sizes, and where what is sensed comes from.

    Raises:
        Refused: saying what is wrong.
    """
    facts: dict[int, Any] = {}
    codes, starts, sizes, own = [], [], [], False
    columns = [pair[name] for name in ("worlds", "sensed", "bisimulation")]
    if any(len(column) != 2 for column in columns):
        raise Refused("not two worlds with what is sensed in them and their classes")
    for world, percepts, classes in zip(*columns, strict=True):
        sigma, alpha = integers(world["sigma"], "sigma"), integers(world["alpha"], "alpha")
        require_map(sigma, alpha)
        start = integers([world["start"]], "start")[0]
        seen = [(one["degree"], one["marks"], one["bearing"]) for one in percepts]
        if not len(seen) == len(integers(classes, "the classes")) == len(sigma) > start >= 0:
            raise Refused("a world has not one class and percept for each dart, or no start")
        if (meant := sensed_under(world["lighthouse"], sigma)) and meant != seen:
            raise Refused(f"a {world['lighthouse']['kind']} lighthouse shows something else")
        own |= meant is None
        for dart, percept in enumerate(seen):
            if percept[0] != len(orbit(sigma, dart)):
                raise Refused(f"dart {dart} has not the degree {percept[0]}")
            fact = (percept, classes[sigma[dart]], classes[alpha[dart]])
            if facts.setdefault(classes[dart], fact) != fact:
                raise Refused(f"dart {dart} does not behave as its class {classes[dart]}")
        codes.append(code(sigma, alpha, start))
        starts.append(classes[start])
        sizes.append(len(sigma) // 2)
    if starts[0] != starts[1]:
        raise Refused("the starts are in different classes")
    if codes[0] == codes[1]:
        raise Refused("the two worlds are the same, start included")
    said = ", sensed as the file says" if own else ""
    return f"alike: m = {sizes[0]} and m = {sizes[1]}{said}"


def require_size(pair: Any, edges: Any, name: object) -> None:
    """Raise Refused unless the larger of the two worlds has so many edges."""
    if edges != max(len(world["sigma"]) // 2 for world in pair["worlds"]):
        raise Refused(f"{name}: the two worlds are not of the size that is claimed")


def joined(letters: Any, one: int, other: int) -> set[frozenset[str]]:
    """The blocks of features when two of them are one."""
    blocks = [frozenset(block) for block in letters]
    kept = [block for i, block in enumerate(blocks) if i not in {one, other}]
    return {*kept, blocks[one] | blocks[other]}


def check(document: Any) -> list[str]:
    """Verify every two worlds of a document, and return a line for each.

    Raises:
        Refused: saying what is wrong.
    """
    said = []
    for row in document.get("rows", []):
        name, pair = row["lighthouse"], row.get("twins")
        if (row["sufficient"] is False) != (pair is not None):
            raise Refused(f"{name}: two worlds look alike just where it does not suffice")
        if pair is not None:
            said.append(f"{name}: {check_pair(pair)}")
            require_size(pair, row["first"], name)
    refuted = document.get("refuted", [])
    for row in refuted:
        said.append(f"{row['letters']}: {check_pair(row['twins'])}")
        number = {feature: i for i, block in enumerate(row["letters"]) for feature in block}
        marks = {one["marks"] for seen in row["twins"]["sensed"] for one in seen}
        require_size(row["twins"], row["edges"], row["letters"])
        if not marks <= {*number.values()} or {*number} != {*document["features"]}:
            raise Refused(f"{row['letters']}: not the letters of these features")
    for row in document.get("minimal", []) if refuted else []:
        below = [{frozenset(block) for block in refuted[i]["letters"]} for i in row["below"]]
        for one, other in combinations(range(len(row["letters"])), 2):
            if joined(row["letters"], one, other) not in below:
                raise Refused(f"{row['letters']}: nothing refutes letters {one} and {other} as one")
    if not said:
        raise Refused("there are no two worlds that look alike, so there is nothing to verify")
    return said


def main(arguments: list[str]) -> int:
    """A line for each two worlds, the answer, and the exit code."""
    if len(arguments) != 1:
        print("usage: sensor_twins.py TWINS.json", file=sys.stderr)
        return 2
    try:
        text = Path(arguments[0]).read_text(encoding="utf-8")
        print("\n".join(check(json.loads(text, object_pairs_hook=once))))
    except OSError as error:
        print(f"sensor_twins.py: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    except Refused as error:
        print(f"REFUSED: {error}")
        return 1
    except (ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError) as error:
        print(f"REFUSED: the file has not the form that is expected: {error!r}")
        return 1
    print("VERIFIED")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
