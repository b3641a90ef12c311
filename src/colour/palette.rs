//! The colours of the roles and of the background, light and dark. The page reads them from `web::constants`.
//!
//! Colour-blind people can distinguish the hues: those of Okabe and Ito, a purple, and a strong red. The dark palette
//! has lighter tones of the same hues.

use serde::Serialize;

use crate::puzzle::scene::Role;

/// CSS colours.
#[derive(Serialize)]
pub struct Palette {
    /// The background.
    pub paper: &'static str,
    /// The green object.
    pub green: &'static str,
    /// A dynamic goal.
    pub blue: &'static str,
    /// A static goal.
    pub purple: &'static str,
    /// Other dynamic bodies.
    pub gray: &'static str,
    /// Other static bodies.
    pub black: &'static str,
    /// The rim that makes black bodies stand out from a dark background.
    pub rim: &'static str,
    /// The red ball.
    pub red: &'static str,
    /// The ring that fills while the green object touches its goal.
    pub ring: &'static str,
    /// Lines that must be visible on the background and on bodies.
    pub ink: &'static str,
    /// Marks the model's ball and paths.
    pub model: &'static str,
}

const LIGHT: Palette = Palette {
    paper: "#fdfcf9",
    green: "#009e73",
    blue: "#0072b2",
    purple: "#8e5ab5",
    gray: "#868d97",
    black: "#25282d",
    rim: "#25282d",
    red: "#e5261f",
    ring: "#e69f00",
    ink: "#16181c",
    model: "#3d2fe0",
};

const DARK: Palette = Palette {
    paper: "#101318",
    green: "#1dbb8d",
    blue: "#4aa3df",
    purple: "#b48ad8",
    gray: "#8d95a3",
    black: "#39404b",
    rim: "#b9c1cd",
    red: "#ff4438",
    ring: "#ffc233",
    ink: "#f3f4f6",
    model: "#8b84ff",
};

/// Returns the colours for a light or a dark background.
pub fn palette(dark: bool) -> &'static Palette {
    if dark { &DARK } else { &LIGHT }
}

impl Palette {
    /// Returns the colour of a role.
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
