"""Code of an explorer in which the user interrupts."""

from allworlds import Move


class Unshown(Exception):
    """Whoever shows it is interrupted."""

    def __str__(self):
        raise KeyboardInterrupt


def interrupted_at_its_close(first):
    """Walk on and on; whoever closes it is interrupted."""
    try:
        while True:
            yield Move(0)
    finally:
        raise KeyboardInterrupt
