"""The parts that need neither model nor LanceDB: tokens, BM25, fusion, chunks, readers, snippets."""

import ast
import subprocess
import sys
from collections import Counter

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from rank_bm25 import BM25Okapi

from c2s_engine.paths import shipped
from c2s_engine.retrieve import blocks, markdown, readers, scenic_reference, snippet_files, sources, vectors
from c2s_engine.retrieve.bm25 import Postings
from c2s_engine.retrieve.embedder import Embedder
from c2s_engine.retrieve.errors import BadDocument
from c2s_engine.retrieve.fusion import fuse
from c2s_engine.retrieve.terms import agreement, terms_of
from c2s_engine.retrieve.tokens import tokenise
from c2s_engine.retrieve.wording import plain
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import (
    Condition,
    EgoSpec,
    ObjectSpec,
    Phase,
    Placement,
    PlaceSpec,
    RestrictionsSpec,
)

WORDS = st.lists(st.sampled_from("abcdefgh"), min_size=1, max_size=12)


@settings(max_examples=60)
@given(st.lists(WORDS, min_size=2, max_size=20), WORDS)
def test_scores_are_those_of_rank_bm25(documents, query):
    reference = np.array(BM25Okapi(documents).get_scores(query))
    postings = Postings.build(documents)
    found, scores = postings.scores(query)
    ours = np.zeros(len(documents))
    ours[found] = scores
    assert np.allclose(ours, reference, atol=1e-4)
    assert set(found) == {i for i, d in enumerate(documents) if set(d) & set(query)}


def test_postings_come_back_from_the_disk(tmp_path):
    postings = Postings.build([["a", "ü"], ["b", "a", "a"]])
    postings.save(tmp_path / "p.npz")
    again = Postings.load(tmp_path / "p.npz")
    assert again.terms == postings.terms
    assert [list(x) for x in again.scores(["a", "ü"])] == [list(x) for x in postings.scores(["a", "ü"])]


def test_api_names_are_whole_and_in_parts():
    terms = tokenise("FollowLaneBehavior")
    assert terms[0] == "followlanebehavior"
    assert {"follow", "lane", "behavior"} <= set(terms)
    assert "withindistancetoanyobj" in tokenise("withinDistanceToAnyObjs(self, 10)")


def test_clauses_are_whole_and_have_their_parents():
    assert tokenise("5.2.6.5") == ["5.2.6.5", "5.2.6", "5.2"]
    assert "5.2.6" in tokenise("clause 5.2.6.5")


def test_words_are_stemmed_and_stopwords_dropped():
    assert tokenise("the cars are braking") == tokenise("car brakes") == ["car", "brake"]
    assert tokenise("cut-in") == ["cutin", "cut"]


def test_fusion_prefers_what_both_lists_hold():
    order = [item for item, _ in fuse({"a": [1, 2, 3], "b": [3, 4]})]
    assert order[0] == 3
    assert set(order) == {1, 2, 3, 4}


def test_jargon_becomes_plain():
    assert plain("Ego follows the lead vehicle") == "my car follows the vehicle in front"
    assert plain("legos") == "legos"


def test_chunks_keep_their_headings_clause_and_tables():
    text = "# Rule\n\n## 5.2.6.5 Lane changes\n\nFirst.\n\n| a | b |\n| --- | --- |\n" + "| 1 | 2 |\n" * 200
    found = blocks.chunks(markdown.read_markdown(text), "Doc")
    assert all(c.path == ("Doc", "Rule", "5.2.6.5 Lane changes") and c.clause == "5.2.6.5" for c in found)
    tables = [c.text for c in found if "| 1 | 2 |" in c.text]
    assert len(tables) > 1
    assert all("| a | b |\n| --- | --- |" in t for t in tables)
    assert max(len(c.text) for c in found) <= 1200


@settings(max_examples=60)
@given(st.text(max_size=500))
def test_any_text_is_chunked_without_loss_of_words(text):
    found = blocks.chunks([blocks.Block("paragraph", text)], "t", target=60)
    joined = "".join("".join(c.text.split()) for c in found)
    assert joined == "".join(text.split())


@pytest.mark.parametrize(
    ("heading", "clause"),
    [
        ("4.4. Cut-in", "4.4"),
        ("Test: cut-in (Annex 5, 4.4)", "Annex 5, 4.4"),
        ("Following distance (5.2.3.3)", "5.2.3.3"),
        ("Units: metres", ""),
    ],
)
def test_clause_of_a_heading(heading, clause):
    assert blocks.clause_of(heading) == clause


