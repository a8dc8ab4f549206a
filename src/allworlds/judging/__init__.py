"""One run: played, judged, kept as a finding, explained.

``episode``, ``endings``
    the one place where a world and an explorer meet, and the ways in which a run can end;
``tasks``, ``walk_log``
    what counts as done, and the log that decides it;
``laws``
    the judge: an answer and a log against the truth, law by law;
``findings``
    a refuting run as a value that can be run again;
``explanations``
    a finding in plain words.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.judging.endings import (
        Answered as Answered,
        Ending as Ending,
        Fault as Fault,
        Over as Over,
        Said as Said,
        UncheckedAmbiguous as UncheckedAmbiguous,
        UncheckedAnswer as UncheckedAnswer,
        UncheckedValue as UncheckedValue,
        Undecided as Undecided,
        answered as answered,
    )
    from allworlds.judging.episode import (
        AroundExplorer as AroundExplorer,
        Environment as Environment,
        Episode as Episode,
        Log as Log,
        default_step_budget as default_step_budget,
        followed as followed,
        play as play,
        unchecked as unchecked,
    )
    from allworlds.judging.explanations.explanation import (
        Explanation as Explanation,
        chiral_worlds as chiral_worlds,
        chirality_in as chirality_in,
        explain as explain,
        may_be_misread as may_be_misread,
        narrowest_class as narrowest_class,
        needs_a_chiral_world as needs_a_chiral_world,
        trial_worlds as trial_worlds,
    )
    from allworlds.judging.explanations.story import (
        Belief as Belief,
        Spending as Spending,
        Story as Story,
        Walked as Walked,
    )
    from allworlds.judging.findings.asked_finding import (
        AskedFinding as AskedFinding,
        FindingWords as FindingWords,
        file_name as file_name,
        kept_findings as kept_findings,
        write_finding as write_finding,
    )
    from allworlds.judging.findings.belief import (
        believed_walk as believed_walk,
        find_parting as find_parting,
    )
    from allworlds.judging.findings.finding import (
        Chirality as Chirality,
        Finding as Finding,
        Misreading as Misreading,
        canonical_world as canonical_world,
        place_of as place_of,
    )
    from allworlds.judging.findings.rules import (
        Among as Among,
        AskedRules as AskedRules,
        RecordedRules as RecordedRules,
        Rules as Rules,
    )
    from allworlds.judging.findings.walks import (
        recorded_trail as recorded_trail,
        true_trail as true_trail,
        true_walk as true_walk,
    )
    from allworlds.judging.laws.bounds import (
        Bound as Bound,
        bound_named as bound_named,
        paper_bound as paper_bound,
    )
    from allworlds.judging.laws.case import Case as Case, Violation as Violation
    from allworlds.judging.laws.folding import fold as fold
    from allworlds.judging.laws.invariants import first_wrong as first_wrong
    from allworlds.judging.laws.law_table import (
        ASKED as ASKED,
        JUDGED as JUDGED,
        LAWS as LAWS,
        PRECEDENCE as PRECEDENCE,
        LawName as LawName,
        checked_laws as checked_laws,
        judge as judge,
    )
    from allworlds.judging.laws.second_opinion import same_map as same_map
    from allworlds.judging.tasks import MAP as MAP, Judge as Judge, Task as Task
    from allworlds.judging.walk_log import WalkLog as WalkLog
else:
    open_door(__name__)
