"""The command line: options in, text or JSON out; every decision is made elsewhere."""

from allworlds.cli.app import main

__all__ = ["main"]
