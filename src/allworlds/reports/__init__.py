"""Reports: what people read.  Every function here turns a value into text and decides nothing."""

from allworlds.reports.check_text import check_text
from allworlds.reports.count_text import count_text
from allworlds.reports.mutants_text import mutants_text
from allworlds.reports.run_text import finding_text, replay_text, run_text

__all__ = ["check_text", "count_text", "finding_text", "mutants_text", "replay_text", "run_text"]
