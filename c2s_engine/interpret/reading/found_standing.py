"""Who is found standing: participles that the tree takes for what one does ("struck V2, legally parked at the kerb",
"did not see V2 stopped ahead", "noticed a van stopped ahead and braked")."""

from __future__ import annotations
