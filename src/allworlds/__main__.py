"""The command line, started as ``python -m allworlds``."""

from allworlds.cli import main

if __name__ == "__main__":
    main()
