"""Labels of road users (V2, Unit 1), and who a name, label or noun stands beside: "V2, a car", "a car (V2)"."""

from __future__ import annotations

import re
from collections.abc import Callable

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.nouns import Nouns

STANDS, STANDS_STILL = language.words("stands"), language.words("stands_still")


class Labels(Nouns):
    """The part of Cast that resolves labels."""

    one_is_ego: bool

    def _label_is_ego(self) -> bool:
        """Whether number 1 is ego although ego has another name: "V1, the subject vehicle"."""
        if not self.strong_ego:
            return True
        text = self._about_one("@ego", lambda span: span.kind == "ego")
        return bool(re.search(r"@one (,|\(|is|was|being|, which is) (the )?@ego|@ego (,|\(|is|was) ?\(? ?@one", text))

    def _about_one(self, mark: str, marked: Callable[[Span], bool]) -> str:
        """The text with number 1 as "@one" and what else is looked for as a mark."""

        def shown(word: Word) -> str:
            if word.span and word.span.kind == "label" and word.span.data["label"] == "1":
                return "@one"
            return mark if word.span and marked(word.span) else word.norm

        return " ".join(shown(w) for w in self.words)

    def _labelled(self, word: Word) -> Entity | None:
        data = word.span.data  # type: ignore[union-attr]
        label = data["label"]
        if label == "1" and self.one_is_ego:
            host = self._apposed(word)
            if host and not host.ego and len(host.mentions) <= 2:
                self.become_ego(host)
            return self.ego
        host = self._copula(word)
        state = self.words[word.i - 1].norm if word.i and self.words[word.i - 1].sentence == word.sentence else ""
        stands = {role for role in [language.roles().get(state)] if role and state in STANDS}
        known = next((e for e in self.entities if e.label == label), None)
        if known is not None:
            known.roles |= stands
            return known
        host = self._apposed(word)
        if host and not host.ego and not host.label:
            host.label = label
            return host
        noun = data["word"] if data["word"] in language.actor_nouns() else label.rsplit(" ", 1)[0]  # "van a" by "a"
        part = noun in language.table("ego")["labels"]["parts"]
        typed = " " in label and noun in language.actor_nouns() and not part
        kind = language.actor_nouns()[noun][0] if typed else "vehicle"
        return self._new(
            Entity("", kind, noun=noun if typed else "", label=label, typed=kind != "vehicle", roles=stands)
        )

    def become_ego(self, entity: Entity) -> None:
        """Take an entity for ego."""
        for mention in entity.mentions:
            self.of[mention.word] = self.ego
        self.subjects = [(i, self.ego if e is entity else e) for i, e in self.subjects]

    def _apposed(self, word: Word) -> Entity | None:
        """The entity that a label or noun stands beside: "a car (V2)", "V2, a car", "V2 was a truck"."""
        before = [w for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence]
        gap: list[str] = []
        for other in reversed(before):
            if other.i in self.of:
                text = re.sub(
                    r"^(ahead|in front|behind|alongside|ahead of it|in front of it) ", "", " ".join(reversed(gap))
                )
                if re.fullmatch(
                    (
                        r"(\(|,|, which (is|was)|:|-+|, (driven|operated) by)?( ?(the|a|an|another|called"
                        r"|designated|labelled|labeled|as|known as|i\.e\.|ie|namely))?( [\w-]+){0,4}"
                    ),
                    text,
                ) and (gap and gap[-1] in ("(", ",", "-", "--", ":") or not gap):
                    if (
                        gap
                        and gap[-1] == ","
                        and not re.search(r"\b(a|an|the|called|as)\b", text)
                        and word.dep != "appos"
                    ):
                        return None
                    return self.of[other.i]
                return None
            gap.append(other.norm)
        return None

    def _copula(self, word: Word) -> Entity | None:
        """The subject of "X is/was a truck"."""
        head = self.words[word.head]
        near = [w.norm for w in self.words[max(0, word.i - 2) : word.i] if w.sentence == word.sentence]
        if {"behind", "beside", "near", "past", "between"} & set(near):
            return None
        if word.dep == "pobj" and head.norm == "as" and (verb := self.words[head.head]).lemma in STANDS_STILL:
            subjects = (c for c in verb.children if self.words[c].dep in ("nsubj", "nsubjpass") and c < word.i)
            return next((self.of[c] for c in subjects if c in self.of), None)  # "stopped as the last car"
        if word.dep == "attr" and head.lemma == "be" and near[-1:] != ["as"]:
            for child in head.children:
                if (
                    self.words[child].dep == "nsubj"
                    and child in self.of
                    and child < word.i
                    and self.words[child].norm not in ("it", "they")
                ):
                    return self.of[child]
                if self.words[child].dep == "nsubj" and child < word.i:
                    return None
        return None
