"""The worker behind its client, the stores and the commands, with the real model and LanceDB."""

import asyncio
import json
import os
import resource
import signal
import subprocess
import sys

import numpy as np
import pytest
from typer.testing import CliRunner

from c2s_bench.retrieval.fitting import fitting
from c2s_engine.retrieve import commands, sources, vectors
from c2s_engine.retrieve.client import RetrievalClient
from c2s_engine.retrieve.embedder import Embedder
from c2s_engine.retrieve.errors import BadDocument, RetrievalError
from c2s_engine.retrieve.library import Library
from c2s_engine.retrieve.wording import plain
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec

pytestmark = pytest.mark.full
PROGRAM = """param map = localPath('town.xodr')
model scenic.simulators.carla.model
ego = new Car
stripedWalker = new Pedestrian ahead of ego by 17,
    with regionContainedIn None
terminate when simulation().currentTime > 50
"""
NOTE = "# House rules\n\n## 7.3 Zebra stripes\n\nThe blue zebra gives way to trams at every depot.\n"


async def test_questions_snippets_and_silence(index_folder):
    async with RetrievalClient(index_folder) as client:
        rules = await client.search("what does R157 ask for a cut-in?")
        assert any("Annex 5, 4.4" in p.clause for p in rules)
        assert rules[0].kind == "doc" and rules[0].ranks and rules[0].source
        lanes = await client.search("which behaviours follow a lane?")
        assert any("FollowLaneBehavior" in p.text for p in lanes)
        cut_ins = await client.search("a car cuts in from the left", kind="snippet", component="O", limit=3)
        assert len(cut_ins) == 3 and all(p.component == "O" for p in cut_ins)
        assert any("LaneChangeBehavior" in p.text for p in cut_ins)
        assert await client.search("best restaurants in Munich") == []
        assert await client.search("best restaurants in Munich", abstain=False)
        assert (await client.search("5.2.5.2"))[0].clause.endswith("5.2.5.2")
        vectors = await client.embed(["one", "two"])
        assert [len(v) for v in vectors] == [384, 384]


def test_snippets_fit_what_a_component_is_and_does(index_folder):
    """Of what is shown for judged components (benchmark/retrieval/fitting.yaml) at least 85 % fit."""
    rows, _ = fitting(Library(index_folder, threads=1))
    by = {way: [r for r in rows if r["by"] == way] for way in ("sentence", "sentence and terms")}
    share = {way: sum(r["fit"] for r in found) / sum(r["shown"] for r in found) for way, found in by.items()}
    assert share["sentence and terms"] >= 0.85 > share["sentence"] + 0.2


async def test_add_search_list_remove(own_index, tmp_path):
    note = tmp_path / "rules.md"
    note.write_text(NOTE)
    stages = []
    async with RetrievalClient(own_index) as client:
        report = await client.add(str(note), lambda stage, done, total: stages.append(stage))
        assert [s["title"] for s in report["added"]] == ["House rules"] and "embedding" in stages
        [first, *_] = await client.search("zebra at the depot")
        assert (first.clause, first.source) == ("7.3", "House rules")
        await client.add(str(note))
        assert sum(s["location"] == str(note) for s in (await client.list())["sources"]) == 1
        rebuilt = await client.build()
        assert rebuilt["embedded"] == 0
        assert (await client.search("zebra at the depot"))[0].source == "House rules"
        assert (await client.verify())["ok"]
        note.write_text(NOTE + "\nChanged.\n")
        assert any("has changed" in f for f in (await client.verify())["findings"])
        await client.remove(str(note))
        assert not any(p.source == "House rules" for p in await client.search("zebra at the depot", abstain=False))
        with pytest.raises(RetrievalError, match="shipped with the program"):
            await client.remove("snippets")


@pytest.mark.nightly
async def test_programs_become_snippets(own_index, tmp_path):
    program = tmp_path / "mine.scenic"
    program.write_text("tram = new Truck ahead of ego by 9\n")

    async def decompose(text: str) -> Structure:
        part = Component(id="O1", description="A tram crawls over the blue depot.", spec=ObjectSpec(), code=text)
        return Structure(objects=(part,))

    async with RetrievalClient(own_index) as client:
        await client.add(str(tmp_path), decompose=decompose)
        [first, *_] = await client.search("tram at the blue depot", kind="snippet", component="O")
        assert "tram = new Truck" in first.text


