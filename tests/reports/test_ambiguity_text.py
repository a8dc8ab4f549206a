import pytest

from allworlds.documents.document import replace
from allworlds.maps import named_map
from allworlds.reports.content.sensors import _drawn
from allworlds.reports.formats import text as text_of
from allworlds.studies.ambiguity import census, class_of, twins
from allworlds.world import Position, World


def census_text(census, width):
    return text_of(census, width)


def class_text(found, width):
    return text_of(found, width)


def twins_text(comparison, width):
    return text_of(comparison, width)


def named(name, kind="position"):
    return World.from_json(named_map(name).to_json(), missing=kind)


def flat(text):
    return " ".join(text.split())


def test_twins_are_drawn_with_the_class_of_each_dart_and_a_reason():
    text = twins_text(twins(named("two-loops-plane"), named("two-loops-torus")), 100)
    assert text.startswith("TWINS")
    assert (
        "both are covers with 4 sheets of the same quotient, which has 1 class of darts. Darts of "
        "one class look alike, so no motion tells the worlds apart"
    ) in flat(text)
    assert "World A (genus 0)" in text
    assert " a a a a" in text
    assert text.endswith(
        "classes clockwise  sensed there      times round a vertex\n"
        "a↺                 degree 4, marked                     4"
    )


def test_sheets_of_different_worlds_are_told_apart():
    text = flat(twins_text(twins(named("cycle-3", "none"), named("cycle-4", "none")), 100))
    assert "A is a cover with 6 sheets and B with 8, both of the same quotient" in text


def test_one_world_twice_is_no_pair_of_twins():
    k4 = named("k4")
    assert twins_text(twins(k4, k4), 80).startswith("SAME")
    left = named("fig1-left")
    other = World(left.map, Position(1), 1)
    assert twins_text(twins(left, other), 80).startswith("ALIKE")


def test_separating_motions_stand_beside_what_is_sensed_in_both_worlds():
    text = twins_text(twins(named("cycle-3"), named("cycle-4")), 80)
    assert "by 3 motions, and by no fewer: 0, 1, 1" in text
    assert flat(text.splitlines()[-1]) == "3 move 1 v0, dart 1 degree 2, marked ≠ degree 2"
    assert text.count(" = ") == 3


def test_worlds_that_differ_at_the_start_need_no_motion():
    text = flat(twins_text(twins(named("loop"), named("edge")), 80))
    assert "by the first percepts, before any motion" in text


@pytest.mark.parametrize("kind", ["compass", "directional"])
def test_the_darts_that_bearings_count_to_are_drawn(kind):
    pairs = [("cycle-3", "cycle-4"), ("k4", "k4-torus")]
    for pair in pairs:
        worlds = [named(name, kind) for name in pair]
        drawn = twins_text(twins(*worlds), 80).split("World A")[1].split("World B")
        for world, text in zip(worlds, drawn, strict=True):
            assert text.count("▲") == len(world.lighthouse.references(world.map)) + 1  # the legend
            assert "▲ dart where the bearing is 0" in text


def test_a_class_is_drawn_and_explained():
    text = class_text(class_of(named("k4"), map_class="simple"), 100)
    assert text.startswith(
        "AMBIGUOUS  2 worlds in the class 'simple' look alike, the given one included; all are"
    )
    assert "The given world (genus 0)" in text
    assert "World 2 (genus 1)" in text
    assert "more worlds: --json" not in text


def test_of_a_large_class_some_worlds_are_drawn_and_the_rest_is_not_forgotten():
    whole = class_text(class_of(named("wheel-4")), 100)
    assert "4 more worlds: --json lists them." in whole
    assert "notice" not in whole
    cut = class_text(class_of(named("wheel-4"), limit=2), 100)
    assert "2 of 10 worlds are listed" in cut
    assert cut.startswith("AMBIGUOUS  10 worlds")


def test_a_world_that_can_be_mapped_is_alone():
    text = class_text(class_of(named("cycle-5")), 100)
    assert text.startswith("ALONE")
    assert "a robot can map this world" in text


def test_a_census_is_a_table():
    lines = census_text(census(edges=3), 80).splitlines()
    assert lines[5].split() == ["2", "7", "2", "1", "2"]
    assert lines[4].split() == ["1", "2", "0", "0", "-"]
    assert any(line.startswith("gate") for line in lines)


@pytest.mark.parametrize("counted", [9, 11])
def test_a_mismatch_with_the_source_is_named(counted):
    good = census(edges=2)
    bad = replace(good.rows[1], counted=counted)
    text = census_text(replace(good, rows=(good.rows[0], bad)), 80)
    wrong = f"but the independent count ({good.source}) is {counted}"
    assert f"found 10 rooted maps with 2 edges, {wrong}" in flat(text)
    assert text.count("MISMATCH") == 1
    assert "gate" not in text


def test_a_restricted_census_names_its_universe():
    found = census(edges=1, map_class="simple")
    assert "every map of the class 'simple'" in flat(census_text(found, 80))


def test_the_order_of_sensors_is_drawn_in_lines_of_90_columns():
    names = ["a" * 40, "b" * 47, "c", "d"]
    pairs = [(one, other) for one in names[:2] for other in names[:2]]
    pairs += [(one, "c") for one in names[:2]] + [("c", "d"), *((one, "d") for one in names[:2])]
    assert [*_drawn(pairs, names)] == [f"{names[0]} = {names[1]}", "   c", "      d"]
    names[1] += "b"
    pairs = [(one, other) for one in names[:2] for other in names[:2]]
    assert [*_drawn(pairs, names)] == [f"{names[0]} =", f" = {names[1]}"]
