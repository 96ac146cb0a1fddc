"""First stage: words, before anybody is meant: spelling, shorthand, numbers, names, sentences, parse."""
