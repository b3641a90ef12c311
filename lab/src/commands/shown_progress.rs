//! Shows the progress of the library's functions on standard error.

use pathlight::command_line::progress::{Progress, say};

/// Shows a progress bar for the current piece of work.
#[derive(Default)]
pub struct ShownProgress {
    work: Option<Progress>,
}

impl pathlight_lab::progress::Progress for ShownProgress {
    fn begin(&mut self, total: u64) {
        self.work = Some(Progress::new(Some(total)));
    }

    fn advance(&mut self, units: u64, so_far: String) {
        if let Some(work) = &mut self.work {
            work.advance(units, so_far);
        }
    }

    fn finish(&mut self, result: &str) {
        if let Some(work) = self.work.take() {
            work.finish(result);
        }
    }

    fn say(&mut self, line: &str) {
        match &self.work {
            Some(work) => work.print(line),
            None => say(line),
        }
    }
}
