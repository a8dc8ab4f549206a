"""The paper's figures, drawn anew from runs of this program: the verb ``figure``.

Every figure is computed before it is drawn, and its data stand beside it as CSV; what is drawn was
checked (a proof that two worlds are twins, or runs that were judged).  matplotlib, from the extra
``figures``, is imported when something is drawn.

``figure_request``
    what is asked for;
``figure_table``
    **the** table of the figures;
``drawn``
    what every figure has: a verdict, data, a caption and a drawing;
``twins``, ``augmentation``, ``holes``
    Fig. 1, Fig. 2 and Fig. 3 of the paper;
``bounds``
    the exact worst cases beside the bound, the optimum and what is known from below;
``canvas``
    maps as matplotlib draws them, darts in their cyclic order;
``figure_telling``
    what is told of a figure.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.evidence.figures.figure_request import FigureRequest as FigureRequest
    from allworlds.evidence.figures.figure_table import figure as figure
else:
    open_door(__name__)
