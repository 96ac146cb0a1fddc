def pocket(lane):
    """Where one waits whom others pass on an approach: the lane to the left of theirs, or the left side of their own;
    how far (m) it stands to the left of its middle there."""
    faster = lane and lane.sections[-1]._fasterLane
    return faster and (faster.lane, 0) or lane and (lane, 1.7)
