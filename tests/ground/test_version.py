import os
import platform
from importlib.metadata import version

from allworlds import version as version_module
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


def test_without_its_list_of_processors_a_system_names_its_own(monkeypatch, tmp_path):
    monkeypatch.setattr(version_module, "Path", lambda _: tmp_path / "cpuinfo")
    monkeypatch.setattr(platform, "processor", lambda: "ours")
    assert host().processor == "ours"
    (tmp_path / "cpuinfo").write_text("model\t: 1\nmodel name\t: Fast One\nmodel name\t: Two\n")
    assert host().processor == "Fast One"
    (tmp_path / "cpuinfo").write_text("processor\t: 0\n")
    assert host().processor == "ours"
