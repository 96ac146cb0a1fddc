"""Maps that programs name: by any path, and such as Scenic cannot read."""

import gzip
import time
from pathlib import Path

import pytest

from c2s_engine import paths
from c2s_engine.api import RUNNER
from c2s_engine.check.client import CheckError, SyncCheckClient
from c2s_engine.check.protocol import CheckRequest, PlacesRequest
from c2s_engine.maps.extras import read_extras
from c2s_engine.maps.opendrive import BrokenMap

PROGRAM = """\
param map = localPath({path!r})
param carla_map = None
param use2DMap = True
model scenic.simulators.carla.model
ego = new Car
terminate after 1 seconds
"""
ROAD = """<road name="" length="100" id="{id}" junction="{junction}"><link>
<predecessor elementType="road" elementId="{before}" contactPoint="end"/>
<successor elementType="road" elementId="{after}" contactPoint="start"/></link>
<planView><geometry s="0" x="{x}" y="0" hdg="0" length="100"><line/></geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right><lane id="-1" type="driving"><link>
<predecessor id="-1"/><successor id="-1"/></link><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes></road>"""
TO_ITSELF = """<junction id="5" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start">
<laneLink from="-1" to="-1"/></connection><connection id="1" incomingRoad="2" connectingRoad="2" contactPoint="start">
<laneLink from="-1" to="-1"/></connection></junction>"""


def road(number: int, before: int, after: int, junction: int = -1) -> str:
    return ROAD.format(id=number, before=before, after=after, junction=junction, x=100 * number)


def write(folder: Path, body: str) -> Path:
    path = folder / "odd.xodr"
    path.write_text(f'<?xml version="1.0"?><OpenDRIVE><header revMajor="1" revMinor="4"/>{body}</OpenDRIVE>')
    return path


@pytest.mark.full
def test_a_map_outside_the_program_s_folder_is_run_on_by_every_kind_of_path(tmp_path: Path) -> None:
    elsewhere, folder = tmp_path / "maps", tmp_path / "programs"
    elsewhere.mkdir()
    folder.mkdir()
    (elsewhere / "village.xodr").write_bytes(paths.shipped("maps", "town.xodr").read_bytes())
    (folder / "link").symlink_to(elsewhere)
    said = (str(elsewhere / "village.xodr"), "../maps/village.xodr", "link/village.xodr")
    with SyncCheckClient(runner=RUNNER) as server:
        for path in said:
            request = CheckRequest(program=PROGRAM.format(path=path), folder=str(folder), upto="run", seconds=1.0)
            report = server.check(request)
            assert report.ok, (path, report.stages[-1])
            assert report.facts[0].ended_by in ("time", "terminated"), report.facts[0].reason


@pytest.mark.parametrize(
    "body",
    [
        road(1, 77, 78),
        road(1, 1, 2) + road(2, 1, 2, junction=5) + TO_ITSELF,
        road(1, 2, 2).replace('type="driving"', 'type="none"') + road(2, 1, 9),
    ],
    ids=["links to nowhere", "a junction that leads into itself", "no lanes"],
)
def test_a_map_that_scenic_cannot_read_is_told_in_one_sentence(
    server: SyncCheckClient, tmp_path: Path, body: str
) -> None:
    with pytest.raises(CheckError, match="Scenic cannot read the map odd.xodr: ") as refusal:
        server.places(PlacesRequest(map=str(write(tmp_path, body)), expressions={"lanes": "network.lanes"}))
    assert "\n" not in str(refusal.value)


def said_of(server: SyncCheckClient, path: Path) -> tuple[str, str]:
    """What is said of a map whose places are asked for, and of one that a program names."""
    with pytest.raises(CheckError) as refusal:
        server.places(PlacesRequest(map=str(path), expressions={"lanes": "network.lanes"}))
    report = server.check(CheckRequest(program=PROGRAM.format(path=path.name), folder=str(path.parent), upto="compile"))
    (fault,) = report.stages[-1].diagnostics
    assert fault.line == 4 and fault.code == "map_broken"
    return str(refusal.value), fault.message


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (paths.shipped("maps", "town.xodr").read_bytes()[:100_000], "odd.xodr is no well-formed XML"),
        (b"", "odd.xodr is no well-formed XML"),
        (gzip.compress(b"0" * 20_000_000, mtime=0), "odd.xodr is a compressed file"),
        (b'<!DOCTYPE a [<!ENTITY b "bb"><!ENTITY c "&b;&b;">]><OpenDRIVE>&c;</OpenDRIVE>', "odd.xodr declares"),
        (b'<OpenDRIVE><header name="' + b"x" * 81_000_000 + b'"/></OpenDRIVE>', "odd.xodr is larger than 80 MB"),
        (b"<OpenDRIVE>" + b"<a>" * 1000 + b"</a>" * 1000 + b"</OpenDRIVE>", "odd.xodr has more elements"),
        (b"<OpenDRIVE><header name='bare'/></OpenDRIVE>", "odd.xodr has no roads"),
        (b'<OpenDRIVE><road id="1" length="9"/></OpenDRIVE>', "Road 1 of the map has no geometry"),
    ],
    ids=["truncated", "empty", "gzip bomb", "entities", "81 MB in one attribute", "deep", "no roads", "no geometry"],
)
def test_hostile_files_are_refused_in_one_sentence_before_scenic_reads_them(
    server: SyncCheckClient, tmp_path: Path, content: bytes, said: str
) -> None:
    path = tmp_path / "odd.xodr"
    path.write_bytes(content)
    for sentence in said_of(server, path):
        assert said in sentence
        assert "\n" not in sentence


def test_a_long_attribute_takes_no_longer_than_it_is_long(tmp_path: Path) -> None:
    long = write(tmp_path, f'<a name="{"x" * 20_000_000}"/>')
    started = time.process_time()
    with pytest.raises(BrokenMap, match="has no roads"):
        read_extras(long)
    assert time.process_time() - started < 2.0


def test_a_ring_of_roads_that_lead_into_each_other_is_read(server: SyncCheckClient, tmp_path: Path) -> None:
    path = write(tmp_path, road(1, 2, 2) + road(2, 1, 1))
    assert server.places(PlacesRequest(map=str(path), expressions={"lanes": "network.lanes"})).counts == {"lanes": 2}
