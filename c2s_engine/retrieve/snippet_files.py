"""The shipped snippets: .scenic files whose head is YAML in comment lines, ended by `# ---`."""

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, Literal

import yaml
from pydantic import BaseModel, ConfigDict, ValidationError

from c2s_engine.retrieve.errors import BadDocument
from c2s_engine.retrieve.rows import Row

END = "# ---"
FOLDERS = ("R", "E", "O", "T")


class Snippet(BaseModel):
    """A component-level snippet: what it is, and the code of that one component.

    `hosts`: the ids of the snippets that it stands upon in a whole program, where the plain ones would not do."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str
    component: Literal["R", "E", "O", "T"]
    description: str
    paraphrases: tuple[str, ...] = ()
    places: tuple[str, ...] = ()
    manoeuvres: tuple[str, ...] = ()
    controls: tuple[str, ...] = ()
    ego_lanes: tuple[str, ...] = ()
    positions: tuple[str, ...] = ()
    actions: tuple[str, ...] = ()
    types: tuple[str, ...] = ()
    conditions: tuple[str, ...] = ()
    reactions: tuple[str, ...] = ()
    hosts: tuple[str, ...] = ()
    code: str

    @property
    def terms(self) -> tuple[str, ...]:
        """The words of the specs' vocabulary that it is about; details of a place with their field."""
        details = {"manoeuvre": self.manoeuvres, "control": self.controls, "ego_lane": self.ego_lanes}
        return (*self._search_terms, *(f"{field}={word}" for field, words in details.items() for word in words))

    @property
    def _search_terms(self) -> tuple[str, ...]:
        return (*self.actions, *self.reactions, *self.places, *self.positions, *self.types, *self.conditions)

    @property
    def keywords(self) -> str:
        """These as a phrase, without the details of places: "cut in, left lane, car"."""
        return ", ".join(t.replace("_", " ") for t in self._search_terms)

    @property
    def phrases(self) -> tuple[str, ...]:
        """All its descriptions."""
        return (self.description, *self.paraphrases)


def parse(text: str, id: str) -> Snippet:
    """The snippet in a file's text; raises BadDocument."""
    head, found, code = text.partition(f"{END}\n")
    if not found:
        raise BadDocument(f"{id} has no head: comment lines of YAML, then a line `{END}`.")
    try:
        data: Any = yaml.safe_load("\n".join(re.sub(r"^# ?", "", line) for line in head.splitlines()))
        return Snippet(id=id, code=code.strip("\n") + "\n", **data)
    except (yaml.YAMLError, ValidationError, TypeError) as error:
        raise BadDocument(f"{id}: its head is not valid ({str(error).splitlines()[0]}).") from None


def shipped(folder: Path) -> Iterator[Snippet]:
    """The snippets of a folder with the sub-folders R, E, O and T, in the order of their names."""
    for component in FOLDERS:
        for path in sorted((folder / component).glob("*.scenic")):
            yield parse(path.read_text(), f"{component}/{path.stem}")


def rows(snippets: Iterable[Snippet], source_id: str, source: str) -> list[Row]:
    """One row a phrase; the code is read by BM25 with the first of them only."""
    found = []
    for snippet in snippets:
        tags = snippet.keywords.replace(",", "")
        full = f"{snippet.description}\n{tags}\n{snippet.code}"
        for i, phrase in enumerate(dict.fromkeys([*snippet.phrases, snippet.keywords] if tags else snippet.phrases)):
            found.append(
                Row(item=snippet.id, source_id=source_id, title=snippet.description, text=snippet.code, embedded=phrase,
                    lexical="" if phrase == snippet.keywords else full if i == 0 else phrase, source=source,
                    component=snippet.component, terms=" ".join(snippet.terms))
            )  # fmt: skip
    return found


class _Normal(ast.NodeTransformer):
    """Names, numbers and strings away: what is left is the skeleton."""

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        return ast.copy_location(ast.Constant(value=type(node.value).__name__), node)


def skeleton(tree: ast.AST) -> str:
    """A parsed fragment without its own names and its values: two snippets with one skeleton differ in values only."""
    own: dict[str, str] = {}
    kept = _NAMES_THAT_MATTER
    dump = ast.dump(_Normal().visit(tree))

    def rename(match: re.Match) -> str:
        name = match[2]
        if name in kept or not name.isidentifier():
            return match[0]
        return f"{match[1]}='{own.setdefault(name, f'v{len(own)}')}'"

    return re.sub(r"\b(id|name|arg|attr|target)='(\w+)'", rename, dump)


_NAMES_THAT_MATTER = frozenset(
    [
        "ego",
        "egoLane",
        "egoSpot",
        "network",
        "Car",
        "Truck",
        "Van",
        "Bus",
        "Motorcycle",
        "Bicycle",
        "Pedestrian",
        "FollowLaneBehavior",
        "FollowTrajectoryBehavior",
        "LaneChangeBehavior",
        "TurnBehavior",
        "SetBrakeAction",
        "SetThrottleAction",
        "SetSteerAction",
        "SetSpeedAction",
        "SetReverseAction",
        "SetHandBrakeAction",
        "SetVelocityAction",
        "SetWalkingSpeedAction",
        "SetWalkingDirectionAction",
        "Range",
        "Uniform",
        "DiscreteRange",
        "Normal",
        "Options",
        "TruncatedNormal",
        "filter",
        "len",
        "ManeuverType",
        "intersections",
        "lanes",
        "laneSections",
        "roads",
        "maneuvers",
        "reverseManeuvers",
        "centerline",
        "sidewalk",
        "shoulder",
        "curb",
        "road",
        "_laneToLeft",
        "_laneToRight",
        "laneToLeft",
        "laneToRight",
        "speed",
        "lane",
        "opposite",
        "crossings",
        "group",
    ]
)
