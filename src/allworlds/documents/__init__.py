"""Documents: the description of every result, once, as a class.

``document``
    a document: its keys, their types and meanings, and its JSON;
``shown``
    values that show themselves, and the registry of those who write each form.
"""
