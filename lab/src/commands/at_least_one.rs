//! A number as an argument that is not zero.

use clap::builder::{RangedU64ValueParser, TypedValueParser};

pub fn at_least_one() -> impl TypedValueParser<Value = u16> {
    clap::value_parser!(u16).range(1..)
}

/// A number from 1 to 2^32 - 1: counts are multiplied, so they need an upper bound too.
pub fn count() -> impl TypedValueParser<Value = usize> {
    RangedU64ValueParser::new().range(1..=u64::from(u32::MAX))
}
