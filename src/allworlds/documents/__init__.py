"""Documents: classes that describe each result once.

``document``
    the keys of a document, their types and meanings, and its JSON;
``report``
    the document that a verb writes, and its maker, place and time;
``reading``
    the strict reading of a JSON value as a value of a type;
``shown``
    values that can be shown, and the registry of the writers of each form.
"""