def test_html_without_navigation():
    page = "<html><head><title>T</title></head><body><nav>menu</nav><h1>Head</h1><p>Body <b>text</b>.</p>"
    page += "<ul><li>one</li><li>two</li></ul><table><tr><th>a</th></tr><tr><td>1</td></tr></table></body></html>"
    document = readers.read_bytes(page.encode(), "page.html", ".html")
    assert document.title == "T"
    assert [(b.kind, b.text) for b in document.blocks] == [
        ("heading", "Head"),
        ("paragraph", "Body text ."),
        ("list", "- one\n- two"),
        ("table", "| a |\n| 1 |"),
    ]


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("empty.pdf", b"", "is empty"),
        ("broken.pdf", b"%PDF-1.4 nothing", "no PDF that can be read"),
        ("program.md", b"\x7fELF\0\0\1\2", "binary file"),
        ("noise.txt", bytes(range(1, 32)) * 50, "binary file"),
        ("large.html", b"<p>x</p>" * (21 << 17), "is read up to 20 MB"),
        ("blank.md", b"\n\n", "no text"),
        ("bare.html", b"<html><script>1</script></html>", "no text"),
    ],
    ids=["empty", "broken PDF", "binary", "control characters", "large HTML", "blank", "HTML without text"],
)
def test_bad_files_get_a_sentence(tmp_path, name, data, words):
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(BadDocument, match=words) as caught:
        readers.read_file(path)
    assert name in str(caught.value)


def test_a_scanned_pdf_gets_a_sentence(tmp_path):
    from pypdf import PdfWriter

    writer = PdfWriter()
    for _ in range(3):
        writer.add_blank_page(200, 200)
    writer.write(tmp_path / "scan.pdf")
    with pytest.raises(BadDocument, match="hardly any text.*OCR"):
        readers.read_file(tmp_path / "scan.pdf")


def test_pdf_pages_and_clauses(tmp_path):
    path = tmp_path / "rule.pdf"
    path.write_bytes(pdf([f"Draft rule\n5.{n}. Requirement {n}\nThe vehicle number {n} stops." for n in range(1, 9)]))
    document = readers.read_file(path)
    found = blocks.chunks(document.blocks, document.title)
    third = next(c for c in found if "vehicle number 3" in c.text)
    assert (third.clause, third.page) == ("5.3", 3)
    assert not any("Draft rule" in c.text for c in found)


def pdf(pages: list[str]) -> bytes:
    """A plain PDF with a text on each page."""
    from io import BytesIO

    from pypdf import PdfWriter
    from pypdf.generic import DecodedStreamObject, DictionaryObject, NameObject

    writer = PdfWriter()
    font = DictionaryObject({NameObject("/Type"): NameObject("/Font"), NameObject("/Subtype"): NameObject("/Type1"),
                             NameObject("/BaseFont"): NameObject("/Helvetica")})  # fmt: skip
    fonts = DictionaryObject({NameObject("/F1"): writer._add_object(font)})
    for text in pages:
        page = writer.add_blank_page(595, 842)
        lines = " ".join(f"({line}) Tj T*" for line in text.splitlines())
        stream = DecodedStreamObject()
        stream.set_data(f"BT /F1 11 Tf 50 780 Td 14 TL {lines} ET".encode())
        page[NameObject("/Resources")] = DictionaryObject({NameObject("/Font"): fonts})
        page[NameObject("/Contents")] = writer._add_object(stream)
    out = BytesIO()
    writer.write(out)
    return out.getvalue()


def test_the_reference_knows_the_behaviours_and_specifiers():
    titles = {" › ".join(c.path[1:]) for c in scenic_reference.reference()}
    for name in (
        "behaviors › FollowLaneBehavior",
        "behaviors › LaneChangeBehavior",
        "veneer › Beyond",
        "roads › Maneuver",
    ):
        assert any(t.endswith(name) for t in titles), name


def test_snippets_cover_the_vocabulary():
    snippets = list(snippet_files.shipped(shipped("snippets")))
    assert len(snippets) >= 250
    words = yaml.safe_load(shipped("vocabulary.yaml").read_text())
    for field, names in (("actions", words["actions"]), ("positions", words["positions"]), ("places", words["places"])):
        count = Counter(value for s in snippets for value in getattr(s, field))
        assert set(count) <= set(names), field
        assert not [n for n in names if count[n] < 2], field
    assert {t for s in snippets for t in s.types} <= set(words["object_types"])
    for field in ("manoeuvres", "controls", "ego_lanes"):
        assert {t for s in snippets for t in getattr(s, field)} <= set(words[field]), field
    assert all(len(s.phrases) >= 2 for s in snippets)


def test_what_is_about_others_does_not_agree():
    """A thing alone has nothing of a cut-out, keeping a lane nothing of a junction; nearer types come first."""
    thing = ("container", "ahead", "stationary")
    assert agreement("O", thing, ("cut_out", "stationary", "ahead", "car")) == 0
    assert agreement("O", thing, ("stationary", "ahead", "container")) == 1
    car = ("car", "ahead", "keep_lane")
    assert agreement("O", car, ("lane_change", "ahead", "car")) == 0
    same, van, right = (agreement("O", car, ("keep_lane", *more)) for more in (("ahead", "car"), ("ahead", "van"),
                                                                               ("right_lane", "car")))  # fmt: skip
    assert same == 1 > van > 0 and 1 > right > 0
    assert agreement("O", car, ()) is None, "nothing is known of a user's own"
    left = ("intersection", "manoeuvre=left")
    told, untold, other, elsewhere = (
        agreement("R", left, ("intersection", *w)) for w in (("manoeuvre=left",), (), ("manoeuvre=right",), ())
    )
    assert told == 1 > untold == elsewhere > other > 0 == agreement("R", left, ("motorway",))


