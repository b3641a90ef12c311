// A new version of the page. These texts are bundled with offline/updates.ts alone.

export const offline = { available: "There is a new version of Pathlight.", load: "Load it", later: "Later" };
