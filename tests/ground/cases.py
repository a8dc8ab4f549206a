"""Cases: which verb is given which input."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from random import Random

from allworlds.cli.app import command_line
from ground import grammar
from ground.law import Case
from recorded.record import HERE, LEAST, PLANTRI

COSTLY = ("worst",)
"""Verbs that are tried with values alone that they refuse: what is legal takes seconds."""

REFUSED = ("", "x", "-1", "1.5", "1_0", "nan", "9" * 5000, "9" * 3000, "\x1b[31m", grammar.LONG)

WORDS = {
    "COMMAND": ("", "'", "/", "missing", "./missing", "tests", grammar.LONG, "a\x00b", "'" * 999),
    "CLASS": ("maps", "simple", "planar", "planar-simple", "planr"),
    "KIND": [
        "none",
        "position",
        "directional",
        "compass",
        "cluster",
        "natural",
        "cluster:single=true",
        "cluster:single=false",
        "cluster:single=no",
        "cluster:x=1",
        "cluster:",
        "cluster:single",
        "position:x=1",
        "cluster:single=true,single=true",
        "lamp",
    ],
    "K/N": ("0/1", "0/2", "1/2", "2/2", "0/0", "-1/2", "0/999999999", "0/9999999999", "1_0/20"),
    "one|all": ("one", "all", "ALL", "two"),
    "POLICY": ("fifo", "lifo", "nearest", "random:0", "random:-1", "random:" + "9" * 5000, "r"),
    "LAWS": ("map", "map,pose", "map,map", "mpa", "variant", ",", "map,", "timeout", "bound"),
    "auto|python|kernel": ("auto", "python", "pyhton"),
    # More of them would be more threads of this process.
    "N|auto": ("auto", "1", "2", "0", "-1", "10001", "9" * 5000),
    "I,I,...": ("0", "0,0", "1", "9" * 10, "-1", "0,", ",0", ",".join("0" * 3000)),
    "F": (
        "lattice:2x2",
        "dense:4",
        "cycle:3",
        "random:3",
        "lattice:0x0",
        "dense:0",
        "cycle:-1",
        "random:0",
        "lattice:2x",
        "dense:" + "9" * 5000,
        "tree:3",
        "lattice:99999x99999",
    ),
    "P%": ("10%", "0.1", "100%", "-1%", "1e-3", "99.9999%", "0%%", "9" * 5000 + "%"),
    "shortest|simple": ("longest", "SIMPLE"),
    "K,K,...": ("0", "1,-1", "1000", "--1", ",".join("1" * 2000)),
    "P,P,...": ("3A", "4P", "3AP", "0A", "3PP", "A", "9" * 5000 + "A"),
    "E": ("algorithm1", "algorthm1", "a.py:", ":a", "json:loads", "missing:x", "missing.py:x"),
    "DIR": ("corpus", "missing/deep", "file/below", "a\x00b", "/dev/null", "/dev/null/x"),
    "FILE": ("report", "missing/report", ".", "/", "a\x00b", "x" * 300, "/dev/null/x"),
    "PATH": ("/", ".", "missing", "/dev/null", "true", "a\x00b", grammar.LONG),
    "NAME[@M]=COMMAND": ("", "a", "=", "a=", "a@=b", "a@x=b", "=b"),
    "S": ("0", "-1", "nan", "inf", "1e9999", "5", "1_0", "1e7", "1e10", "x", "-1e-9"),
}
"""Hostile and legal values by what the help calls them."""


@cache
def options() -> dict[str, list[tuple[str, str]]]:
    """For each verb its options that take a value, with what the help calls it."""
    found = {}
    for name, command in command_line().commands.items():
        below = getattr(command, "commands", None)
        verbs = (
            {f"{name} {sub}": under for sub, under in below.items()} if below else {name: command}
        )
        for verb, under in verbs.items():
            found[verb] = [
                (param.opts[0], param.metavar)
                for param in under.params
                if param.param_type_name == "option" and not param.is_flag
            ]
    return found


def _options(random: Random) -> Case:
    verb = random.choice(list(LEAST))
    if verb in ("ambiguity search", *COSTLY) and random.random() < 0.5:
        verb = "check"
    words = [*verb.split(), *_json(random), *_least(verb)]
    known = options()[verb] or [("--edges", "M")]
    for option, metavar in random.choices(known, k=random.choice((1, 1, 2, 3))):
        value = random.choice(REFUSED) if verb in COSTLY else _value(metavar, random)
        words += [f"{option}={value}"] if random.random() < 0.2 else [option, value]
    if verb not in COSTLY and random.random() < 0.2:
        words.insert(random.randrange(len(words) + 1), random.choice(grammar.TEXTS))
    if verb not in COSTLY and random.random() < 0.1:
        words.pop()
    if random.random() < 0.1:
        words.append(random.choice(("--egdes", "--" + grammar.LONG, "-x", "--info", "--help", "-")))
    return Case("options", tuple(words), {"f.json": _bytes(_finding(random))})


def _least(verb: str) -> list[str]:
    return (
        LEAST[verb]
        .replace("{findings}/lucky-guess.json", "f.json")
        .format(tmp=".", run="run", paper=".", plantri=PLANTRI, recorded=HERE)
        .split()
    )


def _value(metavar: str, random: Random) -> str:
    if random.random() < 0.2:
        return random.choice(grammar.TEXTS)
    if metavar == "BOUND":
        return grammar.expression(random)
    return random.choice(WORDS.get(metavar, grammar.NUMBERS))


def _json(random: Random) -> tuple[str, ...]:
    return random.choice(((), ("--json",), ("--json",), ("-q",)))


def _finding(random: Random) -> dict:
    return random.choice(grammar.findings())


def _bytes(document: object) -> bytes:
    return json.dumps(document).encode()


def _worlds(random: Random) -> Case:
    world = random.choice(grammar.worlds())
    texts = [grammar.mutated(random.choice((world, world, grammar.world_named(random))), random)]
    texts.append(_bytes(world))
    random.shuffle(texts)
    files: dict[str, bytes] = {}
    given = []
    for i, text in enumerate(texts):
        if random.random() < 0.5 or b"\x00" in text:
            files[f"{i}.json"] = text
            given.append(f"@{i}.json")
        else:
            given.append(text.decode(errors="surrogateescape"))
    explorer = random.choice(("algorithm1", "algorithm1-cluster", "algorithm1-natural"))
    match random.randrange(6):
        case 0 | 1:
            words = ["ambiguity", "twins", *given]
        case 2:
            words = ["ambiguity", "class", given[0]]
        case 3:
            return Case("worlds", ("run", "@-", *_json(random)), stdin=texts[0])
        case _:
            words = ["run", explorer, given[0]]
    return Case("worlds", (*words, *_json(random)), files)


def _findings(random: Random) -> Case:
    document: object = _finding(random)
    if random.random() < 0.2:
        document = {"schema": 2, "verdict": "refuted", "findings": [document]}
    content = grammar.mutated(document, random)
    words = random.choice((("explain",), ("explain",), ("replay",)))
    if words == ("replay",) and random.random() < 0.7:
        words = ("replay", "--explorer", "algorithm1")
    if random.random() < 0.2:
        return Case("findings", (*words, "-", *_json(random)), stdin=content)
    return Case("findings", (*words, "f.json", *_json(random)), {"f.json": content})


def _corpus(random: Random) -> Case:
    names = ("map-m1n1-0123456789ab.json", "b.json", "c.json", "\x1b[31m.json", "x" * 200 + ".json")
    files = {
        f"corpus/{name}": grammar.mutated(_finding(random), random)
        for name in random.sample(names, random.choice((1, 1, 2)))
    }
    return Case("corpus", ("check", "--edges", "1", "--corpus", "corpus", *_json(random)), files)


def _expressions(random: Random) -> Case:
    verb = random.choice((("check", "--edges", "1"), ("run", "theta")))
    return Case("expressions", (*verb, "--bound", grammar.expression(random), *_json(random)))


SPEAKER = b"""read first
printf '\\033[31mred\\007\\n' >&2
cat "$1"
"""
"""A program that says its lines, whatever it is told, and would like to colour the terminal."""


def _lines(random: Random) -> Case:
    files = {"speak.sh": SPEAKER, "lines": grammar.talk(random)}
    return Case("lines", ("run", "--exec", "sh speak.sh lines", "edge", *_json(random)), files)


KINDS: dict[str, tuple[int, Callable[[Random], Case]]] = {
    "worlds": (28, _worlds),
    "findings": (20, _findings),
    "options": (24, _options),
    "expressions": (10, _expressions),
    "corpus": (6, _corpus),
    "lines": (2, _lines),
}
"""Every kind of input, with its share in ninety."""


def cases(seed: int, numbers: Iterable[int]) -> Iterator[tuple[str, Case]]:
    """The cases of these numbers, each with a name from which it can be drawn again."""
    shares = [share for share, _ in KINDS.values()]
    for number in numbers:
        name = f"{seed}/{number}"
        random = Random(name)
        [(_, draw)] = random.choices(list(KINDS.values()), shares)
        yield name, draw(random)
