"""The forms of change that a turn may have, in the order in which they are tried."""

from c2s_engine.interpret.changes.approach import start_distance
from c2s_engine.interpret.changes.beside import abreast, each_lane
from c2s_engine.interpret.changes.forms import Form
from c2s_engine.interpret.changes.how_many import count, fewer
from c2s_engine.interpret.changes.limits import by_the_limit
from c2s_engine.interpret.changes.looks import blueprint, uncovered
from c2s_engine.interpret.changes.members import member
from c2s_engine.interpret.changes.motion import distance, rate, reaction, sides
from c2s_engine.interpret.changes.objects import remove, retype
from c2s_engine.interpret.changes.roadsides import roadside
from c2s_engine.interpret.changes.scene import ending, length, own_lane, road, setting
from c2s_engine.interpret.changes.signs import sign
from c2s_engine.interpret.changes.speed import kept, speed, speed_difference, still, walked
from c2s_engine.interpret.changes.steps import step
from c2s_engine.interpret.changes.swap import swapped
from c2s_engine.interpret.changes.timing import at_once, cancelled, shifted
from c2s_engine.interpret.changes.told import acting, standing

FORMS: tuple[Form, ...] = (
    ending,
    step,
    length,
    blueprint,
    uncovered,
    own_lane,
    start_distance,
    each_lane,
    abreast,
    sign,
    roadside,
    member,
    fewer,
    count,
    swapped,
    retype,
    remove,
    still,
    kept,
    at_once,
    cancelled,
    shifted,
    by_the_limit,
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

ADDING: tuple[Form, ...] = (each_lane, abreast, sign, acting, setting, road, standing)
"""The forms that a demand for somebody new may have."""
