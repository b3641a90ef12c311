// Runs before the first picture: in which language and colours, whether the address names a puzzle, and whether it is
// the first that is played. Without it the English home page is seen for a moment. main.js decides.

{
  const root = document.documentElement;
  let kept = null;
  try {
    kept = JSON.parse(localStorage.getItem("pathlight"));
  } catch {
    // Nothing is kept, or the browser refuses.
  }
  root.lang = kept?.language ?? (/^de\b/i.test(navigator.language) ? "de" : "en");
  if (kept?.theme) root.dataset.theme = kept.theme;
  const isElsewhere = /[#&](task|scene|view)=/.test(location.hash);
  root.classList.toggle("elsewhere", isElsewhere);
  root.classList.toggle("first", isElsewhere && !kept && !/[#&](panel|view|challenge)=/.test(location.hash));
}
