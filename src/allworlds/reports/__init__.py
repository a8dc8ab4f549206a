"""Results as people and other programs read them; each report is loaded when it is asked for.

A verb's text is a function from a result and a width, which the table of the verbs names.

The tables of the files that results can be written to are in the module ``rendering``.  Modules
that end in ``_text`` are the texts of the verbs, those that end in ``_words`` parts of them.  Pages
are in ``html``, the page in which the reader is the robot in ``play``, pictures in ``drawing``.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.reports.drawing.layout import Layout as Layout, layout as layout
    from allworlds.reports.drawing.scene import scene_of as scene_of
    from allworlds.reports.drawing.text import draw as draw
    from allworlds.reports.event_lines import (
        Event as Event,
        FindingEvent as FindingEvent,
        LevelEvent as LevelEvent,
        NoticeEvent as NoticeEvent,
        ProgressEvent as ProgressEvent,
        StageEvent as StageEvent,
        UnitEvent as UnitEvent,
        VerdictEvent as VerdictEvent,
    )
    from allworlds.reports.html.frame import Page as Page, counts as counts
    from allworlds.reports.html.viewer import figure as figure
    from allworlds.reports.junit import JUnitCase as JUnitCase, junit_text as junit_text
    from allworlds.reports.markup import tag as tag
    from allworlds.reports.rendering import (
        FORMATS as FORMATS,
        PAGE as PAGE,
        brief as brief,
        ensure_drawable as ensure_drawable,
        file_of as file_of,
        finding_in_words as finding_in_words,
        page_of as page_of,
        text as text,
        written as written,
    )
    from allworlds.reports.text_layout import (
        entry as entry,
        in_lines as in_lines,
        interruption as interruption,
        table as table,
    )
else:
    open_door(__name__)
