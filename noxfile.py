"""Everything that is done to this project, by name: ``nox -l`` lists it."""

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
    """Build and install the package, and test what is installed, with branch coverage."""
    session.install(".[test]")
    session.run("pytest", "-n", "auto", "--cov", "--cov-fail-under=95", *session.posargs)


@nox.session
def exhaustive(session: nox.Session) -> None:
    """Do the main job, further than the tests go."""
    session.install(".")
    session.run("allworlds", "check", "--edges", "6")
    session.run("allworlds", "check", "--edges", "3", "--schedules", "all")


@nox.session
def bench(session: nox.Session) -> None:
    """Measure; peers are given as --peer 'NAME=COMMAND'."""
    session.install(".")
    session.run("python", "benchmarks/python_engine.py", *session.posargs)
