// What the module of a panel exports: a function that returns its markup, which goes into the element with the panel's
// name, and one that makes the components that bring it to life.

/**
 * @typedef {import("../element/components.js").Parts & { imagine: import("./imagine.js").Imagine, scenePicture:
 *   import("./scene-picture.js").ScenePicture }} PanelParts
 */

/** @typedef {import("../widgets/component.js").Component} Component */
/** @typedef {{ markup: () => string, create: (parts: PanelParts) => Component[] }} PanelModule */

export {};
