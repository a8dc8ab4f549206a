"""Prints the assumptions of every theorem of a file; exit 1 unless there are none.

Usage: check_assumptions.py Main.v   (in the folder of the compiled files)
"""

import pathlib
import re
import subprocess
import sys
import tempfile

CLOSED = "Closed under the global context"
FORBIDDEN = re.compile(r"\b(Admitted|admit|Axiom|Axioms|Parameter|Parameters|Conjecture)\b")


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


def main() -> int:
    """The exit code."""
    source = pathlib.Path(sys.argv[1])
    bad = [
        f"{path}: {word}"
        for path in sorted(source.resolve().parent.glob("*.v"))
        for word in FORBIDDEN.findall(without_comments(path.read_text()))
    ]
    names = re.findall(r"^Theorem (\w+)", without_comments(source.read_text()), re.MULTILINE)
    module = source.stem
    ask = f"From Allworlds Require {module}.\n" + "".join(
        f"Print Assumptions {module}.{name}.\n" for name in names
    )
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "assumptions.v"
        file.write_text(ask)
        command = ["coqc", "-w", "-notation-overridden", "-Q", ".", "Allworlds", str(file)]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    answers = run.stdout.strip().split("\n")
    if run.returncode or len(answers) != len(names):
        print(run.stdout + run.stderr)
        return 1
    for name, answer in zip(names, answers, strict=True):
        print(f"{name}: {answer}")
        if answer != CLOSED:
            bad.append(name)
    if bad or not names:
        print("not closed:", *bad, sep="\n  ")
        return 1
    print(f"{len(names)} theorems, no assumptions")
    return 0


if __name__ == "__main__":
    sys.exit(main())
