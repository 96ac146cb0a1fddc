"""The forms of change that a turn may have, in the order in which they are tried."""

from c2s_engine.interpret.change_forms import Form
from c2s_engine.interpret.change_looks import blueprint, uncovered
from c2s_engine.interpret.change_motion import distance, rate, reaction, sides
from c2s_engine.interpret.change_objects import remove, retype
from c2s_engine.interpret.change_read import acting, standing
from c2s_engine.interpret.change_scene import ending, length, own_lane, road, setting
from c2s_engine.interpret.change_speed import speed, speed_difference, walked

FORMS: tuple[Form, ...] = (
    ending,
    length,
    blueprint,
    uncovered,
    own_lane,
    retype,
    remove,
    speed_difference,
    rate,
    acting,
    speed,
    distance,
    setting,
    road,
    standing,
    walked,
    sides,
    reaction,
)
