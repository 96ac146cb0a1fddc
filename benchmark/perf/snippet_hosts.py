"""A snippet in a minimal program of its own: the place and the ego that it stands upon, and what else it names."""

from c2s_engine.paths import shipped
from c2s_engine.retrieve.snippet_files import Snippet

PLACE, EGO = "R/road_any_long_lane", "E/cruise_lane"
HEAD = """param map = localPath({town!r})
param carla_map = None
param weather = 'ClearNoon'
model scenic.simulators.carla.model
"""


def host_program(snippet: Snippet, snippets: dict[str, Snippet]) -> str:
    """The program: settings, place, ego, further objects, restrictions, with the snippet in its slot."""
    parts = {"R": [], "E": [], "O": [], "T": []}
    parts[snippet.component].append(snippet)
    todo = list(snippet.hosts)
    while todo:
        host = snippets[todo.pop(0)]
        parts[host.component].append(host)
        todo += [h for h in host.hosts if not parts[h[0]]]
    if not parts["R"]:
        parts["R"].append(snippets[PLACE])
    if not parts["E"]:
        parts["E"].append(snippets[EGO])
    code = [part.code for kind in "REOT" for part in parts[kind]]
    return HEAD.format(town=str(shipped("maps", "town.xodr"))) + "\n" + "\n".join(code)
