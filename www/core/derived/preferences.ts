// Theme and language of the page: chosen by the person, or those of the device. The page around may ask for a theme.

import type { Language } from "../../text/languages.ts";
import type { Theme } from "../change/kept.ts";
import type { State } from "../state.ts";

export const theme = ({ kept, device }: State): Theme => device.asked ?? kept.theme ?? device.theme;
export const isDark = (state: State): boolean => theme(state) === "dark";
export const language = ({ kept, device }: State): Language => kept.language ?? device.language;
