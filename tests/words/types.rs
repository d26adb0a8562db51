//! Values of a wrong type: the refusal is in the words of a scenario, not in those of the parser.
