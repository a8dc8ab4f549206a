"""Who may import whom: read from the sources, not from a running interpreter."""

import ast
import importlib
import os
import pkgutil
import re
import subprocess
import sys
import types
from collections import Counter, defaultdict
from pathlib import Path
from typing import NamedTuple

import networkx as nx
import pytest

import allworlds

ROOT = Path(allworlds.__file__).parent
ARCHITECTURE = Path(__file__).parents[2] / "docs" / "ARCHITECTURE.md"


class Wing(NamedTuple):
    """A row of the table: what lies right below allworlds, and the wings that may be imported."""

    holds: tuple[str, ...]
    below: tuple[str, ...]


def wings(page):
    """Each wing by its name, in the order of the table of the page, which is the law."""
    (table,) = re.findall(r"^\| wing \| .*\n\|---.*\n((?:\|.*\n)+)", page, re.MULTILINE)
    rows = [[*map(str.strip, row.strip("|").split("|"))] for row in table.splitlines()]
    assert all(len(row) == 4 for row in rows)
    return {named(name)[0]: Wing(named(holds), named(below)) for name, holds, _, below in rows}


def named(cell):
    """The names in backticks of a cell; it holds nothing else."""
    names = re.findall(r"`([^`]+)`", cell)
    assert cell in (", ".join(f"`{name}`" for name in names), "-"), cell
    return tuple(name.removesuffix(".py") for name in names)


WINGS = wings(ARCHITECTURE.read_text(encoding="utf-8"))
HOME = {entry: wing for wing, row in WINGS.items() for entry in row.holds}

MOST_ROWS, MOST_ARROWS, MOST_ENTRIES, MOST_IN_A_CIRCLE = 12, 70, 25, 8
"""What one can hold in the head."""

# Wings without a door of their own: each folder in them has one.
BY_FOLDER = {"studies"}

# What is there for all studies, and knows none of them.
OF_ALL = ("findings", "options", "reports", "scopes", "swept", "user_corpus")
SHARED_BY_STUDIES = {f"studies.{name}" for name in OF_ALL}

# What lies beside the wings and holds no code, or code that no wing knows.
BESIDE = {"corpus", "schemas", "py.typed"}

# The only homes of each library that does not come with Python.
HOMES = {
    "click": ["cli"],
    "dask": ["engines.dask"],
    "distributed": ["engines.dask"],
    "hypothesis": ["strategies"],
    "llvmlite": ["engines.kernel"],
    # Structs: in every wing, but not in what is loaded by "import allworlds".
    "msgspec": [
        *("documents", "outcome", "maps", "protocol", "world", "explorers", "judging", "engines"),
        *("reports", "robots", "studies", "notations"),
    ],
    "networkx": ["maps.build", "maps.networks", "notations.graphs"],
    "numba": ["engines.kernel"],
    "numpy": ["engines.kernel", "studies.ambiguity"],
    "psutil": ["engines.dask"],
    "pyarrow": ["reports.formats"],
    "pysat": ["studies.ambiguity.solvers"],
    "rich": ["cli", "reports"],
    "rich_click": ["cli"],
    "scipy": ["studies.compare"],
    "z3": ["studies.ambiguity.solvers"],
}
# What comes with Python, or will.
EVERYWHERE = {*sys.stdlib_module_names, "typing_extensions"}
# Loaded only inside the functions that need them, or for types.
LAZY = {"dask", "distributed", "networkx", "rich"}

INPUTS = {"inputs", "inputs.checks", "inputs.nesting", "inputs.requests"}
"""The door to checks of values, and what is behind it."""

DOORS = {"documents", "documents.document", "documents.shown", "lazy", "maps", "outcome"}
"""What two modules may share that do not share a line of what they compute."""

UPWARD = {"maps.combinatorial": "maps", "studies.merge": "studies"}
"""Modules that load what stands above them, in a function: a map as a graph of networkx, the sweep
of a verb."""

# Two ways to one answer share nothing but what is named here, however many modules between.
COMPARED = [
    (
        "world.bisimulation",
        "maps.quotient",
        {"maps.combinatorial", *INPUTS, *DOORS},
    ),
    # Twins are found by formulas, and by quotients; one checker serves both, and knows neither.
    (
        "studies.ambiguity.twin_search",
        "maps.quotient",
        {"maps.combinatorial", *INPUTS, *DOORS},
    ),
    ("maps.counting", "maps.enumeration", set()),
    ("engines.kernel.demand_driven", "explorers.builtin.algorithm1", DOORS),
    (
        "engines.kernel.demand_driven",
        "engines.kernel.runs",
        {
            *("engines.kernel.compiling", "engines.kernel.capabilities"),
            "engines.kernel.code",
            *("engines.kernel.compiling", "engines.kernel.arrays"),
        },
    ),
]


