// Tables sort by the data-sort of their cells: numbers by value, the rest by name; what is unknown goes last.
import { unfold } from "./folding.js";

function keyOf(row, column) {
  const key = row.cells[column].dataset.sort;
  if (key === undefined || key === "") return null;
  return Number.isNaN(Number(key)) ? key : Number(key);
}

function compare(a, b) {
  if (a === null || b === null) return (a === null) - (b === null);
  return typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b));
}

function sortBy(table, column, ascending) {
  const body = table.tBodies[0];
  const rows = [...body.rows].map((row, index) => ({ row, index, key: keyOf(row, column) }));
  rows.sort((a, b) => {
    const unknown = (a.key === null) - (b.key === null);
    return unknown || (ascending ? 1 : -1) * compare(a.key, b.key) || a.index - b.index;
  });
  body.append(...rows.map(({ row }) => row));
}

export function setUpSorting() {
  for (const table of document.querySelectorAll("table.sortable")) {
    const heads = [...table.tHead.rows[0].cells];
    heads[0]?.setAttribute("aria-sort", "ascending");
    for (const head of heads) {
      head.querySelector("button")?.addEventListener("click", () => {
        if (table.matches(".ranking")) unfold();
        const ascending = head.getAttribute("aria-sort") !== "ascending";
        heads.forEach((other) => other.removeAttribute("aria-sort"));
        head.setAttribute("aria-sort", ascending ? "ascending" : "descending");
        sortBy(table, head.cellIndex, ascending);
      });
    }
  }
}
