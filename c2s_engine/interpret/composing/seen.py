"""What can be watched of what another does, as actions of the specs."""

from __future__ import annotations

import re
from collections.abc import Mapping

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Trigger

SEEN = {
    "brake": ("brake", "stop"),
    "brake_stop": ("stop", "brake"),
    "stop": ("stop",),
    "start": ("start", "accelerate"),
    "turn": ("turn_left", "turn_right"),
    "lane_change": ("lane_change", "cut_out", "cut_in"),
    "cut_in": ("cut_in",),
    "cut_out": ("cut_out", "lane_change"),
    "cross_road": ("cross_road",),
}
"""What can be watched of an event, as actions of the specs."""

DONE = SEEN | {"swerve": ("swerve",), "accelerate": ("accelerate",), "oncoming": ("oncoming",), "drift": ("drift",)}
DONE |= {"overtake": ("overtake",), "go_straight": ("go_straight",), "evade": ("lane_change", "swerve")}
INTO = re.compile(
    r"^(?:enter|reach|arrive at|drive into|be in|get to|come to) (?:the |an? )?(?:junction|intersection|crossroads?)"
)
MARKS = frozenset(("when", "once", "as", "after"))
"""What joins to a clause the one about what is awaited."""
ENTERS = frozenset(("travel", "go_straight", "cross_path", "turn"))


def shown(scene: Scene, awaited: Event, of: str, others: Mapping[str, ObjectSpec | EgoSpec]) -> Trigger | None:
    """The trigger for what is awaited, where the other has a phase that shows it."""
    own = [p.action for p in others[of].phases] if of in others else []
    action = next((a for a in SEEN.get(awaited.act, ()) if a in own), None)
    return Trigger(kind="action", of=of, action=action) if action is not None else None  # type: ignore[arg-type]
