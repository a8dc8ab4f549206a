"""Prints the assumptions of every theorem of some files; exit 1 unless there are none.

Usage: check_assumptions.py FILE.v ...   (in the folder of the compiled files)
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


def assumptions(source: pathlib.Path) -> list[tuple[str, str]]:
    """Each theorem of a file with what Coq prints of its assumptions.

    Raises RuntimeError if the file is not compiled, or the answers are not as many as the theorems.
    """
    module = source.stem
    names = re.findall(r"^Theorem (\w+)", without_comments(source.read_text()), re.MULTILINE)
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
    bad = [name for name, answer in found if answer != CLOSED] + [
        f"{path}: {word}"
        for path in sorted(pathlib.Path().glob("*.v"))
        for word in FORBIDDEN.findall(without_comments(path.read_text()))
    ]
    if bad or not found:
        print("not closed:", *bad, sep="\n  ")
        return 1
    print(f"{len(found)} theorems, no assumptions")
    return 0


if __name__ == "__main__":
    sys.exit(main())
