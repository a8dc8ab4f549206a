"""Who may import whom: read from the sources, not from a running interpreter."""

import ast
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

import allworlds

ROOT = Path(allworlds.__file__).parent
ARCHITECTURE = Path(__file__).parents[1] / "docs" / "ARCHITECTURE.md"


def layers(page):
    """For each module or package right below allworlds what else of allworlds it may import.

    The table of folders is the law.  '' is the package itself, which loads the upper half only
    when a name of it is used.
    """
    (table,) = re.findall(
        r"^\| folder of `allworlds` .*\n\|---.*\n((?:\|.*\n)+)", page, re.MULTILINE
    )
    told = [[*map(str.strip, row.strip("|").split("|"))] for row in table.splitlines()]
    assert all(len(row) == 3 for row in told)
    return {named(folder)[0]: set(named(below)) for folder, _, below in told}


def named(cell):
    """The names in backticks of a cell; it holds nothing else."""
    names = re.findall(r"`([^`]+)`", cell)
    assert cell in (", ".join(f"`{name}`" for name in names), "nothing"), cell
    return [name.removesuffix(".py").replace("__init__", "") for name in names]


LAYERS = layers(ARCHITECTURE.read_text(encoding="utf-8"))

# Packages that are entered otherwise than by their __init__, and why.
SIDE_DOORS = {
    "maps": "its modules are compared with each other, so each is entered by itself",
}

# What of allworlds its __init__ may load at once; the rest waits until it is used.
AT_ONCE = {"inputs", "maps", "protocol", "verbs", "version"}

# The only homes of each library that does not come with Python.
HOMES = {
    "dask": ["work.cluster"],
    "distributed": ["work.cluster", "work.lanes"],
    "hypothesis": ["strategies"],
    "llvmlite": ["kernel"],
    "matplotlib": ["reports.grow_plot", "figures"],
    "networkx": ["maps.networks", "maps.counting.atlas", "judge.second_opinion", "mutation.judges"],
    "numba": ["kernel"],
    "numpy": ["kernel", "growing"],
    "pysat": ["smt"],
    "rich": ["cli", "reports"],
    "sympy": ["ledger.complexity"],
    "typer": ["cli", "reports"],
    "z3": ["smt"],
}
# Loaded only inside the functions that need them, or for types.
LAZY = {"dask", "distributed", "matplotlib", "networkx", "rich", "sympy"}

# Two ways to one answer share nothing but what is named here, however many modules between.
COMPARED = [
    (
        "bisimulation",
        "maps.quotient",
        {"inputs", "maps.canonical", "maps.combinatorial"},
    ),
    # Twins are found by formulas, and by quotients; one checker serves both, and knows neither.
    ("smt", "maps.quotient", {"inputs", "maps.canonical", "maps.combinatorial"}),
    ("maps.enumeration", "maps.bruteforce", {"maps.combinatorial", "inputs"}),
    ("maps.counting", "maps.enumeration", set()),
    ("maps.counting", "maps.bruteforce", set()),
    ("kernel.demand_driven", "explorers.algorithm1", set()),
    (
        "kernel.demand_driven",
        "kernel.runs",
        {
            *("kernel", "kernel.bits", "kernel.calls", "kernel.code", "kernel.compiling"),
            *("kernel.names", "kernel.records"),
        },
    ),
    ("judge.second_opinion", "maps.canonical", {"maps.combinatorial", "inputs"}),
]


class Import(NamedTuple):
    """``target`` is imported; ``lazy``: inside a function; ``typing``: only for types."""

    target: str
    lazy: bool
    typing: bool

    @property
    def at_once(self):
        return not self.lazy and not self.typing


def imports_of(source, name, *, package=False):
    """Every import of a module's source, by absolute name; also import_module("...")."""
    found = set()

    def visit(node, lazy=False, typing=False):
        for target in targets(node, name, package):
            found.add(Import(target, lazy, typing))
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
            return [alias.name for alias in names]
        case ast.ImportFrom(module, names, 0):
            return from_names(module, names)
        case ast.ImportFrom(module, names, level):
            parts = name.split(".")
            base = parts[: len(parts) - level + package]
            return from_names(".".join([*base, *([module] if module else [])]), names)
        case ast.Call(
            ast.Name("import_module" | "__import__") | ast.Attribute(attr="import_module"),
            [ast.Constant(str() as target), *_],
        ):
            return [target]
    return []


def from_names(module, names):
    """``from allworlds import maps`` imports a module, ``from allworlds.maps import cycle`` not."""
    if module != "allworlds":
        return [module]
    return [f"allworlds.{alias.name}" if alias.name in units() else "allworlds" for alias in names]


