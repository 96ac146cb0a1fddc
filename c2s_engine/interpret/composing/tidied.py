"""The phases of ego without repetitions, and without those that another one already says."""

from c2s_engine.structure.specs import Phase, PlaceSpec


def tidy(phases: list[Phase], place: PlaceSpec) -> list[Phase]:
    """Each phase once, and only what comes of it where one leads into the next."""
    found: list[Phase] = []
    for phase in phases:
        last = found[-1] if found else None
        there = last and last.action == phase.action and last.target == phase.target
        if last and there and not (last.side and phase.side and last.side != phase.side):
            continue
        resumes = phase.action == "follow" and last and last.action in ("stop", "wait")
        once = phase.action in ("turn_left", "turn_right", "go_straight", "u_turn", "follow", "overtake")
        if once and not resumes and any(p.action == phase.action and p.target == phase.target for p in found):
            continue
        to_a_stop = last and last.action == "brake" and not (phase.trigger or last.speed or last.duration)
        if last and to_a_stop and phase.action == "stop":
            rate, target = phase.rate or last.rate, phase.target or last.target  # it brakes to a stop
            found[-1] = phase.model_copy(update={"rate": rate, "target": target, "trigger": last.trigger})
            continue
        if last and last.action == "lose_control" and phase.action in ("leave_road", "oncoming", "drift"):
            found[-1] = phase
            continue
        if last and last.action == "lane_change" and phase.action == "drift" and phase.side == last.side:
            continue
        if last and last.action == "stop" and phase.action == "brake" and phase.speed is phase.trigger is None:
            continue
        if last and last.action == "enter_road" and phase.action in ("start", "lane_change"):
            continue
        if last and last.action in ("oncoming", "drift", "leave_road") and phase.action == "lose_control":
            continue
        if phase.action == "stationary" and found:
            continue
        found.append(phase)
    sets_off = ("enter_road", "start", "turn_left", "turn_right", "go_straight", "reverse")
    if len(found) > 1 and found[0].action == "stationary" and found[1].action in sets_off:
        found = found[1:]
    turns = [p for p in found if p.action in ("turn_left", "turn_right", "u_turn")]
    if turns and place.kind == "intersection":
        found = [p for p in found if p.action != "go_straight"]
    return [p for p in found if p.action != "keep_lane" or len(found) == 1]
