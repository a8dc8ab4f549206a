"""Inputs that are nearly right: valid ones, mutated by what they are made of."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from random import Random
from typing import Any

from allworlds.maps import random_map
from allworlds.world import LIGHTHOUSES
from allworlds.world.named import own_corpus

LONG = "x" * 5000
HUGE = 10**13
"""No number between the small ones and these is tried: it could be legal, and take for ever."""

TEXTS = (
    "",
    " ",
    ".",
    "-",
    "--",
    "/",
    "@",
    "@missing.json",
    "none",
    "a\x00b",
    "\x1b[31mred\x07",
    "a\nb\r\nc\u2028d\u0085e",
    "\ud800",
    "\udcff\udcfe",
    "\N{SUPERSCRIPT TWO}",
    "\N{ARABIC-INDIC DIGIT ONE}",
    "\N{RIGHT-TO-LEFT OVERRIDE}evil",
    "'\"`$(true)",
    "%s{0}{x!r}\\",
    LONG,
    "\x1b" * 500,
    "\N{SNOWMAN}" * 400,
    ",".join("0" * 300),
)
NUMBERS = (
    *("0", "1", "2", "-1", "-0", "+1", "00", "0.5", "1e3", "1_0", "0x1", ".", "nan", "inf", "-inf"),
    *("1e999", str(HUGE), str(-HUGE), *("9" * digits for digits in (100, 3000, 4300, 4301))),
    "-" + "9" * 5000,
)
RAW = (
    *("null", "true", "false", "0", "-1", "1", "2", "3", "5", "0.0", "1.0", "1e999", "-0", "NaN"),
    *("Infinity", "-Infinity", "[]", "{}", '""', "[[]]", "[0]", str(HUGE), str(-(10**21))),
    *("9" * 4300, "9" * 5000, "[" * 100_000, "[" * 900 + "]" * 900),
    *('{"a":' * 400 + "1" + "}" * 400, '"\\ud800"', '"\\u001b[31m\\u0000"', "'", "\\", "//"),
    *(json.dumps(text) for text in TEXTS if "\udcff" not in text),
)
OTHER_KEYS = ("strat", "lighthouse", "dart", "darts", "single", "version", "start", LONG, "\x1b")
BYTES = (b"\xff", b"\xfe\xff", b"\x00", b"\xef\xbb\xbf", b"\xc3", b"\n", b"\r", b"\x1b[2J", b"}")


@dataclass(frozen=True)
class Raw:
    """A text that stands for a value in a JSON text."""

    text: str


def text_of(tree: Any) -> str:
    """The JSON text of a tree, in which anything can stand."""
    match tree:
        case Raw(text):
            return text
        case dict():
            return "{" + ",".join(f"{json.dumps(k)}:{text_of(v)}" for k, v in tree.items()) + "}"
        case list():
            return "[" + ",".join(map(text_of, tree)) + "]"
        case _:
            return json.dumps(tree)


def mutated(tree: Any, random: Random) -> bytes:
    """The bytes of a JSON text that is nearly that of the tree."""
    for _ in range(random.choice((0, 1, 1, 1, 1, 1, 2, 4))):
        tree = _changed(tree, random)
    content = text_of(tree).encode("utf-8", "surrogatepass")
    return _torn(content, random) if random.random() < 0.08 else content


def _changed(tree: Any, random: Random) -> Any:
    """One node is another, misses, or stands twice."""
    if isinstance(tree, dict | list) and tree and random.random() < 0.9:
        keys = list(tree) if isinstance(tree, dict) else list(range(len(tree)))
        key = random.choice(keys)
        changed = tree.copy()
        match random.randrange(16):
            case 0:
                del changed[key]
            case 1 if isinstance(tree, dict):
                again = f"{json.dumps(key)}:{text_of(random.choice((tree[key], Raw('0'))))}"
                return Raw(f"{text_of(tree)[:-1]},{again}}}")
            case 1:
                changed.insert(key, tree[key])
            case 2 if isinstance(tree, dict):
                changed[random.choice(OTHER_KEYS)] = tree[key]
            case 2:
                random.shuffle(changed)
            case _:
                changed[key] = _changed(tree[key], random)
        return changed
    if type(tree) is int and random.random() < 0.7:
        return tree + random.choice((-2, -1, 1, 2, 3, HUGE, -HUGE, 10**21, -(10**21)))
    return Raw(random.choice(RAW))


def _torn(content: bytes, random: Random) -> bytes:
    at = random.randrange(len(content) + 1)
    match random.randrange(5):
        case 0:
            return content[:at]
        case 1:
            return content[:at] + random.choice(BYTES) + content[at:]
        case 2:
            return content[:at] + random.randbytes(random.randrange(1, 9)) + content[at + 3 :]
        case 3:
            return content + content
        case _:
            return random.choice(BYTES) + content


@cache
def worlds() -> list[dict[str, Any]]:
    """Small worlds under every lighthouse, where it stands told or not."""
    maps = [
        ([0, 1], [1, 0]),
        ([1, 0], [1, 0]),
        ([0, 2, 1, 3], [1, 0, 3, 2]),
        ([1, 2, 0, 5, 3, 4], [3, 4, 5, 0, 1, 2]),
        ([1, 2, 3, 0], [2, 3, 0, 1]),
    ]
    lights: list[dict[str, Any]] = [{}]
    for kind in LIGHTHOUSES:
        lights += [{"lighthouse": {"kind": kind, **more}} for more in ({}, {"dart": 0})]
    lights.append({"lighthouse": {"kind": "compass", "darts": [0, 1]}})
    lights.append({"lighthouse": {"kind": "cluster", "dart": 0, "single": True}})
    return [
        {"sigma": sigma, "alpha": alpha, **start, **light}
        for sigma, alpha in maps
        for start in ({}, {"start": 0}, {"start": 1})
        for light in lights
    ]


def world_named(random: Random) -> dict[str, Any]:
    """A random world of up to 6 edges, under any lighthouse, whether it can stand there or not."""
    map_ = random_map(random.randrange(1, 7), random)
    light = {"kind": random.choice(list(LIGHTHOUSES)), "dart": random.choice(map_.darts)}
    if random.random() < 0.3:
        del light["dart"]
    return {**map_.to_json(), "start": random.choice(map_.darts), "lighthouse": light}


@cache
def findings() -> list[dict[str, Any]]:
    """Those that the project keeps; the walks of some are long."""
    corpus = own_corpus()
    kept = [corpus.document(entry) for entry in corpus.of_kind("finding")]
    return [
        one
        for one in kept
        # With a step budget of any size that one goes on for ever.
        if len(one["transcript"]) <= 40 and "never_stops" not in one["explorer"]
    ]


EXPRESSION = (
    *("n", "m", "d0", "D", "0", "1", "2", "7", "63", "64", "65", "(", ")", "+", "-", "*", "//"),
    *("**", "/", "%", "min(", "max(", ",", ".", "not", "if", "else", "or", "1if"),
)
EXPRESSIONS = ("n+m", "2*m", "min(n,m)", "max(n, 2) ** 2", "-n // d0", "(n + m) * D", "paper")


def expression(random: Random) -> str:
    """A bound that is nearly one."""
    match random.randrange(6):
        case 0:
            return random.choice(("(", "-", "n+", "min(", "9**")) * random.choice((3, 200, 3000))
        case 1:
            return random.choice((*NUMBERS, *TEXTS))
        case 2:
            return " ".join(random.choices(EXPRESSION, k=random.randrange(1, 9)))
        case 3:
            return "".join(random.choices(EXPRESSION, k=random.randrange(1, 9)))
        case _:
            words = list(random.choice(EXPRESSIONS))
            words.insert(random.randrange(len(words) + 1), random.choice(EXPRESSION))
            del words[random.randrange(len(words))]
            return "".join(words)


LINES = (
    {"move": 0},
    {"drop": True},
    {"pick": True},
    {"checkpoint": {"sigma": [0, 1], "alpha": [1, 0], "here": 0}},
    {"estimate": {"sigma": [0, 1], "alpha": [1, 0], "here": 0}},
)


def talk(random: Random) -> bytes:
    """The lines of a program that does not listen."""
    lines = [mutated(random.choice(LINES), random) for _ in range(random.randrange(1, 4))]
    return b"\n".join(lines) + random.choice((b"\n", b"\n", b"", b"\r\n"))
