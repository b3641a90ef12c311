// Runs before the first paint: sets the language and theme, whether the address names a puzzle, and whether it is the
// first to be played. Without it, the English home page would flash. main.js and the exhibits have the final word.

{
  const root = document.documentElement;
  let kept = null;
  try {
    kept = JSON.parse(localStorage.getItem("pathlight"));
  } catch {
    // Nothing is stored, or the browser refuses access.
  }
  root.lang = kept?.language ?? navigator.language;
  if (kept?.theme) root.dataset.theme = kept.theme;
  const isElsewhere = /[#&](task|scene|view)=/.test(location.hash);
  root.classList.toggle("elsewhere", isElsewhere);
  root.classList.toggle("first", isElsewhere && !kept && !/[#&](panel|view|challenge)=/.test(location.hash));
}
