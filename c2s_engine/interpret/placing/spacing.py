"""How far apart the members of a group are: "three trucks 20 m apart", "with 15 m between them"."""

from c2s_engine.structure.specs import Placement


def without_spacing(placement: Placement, spacing: float | tuple[float, float] | None) -> Placement:
    """The placement without a gap that only says how far apart the members are."""
    same = spacing is not None and placement.gap == spacing
    return placement.model_copy(update={"gap": None}) if same else placement
