"""One player, as its referee sees it: it is started, heard, and perhaps lost."""

from __future__ import annotations

import time
from collections.abc import Callable

from allworlds.engines.isolation.failures import HarnessError, Unsettled
from allworlds.engines.isolation.jobs import PlayerSetup
from allworlds.engines.isolation.messages import ExplorerDescription
from allworlds.engines.isolation.process import GRACE, NO_RUN, Garbled, Guardian, Process
from allworlds.engines.isolation.process_tree import Stops
from allworlds.engines.units.effort import POLL
from allworlds.explorers import is_library, is_program
from allworlds.inputs import InputError, show
from allworlds.judging import Fault, Log

ANSWER = "an action, or an estimate at the end"

WORLDS = "allworlds.engines.isolation.world_player"
"""The module by which a player plays in worlds; a nursery loads it when it is asked to."""

STOPPED = "a process was stopped again and again, perhaps by the explorer"
"""The sentence about processes that stand still for a reason that is not known."""


class PlayerLost(Exception):
    """Raised if a player was silent for too long, or has died.

    Attributes:
        law: ``timeout`` or ``crash``.
        seen: a sentence about the loss.
        machine: whether the machine may be the cause.
        number: of the run in progress; None if there was none.
        stopped: whether it was found stopped, so that it is not known who is silent.
    """

    stopped = False

    def __init__(self, law: str, seen: str, number: int | None, *, machine: bool) -> None:
        super().__init__(seen)
        self.law, self.seen, self.number, self.machine = law, seen, number, machine

    def log(self, kind: type[Fault]) -> Log:
        """The log that stands for that of the lost run."""
        return Log((), (), kind(self.law, ANSWER, self.seen, "", self.machine))


def start_player(
    guardian: Guardian,
    setup: PlayerSetup,
    hash_seed: int | None = None,
    *,
    in_worlds: bool = False,
) -> tuple[Process, ExplorerDescription]:
    """Start a player, and load its explorer.

    Args:
        guardian: of this process.
        setup: the explorer.
        hash_seed: of the nursery that forks it, and of programs that it starts; None: the guardian
            forks it, whose seed is 0.
        in_worlds: whether it is to play in worlds.

    Raises:
        InputError: if the explorer cannot be loaded.
    """
    # A program is started anew, with addresses of its own.
    parent = guardian
    if hash_seed is not None and not is_program(setup.name):
        parent = guardian.nursery(hash_seed)
        if in_worlds:
            parent.prepare(WORLDS, "load")
    process = Process(parent, "player", setup, hash_seed or 0)
    try:
        return process, _description(process, setup)
    except BaseException:
        process.close()
        raise


def _description(process: Process, setup: PlayerSetup) -> ExplorerDescription:
    stops, deadline = Stops(), time.monotonic() + setup.start_timeout
    while not process.connection.poll(POLL):
        if process.has_ended():
            raise _not_imported(process, setup)
        if stops.too_many(process.pid):
            raise Unsettled(STOPPED)
        if time.monotonic() > deadline:
            loads = "load" if is_library(setup.name) else "import"
            raise InputError(
                f"{show(setup.name)} does not {loads}: it was at it for {setup.start_timeout:g} s"
            )
    try:
        description = process.receive()
    except EOFError:
        raise _not_imported(process, setup) from None
    assert isinstance(description, ExplorerDescription)
    return description


def _not_imported(process: Process, setup: PlayerSetup) -> InputError:
    limit = "" if setup.memory is None else f", with memory limited to {setup.memory} MB"
    loaded = "loaded" if is_library(setup.name) else "imported"
    return InputError(
        f"a process came to {process.death()[0]} when it {loaded} {show(setup.name)}{limit}"
    )


def receive(
    process: Process, setup: PlayerSetup, alive: Callable[[], None] = lambda: None
) -> object:
    """A player's next message.

    ``alive`` is called at least once, and again while there is none.

    Raises:
        PlayerLost: if it is silent for too long, or has died.
    """
    patience = setup.answer_timeout + (GRACE if is_program(setup.name) else 0.0)
    stops = Stops()
    while True:
        alive()
        ready = process.connection.poll(POLL)
        # A message sent before the silence is still read; but a player may send choices for ever.
        tardy = process.silent_for() > patience + (GRACE if ready else 0.0)
        if tardy or (not ready and stops.too_many(process.pid)):
            seen = f"silent for {setup.answer_timeout:g} s"
            lost = PlayerLost("timeout", seen, _number(process), machine=True)
            lost.stopped = stops.seen > 0
            raise lost
        if ready:
            break
        if process.has_ended():
            raise _died(process)
    try:
        return process.receive()
    except Garbled as error:
        raise PlayerLost("crash", str(error), _number(process), machine=False) from None
    except EOFError:
        raise _died(process) from None


def _died(process: Process) -> PlayerLost:
    seen, machine = process.death()
    return PlayerLost("crash", seen, _number(process), machine=machine)


def interference(process: Process, error: HarnessError) -> PlayerLost:
    """The loss of a player that failed out of the explorer's turn, perhaps by its signal."""
    last = (str(error).strip().splitlines() or ["an error"])[-1]
    return PlayerLost("crash", f"{last}, out of its turn", _number(process), machine=True)


def _number(process: Process) -> int | None:
    number = process.beat[0]
    return None if number == NO_RUN else number
