"""The messages between an explorer and the harness: small frozen values, nothing else.

An explorer is a **generator function** ``explore(first)``.  It gets percepts, yields actions
and returns an answer; it never holds a world.  Turning is free and has no action of its own:
it is folded into the next :class:`Move`, or into ``here`` of the answer.

``percept``, ``actions``, ``answers``, ``transcript``
    percepts, actions, answers about the world, and the log of a run;
``choices``
    the choices of an explorer: policies, and every schedule in turn;
``player``
    an explorer as the harness calls it;
``playing``, ``log``
    one run, played to its end, and the log that remains of it;
``faults``
    what went wrong with an explorer that is no generator;
``user_code``, ``importing``, ``model_calls``
    how code of the user's is named and found; how it is loaded; how a model is called.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.protocol.actions import (
        Action as Action,
        Drop as Drop,
        Move as Move,
        Percept as Percept,
        Pick as Pick,
        Write as Write,
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
        Schedule as Schedule,
        ScheduledChoices as ScheduledChoices,
        a_schedule as a_schedule,
        are_due as are_due,
        next_script as next_script,
        policy_named as policy_named,
    )
    from allworlds.protocol.faults import (
        ANSWER_TIMEOUT as ANSWER_TIMEOUT,
        BeyondRecord as BeyondRecord,
        ExplorerFault as ExplorerFault,
        IllegalAction as IllegalAction,
    )
    from allworlds.protocol.importing import (
        START_TIMEOUT as START_TIMEOUT,
        SourceText as SourceText,
        attribute_of as attribute_of,
        bytes_of as bytes_of,
        imported as imported,
        limit_calls as limit_calls,
        limited_loading as limited_loading,
        module_file as module_file,
        module_named as module_named,
        module_of_text as module_of_text,
        points_of as points_of,
        text_of as text_of,
        tried as tried,
    )
    from allworlds.protocol.player import Player as Player, Told as Told
    from allworlds.protocol.playing import (
        A_QUOTIENT as A_QUOTIENT,
        A_VALUE as A_VALUE,
        AN_ACTION as AN_ACTION,
        AN_ESTIMATE as AN_ESTIMATE,
        BUILT as BUILT,
        FREE as FREE,
        NO_MAP as NO_MAP,
        Record as Record,
        TableWorld as TableWorld,
        integers as integers,
        numbers_of as numbers_of,
        percept_of as percept_of,
        play_run as play_run,
    )
    from allworlds.protocol.transcript import (
        AtStart as AtStart,
        Dropped as Dropped,
        Moved as Moved,
        Picked as Picked,
        Transcript as Transcript,
        Wrote as Wrote,
        action_from_json as action_from_json,
    )
    from allworlds.protocol.user_code import (
        Argument as Argument,
        LocalCode as LocalCode,
        OtherText as OtherText,
        Role as Role,
        UserCode as UserCode,
        arguments_of as arguments_of,
        as_recorded as as_recorded,
        called as called,
        pairs_in as pairs_in,
    )
else:
    open_door(__name__)
