// Runs before the first picture: in which language and colours, and whether the address names a puzzle. Without it the
// English home page is seen for a moment. main.js decides.

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
  root.classList.toggle("elsewhere", /[#&](task|scene|view)=/.test(location.hash));
}
