"""What another does and what ego does then, joined in many manners: both, each by its own."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

JOINED = (
    "A van ahead {v}. Ego {e}.",
    "A van ahead {v} and ego {e}.",
    "A van ahead {v}, making ego {eb}.",
    "If a van ahead {v}, ego {e}.",
    "Ego responds to a van ahead {g} by {eg}.",
    "Ego starts {eg} as a van ahead {v}.",
    "Ego is about to {eb} when a van ahead {v}.",
    "Ego must {eb} because a van ahead {v}.",
    "First a van ahead {v}. Next, ego {e}.",
    "A van ahead {v} and therefore ego {e}.",
    "Seeing a van ahead {g}, ego {e}.",
)
OTHERS = (("brakes", "braking", "brake"), ("turns around", "turning around", "u_turn"), ("stops", "stopping", "stop"))
OWN = (
    ("changes to the left lane", "changing to the left lane", "change to the left lane", "lane_change"),
    ("accelerates", "accelerating", "accelerate", "accelerate"),
)


@pytest.mark.parametrize("joined", JOINED)
def test_each_does_its_own(joined: str) -> None:
    for does, doing, theirs in OTHERS:
        for e, eg, eb, own in OWN:
            text = joined.format(v=does, g=doing, e=e, eg=eg, eb=eb)
            structure = EmbeddedInterpreter().interpret(text).structure
            assert [[p.action for p in o.spec.phases] for o in structure.objects] == [[theirs]], text
            assert [p.action for p in structure.ego.spec.phases] == [own], text


def test_what_would_happen_if_it_did_is_not_told() -> None:
    structure = (
        EmbeddedInterpreter().interpret("A van drives ahead. If the van braked, ego would change lanes.").structure
    )
    assert all(not o.spec.phases for o in structure.objects)
    assert not structure.ego.spec.phases
