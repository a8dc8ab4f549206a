"""Documents: the description of every result, once, as a class.

``document``
    a document: its keys, their types and meanings, and its JSON;
``report``
    the document that a verb writes, and who made it, where and when;
``reading``
    the strict reading of a JSON value as a value of a type;
``shown``
    values that show themselves, and the registry of those who write each form.
"""
