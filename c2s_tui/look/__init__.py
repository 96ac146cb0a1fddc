"""The visual language: one colour and one letter per kind of component, marks, themes."""
