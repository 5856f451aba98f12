// Light, dark, or as the system says. `#theme=dark` in the address fixes it; the button remembers where it can.
const KEY = "icebow-theme";

function remembered() {
  const asked = location.hash.match(/theme=(light|dark)/);
  if (asked) return asked[1];
  try { return localStorage.getItem(KEY); } catch { return null; }
}

export function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

export function setUpTheme(redraw) {
  const root = document.documentElement, button = document.getElementById("theme");
  const label = () => { button.textContent = isDark() ? "Light page" : "Dark page"; };
  const chosen = remembered();
  if (chosen) root.dataset.theme = chosen;
  label();
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    try { localStorage.setItem(KEY, root.dataset.theme); } catch { /* a private window forgets */ }
    label();
    redraw();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { label(); redraw(); });
  printInLight(root, redraw);
}

// Paper is white: charts are redrawn for it. Cards print as they stand: those of the best three are open.
function printInLight(root, redraw) {
  let before = null;
  addEventListener("beforeprint", () => {
    before = { theme: root.dataset.theme };
    root.dataset.theme = "light";
    redraw({ paper: true });
  });
  addEventListener("afterprint", () => {
    if (!before) return;
    if (before.theme) root.dataset.theme = before.theme; else delete root.dataset.theme;
    before = null;
    redraw();
  });
}
