//! The Rust example compiles and runs. The npm package's examples run in `tests/package`, the Python ones in
//! `tests/cli`.
#![cfg(not(target_arch = "wasm32"))]

include!("../examples/solve.rs");

#[test]
fn the_example_runs() {
    main().expect("it runs");
}
