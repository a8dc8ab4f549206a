"""Prints the assumptions of every theorem of some files; exit 1 unless there are none.

Usage: check_assumptions.py FILE.v ...   (in the folder of the compiled files)

_CoqProject says under which name the folder, and others that it needs, are known to Coq.
Statements.v must state each of these theorems: Coq has checked that it is what the theorem says.
Every file of the folder is read besides for words that assume something or switch a check off.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

CLOSED = "Closed under the global context"

# each of them assumes something, or gives a statement up
ASSUMES = re.compile(
    r"\b(Admitted|admit|Axioms?|Parameters?|Conjectures?|Declare|Abort|Primitive|bypass_check"
    r"|type_in_type|Admit\s+Obligations|Classical\w*|Choice\w*Facts|FunctionalExtensionality)\b"
)
# outside a section these are axioms
LOCAL = re.compile(r"(Variables?|Hypothes[ie]s|Context|Let)\b")
# what may be switched off or on
HARMLESS = re.compile(
    r"Set Implicit Arguments|Unset Strict Implicit|Unset Printing Implicit Defensive"
    r"|Set Warnings\s.*"
)
# what may stand in a file of headline theorems
HEADLINE = re.compile(
    r"(From|Set|Unset|Theorem|Proof|Qed|by|exact|have|move|split|do|case|apply)\b"
)


def without_comments(text: str) -> str:
    """The text of a Coq file without its comments, nested ones included."""
    out, depth = [], 0
    for piece in re.split(r"(\(\*|\*\))", text):
        if piece == "(*":
            depth += 1
        elif piece == "*)":
            depth -= 1
        elif depth == 0:
            out.append(piece)
    return "".join(out)


def sentences(text: str) -> list[str]:
    """The sentences of a Coq file, each up to its full stop, without comments."""
    return [s.strip() for s in re.split(r"\.(?=\s|$)", without_comments(text)) if s.strip()]


def suspect(text: str) -> list[str]:
    """The words of a Coq file that assume something or switch a check off."""
    found = ASSUMES.findall(without_comments(text))
    depth = 0
    for sentence in sentences(text):
        command = re.sub(r"^(Local|Global|Polymorphic|#\[[^]]*\])\s+", "", sentence)
        if re.match(r"Section\b", command):
            depth += 1
        elif re.match(r"End\b", command):
            depth -= 1
        elif depth == 0 and LOCAL.match(command):
            found.append(f"outside a section: {command.splitlines()[0]}")
        elif re.match(r"(Set|Unset)\b", command) and not HARMLESS.fullmatch(command):
            found.append(command)
    return found


def not_a_theorem(text: str) -> list[str]:
    """The sentences of a file of headline theorems that state something by another word."""
    return [s.splitlines()[0] for s in sentences(text) if not HEADLINE.match(s)]


def stated(text: str) -> list[str]:
    """The names of the theorems whose statements a file has, as ``Check (@name : statement)``."""
    found = (re.match(r"Check \(@([\w']+) :", sentence) for sentence in sentences(text))
    return [match[1] for match in found if match]


def libraries() -> dict[str, str]:
    """The name in Coq of each folder in _CoqProject; ``.`` is the folder itself."""
    lines = pathlib.Path("_CoqProject").read_text()
    return dict(re.findall(r"^-Q (\S+) (\S+)$", lines, re.MULTILINE))


def assumptions(source: pathlib.Path) -> list[tuple[str, str]]:
    """Each theorem of a file with what Coq prints of its assumptions.

    Raises RuntimeError if the file is not compiled, or the answers are not as many as the theorems.
    """
    module = source.stem
    names = re.findall(r"^\s*Theorem (\w+)", without_comments(source.read_text()), re.MULTILINE)
    ask = f"From {libraries()['.']} Require {module}.\n" + "".join(
        f"Print Assumptions {module}.{name}.\n" for name in names
    )
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "assumptions.v"
        file.write_text(ask)
        folders = [word for pair in libraries().items() for word in ("-Q", *pair)]
        command = ["coqc", "-w", "-notation-overridden", *folders, str(file)]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    answers = run.stdout.strip().split("\n")
    if run.returncode or len(answers) != len(names):
        raise RuntimeError(f"{source}: {run.stdout}{run.stderr}")
    return list(zip(names, answers, strict=True))


def main() -> int:
    """The exit code."""
    sources = [pathlib.Path(name) for name in sys.argv[1:]]
    try:
        found = [pair for source in sources for pair in assumptions(source)]
    except RuntimeError as error:
        print(error)
        return 1
    for name, answer in found:
        print(f"{name}: {answer}")
    bad = [name for name, answer in found if answer != CLOSED]
    statements = stated(pathlib.Path("Statements.v").read_text())
    bad += [f"{name}: not stated in Statements.v" for name, _ in found if name not in statements]
    for path in sorted(pathlib.Path().glob("*.v")):
        bad += [f"{path}: {word}" for word in suspect(path.read_text())]
    for path in sources:
        bad += [f"{path}: {line}" for line in not_a_theorem(path.read_text())]
    if bad or not found:
        print("not closed:", *bad, sep="\n  ")
        return 1
    print(f"{len(found)} theorems, no assumptions")
    return 0


if __name__ == "__main__":
    sys.exit(main())
