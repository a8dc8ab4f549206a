"""The verb ``convert`` on the command line."""

import allworlds
from allworlds.cli.output import OutputGroup, emit
from allworlds.documents.document import replace
from allworlds.inputs.requests import answer
from allworlds.reports.formats import names_world_file
from allworlds.studies.convert import ConvertRequest


def convert(request: ConvertRequest, *, output: OutputGroup) -> int:
    """Example: allworlds convert plan.graphml -o plan.json

    Describe each world of a file: its size, genus, faces and symmetries, and where the doors of
    each room lead; with -v draw it. With -o write the worlds in another notation, or draw one world
    (.svg). What the other notation cannot hold is left out.
    """
    files = output.files or []
    worlds = [name for name in files if names_world_file("convert", name)]
    report = answer(allworlds.convert, replace(request, output=worlds))
    return emit(report, replace(output, files=[name for name in files if name not in worlds]))
