"""Input from outside: checks of values, and requests.

``checks``
    checks of values, and the error that is the user's to mend;
``exit_code``
    what keeps a model from setting the exit code of the process;
``requests``
    requests: what a verb is asked for, as a value.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from allworlds.lazy import open_door

if TYPE_CHECKING:
    from allworlds.inputs.checks import (
        INSTALL as INSTALL,
        LARGEST_SIZE as LARGEST_SIZE,
        SHOWN as SHOWN,
        InputError as InputError,
        a_path as a_path,
        a_text as a_text,
        an_integer as an_integer,
        are_plain as are_plain,
        at_most as at_most,
        did_you_mean as did_you_mean,
        ensure_installed as ensure_installed,
        existing_file as existing_file,
        in_file as in_file,
        integer as integer,
        integer_of as integer_of,
        is_loop_of_links as is_loop_of_links,
        lack_of as lack_of,
        let_users_interrupt as let_users_interrupt,
        no_file as no_file,
        one_of as one_of,
        parse_json as parse_json,
        read_text as read_text,
        seconds_of as seconds_of,
        show as show,
    )
    from allworlds.inputs.exit_code import (
        keep_exit_code as keep_exit_code,
        release_exit_code as release_exit_code,
    )
    from allworlds.inputs.requests import (
        AS_IN_PYTHON as AS_IN_PYTHON,
        EFFORT as EFFORT,
        OUTPUT as OUTPUT,
        PANELS as PANELS,
        RULES as RULES,
        SCOPE as SCOPE,
        Argument as Argument,
        Field as Field,
        Named as Named,
        Option as Option,
        Request as Request,
        Taken as Taken,
        answer as answer,
        answers as answers,
        as_json as as_json,
        fields_of as fields_of,
        given_again as given_again,
        in_scope as in_scope,
        meant as meant,
        remembered as remembered,
        takes_fields as takes_fields,
        told_by as told_by,
        values_of as values_of,
        without_effort as without_effort,
    )
else:
    open_door(__name__)
