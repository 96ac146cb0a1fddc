"""Whether the whole way goes through: every description ends in a program that runs, or in a refusal that says why."""
