"""A vehicle that is cast as ego, in its phrase or in a sentence of its own, is ego and nobody else."""

import pytest


@pytest.mark.parametrize(
    ("text", "kind", "speed"),
    [
        (
            "A cyclist rides at the edge of a country road. The car behind, as ego, at 45 km/h, is about to pass when "
            "an oncoming van appears.",
            "car",
            12.5,
        ),
        ("The lorry behind (ego), at 60 km/h, closes in on a moped.", "truck", 16.67),
        ("A pickup, acting as ego, follows a cyclist at 20 km/h.", "truck", 5.56),
        ("With the van as ego: it drives at 40 km/h and a taxi in front of it brakes.", "van", 11.11),
    ],
)
def test_who_is_cast_as_ego(read, text: str, kind: str, speed: float) -> None:
    s = read(text)
    assert s.ego.spec.type == kind
    assert s.ego.spec.speed == pytest.approx(speed, abs=0.01)
    assert kind == "car" or all(o.spec.type != kind for o in s.objects)


@pytest.mark.parametrize(
    ("text", "others"),
    [
        ("Take the motorcycle as ego: a car coming the other way turns left across its path.", ["car"]),
        ("A lorry (ego's role) overtakes a tractor and a bus comes towards it.", ["truck", "bus"]),
    ],
)
def test_who_else_is_there(read, text: str, others: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == others


@pytest.mark.parametrize(
    "text",
    [
        "I drive in the right lane (my Passat = ego) at 120 km/h and a van brakes ahead of me.",
        "Ego is behind a van at 120 km/h. The van brakes.",
        "Ego drives at 120 km/h. The van ahead of ego brakes.",
    ],
)
def test_who_only_stands_near_ego_is_not_cast(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.speed == pytest.approx(33.33, abs=0.01)
    assert [(o.spec.type, [p.action for p in o.spec.phases]) for o in s.objects] == [("van", ["brake"])]