@pytest.mark.parametrize(
    ("spec", "about"),
    [
        (ObjectSpec(type="cone"), ("cone", "ahead", "stationary")),
        (ObjectSpec(placement=Placement(position="parked")), ("car", "parked", "stationary")),
        (ObjectSpec(placement=Placement(position="crossing_left")), ("car", "crossing_left", "go_straight")),
        (ObjectSpec(type="child", placement=Placement(position="sidewalk")), ("child", "sidewalk", "move_along")),
        (ObjectSpec(phases=(Phase(action="brake"), Phase(action="brake"))), ("car", "ahead", "brake")),
        (EgoSpec(), ("car", "turn_left")),
        (EgoSpec(reaction="yield"), ("car", "turn_left", "yield")),
        (PlaceSpec(kind="road", ego_lane="leftmost"), ("road", "ego_lane=leftmost")),
        (RestrictionsSpec(duration=9, require=(Condition(kind="visible", other="O1"),)), ("visible", "time")),
    ],
)
def test_what_a_component_is_about(spec, about):
    place = PlaceSpec(kind="intersection", manoeuvre="left")
    cid = "O1" if spec.component == "O" else spec.component
    s = Structure(text="x", place=Component(id="R", spec=place), objects=(Component(id="O1", spec=ObjectSpec()),))
    s = s.with_component(Component(id=cid, spec=spec))
    assert terms_of(s, cid) == about


@pytest.mark.full
def test_at_most_three_snippets_share_a_skeleton():
    from scenic.syntax.parser import parse_string

    snippets = list(snippet_files.shipped(shipped("snippets")))
    count = Counter(snippet_files.skeleton(parse_string(s.code, "exec")) for s in snippets)
    assert max(count.values()) <= 3


def test_a_skeleton_ignores_names_and_values():
    first, second, third = (snippet_files.skeleton(ast.parse(c)) for c in ("a = 1 + 2", "b = 3 + 4", "b = 3 - 4"))
    assert first == second != third


def test_the_shipped_vectors_are_those_of_the_shipped_data():
    """What differs was changed since `python -m c2s_engine.retrieve.vectors`, and costs time at the first build."""
    rows = {r.key for batch in sources.shipped_batches() for r in batch.rows}
    known = vectors.known(Embedder().name)
    assert len(rows & known.keys()) > 0.95 * len(rows) and len(known.keys() - rows) < 0.05 * len(rows)
    assert all(abs(float(np.linalg.norm(v)) - 1) < 1e-5 for v in list(known.values())[:50])
    assert vectors.known("another model") == {}


def test_the_client_imports_neither_torch_nor_lancedb():
    code = "import sys, c2s_engine.retrieve.client, c2s_engine.retrieve.commands\n"
    code += "bad = [m for m in ('torch', 'lancedb', 'scenic', 'sentence_transformers') if m in sys.modules]\n"
    code += "sys.exit(str(bad) if bad else 0)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


async def test_a_users_snippets_are_told_by_what_their_code_was_read_to_say() -> None:
    from c2s_engine.retrieve.programs import component_snippets
    from c2s_engine.retrieve.snippet_files import Snippet
    from c2s_engine.structure.components import Component, Structure
    from c2s_engine.structure.specs import Condition, EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec, RestrictionsSpec

    lead = ObjectSpec(name="lead", type="truck", phases=(Phase(action="brake"),), placement=Placement(position="ahead"))
    waits = (Phase(action="wait"),)
    van = ObjectSpec(name="van", type="van", placement=Placement(position="crossing_left"), phases=waits)
    unknown = ObjectSpec(name="thing", type="car")
    ends = RestrictionsSpec(terminate_when=(Condition(kind="stopped"),))
    program = Structure(
        place=Component(id="R", code="a = 1", spec=PlaceSpec(kind="intersection", manoeuvre="left")),
        ego=Component(id="E", code="b = 1", spec=EgoSpec(reaction="brake")),
        objects=tuple(Component(id=f"O{n}", code="c = 1", spec=o) for n, o in enumerate((lead, van, unknown), 1)),
        restrictions=Component(id="T", code="d = 1", spec=ends),
    )  # fmt: skip

    async def decompose(_: str) -> Structure:
        return Structure.model_validate(program.model_dump(mode="json"))

    found = [Snippet(id=str(n), **s) for n, s in enumerate(await component_snippets("", decompose))]
    assert [set(s.terms) for s in found] == [
        {"intersection", "manoeuvre=left"}, {"car", "turn_left", "brake"}, {"truck", "brake"},
        {"van", "crossing_left", "wait"}, {"car"}, {"stopped"},
    ]  # fmt: skip
