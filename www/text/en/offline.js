// What `offline/` says. index.html holds it, as offline/updates.js imports nothing.

export const offline = {
  label: "Update",
  available: "A new version of Pathlight is available.",
  load: "Load the new version",
  later: "Later",
};
