// A long table shows its first rows; the others wait in a <template> until somebody asks for them.
const TABLE = "table.ranking";

const waiting = () => document.getElementById("more-rows");
const button = () => document.getElementById("show-all-rows");

// All rows of the ranking, those that wait too.
export function allRows() {
  const body = document.querySelector(`${TABLE} tbody`);
  return body ? [...body.rows, ...(waiting()?.content.querySelectorAll("tr") ?? [])] : [];
}

// A table that is sorted or filtered is whole.
export function unfold() {
  const template = waiting();
  if (!template) return;
  document.querySelector(`${TABLE} tbody`).append(template.content);
  template.remove();
  button().closest("p").remove();
}

export function setUpFolding() { button()?.addEventListener("click", unfold); }
