"""Who tells from off the road is nobody on it; ego is the first whom the tale is about."""

import pytest


@pytest.mark.parametrize(
    ("text", "ego", "others"),
    [
        ("I was standing at the window when a taxi ran into the back of a bus.", "car", ["bus"]),
        ("We were sitting outside the cafe. A white van overtook a cyclist.", "van", ["bicycle"]),
        ("I was waiting for the bus when a boy ran into the road and a car stopped just in time.", "car", ["child"]),
        ("From the pavement I watched a tram hit a delivery van.", "bus", ["van"]),
        ("I was watering the lawn when an ambulance came by chasing a motorcycle.", "ambulance", ["motorcycle"]),
        ("I was at the bus stop in my taxi when a van pulled out in front of me.", "car", ["van"]),
        ("I was sitting at the lights. A car ran into me.", "car", ["car"]),
    ],
)
def test_bystander(read, text: str, ego: str, others: list[str]) -> None:
    s = read(text)
    assert (s.ego.spec.type, [o.spec.type for o in s.objects]) == (ego, others)


def test_a_vehicle_that_a_report_gives_a_number(read) -> None:
    s = read("The grey Kia, which your officer has down as vehicle 1, was waiting. A lorry ran into it.")
    assert [o.spec.type for o in s.objects] == ["truck"]
