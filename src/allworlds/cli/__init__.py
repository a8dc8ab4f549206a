"""The command line: options in, text or JSON out; every decision is made elsewhere."""

from allworlds.cli.app import call, main

__all__ = ["call", "main"]
