"""Failures of processes for which no explorer is to blame."""


class HarnessError(RuntimeError):
    """Raised if a process without user's code has failed, so that no explorer is to blame."""


class Unsettled(Exception):
    """Raised if processes are lost again and again, so that there is no verdict on the explorer."""


class GuardianLost(HarnessError, Unsettled):
    """Raised if the process that starts all others is killed or stopped, or does not start."""
