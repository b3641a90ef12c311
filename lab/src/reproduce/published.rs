//! Published results: auccess in PHYRE's simulator, mean over the ten folds.

use serde::Serialize;

/// A published result.
#[derive(Serialize)]
pub struct Published {
    /// Name of the method in every language; empty if it is known by its authors.
    method: &'static str,
    source: &'static str,
    url: &'static str,
    /// Within and cross.
    pub auccess: [&'static str; 2],
}

impl Published {
    /// The label in reports.
    pub fn label(&self) -> String {
        let separator = if self.method.is_empty() { "" } else { ", " };
        format!("{}{separator}[{}]({})", self.method, self.source, self.url)
    }
}

const HARTER: [&str; 2] = ["Harter et al. (2020)", "https://arxiv.org/abs/2011.07357"];

/// For each setup, the best result without learning across test tasks that we know of; for the nets of Harter et al.
/// (2020) and DQN, their Table 1; for RAND, the benchmark (PHYRE 0.2.2).
pub const PUBLISHED: [Published; 5] = [
    Published {
        method: "",
        source: "Ahmed et al. (2021)",
        url: "https://arxiv.org/abs/2102.10336",
        auccess: ["86.2", "–"],
    },
    Published {
        method: "RPIN",
        source: "Qi et al. (2021)",
        url: "https://arxiv.org/abs/2008.02265",
        auccess: ["–", "42.2"],
    },
    Published { method: "DQN", source: HARTER[0], url: HARTER[1], auccess: ["77", "37"] },
    Published { method: "", source: HARTER[0], url: HARTER[1], auccess: ["62", "31"] },
    Published {
        method: "RAND",
        source: "Bakhtin et al. (2019)",
        url: "https://arxiv.org/abs/1908.05656",
        auccess: ["13.7", "13.0"],
    },
];

/// Auccess that Harter et al. (2020) report for their nets on each template, within and cross; “–” where no fold tests
/// it: no fold of cross tests 00006.
pub const BY_TEMPLATE: [&str; 2] = [
    "80 89 87 95 79 82 86 62 69 77 31 53 52 65 84 78 39 41 69 45 46 29 30 45 42",
    "51 54 67 67 57 63 – 30 24 14 14 38 48 51 15 25 14 5 37 17 24 3 9 6 6",
];

#[cfg(test)]
mod tests {
    use pathlight::puzzle::templates::TEMPLATES;

    use super::*;

    #[test]
    fn every_template_has_a_published_number() {
        for numbers in BY_TEMPLATE {
            assert_eq!(numbers.split_whitespace().count(), TEMPLATES.len(), "{numbers}");
        }
    }
}
