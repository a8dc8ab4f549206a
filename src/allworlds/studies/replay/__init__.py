"""Replay of a finding: ``replaying`` says whether it still stands."""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.studies.replay.replay_request import ReplayRequest as ReplayRequest
    from allworlds.studies.replay.replaying import Replay as Replay, replay as replay
else:
    open_door(__name__)
