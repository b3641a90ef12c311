//! The shipped weights imagine what plain nested loops make of them, natively and, by the loops that only wasm
//! runs, in Node.

use pathlight::nets::{Imagined, PathNet, flex};
use pathlight::puzzle::task::Task;
use safetensors::SafeTensors;

mod plain;

const WEIGHTS: &[u8] = include_bytes!("../assets/within-0.safetensors");

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn shipped_nets_imagine_what_plain_loops_say() {
    let (nets, _) = PathNet::load(WEIGHTS, &flex()).expect("our own weights");
    let file = SafeTensors::deserialize(WEIGHTS).expect("a safetensors file");
    for id in ["00002:007", "00012:002", "00024:006"] {
        let task = Task::load(id.parse().expect("an id")).expect("a task");
        let Imagined { base, target, action, placement } = nets.imagine(&task.scene);
        let maps = [base, target, action, placement];
        for ((name, map), wanted) in
            ["base", "target", "action", "placement"].iter().zip(maps).zip(plain::imagine(&file, &task.scene))
        {
            let worst = map.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(worst < 1e-4, "{id}: {name} differs by {worst}");
            let (low, high) = map.iter().fold((1.0_f32, 0.0_f32), |(low, high), &x| (low.min(x), high.max(x)));
            assert!(high - low > 0.01, "{id}: {name} shows nothing, so nothing was compared");
        }
    }
}
