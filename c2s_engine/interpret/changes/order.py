"""The forms of change that a turn may have, in the order in which they are tried."""

from c2s_engine.interpret.changes.acts import gap_of_act
from c2s_engine.interpret.changes.approach import start_distance
from c2s_engine.interpret.changes.beside import abreast
from c2s_engine.interpret.changes.bounds import allowed, bound, bounded, contact, lifted
from c2s_engine.interpret.changes.forms import Form
from c2s_engine.interpret.changes.how_many import count
from c2s_engine.interpret.changes.looks import blueprint
from c2s_engine.interpret.changes.motion import begun_by, distance, rate, reaction, sides
from c2s_engine.interpret.changes.objects import remove, retype
from c2s_engine.interpret.changes.roadsides import roadside
from c2s_engine.interpret.changes.scene import ending, length, own_lane, road, setting
from c2s_engine.interpret.changes.scene_clauses import acting, standing
from c2s_engine.interpret.changes.signs import sign
from c2s_engine.interpret.changes.speed import kept, speed, speed_difference, walked
from c2s_engine.interpret.changes.swap import swapped
from c2s_engine.interpret.changes.timing import shifted

FORMS: tuple[Form, ...] = (
    lifted,
    allowed,
    bound,
    bounded,
    contact,
    ending,
    length,
    blueprint,
    own_lane,
    start_distance,
    abreast,
    sign,
    roadside,
    count,
    swapped,
    retype,
    remove,
    kept,
    shifted,
    speed_difference,
    rate,
    gap_of_act,
    acting,
    speed,
    distance,
    setting,
    road,
    standing,
    walked,
    sides,
    begun_by,
    reaction,
)
