"""Pin the statements of the headline theorems, and the definitions that they rest on, by digests.

    python statements.py             compare with statements.json; exit 1 if anything differs
    python statements.py --write     write statements.json anew: on purpose, the changes once read
    python statements.py --list      each headline theorem with its digest
    python statements.py --rests-on NAME    the definitions that one theorem rests on
    python statements.py --ask-coq   compare with the dependencies that Coq prints (compiled files)

``Statements.v`` has each statement once more, and Coq checks that the theorem of this name proves
it.  Here its text is compared with that of ``Main.v`` and ``Further.v``, and followed: a
definition is reached if its name stands in the statement, or in a definition that is reached.
Wherever a name is defined twice, both are reached, so that no second definition of an old name
can take the place of the first unseen.  Of a theorem that a definition uses its statement is
followed, not its proof.  Coq says, with ``--ask-coq``, that no definition has been overlooked, and
that whatever is hidden (``Qed``) is a proof.

The digest of a theorem is that of its statement with all that it rests on.  Comments and space
are left out.  Definitions of MathComp are pinned by its version.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from check_assumptions import sentences

HERE = Path(__file__).resolve().parent
HEADLINES = ("Main.v", "Further.v")
STATEMENTS, PINNED = "Statements.v", "statements.json"

WORD = re.compile(r"[A-Za-z_][\w']*")
PREFIX = re.compile(r"^((Local|Global|Program|Polymorphic|#\[[^]]*\])\s+)+")
LOCAL = re.compile(r"Local\b|#\[local\b")
PROVED = ("Lemma", "Theorem", "Corollary", "Fact", "Remark", "Proposition", "Goal")
DEFINED = (
    *("Definition", "Fixpoint", "CoFixpoint", "Function", "Example", "Let"),
    *("Inductive", "CoInductive", "Variant", "Record", "Structure", "Class"),
)
TYPES = DEFINED[-6:]
# in a section they belong to each definition that follows
CONTEXT = ("Variable", "Variables", "Hypothesis", "Hypotheses", "Context", "Let", "Implicit")
# used without being named
UNNAMED = (
    *("Notation", "Infix", "Canonical", "Coercion", "Existing", "Open", "Close", "Bind", "Delimit"),
    *("Reserved", "Instance", "Identity", "Module", "Import", "Export", "Include", "Undelimit"),
)


@dataclass(frozen=True)
class Item:
    """A definition as its file has it.

    Attributes:
        file: where it stands.
        names: the names that it introduces, if any.
        text: its sentence, after those of the sections that it stands in, on one line.
        unnamed: whether it can be used without being named, as a notation.
    """

    file: str
    names: tuple[str, ...]
    text: str
    unnamed: bool = False

    @property
    def title(self) -> str:
        """Its file and its first name, or the beginning of its text."""
        return f"{self.file} {self.names[0] if self.names else self.text[:60]}"


def digest(texts: Iterable[str]) -> str:
    """The first 16 hexadecimal digits of the SHA-256 digest of some texts."""
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:16]


def line(text: str) -> str:
    """The text with single spaces."""
    return " ".join(text.split())


def top_level(text: str, mark: str) -> int:
    """Where the mark stands outside of all brackets for the first time, or -1."""
    depth = 0
    for at, character in enumerate(text):
        depth += (character in "([{") - (character in ")]}")
        if depth == 0 and text.startswith(mark, at):
            return at
    return -1


# ---- Reading ----


def names_of(kind: str, sentence: str) -> tuple[str, ...]:
    """The names that a definition introduces: its own, those of constructors and of fields."""
    head, _, body = sentence.partition(":=")
    found = WORD.findall(head.partition(kind)[2])[:1]
    found += re.findall(r"\bwith\s+([A-Za-z_][\w']*)", sentence) if kind != "Let" else []
    if kind in TYPES:
        found += re.findall(r"(?:^|\|)\s*([A-Za-z_][\w']*)", body)
        found += re.findall(r"[{;]\s*([A-Za-z_][\w']*)\s*:", body)
        found += re.findall(r"^\s*([A-Za-z_][\w']*)\s*\{", body)
    return tuple(dict.fromkeys(found))


def items_of(file: str, text: str) -> Iterator[Item]:
    """The definitions of a file, and what stands in it that is used without being named.

    A theorem that a definition uses is read like one, but without its proof, unless that ends with
    Defined; the script of a definition belongs to it.
    """
    sections: list[list[str]] = [[]]
    pending: list[str] = []
    kind = ""
    for sentence in sentences(text):
        if pending:
            pending.append(sentence)
            if sentence in ("Qed", "Defined", "Abort", "Admitted"):
                hidden = kind in PROVED and sentence == "Qed"
                whole = pending[0] if hidden else ". ".join(pending)
                if kind in CONTEXT:
                    sections[-1].append(line(whole))
                yield from _item(file, kind, line(whole), sections)
                pending = []
            continue
        plain = PREFIX.sub("", sentence)
        kind = plain.split()[0]
        if kind == "Section":
            sections.append([])
        elif kind == "End":
            sections.pop()
        elif kind in PROVED or (
            kind in DEFINED and kind not in TYPES and top_level(plain, ":=") < 0
        ):
            pending = [plain]
        else:
            local = kind in UNNAMED and (LOCAL.match(sentence) or len(sections) > 1)
            if local or kind in CONTEXT:
                sections[-1].append(line(plain))
            if not local:
                yield from _item(file, kind, line(plain), sections)
    if len(sections) != 1 or pending:
        raise ValueError(f"{file}: a section or a proof does not end")


def _item(file: str, kind: str, text: str, sections: list[list[str]]) -> Iterator[Item]:
    around = [sentence for section in sections for sentence in section if sentence != text]
    if kind in (*DEFINED, *PROVED):
        yield Item(file, names_of(kind, text), line(". ".join([*around, text])))
    if kind == "Arguments":
        yield Item(file, (text.split()[1],), text)
    if kind in UNNAMED:
        names = tuple(WORD.findall(text)[1:2]) if kind == "Canonical" else ()
        yield Item(file, names, text, unnamed=True)


def statements_of(text: str) -> dict[str, str]:
    """For each theorem of a file what it says, its binders in front."""
    found = {}
    for sentence in sentences(text):
        if match := re.match(r"Theorem ([\w']+)", sentence):
            rest = sentence[match.end() :]
            colon = top_level(rest, ":")
            binders, says = line(rest[:colon]), line(rest[colon + 1 :])
            found[match[1]] = f"forall {binders}, {says}" if binders else says
    return found


def checked(text: str) -> list[tuple[str, str]]:
    """For each ``Check`` of a file the name and the statement."""
    found = []
    for sentence in sentences(text):
        if sentence.startswith("Check"):
            match = re.fullmatch(r"Check \(@([\w']+) :(.*)\)", sentence, re.DOTALL)
            if match is None:
                raise ValueError(f"not of the form Check (@name : statement): {sentence}")
            found.append((match[1], line(match[2])))
    return found


# ---- Following ----


@dataclass(frozen=True)
class Development:
    """The texts of all files but those of the headline theorems, read.

    Attributes:
        statements: of each headline theorem, from ``Statements.v``.
        items: the definitions by name.
        unnamed: those that can be used without being named.
    """

    statements: dict[str, str]
    items: dict[str, list[Item]]
    unnamed: list[Item]

    def rests_on(self, name: str) -> list[Item]:
        """The definitions that a headline theorem rests on, by file and name."""
        reached: dict[Item, None] = dict.fromkeys(self.unnamed)
        seen: set[str] = set()
        todo = [self.statements[name], *(item.text for item in self.unnamed)]
        while todo:
            for word in set(WORD.findall(todo.pop())) - seen:
                seen.add(word)
                for item in self.items.get(word, []):
                    if item not in reached:
                        reached[item] = None
                        todo.append(item.text)
        return sorted(reached, key=lambda item: (item.file, item.names, item.text))

    def pinned(self) -> dict[str, dict[str, str]]:
        """The digests, as ``statements.json`` has them."""
        theorems, definitions = {}, {}
        for name, says in self.statements.items():
            items = self.rests_on(name)
            theorems[name] = digest([says, *(item.text for item in items)])
            grouped: dict[str, list[str]] = {}
            for item in items:
                grouped.setdefault(item.title, []).append(item.text)
            definitions.update({title: digest(texts) for title, texts in grouped.items()})
        return {
            "theorems": theorems,
            "statements": {name: digest([says]) for name, says in self.statements.items()},
            "definitions": dict(sorted(definitions.items())),
        }


def read(folder: Path) -> tuple[Development, list[str]]:
    """The development, and how the texts of its headline theorems differ from what is checked."""
    texts = {path.name: path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.v"))}
    proved = {name: says for file in HEADLINES for name, says in statements_of(texts[file]).items()}
    listed = checked(texts[STATEMENTS])
    statements = dict(listed)
    amiss = [f"{name}: stated twice in {STATEMENTS}" for name, _ in listed if _twice(name, listed)]
    for name in sorted({*proved, *statements}):
        if name not in statements:
            amiss.append(f"{name}: {STATEMENTS} does not say what it states")
        elif name not in proved:
            amiss.append(f"{name}: no headline theorem has this name")
        elif proved[name] != statements[name]:
            amiss.append(f"{name}: states something else than {STATEMENTS} says")
    items: dict[str, list[Item]] = {}
    unnamed = []
    for file, text in texts.items():
        for item in items_of(file, text):
            for name in item.names:
                items.setdefault(name, []).append(item)
            if item.unnamed:
                unnamed.append(item)
    return Development(statements, items, unnamed), amiss


def _twice(name: str, listed: list[tuple[str, str]]) -> bool:
    return sum(other == name for other, _ in listed) > 1


def differences(
    pinned: Mapping[str, Mapping[str, str]], found: Mapping[str, Mapping[str, str]]
) -> list[str]:
    """Return how the digests differ, in words: statements, definitions, and what rests on them."""
    said = []
    for part, word in (("statements", "the statement of"), ("definitions", "the definition")):
        old, new = pinned.get(part, {}), found[part]
        for name in sorted({*old, *new}):
            if old.get(name) != new.get(name):
                how = "is new" if name not in old else "is gone" if name not in new else "differs"
                said.append(f"{word} {name} {how}")
    old, new = pinned.get("theorems", {}), found["theorems"]
    changed = [name for name in new if old.get(name) != new[name]]
    if changed:
        said.append(f"theorems that say something else now: {', '.join(changed)}")
    elif old != new:
        said.append("theorems are gone")
    return said


# ---- Coq's own list ----


def coq(folder: Path, name: str, script: str) -> str:
    """Return the output of Coq for a script, compiled in a folder of its own.

    Raises:
        RuntimeError: if it refuses the script.
    """
    file = folder / f"{name}.v"
    file.write_text(script, encoding="utf-8")
    where = ["-Q", str(HERE), "Allworlds", "-Q", str(folder), "Asked"]
    command = ["coqc", "-w", "none", *where, str(file)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        raise RuntimeError(run.stderr)
    return run.stdout


def closed_by_coq(
    folder: Path, own: Sequence[str], theorems: Iterable[str]
) -> dict[tuple[str, str], str]:
    """Return what the statements rest on, as Coq prints it: file and name, and the sort if hidden.

    A constant leads to those in its type and in its body, all arguments shown; one that is hidden
    (``Qed``) to those in its type.  ``Says.v`` in the folder has the statements.
    """
    # Where no file is imported, Coq names each constant with its file.
    head = "From Allworlds Require Statements.\nFrom Asked Require Says.\nSet Printing All.\n"
    word = re.compile(rf"\b(?:Allworlds\.)?({'|'.join(own)})\.([A-Za-z_][\w']*)")
    told = coq(folder, "Opaque", f"{head}Print Opaque Dependencies Says.all_of_it.\n")
    hidden = set(word.findall("\n".join(re.findall(r"^[\w'.]+", told, re.MULTILINE))))
    found: dict[tuple[str, str], str] = {}
    says = "\n".join(f"Print Says.says_{name}." for name in theorems)
    new = set(word.findall(coq(folder, "All", head + says)))
    while new:
        asked = []
        for file, name in sorted(new):
            full = f"Allworlds.{file}.{name}"
            asked.append(f"Check @{full}." if (file, name) in hidden else f"Print {full}.")
        told = coq(folder, f"Asked{len(found)}", head + "\n".join(asked))
        found.update(dict.fromkeys(new, ""))
        new = set(word.findall(told)) - set(found)
    lemmas = sorted(hidden & set(found))
    asked = [
        f"Check ltac:(let t := type of @Allworlds.{file}.{name} in let s := type of t in exact s)."
        for file, name in lemmas
    ]
    told = coq(folder, "Sorts", head + "\n".join(asked))
    sorts = re.findall(r"^(\w+)\n?\s+:", told, re.MULTILINE)
    found.update(zip(lemmas, sorts, strict=True))
    return found


def asked_of_coq(development: Development) -> list[str]:
    """Return what Coq finds and the texts do not show: overlooked definitions, hidden data."""
    own = [path.stem for path in sorted(HERE.glob("*.v"))]
    says = [
        re.sub(r"(?s)^Check \(@([\w']+) :(.*)\)$", r"Definition says_\1 :=\2", sentence) + "."
        for sentence in sentences((HERE / STATEMENTS).read_text(encoding="utf-8"))
    ]
    every = " * ".join(f"says_{name}" for name in development.statements)
    says.append(f"Definition all_of_it := ({every})%type.")
    with tempfile.TemporaryDirectory() as name:
        coq(Path(name), "Says", "\n".join(says))
        rests_on = closed_by_coq(Path(name), own, development.statements)
    reached = {
        (item.file, name)
        for theorem in development.statements
        for item in development.rests_on(theorem)
        for name in item.names
    }
    made = ("_rect", "_ind", "_rec", "_sind")  # by Coq, with a type
    amiss = []
    for (file, name), sort in rests_on.items():
        if (f"{file}.v", name) not in reached and not name.endswith(made):
            amiss.append(f"Coq: the statements rest on {file}.v {name}, which was not found")
        if sort not in ("", "Prop") and not _says_reflect(file, name):
            amiss.append(f"Coq: the statements rest on {file}.v {name}, hidden and no proof")
    lemmas = sum(sort != "" for sort in rests_on.values())
    print(f"Coq: the statements rest on {len(rests_on)} names, {lemmas} of them hidden")
    if len(rests_on) < len(development.statements):
        amiss.append("Coq: that is too few")
    return amiss


def _says_reflect(file: str, name: str) -> bool:
    """Return whether a lemma decides a proposition: that fixes its value, like a proof's."""
    for sentence in sentences((HERE / f"{file}.v").read_text(encoding="utf-8")):
        if match := re.match(rf"(?:Lemma|Theorem) {re.escape(name)}\b", sentence):
            colon = top_level(sentence[match.end() :], ":")
            return sentence[match.end() + colon + 1 :].split("->")[-1].split()[0] == "reflect"
    return False


def main() -> int:
    """The exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--ask-coq", action="store_true")
    parser.add_argument("--rests-on", metavar="NAME")
    options = parser.parse_args()
    development, amiss = read(HERE)
    if options.rests_on is not None:
        if options.rests_on not in development.statements:
            parser.error(f"no headline theorem is called {options.rests_on}")
        print(*(item.title for item in development.rests_on(options.rests_on)), sep="\n")
        return 0
    found = development.pinned()
    target = HERE / PINNED
    if options.write:
        target.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    pinned: Any = json.loads(target.read_text(encoding="utf-8"))
    amiss += differences(pinned, found)
    if options.ask_coq:
        amiss += asked_of_coq(development)
    if amiss:
        print("statements that are not as pinned:", *amiss, sep="\n  ")
        return 1
    if options.list:
        for name, value in found["theorems"].items():
            print(f"{name} {value}")
        return 0
    counts = len(found["theorems"]), len(found["definitions"])
    print(f"{counts[0]} statements as pinned, on {counts[1]} definitions")
    return 0


if __name__ == "__main__":
    sys.exit(main())
