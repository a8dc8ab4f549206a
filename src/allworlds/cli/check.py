"""The verb ``check`` on the command line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any

import allworlds
from allworlds.cli.files import Files, ensure_directory
from allworlds.cli.output import OutputGroup, answered, emit
from allworlds.cli.watch import kept_in, watched
from allworlds.document import replace
from allworlds.inputs import EFFORT, InputError, Option, fields_of, show
from allworlds.studies.check import CheckRequest


def check(
    request: CheckRequest,
    *,
    watch: Annotated[
        bool,
        Option(
            EFFORT,
            "",
            "Check again whenever the explorer, or a model of yours, is saved, earlier findings "
            "first.",
        ),
    ] = False,
    estimate: Annotated[
        bool,
        Option(
            EFFORT,
            "",
            "Only estimate the duration, from a sample of some seconds.",
            "estimate",
        ),
    ] = False,
    files: Files,
    output: OutputGroup,
) -> int:
    """Example: allworlds check my_explorer.py:explore --edges 4

    Run an explorer (default: Algorithm 1 of the paper) on every start and every marker
    orientation of every map of a class.  Exit code 0: holds, 1: refuted, 3: inconclusive,
    4: vacuous.
    """
    if estimate:
        kept = {"corpus": request.corpus, "run": request.run, "watch": watch}
        _refuse_beside_estimate({**files.named(), **kept})
        return _estimate(request, output)
    ensure_directory(request.corpus)

    def once(request: CheckRequest) -> int:
        report = answered(allworlds.check, request, output)
        files.write("check", report)
        return emit(report, "check", output, request.workers)

    if not watch:
        return once(request)
    if request.run is not None:
        raise InputError(
            f"watch cannot be given with run {show(request.run)}, which is about one text of the "
            "explorer"
        )
    with kept_in(request.corpus) as past:
        assert isinstance(request.explore, str)
        models = {name: code for name, code in _models(request) if code}
        again = {name: getattr(request, name).name for name in models}
        return watched(
            request.explore,
            # A name stands for the text that its file has now.
            lambda: once(replace(request, corpus=past, **again)),
            [code.file for codes in models.values() for code in codes if code.source],
        )


def _models(request: CheckRequest) -> Iterator[tuple[str, Sequence[Any]]]:
    """The fields of a request, with the user's code that their values stand for."""
    for each in fields_of(type(request)):
        yield each.name, getattr(getattr(request, each.name), "codes", ())


def _estimate(request: CheckRequest, output: OutputGroup) -> int:
    from allworlds.studies.check import estimate

    guess = answered(estimate, request, output)
    return emit(guess, "check", output, request.workers)


def _refuse_beside_estimate(given: Mapping[str, object]) -> None:
    """Raise InputError if an option is given that has no effect on an estimate.

    Raises:
        InputError: naming the first.
    """
    for name, value in given.items():
        if value is not None and value is not False:
            raise InputError(
                f"{name} {'' if value is True else show(value) + ' '}has no effect beside "
                "--estimate, which checks nothing; leave one of them out"
            )
