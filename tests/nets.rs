//! Fresh nets compute what their layers define: plain nested loops of 4 x 4 convolutions agree with them up to
//! rounding, and so does burn's second backend. Their weights files have the expected content.
#![cfg(not(target_arch = "wasm32"))]

use pathlight::benchmark::folds::Setup;
use pathlight::nets::{Card, Imagined, Optimiser, PathNet, SuccessCard, SuccessNet, WeightsError};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::Task;
use pathlight::raster::CELLS;
use safetensors::SafeTensors;

mod reference_nets;

const WIDTHS: [usize; 6] = [8, 16, 32, 64, 128, 256];

fn card() -> Card {
    Card {
        setup: Setup::Within,
        fold: 0,
        seed: 1,
        epochs: 0,
        batch: 32,
        learning_rate: 3e-3,
        decay_epochs: 1,
        mirror: false,
        without_dev: false,
        samples: 0,
        tasks: 0,
        simulator: 0,
        success: Some(SuccessCard {
            seed: 8,
            epochs: 0,
            batch: 32,
            balls_per_scene: 256,
            optimiser: Optimiser::Adam,
            learning_rate: 3e-3,
            balls: 0,
        }),
        dynamics: None,
    }
}

/// Returns fresh weights of the paper's nets and the success net as a file, so that all implementations use the same
/// bytes.
fn weights() -> Vec<u8> {
    weights_with(&card())
}

fn weights_with(card: &Card) -> Vec<u8> {
    let mut nets = PathNet::fresh(7);
    nets.success = Some(SuccessNet::fresh(8));
    nets.save(card).expect("fresh weights are finite")
}

fn scene() -> Scene {
    Task::load("00012:002".parse().expect("an id")).expect("a task").scene
}

/// Returns the maps of the paper's nets and the success net's logits, by name.
fn maps(loaded: Result<(PathNet, Card), WeightsError>) -> [(&'static str, Vec<f32>); 5] {
    let (nets, _) = loaded.expect("our own weights");
    let Imagined { base, target, action, placement } = nets.imagine(&scene());
    let success = nets.cell_logits(&scene()).expect("the weights have a success net");
    [("base", base), ("target", target), ("action", action), ("placement", placement), ("success", success)]
}

#[test]
fn the_nets_agree_with_plain_loops() {
    let bytes = weights();
    let file = SafeTensors::deserialize(&bytes).expect("a safetensors file");
    let [base, target, action, placement] = reference_nets::imagine(&file, &scene());
    let references = [base, target, action, placement, reference_nets::cell_logits(&file, "success", &scene())];
    for ((name, map), reference) in maps(PathNet::load(&bytes)).iter().zip(&references) {
        assert_close(name, map, reference);
        let (low, high) = map.iter().fold((f32::MAX, f32::MIN), |(low, high), &x| (low.min(x), high.max(x)));
        assert!(high - low > 1e-4, "{name} is flat, so that nothing was compared");
    }
}

#[cfg(feature = "ndarray")]
#[test]
fn flex_agrees_with_ndarray() {
    let bytes = weights();
    let reference = maps(PathNet::load_on_ndarray(&bytes));
    for ((name, flex), (_, ndarray)) in maps(PathNet::load(&bytes)).iter().zip(&reference) {
        assert_close(name, flex, ndarray);
    }
}

/// The paper's layers have 1,398,257 parameters with 5 input channels and 1,398,513 with 7. The file omits the twelve
/// taps of each kernel next to the code that meet only padding.
#[test]
fn the_file_holds_every_parameter_of_the_papers_layers_that_meets_data() {
    let dead = 2 * 12 * WIDTHS[4] * WIDTHS[5];
    let bytes = weights();
    let file = SafeTensors::deserialize(&bytes).expect("a safetensors file");
    for (net, channels, paper) in
        [("base", 5, 1_398_257), ("target", 5, 1_398_257), ("action", 7, 1_398_513), ("placement", 7, 1_398_513)]
    {
        assert_eq!(nominal(channels), paper);
        let live: usize = file
            .iter()
            .filter(|(name, _)| name.starts_with(&format!("{net}.")))
            .map(|(_, view)| view.shape().iter().product::<usize>())
            .sum();
        assert_eq!(live + dead, paper, "{net}");
    }
}

/// Returns the number of parameters of an hourglass of 4 x 4 kernels.
fn nominal(channels: usize) -> usize {
    let layer = |a: usize, b: usize| a * b * 16;
    let inputs = [channels, 8, 16, 32, 64, 128];
    let down: usize = inputs.iter().zip(WIDTHS).map(|(&a, b)| layer(a, b) + b).sum();
    let outputs = [1, 8, 16, 32, 64, 128];
    let up: usize = outputs.iter().zip(WIDTHS).map(|(&a, b)| layer(a, b) + a).sum();
    down + up
}

#[test]
fn weights_survive_saving_and_loading() {
    let bytes = weights();
    let (nets, found) = PathNet::load(&bytes).expect("our own weights");
    assert_eq!(found, card());
    assert_eq!(nets.save(&found).expect("what was loaded is finite"), bytes);
}

#[test]
fn files_that_do_not_fit_are_refused() {
    let refusal = |bytes: &[u8]| PathNet::load(bytes).expect_err("not weights");
    assert!(matches!(refusal(b"nothing like it"), WeightsError::NotSafetensors(_)));
    let whole = weights();
    assert!(matches!(refusal(&whole[..whole.len() / 2]), WeightsError::NotSafetensors(_)));
    let one = [0u8; 4];
    let view = || safetensors::tensor::TensorView::new(safetensors::Dtype::F16, vec![2], &one).expect("two values");
    let bare = safetensors::serialize([("base.down.0.bias", view())], None).expect("a file");
    assert!(matches!(refusal(&bare), WeightsError::NoCard));
    let four_nets = Card { success: None, ..card() };
    assert!(matches!(refusal(&weights_with(&four_nets)), WeightsError::OtherNets("success net")));
    let metadata = [("pathlight".to_string(), serde_json::to_string(&four_nets).expect("JSON"))];
    let foreign = safetensors::serialize([("base.down.0.bias", view())], Some(metadata.into())).expect("a file");
    let sentence = refusal(&foreign).to_string();
    assert!(sentence.contains("other nets"), "{sentence}");
}

fn assert_close(name: &str, a: &[f32], b: &[f32]) {
    assert_eq!(a.len(), b.len(), "{name}");
    assert!(a.len().is_multiple_of(CELLS), "{name}");
    let worst = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(worst < 1e-5, "{name} differs by {worst}");
}
