"""`python -m tests.models.measure_tokens`: what the typed method costs on the development texts of median length.

The model is a stand-in that fills the forms with the learned reader's fields, so that answers have the usual
length. Tokens are estimated twice: four characters each, and by the WordPiece vocabulary of the embedding model, which
has a quarter of the words of today's models and so counts too many. Only sums are printed.
"""

import asyncio
import json
import statistics
from typing import Any

from tokenizers import Tokenizer

from c2s_bench.records import load
from c2s_engine.interpret.learned import learned
from c2s_engine.interpret.llm import interpret
from c2s_engine.models import ModelSettings, OllamaClient, approximate_tokens
from c2s_engine.retrieve.embedder import Embedder
from c2s_engine.structure.components import Structure
from tests.models.answers import asked_of
from tests.models.fake_ollama import FakeOllama, said

TEXTS = 24


def _still(spec: Any) -> bool:
    return spec.speed == 0 and not spec.phases or [p.action for p in spec.phases] == ["stationary"]


def mirror(structure: Structure, request: dict[str, Any]) -> str:
    """The form that a request asks for, filled in with what a structure says."""
    cid = asked_of(request)
    if not cid:
        objects = [
            {"type": o.spec.type, **({"still": True} if _still(o.spec) else {}), "sentence": o.description}
            for o in structure.objects
        ]
        names = {"settings": structure.settings, "place": structure.place, "ego": structure.ego}
        return json.dumps({**{n: c.description for n, c in names.items()}, "objects": objects[:8]})
    spec = structure[cid].spec.model_dump(mode="json")
    if cid == "G":
        return json.dumps({n: {"value": spec[n], "confidence": 1} for n in ("weather", "time") if spec[n]})
    told = structure[cid].spec.model_dump(mode="json", exclude_defaults=True)
    wanted = {n: spec[n] for n in spec if n in request["format"].get("required", ()) or n in told}
    return json.dumps(_of_form(request["format"], wanted))


def _of_form(schema: dict[str, Any], value: Any) -> Any:
    """What of a value the form has fields for."""
    if isinstance(value, dict):
        kept = {n: s for n, s in schema.get("properties", {}).items() if value.get(n) not in (None, "", [])}
        return {n: _of_form(s, value[n]) for n, s in kept.items()}
    if isinstance(value, list) and "items" in schema:
        return [_of_form(schema["items"], item) for item in value]
    return value


async def costs() -> list[tuple[int, int]]:
    """(by characters, by WordPiece) for each of the texts."""
    words = Tokenizer.from_file(f"{Embedder().source}/tokenizer.json")
    words.no_truncation()
    words.no_padding()
    median = statistics.median(len(r.text.split()) for r in load())
    texts = sorted((r.text for r in load(split="dev")), key=lambda t: abs(len(t.split()) - median))[:TEXTS]
    found = []
    with FakeOllama() as server:
        for text in texts:
            structure = learned(text).structure
            exchanged: list[str] = []

            def respond(request, structure=structure, exchanged=exchanged):
                answer = mirror(structure, request)
                exchanged.extend((said(request), answer))
                return answer

            server.respond = respond
            async with OllamaClient(ModelSettings(model="small", host=server.host, probe=False)) as client:
                await interpret(text, client=client, reader=learned)
            pieces = sum(len(words.encode(t, add_special_tokens=False).ids) for t in exchanged)
            found.append((sum(map(approximate_tokens, exchanged)), pieces))
    return found


if __name__ == "__main__":
    for name, row in zip(
        ("four characters a token", "WordPiece"), zip(*asyncio.run(costs()), strict=True), strict=True
    ):
        over = sum(n > 8000 for n in row)
        print(f"{name}: median {statistics.median(row):.0f}, most {max(row)}, {over} of {len(row)} over 8,000")
