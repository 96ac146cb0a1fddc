"""What somebody types is split into its demands: reasons go, and what a demand leaves out is filled in."""

import pytest

from c2s_engine.interpret.changes.demands import demands, whole

JUNCTION = (
    "Ego approaches a signalised intersection at 40 km/h. A truck crosses from the left and a motorcycle follows ego."
)


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("make the lead a truck and remove the rain", ["make the lead a truck", "remove the rain"]),
        ("light fog, 3 lanes", ["light fog", "3 lanes"]),
        ("lead -> bus", ["lead -> bus"]),
        ("The van is too easy to spot, so please make it a motorcycle.", ["make it a motorcycle"]),
        ("We can't see anything in the recording, can we have daylight?", ["daylight"]),
        ("As soon as the bus stops, the boy starts to run", ["as soon as the bus stops, the boy starts to run"]),
        ("the bus must stop, because the log says so", ["the bus must stop"]),
        ("I'd like the tram to stop first, then go straight", ["the tram will stop first", "then go straight"]),
        ("put a goat on the road 40 m ahead, standing still", ["put a goat on the road 40 m ahead, standing still"]),
        ("the truck is a bus now, and the van a taxi", ["the truck is a bus", "the van a taxi"]),
        ("truck slower, 20 km/h", ["truck slower, 20 km/h"]),
        ("Could you move the bike to the left, please?", ["move the bike to the left"]),
    ],
)
def test_demands(text, found):
    assert demands(text) == found


@pytest.mark.parametrize(
    ("demand", "before", "topic", "found"),
    [
        ("it drives 60 km/h", "make the lead a truck", "O1", "o1 drives 60 km/h"),
        ("then go straight", "the truck will stop first", "O1", "then o1 will go straight"),
        ("the van too", "make the truck a bus", "O1", "make the van a bus"),
        ("the van a taxi", "the truck is a bus", "O1", "make the van a taxi"),
        ("the motorcycle 30", "the truck goes 50 km/h", "O1", "the motorcycle 30 km/h"),
        ("5 m behind us", "the motorcycle is closer", "O2", "o2 5 m behind us"),
    ],
)
def test_what_a_demand_leaves_out(demand, before, topic, found):
    assert whole(demand, before, topic) == found
