"""Files of worlds for tests, and what is done with them."""

import json

from allworlds.maps.build import named_map

NAMES = ("wheel-4", "k4", "cycle-5", "k4-torus", "theta", "two-loops-torus")

WRONG = """
from allworlds import Move


def goes_on(first):
    while True:
        yield Move(0)
"""


def as_json(of, **more):
    map_ = named_map(of)
    return {"sigma": [*map_.sigma], "alpha": [*map_.alpha], "name": of, **more}


def write(path, *worlds):
    path.write_text("".join(json.dumps(world) + "\n" for world in worlds), encoding="utf-8")
    return str(path)


def of(report):
    """The document of a report, but for the machine that made it."""
    document = report.to_json()
    document.pop("made_by", None)
    return document
