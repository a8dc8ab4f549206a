"""What is written about run directories."""

from typing import TypeAlias

from allworlds.documents.checks import CheckDocument
from allworlds.documents.questions import WorstDocument

MergeDocument: TypeAlias = CheckDocument | WorstDocument
"""What 'merge' writes: the report of the verb whose shards were joined."""
