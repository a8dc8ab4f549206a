"""Files that a wheel or an sdist must hold, and that it must not: ``package_contents.py DIR``."""

import re
import sys
import tarfile
import zipfile
from pathlib import Path

NEEDED = {
    "wheel": (
        "allworlds/py.typed",
        "_allworlds_pytest.py",
        "allworlds/explorers/skeletons/c/Makefile.template",
        "allworlds/explorers/allworlds.h",
        "allworlds/reports/web/style.css",
        "allworlds/schemas/check.schema.json",
        "allworlds/corpus/explorers.py",
        "allworlds/corpus/manifest.json",
    ),
    "sdist": (
        "src/allworlds/py.typed",
        "tests/project/test_readme.py",
        "docs/index.md",
        "docsite/check.py",
        "mkdocs.yml",
        "noxfile.py",
        "corpus/manifest.json",
        "examples/c/algorithm1.c",
        "examples/javascript/algorithm1.js",
        "proofs/certificates/check.py",
        "proofs/coq/Main.v",
        "papers/minimal_information/ledger.toml",
        "papers/lower_bounds/coq/Main.v",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "SECURITY.md",
        "CITATION.cff",
        "action.yml",
        ".pre-commit-hooks.yaml",
        "LICENSE",
        "README.md",
    ),
}

OWN = {"allworlds", "_allworlds_pytest.py"}
"""What the wheel installs: the package, and the door that pytest opens."""

REMAINS = re.compile(
    r"(^|/)(__pycache__|\.[a-z]+_cache|\.hypothesis|\.nox|\.venv|\.git|build|dist)(/|$)"
    r"|\.(pyc|so|o|vo|vok|vos|glob|aux|nbc|nbi|orig|rej)$"
)
"""What tools leave behind."""


def flaws(kind, names):
    """The faults in the list of files of a ``wheel`` or an ``sdist``, a line each."""
    names = list(names)
    found = [f"{name} is missing" for name in NEEDED[kind] if name not in names]
    found += [f"{name} is a remainder" for name in names if REMAINS.search(name)]
    if kind == "wheel":
        outside = {name.partition("/")[0] for name in names}
        outside = {name for name in outside - OWN if ".dist-info" not in name}
        found += [f"{name} would be installed beside the package" for name in sorted(outside)]
    return found


def contents(directory):
    """The lists of files of the one wheel and the one source distribution there."""
    (wheel,), (sdist,) = directory.glob("*.whl"), directory.glob("*.tar.gz")
    with zipfile.ZipFile(wheel) as archive:
        yield "wheel", wheel, archive.namelist()
    with tarfile.open(sdist) as archive:
        names = [member.name.partition("/")[2] for member in archive if member.isfile()]
        yield "sdist", sdist, names


if __name__ == "__main__":
    wrong = []
    for kind, file, names in contents(Path(sys.argv[1])):
        print(f"{file.name}: {len(names)} files, {file.stat().st_size / 1e6:.1f} MB")
        wrong += [f"{kind}: {flaw}" for flaw in flaws(kind, names)]
    print("\n".join(wrong) or "all that is needed is in them, and nothing that tools leave behind")
    sys.exit(bool(wrong))
