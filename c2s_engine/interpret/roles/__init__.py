"""Who plays which part: who is ego, who belongs to the scene."""
