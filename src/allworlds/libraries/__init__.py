"""Explorers in shared libraries: the C interface, from the caller's side.

``allworlds.h``
    the interface, which is its own manual;
``header``
    the same for whoever asks for it;
``guarded``
    memory that nobody can write beyond;
``library``
    a library, loaded and looked at;
``explorer``
    its episodes as an explorer's.

Only processes that may run foreign code load a library.
"""

from allworlds.libraries.explorer import NativeExplorer, threads_left, threads_now
from allworlds.libraries.header import Header, header_text, native
from allworlds.libraries.library import KINDS_OF_ACTION, ROOM, VERSION, Library, library_path

__all__ = [
    "KINDS_OF_ACTION",
    "ROOM",
    "VERSION",
    "Header",
    "Library",
    "NativeExplorer",
    "header_text",
    "library_path",
    "native",
    "threads_left",
    "threads_now",
]
