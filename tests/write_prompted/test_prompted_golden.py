"""The prompts of every configuration as golden files, with their lengths: what a model is told must not drift unseen.

`C2S_GOLDEN=1 pytest tests/write_prompted/test_prompted_golden.py` writes them anew.
"""

import os
from pathlib import Path

import pytest
import yaml

from c2s_engine.interpret.llm import settings, words
from c2s_engine.interpret.llm.components import ObjectSentence, Sentences, instructions
from c2s_engine.interpret.llm.forms import form_of
from c2s_engine.models import approximate_tokens
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.progress import Passage
from c2s_engine.structure.specs import ObjectSpec, SettingsSpec
from c2s_engine.write.prompted.checking import with_code
from c2s_engine.write.prompted.configuration import configuration, names
from c2s_engine.write.prompted.header import Ground, settings_text
from c2s_engine.write.prompted.prompt import generator_question
from tests.golden import assert_same
from tests.write_prompted.programmer import EXAMPLE

TYPED = "typed"
GOLDEN = Path(__file__).parent / "golden"
NEAR = [Passage(kind="snippet", title="A van at the kerb.", text="van = new Van right of spot by 2", score=0.8)]
CHUNKS = [Passage(kind="doc", title="Specifiers", text="A specifier sets properties.", score=0.5, clause="Syntax")]


def scenario() -> Structure:
    structure = Structure(
        text=EXAMPLE.description, objects=tuple(Component(id=f"O{i}", spec=ObjectSpec()) for i in (1, 2))
    )
    for part in EXAMPLE.fragments:
        component = structure[part.id].model_copy(update={"description": part.sentence})
        structure = structure.with_component(with_code(component, part.code))
    settings = structure.settings.model_copy(update={"spec": SettingsSpec(weather=("cloudy",))})
    return structure.with_component(settings)


def prompts(name: str) -> dict[str, str]:
    config, structure, told = configuration(name), scenario(), {}
    for cid in ("G", "R", "E", "O2", "T"):
        asked = generator_question(
            structure,
            cid,
            config,
            NEAR if config.has("CodeICL") and cid != "G" else (),
            CHUNKS if config.has("DocICL") and cid != "G" else (),
            settings=settings_text(structure, Ground()) if cid == "G" else "",
        )
        told[cid] = "\n\n".join(f"[{m.role}]\n{m.content}" for m in asked.messages)
    return told


def forms() -> dict[str, str]:
    """The instructions of the typed method's forms: a vehicle's (O1), a person's (O2), a thing's (O3), for a text that
    says nothing, and those for a text that says something of everything (`all`)."""
    kinds = ("car", "pedestrian", "cone")
    sentences = Sentences(objects=tuple(ObjectSentence(type=k, sentence=f"A {k}.") for k in kinds))
    told = {cid: form_of(cid, "", sentences).system for cid in sentences.ids[1:]}
    cases = yaml.safe_load((Path(__file__).parents[1] / "models" / "offered.yaml").read_text(encoding="utf-8"))
    everything = " ".join(case["says"] for case in cases)
    told |= {f"{cid} all": form_of(cid, everything, sentences).system for cid in sentences.ids[1:]}
    told["G all"] = settings.form_of(everything).system
    return {"components": instructions(), "G": settings.form_of("").system, **told}


@pytest.mark.parametrize("name", [*names(), TYPED])
def test_the_prompts_are_as_they_were(name):
    told = forms() if name == TYPED else prompts(name)
    text = "\n\n".join(f"======== {cid} ========\n{prompt}" for cid, prompt in told.items()) + "\n"
    lengths = {cid: approximate_tokens(prompt) for cid, prompt in told.items()}
    path, table = GOLDEN / f"{name}.txt", GOLDEN / "tokens.yaml"
    assert_same(text, path)
    if os.environ.get("C2S_GOLDEN"):
        known = yaml.safe_load(table.read_text()) if table.exists() else {}
        known = {n: {**known, name: lengths}.get(n) for n in (*names(), TYPED) if n in known or n == name}
        table.write_text(
            "# Tokens of each prompt, at four characters a token.\n" + yaml.safe_dump(known, sort_keys=False)
        )
    assert yaml.safe_load(table.read_text())[name] == lengths


def test_each_prompt_leaves_room_for_an_answer_in_8k():
    lengths = yaml.safe_load((GOLDEN / "tokens.yaml").read_text())
    assert list(lengths) == [*names(), TYPED]
    assert max(max(row.values()) for row in lengths.values()) <= 8192 - 1536 - 2000, (
        "and for 2000 tokens of code so far"
    )
    assert max(lengths[TYPED].values()) <= 800, "forms are for small models, and there is one for each component"
    assert sum(lengths["C1"].values()) < sum(lengths["C4"].values()) < sum(lengths["C11"].values())


def test_prompts_say_something_of_every_word_of_the_vocabulary():
    for section, short in words.shortened().items():
        assert list(short) == list(words.vocabulary()[section]), section
    told = words.lines("actions", ["turn_left", "brake", "u_turn"])
    assert told == "- brake: to speed; hard from rate 4 on\n- turn_left, u_turn"


def test_the_paper_s_sentences_are_asked_for_in_order():
    sentences = Sentences(place="A road.", objects=(ObjectSentence(type="car", sentence="A car."),))
    assert sentences.ids == ["G", "R", "E", "O1", "T"]
