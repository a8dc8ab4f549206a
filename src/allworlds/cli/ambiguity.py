"""The verbs ``twins`` and ``ambiguity``."""

from __future__ import annotations

from typing import Annotated

import typer

from allworlds.cli import options as opt
from allworlds.cli.output import Progress, emit

Info = Annotated[
    str,
    typer.Option(
        metavar="INFO",
        help="The lighthouse of a WORLD that names none: none, position, compass, directional, "
        "cluster or natural.",
        rich_help_panel=opt.SCOPE,
    ),
]
_WORLD = "Inline JSON, @file, or a name such as k4, wheel-4, fig1-left."

ambiguity = typer.Typer(
    name="ambiguity",
    help=(
        "Example: allworlds ambiguity class wheel-4\n\n"
        "What a robot cannot tell apart that knows its position at one vertex, and no direction."
    ),
)


@ambiguity.callback(invoke_without_command=True)
def _help(context: typer.Context) -> None:
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())


@ambiguity.command(name="census")
def census(
    *,
    edges: opt.Edges = None,
    vertices: opt.Vertices = None,
    map_class: opt.MapClassName = "maps",
    as_json: opt.Json = False,
    quiet: opt.Quiet = False,
) -> int:
    """Example: allworlds ambiguity census --edges 5

    Classify every map with one marked vertex: which of them does no motion tell apart?  Twins
    are looked for inside the class only.
    """
    from allworlds.ambiguity import census as run_census

    with Progress(quiet=quiet) as progress:
        result = run_census(edges=edges, vertices=vertices, map_class=map_class, listener=progress)
    emit(result, "ambiguity census", as_json=as_json)
    return result.exit_code


@ambiguity.command(name="class")
def class_(
    world: Annotated[str, typer.Argument(metavar="WORLD", help=_WORLD)],
    *,
    info: Info = "position",
    limit: Annotated[
        int | None,
        typer.Option(
            parser=opt.integer,
            metavar="L",
            help="List at most L worlds; size and poses are exact all the same [default: 1000].",
            rich_help_panel=opt.EFFORT,
            show_default=False,
        ),
    ] = None,
    map_class: opt.MapClassName = "maps",
    as_json: opt.Json = False,
    quiet: opt.Quiet = False,
) -> int:
    """Example: allworlds ambiguity class k4 --class simple

    Build every world that no motion tells from WORLD, and say why.
    """
    from allworlds.ambiguity import DEFAULT_LIMIT, class_of
    from allworlds.world import world_named

    result = class_of(
        world_named(world, info),
        limit=DEFAULT_LIMIT if limit is None else limit,
        map_class=map_class,
    )
    with Progress(quiet=quiet) as progress:
        if result.notice:
            progress.notice(result.notice)
    emit(result, "ambiguity class", as_json=as_json)
    return 0


def twins(
    a: Annotated[str, typer.Argument(metavar="A", help=_WORLD)],
    b: Annotated[str, typer.Argument(metavar="B", help="Another one.")],
    *,
    info: Info = "position",
    as_json: opt.Json = False,
) -> int:
    """Example: allworlds twins fig1-left fig1-right

    Can any motion tell two worlds apart?  The answer comes with the shortest motions that do,
    or with classes of darts that prove that none does.
    """
    from allworlds.ambiguity import twins as compare
    from allworlds.world import world_named

    result = compare(world_named(a, info), world_named(b, info))
    emit(result, "twins", as_json=as_json)
    return 0
