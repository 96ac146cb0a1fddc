"""Who touches whom: oriented boxes, seen from above."""

import math
from typing import Any

GRAZE, ASKEW = 3.0, 0.3
"""m/s at which two come nearer whose sides only graze, and the sine of the angle up to which these are sides."""
LOW = 0.3
"""m: props lower than this are driven over."""
WALKER = 0.075
"""t of somebody on foot."""


def corners(x: float, y: float, heading: float, length: float, width: float) -> list[tuple[float, float]]:
    """The corners of a box, anticlockwise."""
    sin, cos = math.sin(heading), math.cos(heading)
    fx, fy = -sin * length / 2, cos * length / 2
    rx, ry = cos * width / 2, sin * width / 2
    return [
        (x + fx - rx, y + fy - ry),
        (x - fx - rx, y - fy - ry),
        (x - fx + rx, y - fy + ry),
        (x + fx + rx, y + fy + ry),
    ]


def boxes_touch(a: Any, b: Any) -> bool:
    """Whether two boxes (x, y, heading, length, width) overlap: no axis of either separates them."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    reach = 0.5 * (math.hypot(a[3], a[4]) + math.hypot(b[3], b[4]))
    if dx * dx + dy * dy > reach * reach:
        return False
    turn = b[2] - a[2]
    c, s = abs(math.cos(turn)), abs(math.sin(turn))
    for one, other in ((a, b), (b, a)):
        sin, cos = math.sin(one[2]), math.cos(one[2])
        ahead, aside = abs(-sin * dx + cos * dy), abs(cos * dx + sin * dy)
        if ahead > 0.5 * (one[3] + other[3] * c + other[4] * s):
            return False
        if aside > 0.5 * (one[4] + other[3] * s + other[4] * c):
            return False
    return True


class Contacts:
    """Finds the first contact of each pair that can collide."""

    def __init__(self, actors: list[Any], kinds: list[str]) -> None:
        self.actors, self.kinds = actors, kinds
        self.pairs: list[tuple[int, int, float]] = []
        for i, one in enumerate(actors):
            for j in range(i):
                if self._can(kinds[i], kinds[j], one, actors[j]):
                    reach = 0.5 * (math.hypot(*one.size[:2]) + math.hypot(*actors[j].size[:2]))
                    self.pairs.append((j, i, reach))
        self.pairs = [pair for pair in self.pairs if not self._touch(pair[0], pair[1])]
        self.found: list[tuple[float, int, int]] = []
        self.touched: list[tuple[int, int, float]] = []

    @staticmethod
    def _can(one: str, other: str, a: Any, b: Any) -> bool:
        if one == other and one in ("walker", "prop"):
            return False
        if "prop" in (one, other):
            return "walker" not in (one, other) and (a if one == "prop" else b).size[2] > LOW
        return True

    def _box(self, i: int) -> tuple[float, float, float, float, float]:
        actor = self.actors[i]
        return actor.body.x, actor.body.y, actor.body.heading, actor.size[0], actor.size[1]

    def _touch(self, i: int, j: int) -> bool:
        return boxes_touch(self._box(i), self._box(j))

    def near(self, reach: float) -> list[tuple[int, int, float]]:
        """The pairs that could touch when each moves by up to `reach` m."""
        found = []
        for pair in self.pairs:
            a, b = self.actors[pair[0]].body, self.actors[pair[1]].body
            limit = pair[2] + reach
            if (a.x - b.x) ** 2 + (a.y - b.y) ** 2 < limit * limit:
                found.append(pair)
        return found

    def check(self, pairs: list[tuple[int, int, float]], time: float) -> None:
        """Note the contacts among those pairs, and what they do to both; those that touched push one another on."""
        for pair in pairs:
            if pair in self.pairs and self._touch(pair[0], pair[1]):
                self.found.append((time, pair[0], pair[1]))
                self.pairs.remove(pair)
                one, other = self.actors[pair[0]].body, self.actors[pair[1]].body
                drive = not {"walker", "prop"} & {self.kinds[pair[0]], self.kinds[pair[1]]}
                if drive:
                    self.touched.append(pair)
                if not drive or not _grazes(one, other, self._axis(*pair[:2])):
                    _crash(one, other, self._share(*pair[:2]))
        for i, j, _ in self.touched:
            if self._touch(i, j):
                _push(self.actors[i].body, self.actors[j].body, self._axis(i, j), self._share(i, j))

    def _share(self, i: int, j: int) -> float:
        """How much of both masses is the first one's; of things, whose mass is not known, a half."""
        if "prop" in (self.kinds[i], self.kinds[j]):
            return 0.5
        one, other = (WALKER if self.kinds[k] == "walker" else self.actors[k].body.kind.mass for k in (i, j))
        return float(one / (one + other))

    def _axis(self, i: int, j: int) -> tuple[float, float]:
        """Across which two boxes that overlap do so least: from the first to the second, of length 1."""
        a, b = self._box(i), self._box(j)
        dx, dy, turn = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        c, s, best = abs(math.cos(turn)), abs(math.sin(turn)), (math.inf, 1.0, 0.0)
        for one, other in ((a, b), (b, a)):
            sin, cos = math.sin(one[2]), math.cos(one[2])
            for x, y, half in ((-sin, cos, one[3] + other[3] * c + other[4] * s),
                               (cos, sin, one[4] + other[3] * s + other[4] * c)):  # fmt: skip
                apart = x * dx + y * dy
                sign = 1.0 if apart >= 0 else -1.0
                best = min(best, (half / 2 - abs(apart), sign * x, sign * y))
        return best[1], best[2]


def _grazes(a: Any, b: Any, axis: tuple[float, float]) -> bool:
    """Whether two touch with their sides as they drive side by side or past one another: both go on."""
    va, vb = a.velocity(), b.velocity()
    closing = (va[0] - vb[0]) * axis[0] + (va[1] - vb[1]) * axis[1]
    along = max(abs(-math.sin(body.heading) * axis[0] + math.cos(body.heading) * axis[1]) for body in (a, b))
    return along < ASKEW and closing < GRAZE


def _push(a: Any, b: Any, axis: tuple[float, float], share: float) -> None:
    """Two that have crashed do not go through one another: across where they touch, they move alike from then on.
    `share`: of both masses the first one's."""
    va, vb = a.velocity(), b.velocity()
    closing = (va[0] - vb[0]) * axis[0] + (va[1] - vb[1]) * axis[1]
    if closing > 0:
        lost, gained = closing * (1 - share), closing * share
        a.set_velocity(va[0] - lost * axis[0], va[1] - lost * axis[1])
        b.set_velocity(vb[0] + gained * axis[0], vb[1] + gained * axis[1])


def _crash(a: Any, b: Any, share: float) -> None:
    """Both move on with the motion that their masses have together, without control; `share`: the first one's."""
    va, vb = a.velocity(), b.velocity()
    mean = (share * va[0] + (1 - share) * vb[0], share * va[1] + (1 - share) * vb[1])
    for body in (a, b):
        body.set_velocity(*mean)
        body.dead = True
