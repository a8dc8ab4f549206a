"""The paper's figures, drawn from runs of this program, each with its data beside it as CSV.

    python papers/minimal_information/figures.py 1|2|3 [--out FILE.svg]

Exit code 0: the figure's claims were found true; 1: they were not.  Figure 3 takes some minutes.
"""

import argparse
import sys
from pathlib import Path

from drawn import write
from figure_1 import figure_1
from figure_2 import figure_2
from figure_3 import figure_3

FIGURES = {"1": figure_1, "2": figure_2, "3": figure_3}


def main() -> int:
    """Draw the figure that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("figure", choices=FIGURES)
    parser.add_argument("--out", type=Path, help="the picture: .svg, .png or .pdf")
    asked = parser.parse_args()
    return (
        0 if write(FIGURES[asked.figure](), asked.out or Path(f"figure-{asked.figure}.svg")) else 1
    )


if __name__ == "__main__":
    sys.exit(main())
