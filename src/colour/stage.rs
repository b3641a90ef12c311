//! The stages of the model: what each is called, its colours and its dashes. The one list of them; JavaScript reads it
//! from `constants`.

use std::str::FromStr;

use colorous::Gradient;

/// Which cells of a line along cells are drawn, over and over.
pub type Dashes = &'static [bool];

pub const SOLID: Dashes = &[true];

/// What the nets imagine, in the order in which they make it: the paper's four maps, and the judge's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Base,
    Target,
    Action,
    Placement,
    Judge,
}

impl Stage {
    pub const ALL: [Stage; 5] = [Stage::Base, Stage::Target, Stage::Action, Stage::Placement, Stage::Judge];

    pub fn name(self) -> &'static str {
        match self {
            Stage::Base => "base",
            Stage::Target => "target",
            Stage::Action => "action",
            Stage::Placement => "placement",
            Stage::Judge => "judge",
        }
    }

    /// One perceptual colour scale per stage.
    fn gradient(self) -> Gradient {
        match self {
            Stage::Base => colorous::BLUES,
            Stage::Target => colorous::GREENS,
            Stage::Action => colorous::ORANGES,
            Stage::Placement => colorous::RED_PURPLE,
            Stage::Judge => colorous::PURPLES,
        }
    }

    /// Returns the CSS colour of an outline on a map of this stage.
    pub fn line_colour(self, dark: bool) -> String {
        let [r, g, b, _] = self.colour(1.0, dark);
        format!("rgb({r} {g} {b})")
    }

    /// The dashes of that outline, different for each stage.
    pub fn dashes(self) -> Dashes {
        match self {
            Stage::Base => SOLID,
            Stage::Target => &[true, true, true, true, false, false],
            Stage::Action => &[true, false],
            Stage::Placement => &[true, true, true, false, true, false],
            Stage::Judge => &[true, true, false, false],
        }
    }

    /// Returns red, green, blue and opacity (0..=255) of a value in 0..=1; higher values contrast more with the paper.
    pub fn colour(self, value: f32, dark: bool) -> [u8; 4] {
        let value = f64::from(value.clamp(0.0, 1.0));
        // The ends of a scale are near white and near black; one of them is invisible on either paper.
        let position = if dark { 0.78 - 0.42 * value } else { 0.3 + 0.6 * value };
        let colorous::Color { r, g, b } = self.gradient().eval_continuous(position);
        [r, g, b, (235.0 * libm::sqrt(value)) as u8]
    }
}

impl FromStr for Stage {
    type Err = String;

    fn from_str(name: &str) -> Result<Stage, String> {
        Stage::ALL
            .into_iter()
            .find(|stage| stage.name() == name)
            .ok_or_else(|| format!("there is no map `{name}`: the maps are {}", Stage::ALL.map(Stage::name).join(", ")))
    }
}
