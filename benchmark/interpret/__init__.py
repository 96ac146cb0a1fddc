"""The suite of the interpreter: what S says of texts, stage by stage, compared with what they say."""
