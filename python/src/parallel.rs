//! Work on all cores. Threads live as long as a call: a pool would not survive the fork of a process, as PyTorch's data
//! loaders fork it, and would hang there.

use std::sync::Mutex;
use std::thread;

/// Items that a thread takes at a time.
const CHUNK: usize = 32;

/// Returns the results of a function of each item, in order, computed on all cores.
pub fn map<T: Sync, R: Copy + Default + Send>(items: &[T], function: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let mut results = vec![R::default(); items.len()];
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let chunks = Mutex::new(items.chunks(CHUNK).zip(results.chunks_mut(CHUNK)));
    let work = || {
        loop {
            let next = chunks.lock().expect("no thread panics while it holds the lock").next();
            let Some((items, results)) = next else { break };
            items.iter().zip(results).for_each(|(item, result)| *result = function(item));
        }
    };
    thread::scope(|scope| {
        for _ in 1..cores.min(items.len().div_ceil(CHUNK)) {
            scope.spawn(work);
        }
        work();
    });
    results
}
