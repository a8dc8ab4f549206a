import os
import platform
from importlib.metadata import version

from allworlds.version import host


def test_a_host_is_what_python_says_of_it():
    told = host()
    assert told.name == platform.node()
    assert told.system == os.uname().sysname
    assert told.machine == os.uname().machine
    assert told.cores == os.cpu_count()
    assert told.python == platform.python_version()
    assert told.numba == version("numba")
    assert told.load >= 0
    assert isinstance(told.processor, str)
