// The table keeps the chosen designs only; the number of them and the ranges stand above it.
import { allRows, unfold } from "./folding.js";
import { chooseAll, chooseName, isChoosing, isChosen, onChoice, rangesInWords } from "./selection.js";

export function setUpFilter(data) {
  const form = document.getElementById("filter");
  if (!form) return;
  const name = document.getElementById("filter-name"), said = document.getElementById("filter-said");
  const clear = document.getElementById("filter-clear");
  const byId = new Map(data.designs.map((design) => [design.id, design]));
  const rows = allRows();
  form.addEventListener("submit", (event) => event.preventDefault());
  name.addEventListener("input", () => chooseName(name.value));
  clear.addEventListener("click", () => { name.value = ""; chooseAll(); });
  onChoice(() => {
    if (isChoosing()) unfold();
    let shown = 0;
    for (const row of rows) {
      const on = isChosen(byId.get(row.dataset.design));
      row.hidden = !on;
      shown += on;
    }
    const words = rangesInWords();
    said.textContent = isChoosing() ? `${shown} of ${rows.length} designs${words.length ? `: ${words.join(", ")}` : ""}` : "";
    clear.hidden = !isChoosing();
  });
  if (rows.length < 8 && !document.getElementById("parallel-ranges")) form.hidden = true;
}
