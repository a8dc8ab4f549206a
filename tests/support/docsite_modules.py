"""The modules of the folder that makes the site, which is no package."""

import importlib.util
import sys
from pathlib import Path

DOCSITE = Path(__file__).parents[2] / "docsite"


def load(name):
    """A module of the folder."""
    spec = importlib.util.spec_from_file_location(f"docsite_{name}", DOCSITE / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look there
    spec.loader.exec_module(module)
    return module
