"""The verb ``convert`` on the command line."""

import allworlds
from allworlds.cli.output import OutputGroup, emit
from allworlds.documents.document import replace
from allworlds.inputs.checks import InputError, show
from allworlds.inputs.requests import answer
from allworlds.reports.formats import names_world_file
from allworlds.studies.convert import ConvertRequest


def convert(request: ConvertRequest, *, output: OutputGroup) -> int:
    """Example: allworlds convert plan.graphml -o plan.json

    Tell of each world of a file: its size, genus, faces and symmetries; with -o write them in
    another notation, without what that has no place for.
    """
    files = output.files or []
    worlds = [name for name in files if names_world_file("convert", name)]
    if len(worlds) > 1:
        raise InputError(f"-o {show(worlds[1])} is a second file of worlds; one is written")
    report = answer(allworlds.convert, replace(request, output=worlds[0] if worlds else None))
    return emit(report, replace(output, files=[name for name in files if name not in worlds]))
