"""Everything that is done to this project, by name: ``nox -l`` lists it."""

import time
from pathlib import Path

import nox

nox.options.sessions = ["lint", "types", "test"]


@nox.session
def fmt(session: nox.Session) -> None:
    """Format the code and mend what can be mended."""
    session.install("ruff>=0.6")
    session.run("ruff", "check", "--fix", ".")
    session.run("ruff", "format", ".")


@nox.session
def lint(session: nox.Session) -> None:
    """Read the code for mistakes."""
    session.install("ruff>=0.6")
    session.run("ruff", "check", ".")
    session.run("ruff", "format", "--check", ".")


@nox.session
def types(session: nox.Session) -> None:
    """Check the types, strictly."""
    session.install(".[dev]")
    session.run("mypy")


@nox.session
def test(session: nox.Session) -> None:
    """Build and install the package, and test what is installed; measure lines and branches."""
    session.install(".[test]")
    session.run("pytest", "-n", "auto", *session.posargs, env={"COVERED": "1"})


@nox.session
def docs(session: nox.Session) -> None:
    """Build the site of the documents, strictly, into build/site."""
    session.install(".[docs]")
    session.run("mkdocs", "build", "--strict", env={"NO_MKDOCS_2_WARNING": "1"})
    session.run("python", "docsite/check.py", "build/site")


@nox.session
def package(session: nox.Session) -> None:
    """Build wheel and source distribution into dist, and look into them."""
    session.install("build>=1.2", "twine>=5")
    session.run("python", "-c", "import shutil; shutil.rmtree('dist', ignore_errors=True)")
    session.run("python", "-m", "build")
    session.run("twine", "check", "--strict", "dist/*")
    session.run("python", "tests/package_contents.py", "dist")


PYTHONS = ["3.11", "3.12", "3.13"]


@nox.session(python=PYTHONS)
def wheel(session: nox.Session) -> None:
    """Install the wheel in dist alone, with every version of Python that is there, and check."""
    (built,) = Path("dist").resolve().glob("*.whl")
    session.install(str(built))
    session.chdir(session.create_tmp())
    session.run("allworlds", "check", "--edges", "3")


@nox.session(python=PYTHONS)
def pythons(session: nox.Session) -> None:
    """Test the package with every version of Python that is there."""
    session.install(".[test]")
    session.run("pytest", "-n", "auto", *session.posargs)


@nox.session
def exhaustive(session: nox.Session) -> None:
    """Do the main job, further than the tests go."""
    session.install(".")
    session.run("allworlds", "check", "--edges", "6")
    session.run("allworlds", "check", "--edges", "3", "--schedules", "all")


@nox.session
def shards(session: nox.Session) -> None:
    """Do all worlds with up to 9 edges in eight shards, and compare with the whole check."""
    session.install(".")
    directory = session.create_tmp()
    session.run("python", "benchmarks/shards.py", "--in", directory, *session.posargs)


@nox.session
def bench(session: nox.Session) -> None:
    """Measure; peers are given as --peer 'NAME=COMMAND'."""
    session.install(".")
    session.run("python", "benchmarks/python_engine.py", *session.posargs)


@nox.session
def mutants(session: nox.Session) -> None:
    """Change the source at random, and count the changes that the quick tests notice."""
    session.install(".[test]")
    session.run("python", "benchmarks/mutants.py", *session.posargs)


@nox.session
def matrix(session: nox.Session) -> None:
    """Try known mistakes, and show which check catches each."""
    session.install(".")
    session.run("python", "tests/support/mutants/matrix.py", *session.posargs)


@nox.session
def papers(session: nox.Session) -> None:
    """Check each paper's ledger to its full extent, with Coq, and test it."""
    session.install(".[test]")
    for paper in ("papers/minimal_information", "papers/lower_bounds", "papers/mobile_robots"):
        session.run("allworlds", "ledger", paper, "--budget", "full")
        session.run("pytest", "-n", "auto", "-m", "", f"{paper}/tests")


@nox.session
def proofs(session: nox.Session) -> None:
    """Check every certificate and the Coq development, with times."""
    session.install(".[fast,proofs]")
    certificate, played = f"{session.create_tmp()}/algorithm1.v", ("--against", "algorithm1")
    steps = (
        ("python", "proofs/certificates/check.py"),
        ("make", "-j2", "-C", "proofs/coq", "theorems", "assumptions"),
        ("make", "-C", "proofs/coq", "explorer", "mutants"),
        ("make", "-j2", "-C", "papers/lower_bounds/coq", "assumptions", "coqchk-all"),
        ("make", "-C", "papers/lower_bounds/coq", "mutants"),
        ("make", "-C", "proofs/coq", "enumeration", f"PYTHON={session.bin}/python"),
        ("python", "proofs/coq/certificates.py"),
        ("python", "proofs/coq/certified.py"),
        ("python", "proofs/coq/certified.py", "--sample"),
        ("python", "proofs/coq/certified.py", "--certificate", certificate, "algorithm1"),
        ("python", "proofs/coq/certified.py", "--verify", certificate, "algorithm1", *played),
        ("python", "proofs/coq/certified_trees.py"),
    )
    for step in steps:
        start = time.monotonic()
        session.run(*step, external=step[0] == "make")
        session.log(f"{' '.join(step)}: {time.monotonic() - start:.0f} s")


@nox.session
def full(session: nox.Session) -> None:
    """Run the slowest tests, then go further with what Coq extracts (nox -s proofs builds it)."""
    session.install(".[browser,dev,docs]")
    distributed = ("-n", "auto", "--dist", "worksteal")
    everywhere = ("-o", "norecursedirs=build .*")  # in tests/slow, too
    session.run("pytest", *distributed, "-m", "slowest", "--durations=25", *everywhere, "tests")
    further = ("walked", "judged", "checked", "folded", "shielded")
    limits = [word for name in further for word in (f"--{name}-edges", "4")]
    session.run("python", "proofs/coq/certified.py", "--edges", "5", *limits)
    session.run(
        "python", "proofs/coq/certified.py", "--sample", "20000", "--units", "500", "--seed", "1"
    )
    session.run("proofs/coq/minimality", external=True)
    session.run("python", "tests/support/mutants/matrix.py")
