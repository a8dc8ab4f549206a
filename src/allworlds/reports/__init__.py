"""Results for people and for other programs; each form of report is loaded on first use.

``telling``
    what a result says, once, in parts that every form of a report can show;
``tellings``
    a module for each verb, which makes the telling of its result;
``plain_text``, ``web``
    a telling as a text, and the parts of a web page; they know no verb;
``formats``, ``format_table``, ``file_format``
    the files that results can be written to, a module for each; their table; what a format is;
``rows``, ``world_rows``
    rows for programs, and those of costs in single worlds and runs;
``rendering``
    the telling of a result by its verb, and its texts;
``drawing``, ``scenes``, ``tours``, ``cost_curve``
    pictures of maps, of walks and of costs, and walks to show worlds by;
``text_layout``, ``markup``, ``project``
    what forms share: laws in a line each, tables and paragraphs, elements, the folder of files;
``schemas``
    the schemas of all documents;
``notebook``
    results as notebooks and ``print`` show them;
``play``
    the page in which the reader is the robot.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.reports.drawing.layout import Layout as Layout, layout as layout
    from allworlds.reports.drawing.scene import scene_of as scene_of
    from allworlds.reports.drawing.standalone import Drawing as Drawing, draw as draw
    from allworlds.reports.format_table import (
        FORMATS as FORMATS,
        content_of as content_of,
        ensure_possible as ensure_possible,
        file_of as file_of,
        formats_of as formats_of,
    )
    from allworlds.reports.play.page import game as game
    from allworlds.reports.rendering import (
        brief as brief,
        finding_in_words as finding_in_words,
        tag as tag,
        text as text,
    )
    from allworlds.reports.text_layout import table as table
else:
    open_door(__name__)
