"""Explorers: generator functions that are written against the protocol alone."""
