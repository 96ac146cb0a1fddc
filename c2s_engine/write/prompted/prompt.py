"""The prompt of one component: the role, the blocks of the configuration, and what the component builds on."""

from collections.abc import Sequence

from c2s_engine.models.messages import Question, question
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.progress import Passage
from c2s_engine.write.prompted import blocks
from c2s_engine.write.prompted.checking import body
from c2s_engine.write.prompted.configuration import Configuration
from c2s_engine.write.prompted.texts import fill


def system_prompt(kind: str, cid: ComponentId, config: Configuration) -> str:
    """Everything that does not depend on the scenario."""
    parts = [fill("role"), fill(f"task_{kind}", id=cid) if kind == "O" else fill(f"task_{kind}")]
    if config.has("CP"):
        parts.append(blocks.contextual(kind))
    if config.has("CoT"):
        parts.append(blocks.thinking(kind))
    if config.has("ICL"):
        parts.append(blocks.fixed_examples(kind))
    parts.append(fill("answer_cot" if config.has("CoT") else "answer"))
    return "\n\n".join(parts)


def generator_question(
    structure: Structure,
    cid: ComponentId,
    config: Configuration,
    snippets: Sequence[Passage] = (),
    chunks: Sequence[Passage] = (),
    settings: str = "",
) -> Question:
    """The question to Generator_R, _E, _O, _T, or (with `settings`) to the HeaderGenerator."""
    kind = cid[0]
    retrieved = [blocks.snippets(snippets), blocks.chunks(chunks)]
    description = structure[cid].description or _unsaid(kind)
    if kind == "G":
        task = fill("user_G", settings=settings, description=description)
    else:
        task = fill("user", related=related(structure, cid), code=code_so_far(structure, cid), id=cid,
                    description=description)  # fmt: skip
    user = "\n\n".join(p for p in (*retrieved, task) if p)
    return question(system_prompt(kind, cid, config), user, purpose=f"generate {kind}", component=cid)


def repair_question(
    structure: Structure,
    cid: ComponentId,
    code: str,
    finding: Diagnostic,
    passage: Passage | None,
    config: Configuration,
) -> Question:
    """The question for one fragment that does not pass, with its finding and the passage that may help."""
    numbered = "\n".join(f"{i:3} {line}" for i, line in enumerate(code.splitlines(), 1))
    parts = [fill("role")]
    if config.has("CP"):
        parts.append(blocks.contextual(cid[0]))
    user = fill(
        "repair", id=cid, code=code_so_far(structure, cid), fragment=numbered, stage=finding.stage,
        where=f", line {finding.line}" if finding.line else "", message=finding.message,
        fix=f"What may help: {finding.fix}" if finding.fix else "",
        passage=blocks.chunks([passage]) if passage else "",
        description=structure[cid].description or _unsaid(cid[0]),
    )  # fmt: skip
    return question("\n\n".join(parts), user, purpose=f"repair {cid[0]}", component=cid)


def code_so_far(structure: Structure, cid: ComponentId) -> str:
    """The code of the components before this one (Algorithm 1)."""
    earlier = structure.ids[: structure.ids.index(cid)]
    return "\n\n".join(body(structure[c].code).strip() for c in earlier if structure[c].code) or "# nothing yet"


def related(structure: Structure, cid: ComponentId) -> str:
    """The descriptions of the components that belong together with this one: all but the settings."""
    rows = [f"- {c.id}: {c.description}" for c in structure.components if c.description and c.id not in ("G", cid)]
    return "\n".join(rows) or "- nothing else is described"


def _unsaid(kind: str) -> str:
    return {
        "G": "the settings as given",
        "R": "a road where the other components can take place",
        "E": "the ego car drives in its lane",
        "O": "a car in ego's lane",
        "T": "nothing is described",
    }[kind]
