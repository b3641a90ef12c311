//! The Rust example compiles and runs. Those of the npm package run in `tests/package`, those in Python in `tests/cli`.
#![cfg(not(target_arch = "wasm32"))]

include!("../examples/solve.rs");

#[test]
fn the_example_runs() {
    main().expect("it runs");
}
