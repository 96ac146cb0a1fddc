"""The reference of S in the documentation is the generated one."""

from pathlib import Path

from c2s_engine.write.typed.reference import markdown

PAGE = Path(__file__).parents[2] / "docs" / "VOCABULARY.md"


def test_the_page_is_up_to_date():
    assert PAGE.read_text(encoding="utf-8") == markdown()


def test_the_page_names_every_field_action_and_contradiction():
    page = markdown()
    for name in ("`hidden_by`", "`cut_in`", "`crossing_left`", "no road crosses a motorway", "`oncoming_intrusion`"):
        assert name in page
