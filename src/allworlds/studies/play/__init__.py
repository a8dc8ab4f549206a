"""The reader as an explorer: percepts come, actions go.

``playing``
    the verb;
``costs``
    the costs of others in the world that is played.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.play.costs import Walker as Walker
    from allworlds.studies.play.playing import (
        Play as Play,
        PlayRequest as PlayRequest,
        play as play,
    )
else:
    open_door(__name__)