class Import(NamedTuple):
    """``name`` of ``module``, or the module if it is None; ``lazy``: inside a function;
    ``typing``: only for types."""

    module: str
    name: str | None = None
    lazy: bool = False
    typing: bool = False

    @property
    def at_once(self):
        return not self.lazy and not self.typing


def imports_of(source, name, *, package=False):
    """Every import of a module's source, by absolute name; also import_module("...")."""
    found = set()

    def visit(node, lazy=False, typing=False):
        for module, target in targets(node, name, package):
            found.add(Import(module, target, lazy, typing))
        inside = lazy or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        if isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
            for child in node.body:
                visit(child, inside, typing=True)
            for child in node.orelse:
                visit(child, inside, typing)
            return
        for child in ast.iter_child_nodes(node):
            visit(child, inside, typing)

    visit(ast.parse(source))
    return found


def targets(node, name, package):
    match node:
        case ast.Import(names):
            return [(alias.name, None) for alias in names]
        case ast.ImportFrom(module, names, 0):
            return [(module, alias.name) for alias in names]
        case ast.ImportFrom(module, names, level):
            parts = name.split(".")
            base = parts[: len(parts) - level + package]
            home = ".".join([*base, *([module] if module else [])])
            return [(home, alias.name) for alias in names]
        case ast.Call(
            ast.Name("import_module" | "__import__") | ast.Attribute(attr="import_module"),
            [ast.Constant(str() as target), *_],
        ):
            return [(target, None)]
    return []


def is_upward(short, target):
    return target.module.startswith(f"allworlds.{UPWARD[short]}")


def modules():
    """``{name without 'allworlds.': imports}`` for every source file."""
    read = {}
    for path in sorted(ROOT.rglob("*.py")):
        parts = list(path.relative_to(ROOT).with_suffix("").parts)
        if parts[0] in BESIDE:
            continue
        package = parts[-1] == "__init__"
        short = ".".join(parts[:-1] if package else parts)
        name = f"allworlds.{short}" if short else "allworlds"
        read[short] = imports_of(path.read_text(encoding="utf-8"), name, package=package)
    return read


def upward(short):
    """The imports by which a module that has a row of UPWARD loads what stands above it."""
    if short not in UPWARD:
        return set()
    above = {each for each in EVERY_IMPORT[short] if each.lazy and is_upward(short, each)}
    assert above, f"{short} needs no row of UPWARD"
    return above


EVERY_IMPORT = modules()
MODULES = {short: found - upward(short) for short, found in EVERY_IMPORT.items()}


def inner(module):
    """The name without 'allworlds.' of one of our own modules, '' for the package, else None."""
    head, _, rest = module.partition(".")
    return rest if head == "allworlds" else None


def is_door(short):
    """Whether a package passes names on."""
    return any(inner(i.module) == "lazy" for i in MODULES[short] if i.name == "open_door")


def entered(target):
    """The module that is named: of ``from package import module`` the latter."""
    own = inner(target.module)
    below = f"{own}.{target.name}" if own else target.name
    return below if target.name and below in MODULES else own


def defining(target):
    """The module in which a name is defined, behind however many doors; None for the root's."""
    own = entered(target)
    if own is None or own not in MODULES or not is_door(own):
        return own
    behind = [i for i in MODULES[own] if i.typing and i.name == target.name]
    return defining(behind[0]) if behind else own


def wing(short):
    return HOME[short.partition(".")[0] or "__init__"]


def room(short):
    """A wing, or the folder of a verb in a wing that is entered by folders."""
    parts = short.split(".")
    return ".".join(parts[:2]) if parts[0] in BY_FOLDER else parts[0]


def within(short, homes):
    return any(short == home or short.startswith(f"{home}.") for home in homes)


def own_imports():
    """Every import of one of our modules: who, what, and where it is defined."""
    for short, imports in MODULES.items():
        for target in imports:
            if inner(target.module) is not None:
                yield short, target, entered(target)


def arrows():
    """How often which wing imports from which, types included; doors pass on, and do not count."""
    return Counter(
        (wing(short), wing(own)) for short, _, own in own_imports() if wing(short) != wing(own)
    )


def test_what_lies_below_the_package_is_in_the_table_and_fits_on_a_screen():
    there = {path.stem for path in ROOT.glob("*") if path.name != "__pycache__"}
    assert there - {"py", "schemas", "corpus"} == set(HOME)
    assert len(set(HOME) - BESIDE) <= MOST_ENTRIES
    assert len(WINGS) <= MOST_ROWS


