"""Documents: the description of every result, once, as a class.

``document``
    a document: its keys, their types and meanings, and its JSON.
"""
