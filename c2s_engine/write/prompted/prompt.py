"""The prompt of one component: the role, the blocks of the configuration, and what the component builds on."""

from collections.abc import Sequence

from c2s_engine.models.messages import Question, question
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.progress import Passage
from c2s_engine.write.prompted import blocks
from c2s_engine.write.prompted.checking import Verdict, body
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
    later = [c for c in structure.ids[structure.ids.index(cid) + 1 :] if c[0] in "EO"] if kind in "EO" else []
    description = structure[cid].description or _unsaid(kind)
    if kind == "G":
        task = fill("user_G", settings=settings, description=description)
    else:
        pending = f"\n{fill('later', ids=', '.join(later))}\n" if later else ""
        task = fill("user", related=related(structure, cid), code=code_so_far(structure, cid), id=cid,
                    later=pending, description=description)  # fmt: skip
    user = "\n\n".join(p for p in (*retrieved, task) if p)
    return question(system_prompt(kind, cid, config), user, purpose=f"generate {kind}", component=cid)


def repair_question(
    structure: Structure,
    cid: ComponentId,
    current: Verdict,
    before: Sequence[Verdict],
    passage: Passage | None,
    config: Configuration,
) -> Question:
    """The question for one fragment that does not pass, with its finding, the passage that may help, what the others
    say, and what was tried before."""
    finding = current.diagnostic
    assert finding is not None
    numbered = "\n".join(f"{i:3} {line}" for i, line in enumerate(current.code.splitlines(), 1))
    parts = [fill("role")]
    if config.has("CP"):
        about = f"{current.code} {finding.message} {finding.fix}"
        parts.append(blocks.contextual(cid[0], about))
    user = fill(
        "repair", id=cid, code=code_so_far(structure, cid), fragment=numbered, stage=finding.stage,
        where=f", line {finding.line}" if finding.line else "", message=finding.message,
        fix=f"What may help: {finding.fix}" if finding.fix else "",
        passage=blocks.chunks([passage]) if passage else "", related=related(structure, cid),
        tried=_tried(before, finding),
        description=structure[cid].description or _unsaid(cid[0]),
    )  # fmt: skip
    return question("\n\n".join(parts), user, purpose=f"repair {cid[0]}", component=cid)


def _tried(before: Sequence[Verdict], finding: Diagnostic) -> str:
    """The versions of before with what was found in each, and whether the last change helped."""
    refused = [(v.code, v.diagnostic) for v in before if v.diagnostic]
    if not refused:
        return ""
    rows = [f"Version {i}:\n```scenic\n{c}\n```\nFinding: {d.message}" for i, (c, d) in enumerate(refused, 1)]
    last = refused[-1][1]
    same = " The finding is still the same: write it in another way." if last.message == finding.message else ""
    return "\n".join(["Tried before, and refused:", *rows, f"Write none of these again.{same}", ""])


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
        "T": "end the run after 20 seconds",
    }[kind]
