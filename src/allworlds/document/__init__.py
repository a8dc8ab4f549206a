"""A document, described once: the class of a result names its keys, their types and meanings.

A result is a frozen :class:`Document`: its fields are the keys of its JSON object, in their order,
each annotated with its type and, by :func:`about`, with one line of meaning.  From the same class
come the JSON (:meth:`Document.to_json`), the strict reading (:func:`taken`), the JSON Schemas and
the reference of keys.

With ``@with_options(Request)`` a class has a key for each option of a request, too, whose type and
meaning stand beside the option.  A method with ``@computed`` is a key that follows from the fields,
after which it stands: its type is that of the annotation, its meaning the docstring.

Three things are said beside a type:

``key: T | UnsetType = UNSET``
    may be missing in the object;
``key: IfAny[T]``
    is missing while it is None or empty;
``name: NotInDocument[T]``
    belongs to the result in Python, and is no key.
"""
