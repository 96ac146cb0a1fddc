"""Braking for who forces one to, as it is laid around what one does of one's own accord."""

import re

from c2s_engine.write.typed import scope

SOFT, HARD = 1.0, 4.5
"""m/s2 at least with which drivers brake for who forces them to; a little more than it takes."""
DRY = 8.0
"""m/s2 of an emergency braking on a dry road."""


def force(threats: list[str]) -> str:
    """The need (m/s2) to brake for one or several."""
    alone = threats[0].removeprefix("*") if len(threats) == 1 else f"[{', '.join(threats)}]"
    return f"braking_needed(self, {alone})"


def around(statements: list[str], threats: list[str], limit: float, braking: str, when: str = "") -> list[str]:
    """The statements, interrupted by `braking` when the need (m/s2) for one of the threats is over `limit`; `when`: a
    condition of that, with its `and`."""
    head, rest = statements[:1], statements[1:]
    around = [*head, "try:", *(f"    {s}" for s in rest)]
    if not threats:
        return around
    return [*around, f"interrupt when {when}{force(threats)} > {scope.number(limit)}:  # m/s2", f"    {braking}"]


def brakes(threats: list[str], least: float = SOFT, release: float = 0, stands: float = 0) -> str:
    """Braking with `least` m/s2 or more until the need of it is no more than `release`, or to a stand and until it is
    no more than `stands`."""
    more = f", least={scope.number(least)}" if least != SOFT else ""
    more += f", stands={scope.number(stands)}" if stands else f", release={scope.number(release)}" if release else ""
    return f"do BrakeFor(line, {_them(threats)}{more})"


def stops(threats: list[str], rate: float) -> str:
    """To a stand with all that the road holds (m/s2), until the cause is gone."""
    return f"do EmergencyStop(line, {_them(threats)}{f', rate={scope.number(rate)}' if rate != DRY else ''})"


def _them(threats: list[str]) -> str:
    """One or several, as an argument: by a function where it changes who of them is to be seen."""
    if len(threats) == 1 and re.fullmatch(r"\w+", threats[0]):
        return threats[0]
    listed = f"[{', '.join(threats)}]"
    return listed if all(re.fullmatch(r"\*?[\w\[\]-]+", t) for t in threats) else f"lambda: {listed}"