def test_each_row_stands_on_the_rows_before_it():
    rows = [*WINGS]
    for number, (name, row) in enumerate(WINGS.items()):
        above = set(row.below) - set(rows[:number])
        assert not above, f"{name} may import {', '.join(sorted(above))}, which come after it"


def test_a_wing_imports_just_what_its_row_says():
    for name, row in WINGS.items():
        reached = {to for came_from, to in arrows() if came_from == name}
        assert reached == set(row.below), f"{name} imports {', '.join(sorted(reached))}"


def test_there_are_no_more_arrows_than_one_can_follow():
    assert len(arrows()) <= MOST_ARROWS


def test_only_the_folders_that_users_import_from_pass_names_on():
    passing = {short for short in MODULES if is_door(short)}
    assert passing == {"", "explorers", "maps", "robots", "world", "studies.ambiguity"}
    for short, _, own in own_imports():
        assert not own or not is_door(own) or short in passing | {"ambiguity"}, (
            f"{short} goes by the way of users: {own}"
        )
    files = {short: ROOT.joinpath(*short.split("."), "__init__.py") for short in MODULES}
    packages = {short for short, file in files.items() if file.exists()}
    assert not [short for short in packages - passing - {"cli"} if MODULES[short]]


def test_a_study_imports_no_study_but_check():
    found = set()
    for short, _, own in own_imports():
        if wing(short) == wing(own) in BY_FOLDER and room(short) != room(own):
            found.add(room(own))
    assert found == {"studies.check", "studies.team", *SHARED_BY_STUDIES}


def test_what_all_studies_share_knows_none_of_them():
    for shared in SHARED_BY_STUDIES:
        assert {own for own in closure(shared) if wing(own) == "studies"} <= SHARED_BY_STUDIES


def test_no_circle_is_closed_among_the_modules_of_the_ground():
    below = {entry: set() for entry in WINGS["ground"].holds}
    for short, _, own in own_imports():
        if wing(short) == "ground" and room(own) != room(short):
            below[room(short)].add(room(own))
    while free := [entry for entry in below if not below[entry]]:
        for entry in free:
            del below[entry]
        for others in below.values():
            others.difference_update(free)
    assert not below


def circles():
    """The modules that import each other, at once, in functions or by a door, largest first."""
    graph = nx.DiGraph()
    for short, imports in EVERY_IMPORT.items():
        for target in imports:
            behind = {entered(target), defining(target)} & MODULES.keys()
            if is_door(short) or not target.typing:
                graph.add_edges_from((short, own) for own in behind - {short})
    return sorted(nx.strongly_connected_components(graph), key=len, reverse=True)


def test_no_large_circle_of_imports_is_closed():
    largest, *_ = circles()
    assert len(largest) <= MOST_IN_A_CIRCLE, f"these import each other: {sorted(largest)}"


def test_a_circle_through_a_function_of_the_ground_is_seen(monkeypatch):
    writers = Import("allworlds.reports.notebook", "WRITERS", lazy=True)
    shown = {*EVERY_IMPORT["documents.shown"], writers}
    monkeypatch.setitem(EVERY_IMPORT, "documents.shown", shown)
    assert len(circles()[0]) > MOST_IN_A_CIRCLE


def test_a_library_is_imported_only_at_home():
    for short, imports in MODULES.items():
        for target in imports:
            library = target.module.partition(".")[0]
            if library == "allworlds" or library in EVERYWHERE:
                continue
            assert library in HOMES, f"HOMES needs a row for {library}, which {short} imports"
            assert within(short, HOMES[library]), f"{short} imports {library}"
            assert library not in LAZY or not target.at_once, f"{short} loads {library} at once"


