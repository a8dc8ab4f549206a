"""What an explorer and the harness say to each other: small frozen values, nothing else.

An explorer is a **generator function** ``explore(first)``.  It gets percepts, yields actions
and returns an answer; it never holds a world.  Turning is free and has no action of its own:
it is folded into the next :class:`Move`, or into ``here`` of the answer.

``percept``, ``actions``, ``answers``, ``transcript``
    what is sensed, what is done, what is said of the world, and the log of it;
``choices``
    where an explorer is free: policies, and every answer in turn;
``player``
    an explorer as the harness calls it;
``faults``
    what went wrong with an explorer that is no generator.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.protocol.actions import (
        Action as Action,
        Drop as Drop,
        Move as Move,
        Pick as Pick,
        action_numbered as action_numbered,
        number_of as number_of,
    )
    from allworlds.protocol.answers import (
        Ambiguous as Ambiguous,
        Answer as Answer,
        Checkpoint as Checkpoint,
        Estimate as Estimate,
        RootedMap as RootedMap,
    )
    from allworlds.protocol.choices import (
        DEFAULT_POLICY as DEFAULT_POLICY,
        KINDS as KINDS,
        POLICIES as POLICIES,
        SEEDED as SEEDED,
        Choices as Choices,
        Kind as Kind,
        Policy as Policy,
        Schedule as Schedule,
        Schedules as Schedules,
        a_schedule as a_schedule,
        next_script as next_script,
        policy_named as policy_named,
    )
    from allworlds.protocol.faults import (
        ANSWER_TIMEOUT as ANSWER_TIMEOUT,
        ExplorerFault as ExplorerFault,
    )
    from allworlds.protocol.percept import Percept as Percept
    from allworlds.protocol.player import Player as Player
    from allworlds.protocol.transcript import (
        AtStart as AtStart,
        Dropped as Dropped,
        Moved as Moved,
        Picked as Picked,
        Transcript as Transcript,
        action_from_json as action_from_json,
    )
else:
    open_door(__name__)
