//! The shipped weights compute what plain nested loops compute, natively and in Node.

use pathlight::nets::{Imagined, PathNet};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::Task;
use safetensors::SafeTensors;

mod reference_nets;

const WEIGHTS: &[u8] = include_bytes!("../assets/within-0.safetensors");

fn nets() -> PathNet {
    PathNet::load(WEIGHTS).expect("our own weights").0
}

fn file() -> SafeTensors<'static> {
    SafeTensors::deserialize(WEIGHTS).expect("a safetensors file")
}

fn scenes() -> impl Iterator<Item = (&'static str, Scene)> {
    let load = |id: &str| Task::load(id.parse().expect("an id")).expect("a task").scene;
    ["00002:007", "00012:002", "00024:006"].into_iter().map(move |id| (id, load(id)))
}

/// Asserts that two maps agree, and that they are not flat.
fn assert_close(name: &str, map: &[f32], expected: &[f32], tolerance: f32, contrast: f32) {
    assert_eq!(map.len(), expected.len(), "{name}");
    let worst = map.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(worst < tolerance, "{name} differs by {worst}");
    let (low, high) = map.iter().fold((f32::MAX, f32::MIN), |(low, high), &x| (low.min(x), high.max(x)));
    assert!(high - low > contrast, "{name} is flat, so that nothing was compared");
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn the_shipped_nets_agree_with_plain_loops() {
    let (nets, file) = (nets(), file());
    for (id, scene) in scenes() {
        let Imagined { base, target, action, placement } = nets.imagine(&scene);
        let names = ["base", "target", "action", "placement"];
        for ((name, map), reference) in
            names.iter().zip([base, target, action, placement]).zip(reference_nets::imagine(&file, &scene))
        {
            assert_close(&format!("{id}: {name}"), &map, &reference, 1e-4, 0.01);
        }
    }
}

/// Logits of the shipped dynamics net span some tens, and are sums of up to a thousand products.
#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn the_shipped_dynamics_net_agrees_with_plain_loops() {
    let (nets, file) = (nets(), file());
    for (id, scene) in scenes() {
        let logits = nets.cell_logits(&scene).expect("the shipped weights have a dynamics net");
        assert_close(
            &format!("{id}: cells"),
            &logits,
            &reference_nets::cell_logits(&file, "dynamics", &scene),
            1e-3,
            1.0,
        );
    }
}
