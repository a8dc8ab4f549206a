"""The compiled code by which users' explorers are judged: whether it is kept, and its compiling."""

from __future__ import annotations

import json
import subprocess
import sys

from allworlds.engines.kernel.batches import load_native
from allworlds.engines.kernel.compiling import is_compiled
from allworlds.engines.kernel.native import play
from allworlds.engines.kernel.runs import examine


def is_kept() -> bool:
    """Whether it has been compiled before."""
    return all(map(is_compiled, (play, examine)))


def compile_apart() -> None:
    """Let another process compile it, which is not waited for."""
    command = [sys.executable, "-c", _APART, json.dumps(sys.path)]
    nothing = subprocess.DEVNULL
    subprocess.Popen(command, stdin=nothing, stdout=nothing, stderr=nothing)  # noqa: S603  # ours


_APART = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from allworlds.engines.kernel.users import load_native; load_native()"
)

__all__ = ["compile_apart", "is_kept", "load_native"]
