"""A report as one page that needs nothing else: no network, no other file, no script to be read.

``page``, ``comparison``, ``claims``
    whole documents, of a check, a comparison and the ledger: the entries;
``frame``
    what every document has round it;
``findings``, ``walk``
    a finding with its pictures, and its walk as a list of steps;
``style.css``, ``script.js``
    what the page looks like, and the keys that step along a walk.
"""

from allworlds.reports.html.claims import claims_page
from allworlds.reports.html.comparison import comparison_page
from allworlds.reports.html.findings import figure
from allworlds.reports.html.frame import Own, framed
from allworlds.reports.html.page import page

__all__ = ["Own", "claims_page", "comparison_page", "figure", "framed", "page"]
