"""What is settled once all objects are known."""

from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.interpret.composing.settling import _open_circles
from c2s_engine.structure.specs import ObjectSpec, Placement


def test_nobody_is_placed_by_one_that_is_placed_by_it() -> None:
    """Two that hide or place one another: the first is placed by ego, the second by the first."""
    first = ObjectSpec(name="bus", type="bus", placement=Placement(of="O2", hidden_by="O2"))
    second = ObjectSpec(name="child", type="child", placement=Placement(of="O1", hidden_by="O1"))
    drafts = [Draft(None, s, []) for s in (first, second)]
    _open_circles(drafts)
    assert [(d.spec.placement.of, d.spec.placement.hidden_by) for d in drafts] == [("ego", None), ("O1", "O1")]
