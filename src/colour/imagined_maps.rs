//! The maps that the nets imagine, with their names and colours. This is the only list of them; JavaScript reads it
//! from `constants`, TypeScript from `NAME_TYPE`.

use std::str::FromStr;

use colorous::Gradient;

macro_rules! imagined_maps {
    ($($(#[$doc:meta])* $map:ident: $name:literal, $gradient:ident;)+) => {
        /// A map that a net imagines.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum ImaginedMap {
            $($(#[$doc])* $map,)+
        }

        impl ImaginedMap {
            /// All maps, in the order in which the nets compute them.
            pub const ALL: [ImaginedMap; [$($name),+].len()] = [$(ImaginedMap::$map),+];

            /// The type of their names in TypeScript.
            pub const NAME_TYPE: &str = concat!(
                "/** The maps that the nets imagine, in order. */\nexport type MapName =",
                $(" | \"", $name, "\"",)+
                ";\n",
            );

            /// Returns the map's name in links and JSON.
            pub fn name(self) -> &'static str {
                match self {
                    $(ImaginedMap::$map => $name,)+
                }
            }

            fn gradient(self) -> Gradient {
                match self {
                    $(ImaginedMap::$map => colorous::$gradient,)+
                }
            }
        }
    };
}

imagined_maps! {
    /// The path of the green object without a ball.
    Base: "base", BLUES;
    /// The path of the green object in a solution.
    Target: "target", GREENS;
    /// The path of the red ball in a solution.
    Action: "action", ORANGES;
    /// Where the red ball starts in a solution.
    Placement: "placement", RED_PURPLE;
    /// Where a ball is likely to solve the task.
    Success: "success", PURPLES;
}

impl ImaginedMap {
    /// Returns red, green, blue and opacity (0..=255) of a value in 0..=1. Higher values contrast more with the
    /// background.
    pub fn colour(self, value: f32, dark: bool) -> [u8; 4] {
        let value = f64::from(value.clamp(0.0, 1.0));
        // The ends of a scale are near white and near black, so one of them is invisible on either background.
        let position = if dark { 0.78 - 0.42 * value } else { 0.3 + 0.6 * value };
        let colorous::Color { r, g, b } = self.gradient().eval_continuous(position);
        [r, g, b, (235.0 * libm::sqrt(value)) as u8]
    }
}

impl FromStr for ImaginedMap {
    type Err = String;

    fn from_str(name: &str) -> Result<ImaginedMap, String> {
        let found = ImaginedMap::ALL.into_iter().find(|map| map.name() == name);
        let names = ImaginedMap::ALL.map(ImaginedMap::name).join(", ");
        found.ok_or_else(|| format!("unknown map `{name}`: the maps are {names}"))
    }
}
