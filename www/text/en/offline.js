// What `offline/` says. index.html holds these words too, so that offline/updates.js needs no module for them.

export const offline = {
  label: "Update",
  available: "A new version of Pathlight is available.",
  load: "Load the new version",
  later: "Later",
};
