// Runs before the first picture: the top of the home page is shown at once, in English, which index.html holds, unless
// the address asks for something else. Without it nothing is seen until the modules of the page are there. A classic
// script, which knows only the address; page/main.js decides.

{
  const language = new URLSearchParams(location.search).get("lang") ?? navigator.language;
  const isElsewhere = /[#&](task|scene|view|hide)=/.test(location.hash);
  if (/^en\b/i.test(language) && !isElsewhere) document.documentElement.classList.add("home");
}
