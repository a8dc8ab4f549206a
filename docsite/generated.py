"""The pages that are made from the tables of the program, whenever the site is built.

The command line from the parser that reads it, the names of the package from their docstrings,
the header from the file that is shipped.  Nothing here is written by hand but headings.
"""

from __future__ import annotations

import importlib
import inspect
import json
import re
from importlib.resources import files
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import allworlds
from allworlds.cli import app
from allworlds.reports.schemas import schemas
from allworlds.verbs import GROUPS, VERBS, Verb


def on_files(files_: Files, config: MkDocsConfig) -> Files:
    """The pages of the folder, and those that are made."""
    for name, text in pages().items():
        files_.append(File.generated(config, name, content=text))
    for name, schema in schemas().items():
        text = json.dumps(schema, indent=2) + "\n"
        files_.append(File.generated(config, f"schemas/{name}.schema.json", content=text))
    return files_


def pages() -> dict[str, str]:
    """Every page that is made, by its place."""
    return {
        "reference/command-line.md": command_line(),
        "reference/python.md": names(),
        "reference/header.md": header(),
    }


# ---------------------------------------------------------------- the command line


def command_line() -> str:
    """The reference of the verbs: for each its help, its arguments and its options."""
    text = "# Command line\n\n| verb | what it does |\n|---|---|\n"
    for verb in VERBS:
        text += f"| [`{verb.name}`](#{_anchor(verb)}) | {verb.summary} |\n"
    text += (
        "\nWith `--json` a verb prints one document: [its keys](../documents.md). "
        "[Exit codes](../verdicts.md#verdicts-and-exit-codes) are the same for all verbs.\n"
    )
    root = app.command_line()
    return text + "".join(_verb_text(verb, _command(root, verb)) for verb in VERBS)


def _command(root: Any, verb: Verb) -> Any:
    command = root
    for word in verb.name.split():
        command = command.commands[word]
    return command


def _anchor(verb: Verb) -> str:
    return verb.name.replace(" ", "-")


def _verb_text(verb: Verb, command: Any) -> str:
    example, _, rest = inspect.cleandoc(command.help).partition("\n\n")
    prose = rest.replace("\f", "\n").replace("\b", "")
    text = f"\n## {verb.name}\n\n```sh\n{example.removeprefix('Example: ')}\n```\n\n{prose}\n"
    if verb.group:
        text += f"\n*{GROUPS[verb.group].summary}*\n"
    arguments = [p for p in command.params if p.param_type_name == "argument"]
    if arguments:
        text += "\n| argument | what it is |\n|---|---|\n"
        text += "".join(
            f"| `{_cell(p.metavar or p.name)}` | {_cell(p.help)} |\n" for p in arguments
        )
    panels: dict[str, list[Any]] = {}
    for option in command.params:
        if option.param_type_name == "option":
            panels.setdefault(option.panel or "Options", []).append(option)
    for panel, options in panels.items():
        text += f"\n| {panel.lower()} | |\n|---|---|\n"
        text += "".join(_option_row(option) for option in options)
    return text


def _option_row(option: Any) -> str:
    value = f" {option.metavar}" if option.metavar else ""
    forms = ", ".join(f"`{_cell(form + value)}`" for form in option.opts)
    required = " Required." if option.required else ""
    return f"| {forms} | {_cell(option.help)}{required} |\n"


def _cell(text: str) -> str:
    return " ".join(text.replace("|", r"\|").split())


# ---------------------------------------------------------------- Python


MODULES = {
    "robots": (
        "For several robots: the base of models, and the search of one world; see "
        "[Several robots](../robots.md)."
    ),
    "testing": "Assertions for tests: [how to use them](../how-to/pytest.md).",
    "strategies": "Hypothesis strategies: [how to use them](../how-to/pytest.md).",
    "claims": "For the claims of a paper: [ledger](command-line.md#ledger).",
}
"""The modules of the public API beside ``import allworlds``."""


def names() -> str:
    """The public API: the names of ``import allworlds`` and of the modules beside it."""
    verbs = [resolve_name(verb.path) for verb in VERBS if verb.path.count(".") > 1]
    text = (
        "# Python\n\nThe public API: the names of `import allworlds` and of three modules. An "
        "explorer needs the classes, and the functions are the verbs: they take the options of the "
        "[command line](command-line.md) as keywords. Everything else in the package may change "
        "without notice.\n\n"
    )
    text += "".join(_reference(f"allworlds.{name}") for name in allworlds.__all__ if _is_told(name))
    text += "# allworlds.ambiguity\n\n"
    text += "".join(_reference(f"{one.__module__}.{one.__name__}") for one in verbs)
    for name, told in MODULES.items():
        text += f"# allworlds.{name}\n\n{told}\n\n"
        paths = [f"allworlds.{name}.{public}" for public in _public(f"allworlds.{name}")]
        text += "".join(map(_reference, paths))
    return text


def _public(name: str) -> list[str]:
    module = importlib.import_module(name)
    told = getattr(module, "__all__", None) or [
        public
        for public, value in vars(module).items()
        if public[0] != "_" and getattr(value, "__module__", None) == name
    ]
    return [public for public in told if public != "__version__" and _is_plain(module, public)]


def _is_plain(module: Any, name: str) -> bool:
    """Whether a name can be found by reading: a class, a function, or assigned by itself."""
    value = getattr(module, name)
    if inspect.isclass(value) or inspect.isroutine(value):
        return value.__module__.startswith("allworlds")
    source = Path(module.__file__).read_text(encoding="utf-8")
    return bool(re.search(rf"^{name}(:.*)? = ", source, re.MULTILINE))


def _is_told(name: str) -> bool:
    return not name.startswith("__") and not inspect.ismodule(getattr(allworlds, name))


def _reference(path: str) -> str:
    return f"::: {path}\n\n"


# ---------------------------------------------------------------- C


def header() -> str:
    """``allworlds.h`` as it is printed by ``allworlds init --header``."""
    text = (files("allworlds.explorers") / "allworlds.h").read_text(encoding="utf-8")
    return (
        "# allworlds.h\n\nThe header of [explorers in shared libraries](../how-to/languages.md), "
        f"as `allworlds init --header` prints it.\n\n```c\n{text.rstrip()}\n```\n"
    )


ROLE = re.compile(r":(?:class|func|meth|mod|data|attr|exc):<code>~?(?:[\w.]+\.)?(\w+)</code>")
"""A reference in a docstring, as Python's own tools write them."""


def on_page_content(html: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """The page with the references in docstrings as the names that they name."""
    return ROLE.sub(r"<code>\1</code>", html)
