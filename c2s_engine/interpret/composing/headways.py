"""Triggers by a time gap ("when the headway falls below 1 s"): distances at the speed of who is behind."""

from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.specs import EgoSpec


def by_headway(scene: Scene, ego: EgoSpec) -> bool:
    """Turn them into distances; whether there was one."""
    told = [e for e in scene.clauses.events if e.trigger is not None and e.trigger["kind"] == "headway"]
    assumed = ego.speed if isinstance(ego.speed, int | float) else sum(ego.speed) / 2 if ego.speed else 0.0
    for event in told:
        assert event.trigger is not None
        behind = event.agent if scene.where(event.agent).rel == "behind" else scene.cast.ego
        speed = scene.speeds.get(behind)
        metres = event.trigger["value"] * ((speed[0] + speed[1]) / 2 if speed else assumed)
        event.trigger |= {"kind": "distance", "value": max(1.0, round(metres, 1))}
    return bool(told)
