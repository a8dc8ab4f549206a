"""Every verb says what it is recorded to say."""

import importlib.util
from pathlib import Path

HERE = Path(__file__).parent


def recorder():
    spec = importlib.util.spec_from_file_location("record", HERE / "record.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_record_has_its_command():
    record = recorder()
    assert sorted(path.stem for path in record.RECORDS.iterdir()) == sorted(record.COMMANDS)
