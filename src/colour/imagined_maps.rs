//! The maps that the nets imagine: how each is called and drawn, and whether a net of the paper makes it. The one list
//! of them; JavaScript reads it from `constants`.

use std::str::FromStr;

use colorous::Gradient;

/// Which cells of a line along cells are drawn, over and over.
pub type Dashes = &'static [bool];

/// A line without gaps.
pub const SOLID: Dashes = &[true];

/// A map that a net imagines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImaginedMap {
    /// The path of the green object without a ball.
    Base,
    /// The path of the green object in a solution.
    Target,
    /// The path of the red ball in a solution.
    Action,
    /// Where the red ball starts in a solution.
    Placement,
    /// Where a ball is likely to solve the task.
    Success,
}

/// What there is to say of a map; its texts for the page are in `www/text/en/model.js`.
struct Declaration {
    name: &'static str,
    /// Whether a net of Harter et al. (2020) makes it. Weights may come without the others.
    of_paper: bool,
    gradient: Gradient,
    /// The dashes of an outline on it, different for each map.
    dashes: Dashes,
}

impl ImaginedMap {
    /// In the order in which the nets make them.
    pub const ALL: [ImaginedMap; 5] =
        [ImaginedMap::Base, ImaginedMap::Target, ImaginedMap::Action, ImaginedMap::Placement, ImaginedMap::Success];

    fn declaration(self) -> Declaration {
        match self {
            ImaginedMap::Base => Declaration { name: "base", of_paper: true, gradient: colorous::BLUES, dashes: SOLID },
            ImaginedMap::Target => Declaration {
                name: "target",
                of_paper: true,
                gradient: colorous::GREENS,
                dashes: &[true, true, true, true, false, false],
            },
            ImaginedMap::Action => {
                Declaration { name: "action", of_paper: true, gradient: colorous::ORANGES, dashes: &[true, false] }
            }
            ImaginedMap::Placement => Declaration {
                name: "placement",
                of_paper: true,
                gradient: colorous::RED_PURPLE,
                dashes: &[true, true, true, false, true, false],
            },
            ImaginedMap::Success => Declaration {
                name: "success",
                of_paper: false,
                gradient: colorous::PURPLES,
                dashes: &[true, true, false, false],
            },
        }
    }

    /// Returns its name in links and JSON.
    pub fn name(self) -> &'static str {
        self.declaration().name
    }

    /// Whether a net of the paper makes it.
    pub fn of_paper(self) -> bool {
        self.declaration().of_paper
    }

    /// The dashes of an outline on it.
    pub fn dashes(self) -> Dashes {
        self.declaration().dashes
    }

    /// Returns the CSS colour of an outline on it.
    pub fn line_colour(self, dark: bool) -> String {
        let [r, g, b, _] = self.colour(1.0, dark);
        format!("rgb({r} {g} {b})")
    }

    /// Returns red, green, blue and opacity (0..=255) of a value in 0..=1; higher values contrast more with the
    /// background.
    pub fn colour(self, value: f32, dark: bool) -> [u8; 4] {
        let value = f64::from(value.clamp(0.0, 1.0));
        // The ends of a scale are near white and near black; one of them is invisible on either background.
        let position = if dark { 0.78 - 0.42 * value } else { 0.3 + 0.6 * value };
        let colorous::Color { r, g, b } = self.declaration().gradient.eval_continuous(position);
        [r, g, b, (235.0 * libm::sqrt(value)) as u8]
    }
}

impl FromStr for ImaginedMap {
    type Err = String;

    fn from_str(name: &str) -> Result<ImaginedMap, String> {
        let found = ImaginedMap::ALL.into_iter().find(|map| map.name() == name);
        let names = ImaginedMap::ALL.map(ImaginedMap::name).join(", ");
        found.ok_or_else(|| format!("there is no map `{name}`: the maps are {names}"))
    }
}
