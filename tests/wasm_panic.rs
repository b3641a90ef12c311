//! A Rust panic in wasm throws an error with its message. The only test in its file, because none can run after a
//! panic.
#![cfg(target_arch = "wasm32")]

use js_sys::Reflect;
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

#[wasm_bindgen_test]
fn a_panic_is_an_error_with_its_message_and_a_code() {
    // The test harness has its own hook.
    pathlight::web::throw_panics();
    let panics = Closure::<dyn FnMut()>::new(|| panic!("no ball is left"));
    let function: &js_sys::Function = panics.as_ref().unchecked_ref();
    let error: js_sys::Error = function.call0(&JsValue::NULL).expect_err("it throws").dyn_into().expect("a real Error");
    assert!(String::from(error.message()).contains("no ball is left"), "{}", error.message());
    assert_eq!(Reflect::get(&error, &"code".into()).expect("an object"), "panic");
}
