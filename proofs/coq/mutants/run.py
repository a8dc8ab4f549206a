"""Every mutant of a definition or statement must make the development fail to compile.

Usage: run.py [--workers N] [NAME ...]   (in the folder of the compiled, unchanged files)

``mutants/mutants.json`` lists them: a file, a text that stands in it exactly once, the text put in
its place, what that breaks, and what dies of it: ``truth`` (some theorem is then false), ``script``
(the statements stay true, only a proof script no longer fits) or ``statement`` (all is true, but a
theorem no longer says what ``Statements.v`` says, or that says what is not proved).  ``dies_in``,
if it is there, names the file that no longer compiles: what is not needed for it is compiled only
if it does.  Nothing else rests on that name.
Exit 1 if a mutant compiles, does not apply, or runs out of time; exit 2 if there is none of a name.
"""

import argparse
import concurrent.futures
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

LIMITED = pathlib.Path(__file__).resolve().parents[1] / "limit"
ROOT = pathlib.Path()
LIMIT = 120  # seconds of CPU for each file


def sources() -> list[str]:
    """The files of _CoqProject in their order, without the extraction."""
    names = [n for n in (ROOT / "_CoqProject").read_text().split() if n.endswith(".v")]
    return [n for n in names if n != "Extraction.v"]


def libraries() -> dict[str, str]:
    """The name in Coq of each folder in _CoqProject; ``.`` is the folder itself."""
    lines = (ROOT / "_CoqProject").read_text()
    return dict(re.findall(r"^-Q (\S+) (\S+)$", lines, re.MULTILINE))


def imports(name: str) -> set[str]:
    """The files of the folder that ``name`` requires directly."""
    text = (ROOT / name).read_text()
    found = re.findall(rf"From {libraries()['.']} Require(?: Import)? ([\w\s]+)\.", text)
    return {f"{module}.v" for line in found for module in line.split()}


def affected(name: str) -> list[str]:
    """``name`` and the files that depend on it, in order."""
    reached = [name]
    for other in sources():
        if other != name and imports(other) & set(reached):
            reached.append(other)
    return reached


def needed(name: str) -> set[str]:
    """``name`` and the files that it depends on."""
    reached = {name}
    for other in reversed(sources()):
        if other in reached:
            reached |= imports(other)
    return reached


def in_order(mutant: dict[str, str]) -> list[str]:
    """The files to compile: first those that the one where it should die needs."""
    todo = affected(mutant["file"])
    first = needed(mutant.get("dies_in", mutant["file"]))
    return sorted(todo, key=lambda name: name not in first)


def outcome(mutant: dict[str, str]) -> tuple[bool, str]:
    """Whether the mutant dies, and where."""
    text = (ROOT / mutant["file"]).read_text()
    if text.count(mutant["old"]) != 1:
        return False, f"does not apply: its text stands {text.count(mutant['old'])} times"
    todo = in_order(mutant)
    folders = []
    for at, of in libraries().items():
        folders += ["-Q", at if at == "." else str((ROOT / at).resolve()), of]
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        for name in sources():
            shutil.copy(ROOT / name, place)
            if name not in todo:
                shutil.copy((ROOT / name).with_suffix(".vo"), place)
        (place / mutant["file"]).write_text(text.replace(mutant["old"], mutant["new"]))
        for name in todo:
            command = [str(LIMITED), str(LIMIT), "coqc", "-w", "none", *folders, name]
            run = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False)
            if run.returncode and "Error:" not in run.stderr:
                return False, f"no verdict on {name}: {run.stderr.strip()[-200:]}"
            if run.returncode:
                line = re.search(r"line (\d+)", run.stderr)
                return True, f"{name}:{line.group(1) if line else '?'}"
    return False, "compiles"


def main() -> int:
    """The exit code."""
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*")
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()
    mutants = json.loads((ROOT / "mutants" / "mutants.json").read_text())
    if unknown := set(options.names) - {m["name"] for m in mutants}:
        parser.error(f"no mutant has the name {', '.join(sorted(unknown))}")
    chosen = [m for m in mutants if not options.names or m["name"] in options.names]
    began = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        alive = 0
        for mutant, (dead, where) in zip(chosen, pool.map(outcome, chosen), strict=True):
            state = "dies" if dead else "SURVIVES"
            line = f"{state:8} {mutant['kind']:6} {mutant['name']}: {where}; {mutant['breaks']}"
            print(line, flush=True)
            alive += not dead
    truths = sum(m["kind"] == "truth" for m in chosen)
    print(
        f"{len(chosen)} mutants ({truths} of the truth), {alive} survive, "
        f"{time.monotonic() - began:.0f} s"
    )
    return 1 if alive or not chosen else 0


if __name__ == "__main__":
    sys.exit(main())
