"""The verbs ``ambiguity twins``, ``class`` and ``search``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import answered
from allworlds.cli.files import Files
from allworlds.cli.options import WORLD, LighthouseOfWorld, LongOutputGroup, OutputGroup, WorldText
from allworlds.cli.output import Progress, emit
from allworlds.inputs import Argument, answer, values_of
from allworlds.studies.ambiguity import AskedMembers, ClassRequest, SearchRequest


def twins(
    a: Annotated[str, Argument("", "A", WORLD)],
    b: Annotated[str, Argument("", "B", "Another one.")],
    *,
    lighthouse: LighthouseOfWorld = "position",
    files: Files,
    output: OutputGroup,
) -> int:
    """Example: allworlds ambiguity twins fig1-left fig1-right

    Can any motion tell two worlds apart?  The answer comes with the shortest motions that do,
    or with classes of darts that prove that none does.
    """
    from allworlds.world import world_named

    result = allworlds.twins(world_named(a, lighthouse), world_named(b, lighthouse))
    files.write("ambiguity twins", result)
    return emit(result, "ambiguity twins", output)


def class_(
    world: WorldText,
    *,
    lighthouse: LighthouseOfWorld = "position",
    asked: AskedMembers,
    files: Files,
    output: OutputGroup,
) -> int:
    """Example: allworlds ambiguity class k4 --class simple

    Build every world that no motion tells from WORLD, and say why.
    """
    from allworlds.world import world_named

    request = ClassRequest(world_named(world, lighthouse), **values_of(AskedMembers, asked))
    result = answer(allworlds.ambiguity.class_of, request)
    with Progress(quiet=output.quiet) as progress:
        if result.notice:
            progress.notice(result.notice)
    files.write("ambiguity class", result)
    return emit(result, "ambiguity class", output)


def search(request: SearchRequest, *, files: Files, output: LongOutputGroup) -> int:
    """Example: allworlds ambiguity search --lighthouse position --class simple --edges 6

    Find two different worlds that no motion tells apart, or show that there are none.  Exit
    code 0: answered, 3: the time was over, 4: no world exists within the bounds.
    """
    result = answered(allworlds.search, request, output)
    seconds = [searched.seconds for searched in result.levels]
    files.write("ambiguity search", result)
    return emit(result, "ambiguity search", output, level_seconds=seconds)
