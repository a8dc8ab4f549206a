"""The page on sensors has what the program finds."""

import pytest

import sensor_table

TEXT = sensor_table.PAGE.read_text(encoding="utf-8")


def test_rows_of_the_table_are_what_the_command_finds():
    report = sensor_table.found(("door", "word:1", "word:01*"))
    rows = sensor_table.table(report).splitlines()[2:]
    assert len(rows) == 3
    assert all(f"{row}\n" in TEXT for row in rows)
    other = sensor_table.table(sensor_table.found(("word:1",), edges=1))
    assert other.splitlines()[-1] not in TEXT


@pytest.mark.long
def test_the_table_and_the_pictures_are_those_that_are_written_anew():
    found = sensor_table.found()
    again = sensor_table.written(TEXT, "table", sensor_table.table(found))
    assert sensor_table.written(again, "twins", sensor_table.pictures(found)) == TEXT
