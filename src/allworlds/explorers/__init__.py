"""Explorers: the built-in ones, and the loading of the user's.

``builtin``
    the explorers that come with the package, one a module;
``names``
    names of explorers, and what is known by a name alone;
``subject``
    an explorer as a check speaks of it;
``loading``, ``functions``
    its code, found by its name, in a process that may run users' code; a function, with the fewest
    imports;
``asked``
    the part of a request that names one;
``spelling``
    names that are nearly those of an explorer;
``digest``
    a digest of an explorer's code, independent of its name;
``source_line``
    the file and the line of one;
``program``, ``program_lines``
    a program in any language behind a pipe, and the lines between;
``translated``
    an explorer with one wrong convention, and a translator that puts it right;
``command_words``
    the words of its command: an interpreter and its script;
``shared_library``
    explorers in shared libraries: the C interface;
``skeletons``
    explorers to begin with, in several languages.
"""

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.explorers.asked import (
        DEFAULT_EXPLORER as DEFAULT_EXPLORER,
        AskedExplorer as AskedExplorer,
        ExplorersWords as ExplorersWords,
        ProgramWords as ProgramWords,
    )
    from allworlds.explorers.builtin.algorithm1 import (
        Algorithm1 as Algorithm1,
        Walk as Walk,
        algorithm1 as algorithm1,
    )
    from allworlds.explorers.builtin.depth_first import dfs as dfs
    from allworlds.explorers.builtin.dudek91 import dudek91 as dudek91
    from allworlds.explorers.builtin.explorer_table import BUILT_IN as BUILT_IN, BuiltIn as BuiltIn
    from allworlds.explorers.builtin.folded_log import OPEN as OPEN, FoldedLog as FoldedLog
    from allworlds.explorers.builtin.folding import (
        explore_folding as explore_folding,
        folding as folding,
        folding_oldest as folding_oldest,
        way as way,
    )
    from allworlds.explorers.builtin.quotient import quotient as quotient
    from allworlds.explorers.builtin.shield import Shield as Shield
    from allworlds.explorers.builtin.undirected import (
        algorithm1_cluster as algorithm1_cluster,
        algorithm1_natural as algorithm1_natural,
    )
    from allworlds.explorers.digest import (
        content_digest as content_digest,
        not_alike as not_alike,
        with_content as with_content,
    )
    from allworlds.explorers.functions import Function as Function
    from allworlds.explorers.loading import load as load, source_of as source_of
    from allworlds.explorers.names import (
        SHIELD as SHIELD,
        TRANSLATED as TRANSLATED,
        command_of as command_of,
        is_library as is_library,
        is_program as is_program,
        named_on_command_line as named_on_command_line,
        names_explorer as names_explorer,
        own_bound as own_bound,
        own_lighthouse as own_lighthouse,
    )
    from allworlds.explorers.program import Program as Program
    from allworlds.explorers.shared_library.library import (
        INTERFACE_VERSION as INTERFACE_VERSION,
        header_text as header_text,
    )
    from allworlds.explorers.shared_library.native import (
        NativeExplorer as NativeExplorer,
        threads_left as threads_left,
        threads_now as threads_now,
    )
    from allworlds.explorers.skeletons.languages import (
        LANGUAGES as LANGUAGES,
        Language as Language,
        templates as templates,
        templates_in as templates_in,
    )
    from allworlds.explorers.source_line import (
        SourceLine as SourceLine,
        files_of_explorer as files_of_explorer,
        place_of_explorer as place_of_explorer,
    )
    from allworlds.explorers.spelling import short_names as short_names, whole_name as whole_name
    from allworlds.explorers.subject import (
        HASH_SEED as HASH_SEED,
        Subject as Subject,
        built_in as built_in,
        in_process_subject as in_process_subject,
        subject_known as subject_known,
        with_shield as with_shield,
        with_translator as with_translator,
    )
    from allworlds.explorers.translated import CONVENTIONS as CONVENTIONS
else:
    open_door(__name__)
