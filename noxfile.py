"""Everything that is done to this project, by name: ``nox -l`` lists it."""

import nox

nox.options.sessions = ["lint", "types", "test"]


@nox.session
def fmt(session):
    """Format the code and mend what can be mended."""
    session.install("ruff>=0.6")
    session.run("ruff", "check", "--fix", ".")
    session.run("ruff", "format", ".")


@nox.session
def lint(session):
    """Read the code for mistakes."""
    session.install("ruff>=0.6")
    session.run("ruff", "check", ".")
    session.run("ruff", "format", "--check", ".")


@nox.session
def types(session):
    """Check the types, strictly."""
    session.install("-e", ".[dev]")
    session.run("mypy")


@nox.session
def test(session):
    """Build the wheel, install it, and test what is installed, with branch coverage."""
    session.install("build>=1.2")
    session.run("python", "-m", "build", "--wheel", "--outdir", "dist", ".")
    session.run("python", "-m", "pip", "install", "--force-reinstall", "--no-deps", "--find-links", "dist", "--no-index", "allworlds")
    session.install("allworlds[test]", "--find-links", "dist")
    session.run("pytest", "-n", "auto", "--cov", "--cov-report=term", "--cov-fail-under=95", *session.posargs)


@nox.session
def exhaustive(session):
    """The main job, further than the tests go."""
    session.install(".")
    session.run("allworlds", "check", "--edges", "6")
    session.run("allworlds", "check", "--edges", "3", "--schedules", "all")


@nox.session
def bench(session):
    """Ratios against peers, with their spread."""
    session.install(".")
    session.run("python", "benchmarks/run.py", *session.posargs)
