"""A function for each claim of ledger.toml: it finds a verdict, and reads no expected one."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[2] / "examples" / "robots"))

from companions import hidden_once, labels, lights, second_robot, to_the_other
from delays import delays, dispersion
from exploring import (
    perpetual_new,
    perpetual_none,
    perpetual_old,
    perpetual_schedulers,
    perpetual_twelve,
    stopping,
)
from holes import hole_lost_update, hole_one, hole_two
from moving_edges import dynamic_facing, dynamic_one, dynamic_two
from oblivious import lcm_counts, naive_three, naive_two, rule_sets_all, rule_sets_five
from rotor import rotor_model, rotor_worst
from shrink import shrink_named, shrink_positive, shrink_worlds, shrink_zero
from tokens import tokens_facing, tokens_more, tokens_one_way
