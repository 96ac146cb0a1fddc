"""The blocks of a generator's prompt: CP from the installed Scenic, CoT, ICL; CodeICL and DocICL as retrieved."""

import re
from collections.abc import Sequence
from functools import cache
from typing import Any

import yaml

from c2s_engine.structure.progress import Passage
from c2s_engine.write.prompted import knowledge
from c2s_engine.write.prompted.examples import examples
from c2s_engine.write.prompted.texts import fill, read

LONGEST_SNIPPET = 1600
LONGEST_CHUNK = 1200


@cache
def operators() -> list[dict[str, str]]:
    """The operators and specifiers that are offered, each with an example."""
    return yaml.safe_load(read("cp", "operators.yaml"))


@cache
def contextual(kind: str, about: str | None = None) -> str:
    """CP: what holds for every component, and what this kind needs to know; of the network only what some words are
    about, where those are given."""
    common = fill(
        "cp/common",
        version=knowledge.version(),
        maneuvers=", ".join(knowledge.maneuver_types()),
        operators="\n".join(f"- {o['form']}: {o['means']}" for o in operators()),
    )
    return f"{common}\n\n{fill(f'cp/{kind}', **_facts(kind, about))}"


def _facts(kind: str, about: str | None = None) -> dict[str, str]:
    classes = knowledge.object_classes()
    lights = [f for f in knowledge.functions() if "TrafficLight" in f]
    if kind == "G":
        return {"lights": ", ".join(lights)}
    if kind == "R":
        elements = {n: a for n, a in knowledge.road_elements().items() if a}
        if about is not None:
            elements = {n: a for n, a in elements.items() if _concerns(n, a, about)}
        rows = "\n".join(f"- {name}: {', '.join(attributes)}" for name, attributes in elements.items())
        return {"hierarchy": knowledge.road_hierarchy(), "elements": rows}
    if kind == "T":
        return {}
    facts = {
        "vehicles": ", ".join(classes["vehicles"]),
        "behaviours": ", ".join(knowledge.behaviours()),
        "actions": ", ".join(knowledge.actions()),
        "functions": ", ".join(knowledge.functions()),
    }
    if kind == "O":
        facts |= {"persons": ", ".join(classes["persons"]), "props": ", ".join(classes["props"])}
    return facts


def _concerns(name: str, attributes: list[str], about: str) -> bool:
    """Whether an element, or something that only few elements have, is spoken of."""
    plural = name[0].lower() + name[1:].removesuffix("y") + ("ies" if name.endswith("y") else "s")
    words = set(re.findall(r"\w+", about))
    return bool({name, plural, *(a.split("(")[0] for a in attributes if len(a) > 8)} & words)


def thinking(kind: str) -> str:
    """CoT: the steps for this kind."""
    return fill(f"cot/{kind}")


@cache
def example_table() -> dict[str, Any]:
    """Which examples and which pairs of mistakes are shown for each kind."""
    return yaml.safe_load(read("icl", "examples.yaml"))


@cache
def fixed_examples(kind: str) -> str:
    """ICL: components with what they build on, and mistakes with their corrections."""
    table = example_table()
    shown = []
    for number in table["examples"][kind]:
        example = examples()[number]
        part = example.of_kind(kind)
        before = example.before(part.id) if kind != "G" else ""
        built_on = f"Code so far:\n{_code(before)}\n" if before else ""
        shown.append(f"{built_on}Component {part.id}: {part.sentence}\n{_code(part.code)}")
    pairs = [f"- {p['why']}\nWrong:\n{_code(p['wrong'])}\nRight:\n{_code(p['right'])}" for p in table["pairs"][kind]]
    return fill("icl", examples="\n\n".join(shown), pairs="\n".join(pairs))


def snippets(found: Sequence[Passage]) -> str:
    """CodeICL: retrieved component snippets."""
    if not found:
        return ""
    shown = [f"- {p.title}\n{_code(p.text[:LONGEST_SNIPPET])}" for p in found]
    return fill("codeicl", snippets="\n".join(shown))


def chunks(found: Sequence[Passage]) -> str:
    """DocICL: retrieved chunks of the documentation."""
    if not found:
        return ""
    shown = [f"[{p.title}{f', {p.clause}' if p.clause else ''}]\n{p.text[:LONGEST_CHUNK].strip()}" for p in found]
    return fill("docicl", chunks="\n\n".join(shown))


def _code(text: str) -> str:
    return f"```scenic\n{text.strip()}\n```"
