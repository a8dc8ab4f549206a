"""The reader as an explorer, ``playing``: percepts come, actions go."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.play.playing import (
        Play as Play,
        PlayRequest as PlayRequest,
        play as play,
    )
else:
    open_door(__name__)
