//! A number as an argument that is not zero.

use clap::builder::TypedValueParser;

pub fn at_least_one() -> impl TypedValueParser<Value = u16> {
    clap::value_parser!(u16).range(1..)
}
