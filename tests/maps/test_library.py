"""Where maps are found, by name and by path."""

import subprocess
import sys
from pathlib import Path

import pytest

from c2s_engine.maps.library import MapLibrary, MapNotFound


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("CARLA_ROOT", raising=False)


def put(path, text="<OpenDRIVE/>"):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path


def test_the_town_is_always_there():
    town = MapLibrary().find("town")
    assert town.path.is_file()
    assert town.carla_map is None
    assert MapLibrary().list()[0] == town


def test_carla_towns_are_found_below_its_root(tmp_path, monkeypatch):
    put(tmp_path / "carla/CarlaUE4/Content/Carla/Maps/OpenDrive/Town05.xodr")
    put(tmp_path / "carla/elsewhere/Town06.xodr")
    monkeypatch.setenv("CARLA_ROOT", str(tmp_path / "carla"))
    library = MapLibrary()
    assert library.names() == ("town", "Town05")
    assert library.find("town05").carla_map == "Town05"


def test_configured_folders_come_before_carla(tmp_path):
    mine = put(tmp_path / "mine/Town05.xodr", "<OpenDRIVE mine=''/>")
    put(tmp_path / "carla/OpenDrive/Town05.xodr")
    library = MapLibrary(folders=[tmp_path / "mine"], carla_root=tmp_path / "carla")
    assert library.find("Town05").path == mine


def test_any_path_of_the_users(tmp_path):
    path = put(tmp_path / "my maps/village.xodr")
    found = MapLibrary().find(str(path))
    assert (found.name, found.carla_map, found.path) == ("village", None, path)


def test_through_links_relative_and_without_the_ending(tmp_path, monkeypatch):
    path = put(tmp_path / "real/village.xodr")
    (tmp_path / "linked").symlink_to(tmp_path / "real")
    (tmp_path / "real/back").symlink_to(tmp_path / "real")  # a circle
    monkeypatch.chdir(tmp_path)
    library = MapLibrary(folders=["linked"])
    assert library.names() == ("town", "village")
    for name in ("VILLAGE", "linked/village.xodr", "linked/village", str(path), "./real/village.xodr"):
        found = library.find(name)
        assert (found.name, found.digest) == ("village", library.find(str(path)).digest), name
    with pytest.raises(MapNotFound, match="is a folder.*village.xodr"):
        library.find("./real")


def test_a_town_with_a_folder_of_its_own_and_a_root_that_holds_only_maps(tmp_path):
    put(tmp_path / "carla/Unreal/CarlaUE4/Content/Carla/Maps/Town11/OpenDrive/Town11.xodr")
    put(tmp_path / "maps/Town07.xodr")
    assert MapLibrary(carla_root=tmp_path / "carla").names() == ("town", "Town11")
    assert MapLibrary(carla_root=tmp_path / "maps").names() == ("town", "Town07")


def test_a_map_given_by_its_path_is_known_again_by_the_program(tmp_path):
    library = MapLibrary()
    given = library.find(str(put(tmp_path / "mine/village.xodr")))
    program = "param map = localPath('village.xodr')"
    assert library.named_in(program) == given
    library.working_copy(given)
    assert MapLibrary().named_in(program).digest == given.digest
    assert (Path(MapLibrary().folder_of(program)) / "village.xodr").is_file()
    assert MapLibrary().named_in("model scenic.simulators.carla.model") is None


def test_one_map_that_cannot_be_read_does_not_hide_the_others(tmp_path, monkeypatch):
    put(tmp_path / "good.xodr")
    (tmp_path / "dangling.xodr").symlink_to(tmp_path / "nothing")
    (tmp_path / "huge.xodr").write_text("x" * 2_000_000)
    monkeypatch.setattr("c2s_engine.maps.library.MAX_BYTES", 1_500_000)
    library = MapLibrary(folders=[tmp_path])
    assert [m.name for m in library.list()] == ["town", "good"]
    for name, why in (("dangling", "cannot be read"), ("huge", "larger than")):
        with pytest.raises(MapNotFound, match=why):
            library.find(name)


@pytest.mark.parametrize("name", ["Town05", "nowhere", "nowhere.xodr", "/no/such/file.xodr"])
def test_an_unknown_map_names_those_that_there_are(name):
    with pytest.raises(MapNotFound) as refusal:
        MapLibrary().find(name)
    assert "Known maps: town" in str(refusal.value)
    assert ("CARLA_ROOT" in str(refusal.value)) == (name == "Town05")


def test_a_town_that_is_not_where_carla_is_said_to_be_is_told_where_it_was_looked_for(tmp_path):
    with pytest.raises(MapNotFound) as refusal:
        MapLibrary(carla_root=tmp_path).find("Town05")
    assert f"none of its maps are below {tmp_path}" in str(refusal.value)


@pytest.mark.parametrize(("name", "near"), [("Town99", "town"), ("town 7", "town"), ("twon", "town")])
def test_a_name_that_no_map_has_gets_the_nearest_that_is_there(name, near):
    with pytest.raises(MapNotFound, match=rf"Did you mean {near}\?$") as refusal:  # of those that are there
        MapLibrary().find(name)
    assert "CARLA_ROOT" not in str(refusal.value)


def test_a_file_that_is_no_map(tmp_path):
    with pytest.raises(MapNotFound, match="ends in .xodr"):
        MapLibrary().find(str(put(tmp_path / "notes.txt")))


def test_the_working_copy_follows_the_file(tmp_path):
    path = put(tmp_path / "a.xodr", "<OpenDRIVE one=''/>")
    library = MapLibrary()
    first = library.working_copy(library.find(str(path)))
    assert first.read_text() == path.read_text()
    assert first.parent.parent.parent == tmp_path / "cache" / "c2s"
    path.write_text("<OpenDRIVE another=''/>")
    second = library.working_copy(library.find(str(path)))
    assert second != first
    assert second.read_text() == path.read_text()


def test_the_front_can_use_it_without_scenic():
    code = (
        "import sys; from c2s_engine.maps import library, extras, expressions; "
        "extras.read_extras(library.MapLibrary().find('town').path); expressions.survey(); "
        "sys.exit(any(m in sys.modules for m in ('scenic', 'numpy')))"
    )
    assert subprocess.run([sys.executable, "-c", code], timeout=60).returncode == 0


def test_a_cache_that_cannot_be_written_is_said(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    with pytest.raises(MapNotFound, match="Set XDG_CACHE_HOME"):
        MapLibrary().working_copy(MapLibrary().find("town"))
