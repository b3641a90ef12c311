//! The numbers of a template's tasks in the benchmark.
//!
//! PHYRE chose them by measuring which tasks can be solved, so they cannot be derived from the layout. Each template
//! lists them as runs like "0-11 13 15-17". The lists are parsed at compile time; a wrong list does not compile.

use super::TASKS;

/// Returns the numbers in the runs. There must be `TASKS` of them, ascending.
pub(crate) const fn task_numbers(runs: &str) -> [u16; TASKS] {
    let text = runs.as_bytes();
    let mut numbers = [0; TASKS];
    let (mut count, mut at) = (0, 0);
    while at < text.len() {
        let (first, after) = number(text, at);
        let (last, after) = match after < text.len() && text[after] == b'-' {
            true => number(text, after + 1),
            false => (first, after),
        };
        assert!(after == text.len() || text[after] == b' ', "one space between two runs");
        at = after + 1;
        let mut next = first;
        while next <= last {
            assert!(count == 0 || numbers[count - 1] < next, "the numbers ascend");
            numbers[count] = next;
            (count, next) = (count + 1, next + 1);
        }
    }
    assert!(count == numbers.len(), "the benchmark keeps 100 tasks of a template");
    numbers
}

/// Returns the number that starts here, and the position of its end.
const fn number(text: &[u8], mut at: usize) -> (u16, usize) {
    let start = at;
    let mut value = 0;
    while at < text.len() && text[at].is_ascii_digit() {
        value = 10 * value + (text[at] - b'0') as u16;
        at += 1;
    }
    assert!(at > start, "a run is made of numbers");
    (value, at)
}

#[cfg(test)]
mod tests {
    use super::task_numbers;

    #[test]
    fn runs_and_single_numbers_are_read() {
        let numbers = task_numbers("3 5-7 100-194 999");
        assert_eq!(numbers[..5], [3, 5, 6, 7, 100]);
        assert_eq!(numbers[98..], [194, 999]);
    }

    #[test]
    #[should_panic(expected = "the numbers ascend")]
    fn a_list_out_of_order_is_refused() {
        task_numbers("5 0-98");
    }

    #[test]
    #[should_panic(expected = "keeps 100 tasks")]
    fn a_short_list_is_refused() {
        task_numbers("0-98");
    }
}
