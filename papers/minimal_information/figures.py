"""The paper's figures, drawn from runs of this program, each with its data beside it as CSV.

    python papers/minimal_information/figures.py 1|2|3 [--out FILE.svg] [--graphs K] [--places P]

Exit code 0: the figure's claims were found true; 1: they were not.  Figure 3 takes some 80 s on two
cores, and after Ctrl-C it is drawn of the sizes that are finished.
"""

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from drawn import Drawn, write
from figure_1 import figure_1
from figure_2 import figure_2
from figure_3 import figure_3

FIGURES: dict[str, Callable[..., Drawn]] = {"1": figure_1, "2": figure_2, "3": figure_3}


def main() -> int:
    """Draw the figure that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("figure", choices=FIGURES)
    parser.add_argument("--out", type=Path, help="the picture: .svg, .png or .pdf")
    parser.add_argument("--graphs", type=int, help="of figure 3, of each size [default: 3]")
    parser.add_argument("--places", type=int, help="of figure 3, the most in a graph [default: 2]")
    asked = parser.parse_args()
    given = {"worlds": asked.graphs, "places": asked.places}
    options = {name: value for name, value in given.items() if value}
    if options and asked.figure != "3":
        parser.error("--graphs and --places are of figure 3")
    made = FIGURES[asked.figure](**options)
    return 0 if write(made, asked.out or Path(f"figure-{asked.figure}.svg")) else 1


if __name__ == "__main__":
    sys.exit(main())
