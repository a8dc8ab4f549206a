"""Notations of embedded graphs: one reader and writer a file, found by a table."""