def units():
    """The modules and packages right below allworlds."""
    return {
        path.stem
        for path in ROOT.iterdir()
        if (path.suffix == ".py" and path.stem != "__init__") or (path / "__init__.py").exists()
    }


def modules():
    """``{name without 'allworlds.': imports}`` for every source file."""
    read = {}
    for path in sorted(ROOT.rglob("*.py")):
        parts = list(path.relative_to(ROOT).with_suffix("").parts)
        package = parts[-1] == "__init__"
        short = ".".join(parts[:-1] if package else parts)
        name = f"allworlds.{short}" if short else "allworlds"
        read[short] = imports_of(path.read_text(encoding="utf-8"), name, package=package)
    return read


MODULES = modules()


def inner(target):
    """The name without 'allworlds.' of one of our own modules, else None."""
    head, _, rest = target.partition(".")
    return rest if head == "allworlds" else None


def unit(short):
    return short.partition(".")[0]


def within(short, homes):
    return any(short == home or short.startswith(f"{home}.") for home in homes)


def test_every_module_has_a_row_in_the_table():
    unknown = units() - set(LAYERS)
    assert not unknown, f"{ARCHITECTURE} needs a row for {', '.join(sorted(unknown))}"


def test_every_row_of_the_table_is_a_module():
    stale = set(LAYERS) - {""} - units()
    assert not stale, f"{ARCHITECTURE} has rows without a module: {', '.join(sorted(stale))}"


def test_each_row_stands_on_the_rows_before_it():
    for number, (layer, below) in enumerate(LAYERS.items()):
        above = below - set([*LAYERS][:number])
        assert not above, f"{layer} may import {', '.join(sorted(above))}, which come after it"


def test_no_row_allows_what_nobody_needs():
    for layer, below in LAYERS.items():
        reached = {
            unit(inner(target.target))
            for short, imports in MODULES.items()
            for target in imports
            if unit(short) == layer and inner(target.target) is not None
        }
        assert below <= reached, f"{layer} does not import {', '.join(sorted(below - reached))}"


def test_a_module_imports_only_what_its_layer_may():
    for short, imports in MODULES.items():
        layer = unit(short)
        for target in imports:
            own = inner(target.target)
            if own is not None and unit(own) != layer:
                assert unit(own) in LAYERS[layer], f"{short or 'allworlds'} imports {target.target}"


def test_a_library_is_imported_only_at_home():
    for short, imports in MODULES.items():
        for target in imports:
            library = target.target.partition(".")[0]
            if library == "allworlds" or library in sys.stdlib_module_names:
                continue
            assert library in HOMES, f"HOMES needs a row for {library}, which {short} imports"
            assert within(short, HOMES[library]), f"{short} imports {library}"
            assert library not in LAZY or not target.at_once, f"{short} loads {library} at once"


def door(target):
    """The innermost package of ours that holds what is imported; '' for a module at the top."""
    parts = target.split(".")
    while parts and not (ROOT.joinpath(*parts) / "__init__.py").exists():
        parts.pop()
    return ".".join(parts)


def test_a_package_is_entered_by_its_door():
    for short, imports in MODULES.items():
        for target in imports:
            own = inner(target.target)
            if own is None or unit(own) in SIDE_DOORS:
                continue
            house = door(own)
            if house and not within(short, [house]):
                assert own == house, f"{short or 'allworlds'} goes round the door of {house}: {own}"


def test_no_side_door_is_open_without_need():
    used = {
        unit(inner(target.target))
        for short, imports in MODULES.items()
        for target in imports
        if inner(target.target) and door(inner(target.target)) not in ("", inner(target.target))
        if not within(short, [door(inner(target.target))])
    }
    assert used == set(SIDE_DOORS)


def test_the_package_loads_only_maps_and_protocol_at_once():
    loaded = {unit(inner(i.target)) for i in MODULES[""] if inner(i.target) and i.at_once}
    assert loaded <= AT_ONCE
    homes = set(allworlds._HOMES.values())
    assert homes <= LAYERS[""] & units()


@pytest.mark.parametrize("door", sorted(ROOT.rglob("__init__.py")), ids=lambda d: d.parent.name)
def test_a_package_that_tells_of_its_modules_tells_of_each(door):
    told = ast.get_docstring(ast.parse(door.read_text(encoding="utf-8"))) or ""
    # A list of modules: names, and indented below them what they hold.
    lines = re.findall(r"^((?:``[\w.]+``,?\s)+) +\S", told, re.MULTILINE)
    names = {name for line in lines for name in re.findall(r"``([\w]+)``", line)}
    inside = {file.stem for file in door.parent.glob("*.py") if file != door}
    if names & inside:
        assert inside <= names


