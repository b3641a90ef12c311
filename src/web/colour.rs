//! The colours of the page's pictures: one palette for the roles, one perceptual scale for each stage.
//!
//! The hues hold for colour-blind eyes (Okabe and Ito's, and a purple); dark paper takes lighter tones of the
//! same. Legends are drawn from the same scales as the maps, and the style sheet takes the roles from here.

use std::str::FromStr;

use colorous::Gradient;
use serde::Serialize;

use crate::puzzle::scene::Role;

/// CSS colours.
#[derive(Serialize)]
pub struct Palette {
    pub paper: &'static str,
    pub green: &'static str,
    pub blue: &'static str,
    pub purple: &'static str,
    pub gray: &'static str,
    pub black: &'static str,
    /// Round black bodies, which dark paper would swallow.
    pub rim: &'static str,
    pub red: &'static str,
    /// The ring that fills while the goal holds.
    pub ring: &'static str,
    /// Lines that have to be seen on paper and on bodies.
    pub ink: &'static str,
}

const LIGHT: Palette = Palette {
    paper: "#fdfcf9",
    green: "#009e73",
    blue: "#0072b2",
    purple: "#8e5ab5",
    gray: "#868d97",
    black: "#25282d",
    rim: "#25282d",
    red: "#d55e00",
    ring: "#e69f00",
    ink: "#16181c",
};

const DARK: Palette = Palette {
    paper: "#2a2f38",
    green: "#1dbb8d",
    blue: "#4aa3df",
    purple: "#b48ad8",
    gray: "#8d95a3",
    black: "#07080a",
    rim: "#808997",
    red: "#f2812f",
    ring: "#ffc233",
    ink: "#f3f4f6",
};

pub fn palette(dark: bool) -> &'static Palette {
    if dark { &DARK } else { &LIGHT }
}

impl Palette {
    pub fn role(&self, role: Role) -> &'static str {
        match role {
            Role::Green => self.green,
            Role::Blue => self.blue,
            Role::Purple => self.purple,
            Role::Gray => self.gray,
            Role::Black => self.black,
            Role::Red => self.red,
        }
    }
}

/// Which cells of a line along cells are drawn, over and over.
pub type Dashes = &'static [bool];

pub const SOLID: Dashes = &[true];

/// What the nets imagine, in their order: the paper's four, and the judge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Base,
    Target,
    Action,
    Placement,
    Judge,
}

impl FromStr for Stage {
    type Err = String;

    fn from_str(name: &str) -> Result<Stage, String> {
        match name {
            "base" => Ok(Stage::Base),
            "target" => Ok(Stage::Target),
            "action" => Ok(Stage::Action),
            "placement" => Ok(Stage::Placement),
            "judge" => Ok(Stage::Judge),
            _ => Err(format!("there is no map `{name}`: they are base, target, action, placement and judge")),
        }
    }
}

impl Stage {
    fn gradient(self) -> Gradient {
        match self {
            Stage::Base => colorous::BLUES,
            Stage::Target => colorous::GREENS,
            Stage::Action => colorous::ORANGES,
            Stage::Placement => colorous::RED_PURPLE,
            Stage::Judge => colorous::PURPLES,
        }
    }

    /// The colour of a line round what a stage imagines, as a CSS colour.
    pub fn line(self, dark: bool) -> String {
        let [r, g, b, _] = self.colour(1.0, dark);
        format!("rgb({r} {g} {b})")
    }

    /// The dashes of that line.
    pub fn dashes(self) -> Dashes {
        match self {
            Stage::Base => SOLID,
            Stage::Target => &[true, true, true, true, false, false],
            Stage::Action => &[true, false],
            Stage::Placement => &[true, true, true, false, true, false],
            Stage::Judge => &[true, true, false, false],
        }
    }

    /// Red, green, blue and opacity of a share of the most, 0..=1: the more, the further from the paper.
    pub fn colour(self, value: f32, dark: bool) -> [u8; 4] {
        let value = f64::from(value.clamp(0.0, 1.0));
        // The ends of a scale are near white and near black; on either paper one of them cannot be seen.
        let along = if dark { 0.78 - 0.42 * value } else { 0.3 + 0.6 * value };
        let colorous::Color { r, g, b } = self.gradient().eval_continuous(along);
        [r, g, b, (235.0 * libm::sqrt(value)) as u8]
    }
}