async def test_the_shipped_vectors_are_the_model_s(own_index):
    shipped = vectors.known(Embedder().name)
    rows = [r for batch in sources.shipped_batches() for r in batch.rows if r.key in shipped][::150]
    async with RetrievalClient(own_index) as client:
        made = await client.embed([plain(r.embedded) for r in rows])
    for row, vector in zip(rows, made, strict=True):
        assert np.dot(shipped[row.key], vector) > 0.9999


@pytest.mark.nightly
async def test_all_who_wait_for_the_index_share_one_build(tmp_path):
    told: list[str] = []
    async with RetrievalClient(tmp_path / "index") as client:
        impatient = asyncio.create_task(client.ready(lambda stage, done, total: told.append(stage)))
        waiting = asyncio.create_task(client.ready())
        await asyncio.sleep(0.2)
        impatient.cancel()
        await waiting
        assert impatient.cancelled() and await client.search("lane change", kind="snippet")
        assert len(list((tmp_path / "index").glob("generation-*"))) == 1


async def test_refusals_are_sentences(own_index, tmp_path):
    (tmp_path / "program.md").write_bytes(b"\x7fELF\0\0")
    (tmp_path / "good.md").write_text(NOTE)
    async with RetrievalClient(own_index) as client:
        with pytest.raises(BadDocument, match="program.md is a binary file"):
            await client.add(str(tmp_path / "program.md"))
        with pytest.raises(BadDocument, match="There is no file"):
            await client.add(str(tmp_path / "nothing.md"))
        with pytest.raises(BadDocument, match="could not be reached"):
            await client.add("http://127.0.0.1:9/page.html")
        report = await client.add(str(tmp_path))
        assert len(report["added"]) == 1 and len(report["refused"]) == 1


@pytest.mark.nightly
async def test_a_worker_that_is_killed_is_replaced_and_the_request_named(own_index):
    async with RetrievalClient(own_index) as client:
        await client.search("lane change")
        first = client.pid
        begun = asyncio.Event()

        def kill(stage: str, done: int, total: int) -> None:
            if not begun.is_set():
                begun.set()
                os.kill(client.pid, signal.SIGKILL)

        with pytest.raises(RetrievalError, match=r"died \(signal 9\) at build"):
            await client.build(kill)
        assert await client.search("lane change")
        assert client.pid != first


def test_kill_9_while_building_leaves_the_old_index(own_index):
    before = (own_index / "current").read_text()
    code = (
        "import os, sys, pathlib\n"
        "from c2s_engine.retrieve import store\n"
        "from c2s_engine.retrieve.library import Library\n"
        "store.Postings.save = lambda self, path: os.kill(os.getpid(), 9)\n"
        "Library(pathlib.Path(sys.argv[1])).build()\n"
    )
    done = subprocess.run([sys.executable, "-c", code, str(own_index)], capture_output=True)
    assert done.returncode == -signal.SIGKILL
    assert (own_index / "current").read_text() == before
    assert list(own_index.glob("*.building"))
    library = Library(own_index)
    assert library.verify()["ok"]
    library.build()
    assert not list(own_index.glob("*.building"))


def test_a_full_disk_leaves_the_old_index(own_index):
    """A limit on the size of files stands in for a full disk: writes fail in the same place."""
    before = (own_index / "current").read_text()
    code = (
        "import pathlib, sys\n"
        "from c2s_engine.retrieve.errors import RetrievalError\n"
        "from c2s_engine.retrieve.library import Library\n"
        "try:\n    Library(pathlib.Path(sys.argv[1])).build()\n"
        "except RetrievalError as error:\n    print(error)\n    sys.exit(7)\n"
    )

    def limit() -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))

    done = subprocess.run(
        [sys.executable, "-c", code, str(own_index)], capture_output=True, text=True, preexec_fn=limit
    )
    assert done.returncode == 7, done.stderr
    assert "is full: the index was left as it was" in done.stdout
    assert (own_index / "current").read_text() == before
    assert Library(own_index).verify()["ok"]