def named_types(path):
    """Each class, with its place; each other name of a type, with what it stands for."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ClassDef):
            yield node.name, f"{path}:{node.lineno}"
        elif isinstance(node, ast.AnnAssign) and ast.unparse(node.annotation) == "TypeAlias":
            yield node.target.id, ast.unparse(node.value)


def test_a_name_stands_for_one_type_and_in_a_wing_for_one_module():
    meanings = defaultdict(set)
    for path in ROOT.rglob("*.py"):
        for name, meaning in named_types(path):
            meanings[name].add(meaning)
    del meanings["FromJson"]  # a checker of types reads another line than Python
    assert not [name for name, several in meanings.items() if len(several) > 1]
    inside = [short for short in MODULES if "." in short]
    names = Counter((wing(short), short.rpartition(".")[2]) for short in inside)
    assert not [name for name, times in names.items() if times > 1]


@pytest.mark.parametrize("door", sorted(ROOT.rglob("__init__.py")), ids=lambda d: d.parent.name)
def test_a_package_that_tells_of_its_modules_tells_of_each(door):
    told = ast.get_docstring(ast.parse(door.read_text(encoding="utf-8"))) or ""
    # A list of modules: names, and indented below them what they hold.
    lines = re.findall(r"^((?:``[\w.]+``,?\s)+) +\S", told, re.MULTILINE)
    names = {name for line in lines for name in re.findall(r"``([\w]+)``", line)}
    inside = {file.stem for file in door.parent.glob("*.py") if file != door}
    if names & inside:
        assert inside <= names


def test_explorers_judges_and_worlds_do_not_know_each_other():
    for one, other in [
        ("explorers", "world"),
        ("explorers", "judging"),
        ("world", "explorers"),
        ("world", "judging"),
        ("judging.laws", "world"),
        ("judging.laws", "judging.episode"),
        ("judging.laws", "explorers"),
        ("judging.episode", "explorers"),
        ("judging.episode", "judging.laws"),
    ]:
        reached = closure(one)
        assert any(within(short, [one]) for short in reached)
        assert not any(within(short, [other]) for short in reached), f"{one} reaches {other}"


def test_built_in_explorers_are_written_against_maps_and_protocol_alone():
    allowed = ["explorers.builtin", "maps", "protocol", "documents", "inputs", "lazy", "outcome"]
    assert all(within(short, allowed) for short in closure("explorers.builtin"))


def closure(start):
    """Everything of allworlds that a module, or any module of a package, imports in the end.

    Types are not counted: what is imported for them alone does not run.  A door loads a module
    when a name of it is used, so a name leads to where it is defined.
    """
    reached = [short for short in MODULES if within(short, [start])]
    for short in reached:
        for target in MODULES[short]:
            if inner(target.module) is None or target.typing:
                continue
            for own in dict.fromkeys([entered(target), defining(target)]):
                if own in MODULES and own not in reached:
                    reached.append(own)
    return set(reached)


@pytest.mark.parametrize(("one", "other", "shared"), COMPARED)
def test_what_is_compared_shares_no_code(one, other, shared):
    assert one in MODULES
    assert other in MODULES
    assert closure(one) & closure(other) <= shared
    assert not {one, other} <= closure(one)
    assert not {one, other} <= closure(other)


def test_counting_imports_nothing_of_the_package_and_folding_no_explorer():
    assert all(within(short, ["maps.counting"]) for short in closure("maps.counting"))
    assert not any(within(short, ["explorers"]) for short in closure("judging.laws.folding"))
    assert not any(within(short, ["judging"]) for short in closure("explorers.builtin"))


# ---------------------------------------------------------------- the reader of imports


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("import os, networkx as nx", [Import("os"), Import("networkx")]),
        ("import allworlds.maps.build as b", [Import("allworlds.maps.build")]),
        ("from allworlds import maps", [Import("allworlds", "maps")]),
        ("from allworlds.maps import cycle as c", [Import("allworlds.maps", "cycle")]),
        ("from . import bounds", [Import("allworlds.judge", "bounds")]),
        ("from .bounds import x", [Import("allworlds.judge.bounds", "x")]),
        ("from ..world import World", [Import("allworlds.world", "World")]),
        ("from .. import world", [Import("allworlds", "world")]),
        ("def f():\n    import rich.table", [Import("rich.table", lazy=True)]),
        ("class C:\n    import rich", [Import("rich")]),
        ("if TYPE_CHECKING:\n    import z3", [Import("z3", typing=True)]),
        ("if typing.TYPE_CHECKING:\n    pass\nelse:\n    import z3", [Import("z3")]),
        ("try:\n    import z3\nexcept ImportError:\n    pass", [Import("z3")]),
        ("import_module('allworlds.cli')", [Import("allworlds.cli")]),
        ("f = lambda: importlib.import_module('z3')", [Import("z3", lazy=True)]),
        ("__import__('numba')", [Import("numba")]),
        ("x = 'import z3'", []),
    ],
)
def test_every_way_to_import_is_seen(source, expected):
    assert imports_of(source, "allworlds.judge.laws") == set(expected)


def test_a_relative_import_of_a_package_starts_in_the_package():
    found = imports_of("from .bounds import x", "allworlds.judge", package=True)
    assert found == {Import("allworlds.judge.bounds", "x")}


def test_a_name_is_found_behind_its_doors():
    assert defining(Import("allworlds", "check")) == "studies.check.exhaustive"
    assert defining(Import("allworlds.maps", "from_cycles")) == "maps.build"
    assert defining(Import("allworlds.maps", "build")) == "maps.build"
    assert defining(Import("allworlds.maps.build", "cycle")) == "maps.build"


# ---------------------------------------------------------------- what is loaded in fact


def loaded_by(statement):
    paths = [str(ROOT.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
    run = subprocess.run(
        [sys.executable, "-c", f"import sys; {statement}; print(*sys.modules)"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        capture_output=True,
        text=True,
        check=True,
    )
    return set(run.stdout.split())


def test_importing_the_package_loads_no_library_and_no_wing():
    loaded = loaded_by("import allworlds")
    assert not {name.partition(".")[0] for name in loaded} & set(HOMES)
    own = {inner(name) for name in loaded if inner(name)}
    assert {wing(name) for name in own} == {"ground"}


def test_a_check_loads_nothing_of_teams():
    parts = ["cli.app", "cli.check", "studies.check.exhaustive", "reports.content.check"]
    loaded = loaded_by("import " + ", ".join(f"allworlds.{part}" for part in parts))
    assert "allworlds.reports.formats" in loaded
    assert not {name for name in loaded if name.startswith("allworlds.robots")}
    assert not {name for name in loaded if name.startswith("allworlds.studies.team")}


def test_what_explorers_need_loads_maps_and_protocol_alone():
    loaded = loaded_by("from allworlds import CombinatorialMap, Choices, Move, Estimate")
    assert {name.partition(".")[0] for name in loaded} & set(HOMES) == {"msgspec"}
    own = {inner(name) for name in loaded if inner(name)}
    assert {wing(name) for name in own} == {"ground", "maps", "protocol"}


def test_a_process_that_only_plays_loads_neither_judges_nor_worlds():
    loaded = loaded_by(
        "import allworlds.engines.player; "
        "from allworlds.explorers.loading import Subject; "
        "from allworlds.protocol.playing import Record, TableWorld, play_run"
    )
    libraries = {"numpy", "numba", "z3", "networkx", "subprocess", "pickle", "socket", "difflib"}
    assert not libraries & loaded
    own = {inner(name) for name in loaded if inner(name)}
    assert not {name for name in own if wing(name) in ("judging", "world", "studies")}
    explorers = {name for name in own if wing(name) == "explorers"}
    assert explorers == {"explorers", "explorers.loading"}
    assert not {"inputs.requests", "documents.reading"} & own


def test_a_command_that_lets_others_judge_loads_no_compiled_code():
    loaded = loaded_by(
        "import allworlds.studies.check.exhaustive, allworlds.engines.lanes, "
        "allworlds.engines.engine_table"
    )
    assert not {"numpy", "numba"} & loaded


def test_a_command_does_not_load_pydantic():
    """It takes a tenth of a second."""
    loaded = loaded_by(
        "import allworlds.cli.app as app; assert app.call(['count', '--edges', '1', '-q']) == 0"
    )
    assert "click" in loaded
    assert "pydantic" not in loaded


def test_a_name_loads_its_module_when_it_is_used():
    counting = "allworlds.maps.counting"
    assert counting not in loaded_by("import allworlds")
    assert counting in loaded_by("import allworlds; allworlds.count")


def test_no_module_takes_the_name_of_what_a_door_shows():
    """A package gets an attribute for each module in it that is imported, whatever a door says."""
    for short in filter(is_door, MODULES):
        inside = {own.rpartition(".")[2] for own in MODULES if own.rpartition(".")[0] == short}
        values = {i.name for i in MODULES[short] if i.typing and entered(i) == inner(i.module)}
        assert not inside & values, f"{short or 'allworlds'} has modules of these names"


def test_every_name_of_a_door_is_as_it_should_be_whatever_was_imported_before():
    for found in pkgutil.walk_packages(allworlds.__path__, "allworlds."):
        if not found.name.endswith("__main__"):
            importlib.import_module(found.name)
    for short in filter(is_door, MODULES):
        door = importlib.import_module(f"allworlds.{short}" if short else "allworlds")
        behind = {i.name: i for i in MODULES[short] if i.typing}
        assert [*door.__all__] == dir(door) == sorted({*door.__all__} & behind.keys())
        for name, one in behind.items():
            value = getattr(door, name)
            if entered(one) != inner(one.module):
                assert value is sys.modules[f"allworlds.{entered(one)}"]
            else:
                assert value is getattr(importlib.import_module(one.module), name)
                assert not isinstance(value, types.ModuleType)
