"""The fenced blocks of a page, and what running them means."""

import re
from dataclasses import dataclass

BLOCK = re.compile(
    r"(?:^<!-- not run: (?P<reason>[^\n]*) -->\n)?"
    r"(?:^<!-- needs: (?P<needs>[^\n]*) -->\n)?"
    r"^(?P<indent> *)```(?P<language>\w+)(?: title=\"(?P<title>[^\"\n]+)\")?\n"
    r"(?P<body>.*?)^(?P=indent)```$",
    re.MULTILINE | re.DOTALL,
)


@dataclass(frozen=True)
class Block:
    """A fenced block.

    Attributes:
        language: of the block.
        title: the file that it is.
        reason: why it is not run.
        needs: the programs, and the modules of Python, without which it cannot be run.
        body: its text.
    """

    language: str
    title: str
    reason: str
    needs: tuple[str, ...]
    body: str


def blocks(text, *languages):
    """The fenced blocks of a page, in order; of these languages, where there are any."""
    found = [
        Block(
            each["language"],
            each["title"] or "",
            each["reason"] or "",
            tuple((each["needs"] or "").split()),
            each["body"],
        )
        for each in BLOCK.finditer(text)
    ]
    return [block for block in found if not languages or block.language in languages]


def commands(body):
    """A console block as (command, expected lines)."""
    told = []
    for line in body.splitlines():
        if line.startswith("$ "):
            told.append((line.removeprefix("$ "), []))
        else:
            told[-1][1].append(line)
    return told


def shows(expected, lines):
    """Whether the lines are those expected, where ``...`` stands for any number of them.

    At the end of a line it stands for any words.
    """
    pattern = "".join(
        r"(?:.*\n)*?"
        if line == "..."
        else re.escape(line.removesuffix(" ...")) + (r" .*\n" if line[-4:] == " ..." else r"\n")
        for line in expected
    )
    return re.fullmatch(pattern, "".join(line.rstrip() + "\n" for line in lines)) is not None


def write(file, code):
    """A block of a program: a new file, or what replaces a part of it, first to last line."""
    lines = code.splitlines()
    old = file.read_text().splitlines() if file.exists() else []
    if old and lines[0] in old and lines[-1] in old:
        code = "\n".join([*old[: old.index(lines[0])], *lines, *old[old.index(lines[-1]) + 1 :]])
    file.write_text(code + "\n")
