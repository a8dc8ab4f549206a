"""The verbs ``ambiguity twins``, ``class``, ``census`` and ``search``."""

from __future__ import annotations

from typing import Annotated

import allworlds
from allworlds.cli.events import answered
from allworlds.cli.files import PageFile
from allworlds.cli.options import WORLD, LighthouseOfWorld, LongOutputGroup, OutputGroup, WorldText
from allworlds.cli.output import Progress, emit
from allworlds.inputs import Argument, answer, values_of
from allworlds.studies.ambiguity import AskedMembers, CensusRequest, ClassRequest, SearchRequest


def twins(
    a: Annotated[str, Argument("", "A", WORLD)],
    b: Annotated[str, Argument("", "B", "Another one.")],
    *,
    lighthouse: LighthouseOfWorld = "position",
    page: PageFile,
    output: OutputGroup,
) -> int:
    """Example: allworlds ambiguity twins fig1-left fig1-right

    Can any motion tell two worlds apart?  The answer comes with the shortest motions that do,
    or with classes of darts that prove that none does.
    """
    from allworlds.world import world_named

    page.ensure_writable()
    result = allworlds.twins(world_named(a, lighthouse), world_named(b, lighthouse))
    page.write("ambiguity twins", result)
    return emit(result, "ambiguity twins", output)


def census(request: CensusRequest, *, output: LongOutputGroup) -> int:
    """Example: allworlds ambiguity census --edges 5

    Classify every map with one marked vertex: which of them does no motion tell apart?  Twins
    are looked for inside the class only.
    """
    result = answered(allworlds.ambiguity.census, request, output)
    return emit(result, "ambiguity census", output)


def class_(
    world: WorldText,
    *,
    lighthouse: LighthouseOfWorld = "position",
    asked: AskedMembers,
    page: PageFile,
    output: OutputGroup,
) -> int:
    """Example: allworlds ambiguity class k4 --class simple

    Build every world that no motion tells from WORLD, and say why.
    """
    from allworlds.world import world_named

    page.ensure_writable()
    request = ClassRequest(world_named(world, lighthouse), **values_of(AskedMembers, asked))
    result = answer(allworlds.ambiguity.class_of, request)
    with Progress(quiet=output.quiet) as progress:
        if result.notice:
            progress.notice(result.notice)
    page.write("ambiguity class", result)
    return emit(result, "ambiguity class", output)


def search(request: SearchRequest, *, page: PageFile, output: LongOutputGroup) -> int:
    """Example: allworlds ambiguity search --lighthouse position --class simple --edges 6

    Find two different worlds that no motion tells apart, or show that there are none.  Exit
    code 0: answered, 3: the time was over, 4: no world exists within the bounds.
    """
    page.ensure_writable()
    result = answered(allworlds.search, request, output)
    seconds = [searched.seconds for searched in result.levels]
    page.write("ambiguity search", result)
    return emit(result, "ambiguity search", output, level_seconds=seconds)
