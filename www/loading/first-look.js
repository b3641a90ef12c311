// Runs before the first picture: the top of the home page is shown at once, in English, which index.html holds, unless
// the address asks for something else. Without it nothing is seen until the modules of the page are there. A classic
// script, which knows only the address; page/main.js decides.

{
  const tags = [new URLSearchParams(location.search).get("lang") ?? "", ...navigator.languages];
  const language = tags.map((tag) => tag.slice(0, 2).toLowerCase()).find((name) => name === "en" || name === "de");
  const isElsewhere = /[#&](task|scene|view|hide)=/.test(location.hash);
  if (language !== "de" && !isElsewhere) document.documentElement.classList.add("home");
}
