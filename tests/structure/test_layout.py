"""Where the components of an imported program stand once some of them were written anew."""

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.layout import chunks


def imported(cid: str, *parts: tuple[int, str]) -> Component:
    base = Structure()[cid]
    return base.model_copy(update={"origin": "imported", "layout": parts, "code": "".join(t for _, t in parts)})


def order(*components: Component) -> list[str]:
    return [cid for cid, text, _ in chunks(components) if text]


def test_a_place_written_anew_stands_after_the_world_model_and_before_who_reads_it():
    settings = imported("G", (0, "param map = 1\n"), (2, "model m\n"))
    ego = imported("E", (1, "SPEED = 3\n"), (3, "ego = new Car\n"))
    place = imported("R", (4, "require somewhere\n"))
    assert order(settings, place, ego) == ["G", "E", "G", "E", "R"], "as imported"
    anew = place.model_copy(update={"origin": "rendered", "code": "lane = 1\n"})
    assert order(settings, anew, ego) == ["G", "E", "G", "R", "E"]
    assert order(settings.model_copy(update={"origin": "rendered"}), anew, ego) == ["G", "R", "E", "E"]