def test_nobody_but_main_imports_the_command_line():
    importers = {
        unit(short)
        for short, imports in MODULES.items()
        if any(unit(inner(i.target) or "") == "cli" for i in imports)
    }
    assert importers - {"cli"} == {"__main__"}
    assert [layer for layer, below in LAYERS.items() if "cli" in below] == ["__main__"]


def test_explorers_judges_and_worlds_do_not_know_each_other():
    for one, other in [
        ("explorers", "world"),
        ("explorers", "episode"),
        ("explorers", "judge"),
        ("judge", "world"),
        ("judge", "episode"),
        ("judge", "explorers"),
        ("world", "explorers"),
        ("world", "judge"),
        ("episode", "explorers"),
        ("episode", "judge"),
    ]:
        reached = {unit(short) for short in closure(one)}
        assert one in reached
        assert other not in reached, f"{one} reaches {other}"


def closure(start):
    """Everything of allworlds that a module, or any module of a package, imports in the end.

    Types are not counted: what is imported for them alone does not run.
    """
    reached = [short for short in MODULES if within(short, [start])]
    for short in reached:
        for target in MODULES[short]:
            own = inner(target.target)
            if own and own in MODULES and own not in reached and not target.typing:
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
    assert not any(within(short, ["explorers"]) for short in closure("judge.folding"))
    assert not any(within(short, ["judge"]) for short in closure("explorers"))


# ---------------------------------------------------------------- the reader of imports


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("import os, networkx as nx", [("os", False, False), ("networkx", False, False)]),
        ("import allworlds.maps.build as b", [("allworlds.maps.build", False, False)]),
        ("from allworlds import maps", [("allworlds.maps", False, False)]),
        ("from allworlds import Percept", [("allworlds", False, False)]),
        ("from allworlds.maps import cycle", [("allworlds.maps", False, False)]),
        ("from . import bounds", [("allworlds.judge", False, False)]),
        ("from .bounds import x", [("allworlds.judge.bounds", False, False)]),
        ("from ..world import World", [("allworlds.world", False, False)]),
        ("from .. import world", [("allworlds.world", False, False)]),
        ("def f():\n    import rich.table", [("rich.table", True, False)]),
        ("class C:\n    import rich", [("rich", False, False)]),
        ("if TYPE_CHECKING:\n    import z3", [("z3", False, True)]),
        ("if typing.TYPE_CHECKING:\n    pass\nelse:\n    import z3", [("z3", False, False)]),
        ("try:\n    import z3\nexcept ImportError:\n    pass", [("z3", False, False)]),
        ("import_module('allworlds.cli')", [("allworlds.cli", False, False)]),
        ("f = lambda: importlib.import_module('z3')", [("z3", True, False)]),
        ("__import__('numba')", [("numba", False, False)]),
        ("x = 'import z3'", []),
    ],
)
def test_every_way_to_import_is_seen(source, expected):
    assert imports_of(source, "allworlds.judge.laws") == {Import(*e) for e in expected}


def test_a_relative_import_of_a_package_starts_in_the_package():
    found = imports_of("from .bounds import x", "allworlds.judge", package=True)
    assert found == {Import("allworlds.judge.bounds", lazy=False, typing=False)}


# ---------------------------------------------------------------- what is loaded in fact


def loaded_by(statement):
    paths = [str(ROOT.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
    run = subprocess.run(
        [sys.executable, "-X", "importtime", "-c", statement],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
        capture_output=True,
        text=True,
        check=True,
    )
    lines = [line for line in run.stderr.splitlines() if line.startswith("import time:")]
    return {line.rpartition("|")[2].strip() for line in lines}


def test_importing_the_package_loads_no_library():
    loaded = loaded_by("import allworlds")
    assert "allworlds.maps.combinatorial" in loaded
    assert not {name.partition(".")[0] for name in loaded} & set(HOMES)
    assert {unit(inner(name)) for name in loaded if inner(name)} <= AT_ONCE


def test_a_name_of_the_upper_half_loads_it_when_it_is_used():
    # What import_module itself loads is not in the list, but what that module imports is.
    assert "allworlds.maps.counting" not in loaded_by("import allworlds")
    assert "allworlds.maps.counting" in loaded_by("import allworlds; allworlds.count")
