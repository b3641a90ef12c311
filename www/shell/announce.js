// The page's one voice for those who listen: what is said here is read out as soon as there is time, and the last
// thing said replaces what has not been read yet.

const told = document.getElementById("told");

export function say(words) {
  if (told.textContent !== words) told.textContent = words;
}
