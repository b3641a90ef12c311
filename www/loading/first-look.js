// Runs before the first picture, in English, which index.html holds: shows the top of the home page, or the story of
// the puzzle that the address asks for. Without it nothing is seen until the modules of the page are there. A classic
// script, which knows only the address; page/main.js decides.

{
  const language = new URLSearchParams(location.search).get("lang") ?? navigator.language;
  const isElsewhere = /[#&](task|scene|view|hide)=/.test(location.hash);
  const [, kind] = location.hash.match(/[#&]task=(\d{5})/) ?? [];
  if (/^en\b/i.test(language)) {
    if (!isElsewhere) document.documentElement.classList.add("home");
    if (kind && !/[#&]hide=/.test(location.hash)) {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(`#loading-story [data-kind="${kind}"] { display: block; }`);
      document.adoptedStyleSheets.push(sheet);
    }
  }
}
