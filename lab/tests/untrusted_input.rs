//! Untrusted input, whatever it is, causes no panic, no hang and no more memory than stated, and a refusal says why.
//!
//! Each fuzz target runs on its corpus, and for one second on mutations of it; PATHLIGHT_FUZZ_SECONDS sets how long.
//! `fuzz/run` searches further, guided by coverage.
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::thread;
use std::time::{Duration, Instant};
use std::{env, fs};

use peak_alloc::PeakAlloc;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

#[path = "../../fuzz/untrusted/mod.rs"]
mod untrusted;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

/// Maximum memory for an input of up to 20 kB, bytes. Weights take the most: the file, and the nets twice.
const MOST_MEMORY: usize = 64 << 20;

/// Maximum time for one input.
const LONGEST: Duration = Duration::from_secs(20);

/// Tokens that JSON parsers are likely to break on.
const TOKENS: [&str; 16] = [
    "null",
    "-1",
    "0",
    "1e999",
    "-1e308",
    "1e-320",
    "18446744073709551616",
    "0.5",
    "NaN",
    "[]",
    "{}",
    "\"\"",
    "\\u0000",
    "\u{fffd}",
    "true",
    ",",
];

#[test]
fn no_door_panics_hangs_or_takes_more_memory_than_stated() {
    let seconds = env::var("PATHLIGHT_FUZZ_SECONDS").map_or(1.0, |text| text.parse().expect("seconds"));
    for (name, target) in untrusted::ALL {
        let corpus = corpus(name);
        let tried = try_all(name, target, corpus.clone().into_iter().chain(mutations(corpus, seconds)));
        println!("{name}: {tried} inputs");
    }
}

#[test]
fn the_corpus_is_small() {
    let bytes: usize = untrusted::ALL.iter().flat_map(|(name, _)| corpus(name)).map(|input| input.len()).sum();
    assert!(bytes < 20_000, "{bytes} bytes");
}

fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus").join(target);
    let files = fs::read_dir(&folder).unwrap_or_else(|why| panic!("{}: {why}", folder.display()));
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.sort();
    let inputs: Vec<Vec<u8>> = paths.iter().map(|path| fs::read(path).expect("a file")).collect();
    assert!(!inputs.is_empty(), "{} is empty", folder.display());
    inputs
}

/// Yields inputs until time is up: each is one of the corpus, changed in up to four places.
fn mutations(corpus: Vec<Vec<u8>>, seconds: f64) -> impl Iterator<Item = Vec<u8>> {
    let end = Instant::now() + Duration::from_secs_f64(seconds);
    let mut rng = Pcg64Mcg::seed_from_u64(16);
    std::iter::from_fn(move || {
        let mut input = corpus.choose(&mut rng).expect("at least one").clone();
        for _ in 0..rng.random_range(1..=4) {
            let at = rng.random_range(0..=input.len());
            let to = rng.random_range(at..=input.len().min(at + 8));
            match rng.random_range(0..5) {
                0 => drop(input.splice(at..to, TOKENS.choose(&mut rng).expect("tokens").bytes())),
                1 => drop(input.drain(at..to)),
                2 => input.insert(at, rng.random()),
                3 => input.truncate(at.max(1)),
                _ if at < input.len() => input[at] ^= 1 << rng.random_range(0..8),
                _ => {}
            }
        }
        (Instant::now() < end).then_some(input)
    })
}

/// Runs a target on inputs; returns how many were tried.
fn try_all(name: &str, target: untrusted::Target, inputs: impl Iterator<Item = Vec<u8>> + Send) -> usize {
    let (sender, receiver) = sync_channel(0);
    thread::scope(|scope| {
        let worker = scope.spawn(move || {
            for input in inputs {
                sender.send(input.clone()).expect("somebody watches");
                ALLOCATOR.reset_peak_usage();
                let before = ALLOCATOR.current_usage();
                target(&input);
                let taken = ALLOCATOR.peak_usage().saturating_sub(before);
                assert!(taken < MOST_MEMORY, "{taken} bytes of memory");
            }
        });
        let (mut tried, mut latest) = (0, Vec::new());
        loop {
            match receiver.recv_timeout(LONGEST) {
                Ok(input) => (tried, latest) = (tried + 1, input),
                Err(RecvTimeoutError::Disconnected) => break,
                Err(RecvTimeoutError::Timeout) => {
                    println!("{name} hangs on {}", latest.escape_ascii());
                    std::process::exit(1);
                }
            }
        }
        assert!(worker.join().is_ok(), "{name} fails on {}", latest.escape_ascii());
        tried
    })
}
