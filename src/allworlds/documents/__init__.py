"""Documents: one class for each result, which describes its JSON once.

``document``
    the keys of a document, their types and meanings, and its JSON;
``report``
    the document that a verb writes; it names the program and the machine that made it;
``reading``
    the strict reading of a JSON value as a value of a type;
``shown``
    values with a text, a page or a picture, and the registry of the functions that write these.
"""
