"""What another does and what ego does then, joined in many manners: both, each by its own."""

from c2s_engine.interpret import EmbeddedInterpreter


def test_what_would_happen_if_it_did_is_not_told() -> None:
    structure = (
        EmbeddedInterpreter().interpret("A van drives ahead. If the van braked, ego would change lanes.").structure
    )
    assert all(not o.spec.phases for o in structure.objects)
    assert not structure.ego.spec.phases
