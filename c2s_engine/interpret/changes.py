"""The forms of change that a turn may have, in the order in which they are tried."""

from c2s_engine.interpret.change_forms import Form
from c2s_engine.interpret.change_motion import behaviour, distance, sides, speed
from c2s_engine.interpret.change_objects import more, remove, retype
from c2s_engine.interpret.change_scene import length, road, setting

FORMS: tuple[Form, ...] = (length, more, retype, remove, speed, distance, setting, sides, road, behaviour)
