"""A session as one JSON file: its turns with the state after each, up to where it stands."""

import json
from typing import Any

from pydantic import ValidationError

from c2s_engine.session.errors import SessionError
from c2s_engine.session.saver import SessionSaver
from c2s_engine.session.state import State
from c2s_engine.session.store import Store, TurnRow

FORMAT = "c2s session 1"


def bundle(store: Store, thread: str, name: str) -> str:
    """The file's text."""
    saver, turns = SessionSaver(store), store.turns(thread)
    row = next(r for r in store.rows() if r.thread == thread)
    path, at = [], row.head
    while at in turns:
        turn = turns[at]
        found = saver.get_tuple({"configurable": {"thread_id": thread, "checkpoint_ns": "", "checkpoint_id": at}})
        state = dict(found.checkpoint["channel_values"]["state"] if found else State().model_dump(mode="json"))
        state["details"] = {k: v for k, v in state["details"].items() if k != "folder"}  # of this machine alone
        told = {"kind": turn.kind, "text": turn.text, "when": turn.when, "summary": turn.summary}
        path.append({**told, "replies": list(turn.replies), "state": state})
        at = turn.parent
    return json.dumps({"format": FORMAT, "name": name, "turns": path[::-1]}, indent=1, ensure_ascii=False) + "\n"


def unbundle(store: Store, text: str, origin: str, name: str | None) -> str:
    """Make a session of a file's text; returns its name."""
    try:
        data = json.loads(text)
        turns = [(t, State.model_validate(t["state"])) for t in data["turns"]] if data["format"] == FORMAT else None
        wanted = name or str(data["name"])
    except (ValueError, KeyError, TypeError, ValidationError):
        raise SessionError(f"{origin} is not an exported session") from None
    if turns is None:
        raise SessionError(f"{origin} is not an exported session of this version ({FORMAT})")
    taken = {r.name for r in store.rows()}
    free, number = wanted, 2
    while free in taken:
        free, number = f"{wanted} {number}", number + 1
    row = store.create(free)
    _restore(store, row.thread, turns)
    return free


def _restore(store: Store, thread: str, turns: list[tuple[dict[str, Any], State]]) -> None:
    from c2s_engine.session.turns import build_turns

    graph = build_turns(None, SessionSaver(store))  # type: ignore[arg-type]
    parent = None
    at: Any = {"configurable": {"thread_id": thread}}
    for told, state in turns:
        values = {"request": {}, "state": state.model_dump(mode="json")}
        at = graph.update_state(at, values, as_node="turn")
        checkpoint = at["configurable"]["checkpoint_id"]
        replies = tuple(told["replies"])
        row = TurnRow(checkpoint, parent, told["kind"], told["text"], told["when"], told["summary"], replies)
        store.add_turn(thread, row)
        parent = checkpoint
