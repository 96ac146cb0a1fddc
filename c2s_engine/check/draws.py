"""What statements draw from the random generators while they are executed, so that another seed can be told from here.

Scenic draws one sample of a random region to see whether regions of its kind give an orientation: nothing else of it is
kept. Who has executed statements with one seed can stand for another seed where all samples drawn anew say the same.
"""

from typing import Any

from c2s_engine.check import warm


class Draws:
    """Watches the draws of what is executed meanwhile."""

    def __init__(self) -> None:
        self.known = True  # whether nothing was drawn but for what `repeat` can draw again
        self._asked: list[tuple[Any, bool]] = []

    def __enter__(self) -> "Draws":
        from scenic.syntax import veneer

        self._original = veneer.alwaysProvidesOrientation
        veneer.alwaysProvidesOrientation = self._ask
        warm.reseed(0)
        self._state = warm.random_state()
        return self

    def __exit__(self, *_: object) -> None:
        from scenic.syntax import veneer

        self._compare()
        veneer.alwaysProvidesOrientation = self._original

    def _ask(self, region: Any) -> bool:
        self._compare()
        answer = self._original(region)
        self._state = warm.random_state()
        self._asked.append((region, answer))
        return answer

    def _compare(self) -> None:
        self.known = self.known and warm.random_state() == self._state

    def repeat(self, seed: int) -> bool:
        """Set the random states as this seed would have left them; False where it could have gone otherwise."""
        warm.reseed(seed)
        return all(self._original(region) == answer for region, answer in self._asked)
