//! Parses template numbers on the command line; used by the lab's binary too.

use crate::puzzle::task::TaskError;
use crate::puzzle::templates::{TEMPLATES, Template};

/// Parses the number of a template, like `00007` or `7`.
pub fn template(text: &str) -> Result<&'static Template, TaskError> {
    let number = text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse::<usize>().ok()).flatten();
    let template = number.and_then(|number| TEMPLATES.get(number));
    template.copied().ok_or_else(|| TaskError::NoTemplate(text.to_string()))
}
