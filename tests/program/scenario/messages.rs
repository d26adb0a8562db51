//! Texts for the user: refusals of values of a wrong type.

mod value_types;
