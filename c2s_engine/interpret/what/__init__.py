"""What happens: verbs and nouns of motion become events, with who, whom, how and when."""