def test_a_folder_without_permission_gets_a_sentence(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    with pytest.raises(RetrievalError):
        Library(blocked / "index").build()


@pytest.mark.nightly
def test_two_processes_build_one_after_the_other(own_index):
    code = "import pathlib, sys\nfrom c2s_engine.retrieve.library import Library\n"
    code += "Library(pathlib.Path(sys.argv[1])).build()\n"
    both = [subprocess.Popen([sys.executable, "-c", code, str(own_index)]) for _ in range(2)]
    assert [p.wait() for p in both] == [0, 0]
    assert Library(own_index).verify()["ok"]


def test_another_model_must_be_said(own_index, monkeypatch):
    library = Library(own_index)
    monkeypatch.setattr(type(library.embedder), "name", property(lambda self: "another model"))
    with pytest.raises(RetrievalError, match="run `c2s index build`"):
        library.search("lane")
    assert not library.verify()["ok"]


def test_a_damaged_index_says_so_and_is_built_anew(own_index):
    current = own_index / (own_index / "current").read_text()
    (current / "documents.npz").write_bytes(b"nonsense")
    with pytest.raises(RetrievalError, match="damaged: run `c2s index build`"):
        Library(own_index).search("lane")
    Library(own_index).build()
    assert Library(own_index).search("lane change behaviour")


@pytest.mark.nightly
def test_a_pdf_of_300_pages(own_index, tmp_path):
    from test_parts import pdf

    pages = [f"Draft rule\n5.{n}. Requirement {n}\nThe crane number {n} swings over the quay." for n in range(1, 301)]
    (tmp_path / "long.pdf").write_bytes(pdf(pages))
    library = Library(own_index)
    report = library.add(str(tmp_path / "long.pdf"))
    assert report["added"][0]["items"] == 300
    [first, *_] = library.search("5.217 crane over the quay")
    assert (first.clause, first.page) == ("5.217", 217)


@pytest.mark.nightly
def test_users_programs_are_taken_apart_by_the_command(own_index, tmp_path):
    """`c2s index add` as it is typed: the check server's importer gives the components, their specs the words."""
    (tmp_path / "data" / "c2s").mkdir(parents=True)
    own_index.rename(tmp_path / "data" / "c2s" / "index")
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "zebra.scenic").write_text(PROGRAM)
    (tmp_path / "mine" / "broken.scenic").write_text("ego = = new Car\n")
    environment = os.environ | {f"XDG_{n}_HOME": str(tmp_path / n.lower()) for n in ("DATA", "CONFIG", "CACHE")}

    def c2s(*arguments):
        command = [sys.executable, "-m", "c2s_engine.cli", *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=280)

    added = c2s("index", "add", tmp_path / "mine")
    assert added.returncode == 1 and "broken.scenic could not be taken apart" in added.stderr, added.stderr
    found = c2s("search", "pedestrian", "--component", "O", "--limit", "50", "--all", "--json")
    mine = [p for p in json.loads(found.stdout) if "stripedWalker" in p["text"]]
    assert mine and mine[0]["component"] == "O" and "ego = new Car" not in mine[0]["text"]


def test_commands(own_index, tmp_path, monkeypatch):
    import typer

    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    (tmp_path / "data" / "c2s").mkdir(parents=True)
    own_index.rename(tmp_path / "data" / "c2s" / "index")
    app = typer.Typer()
    app.command("search")(commands.search_command)
    app.add_typer(commands.app, name="index")
    run = CliRunner().invoke
    found = run(app, ["search", "which behaviours follow a lane?", "--json"])
    assert found.exit_code == 0 and "FollowLaneBehavior" in found.stdout
    assert run(app, ["search", "best restaurants in Munich"]).exit_code == 1
    assert run(app, ["search", "lead brakes", "--component", "X"]).exit_code == 2
    assert run(app, ["index", "verify"]).exit_code == 0
    assert "snippet" in run(app, ["index", "list"]).stdout
    refused = run(app, ["index", "add", str(tmp_path / "none.md")])
    assert refused.exit_code == 2
