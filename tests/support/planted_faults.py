"""Faults for the processes of a check: a guardian is let call one of these functions.

All that it forks later has the fault: see ``Guardian.prepare``.
"""

import os
import signal

from allworlds.engines.isolation.guardian import _Guardian
from allworlds.engines.isolation.player_pair import PlayerPair


def one_seed():
    """Fork all players of one process."""
    PlayerPair._seed = lambda *_: None


def who_is_stopped_stays_so():
    """Do not let a child go on that was stopped."""
    _Guardian._heed = lambda *_: None


def wait_for_a_child_that_was_stopped():
    """Stand still, as a process does that starts a program, until the child goes on."""
    child = os.fork()
    if not child:
        os.kill(os.getpid(), signal.SIGSTOP)
        os._exit(0)
    os.waitpid(child, 0)
