// One sentence above everything else, when something has to be said: what is wrong, and the ways on.

const bar = document.getElementById("notice");

/** Says a sentence; `ways` are [label, address] pairs. */
export function notice(sentence, ways = []) {
  document.getElementById("problem").textContent = sentence;
  const links = ways.map(([label, address]) => {
    const link = document.createElement("a");
    link.href = address;
    link.textContent = label;
    return link;
  });
  const close = document.createElement("button");
  close.type = "button";
  close.textContent = "Close";
  close.addEventListener("click", quiet);
  document.getElementById("ways").replaceChildren(...links, close);
  bar.hidden = false;
}

/** Takes the sentence away. */
export function quiet() {
  bar.hidden = true;
}
