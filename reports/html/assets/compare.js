// Two designs beside each other: numbers with the test of their difference, waterlines, records, lines plans, pictures.
import { bodyOf } from "./cards.js";
import { drawRecords } from "./charts/history.js";
import { format, isNumber } from "./charts/kit.js";
import { welch } from "./welch.js";

const ANGLES = ["stem", "waterline", "buttock", "flare"];
let data = null, chosen = [];

function option(design) {
  const element = document.createElement("option");
  element.value = design.id;
  element.textContent = `${design.rank}  ${design.name}`;
  return element;
}

function cells(label, values) {
  const row = document.createElement("tr");
  const head = document.createElement("th");
  head.scope = "row"; head.textContent = label;
  row.append(head);
  for (const value of values) {
    const cell = document.createElement("td");
    cell.className = "num"; cell.textContent = value;
    row.append(cell);
  }
  return row;
}

const name = (pointer) => pointer.split("/").filter(Boolean).join(" ").replaceAll("_", " ");

function fillTable([a, b]) {
  const table = document.getElementById("compare-table"), unit = data.unit, heads = table.tHead.rows[0].cells;
  heads[1].textContent = a.name; heads[2].textContent = b.name;
  const rows = [];
  const add = (label, x, y, decimals) => {
    if (!isNumber(x) && !isNumber(y)) return;
    rows.push(cells(label, [format(x, decimals), format(y, decimals), isNumber(x) && isNumber(y) ? format(y - x, decimals) : "–"]));
  };
  for (const key of ANGLES) add(`${key}, deg`, a.angles_deg[key], b.angles_deg[key], 2);
  for (const pointer of Object.keys(a.parameters))
    if (!ANGLES.some((key) => pointer.endsWith(`/${key}_deg`))) add(name(pointer), a.parameters[pointer], b.parameters[pointer], 3);
  const own = data.rank_by.startsWith("/"), size = data.rank_by === "mean_load_per_beam" ? 1e3 : unit.newtons;
  if (own || size !== unit.newtons)
    add(`${data.quantity}, ${own ? unit.name : "kN/m"}`, isNumber(a.value) ? a.value / size : null, isNumber(b.value) ? b.value / size : null, unit.decimals);
  const loads = { mean_N: "Mean load", max_N: "Peak", q95_N: "95 % quantile", lindqvist_N: `Lindqvist, ${data.compared}` };
  for (const [key, label] of Object.entries(loads))
    add(`${label}, ${unit.name}`, a[key] === null ? null : a[key] / unit.newtons, b[key] === null ? null : b[key] / unit.newtons, unit.decimals);
  table.tBodies[0].replaceChildren(...rows);
}

function sayDifference([a, b]) {
  const { ci95, p, difference } = welch(a, b), share = (100 * difference) / a.value;
  const said = document.getElementById("compare-said");
  delete said.dataset.p;
  if (a === b || (ci95 === 0 && difference === 0)) { said.textContent = a === b ? "One and the same design." : `${b.name} and ${a.name} have the same.`; return; }
  // Of a number that is not positive there is no percentage.
  const much = a.value > 0 ? `${format(Math.abs(share), 1)} %` : `${format(Math.abs(difference) / data.unit.newtons, data.unit.decimals)} ${data.unit.name}`;
  const apart = `${b.name} is ${much} ${difference < 0 ? "below" : "above"} ${a.name}`;
  if (ci95 === 0) { said.textContent = `${apart}, without sampling error.`; return; }
  if (ci95 === null) { said.textContent = `${apart}; the intervals are not known.`; return; }
  const words = p < 0.001 ? "p < 0.001" : `p = ${p.toFixed(p < 0.0095 ? 3 : 2)}`;
  said.textContent = `${apart}, ± ${format(a.value > 0 ? (100 * ci95) / a.value : ci95 / data.unit.newtons, 1)} (95 %), ${words}: ${p < 0.05 ? "told apart" : "not told apart"}.`;
  said.dataset.p = p;
}

function drawBows(designs) {
  const svg = document.getElementById("compare-bows");
  const beam = Math.max(...designs.map((d) => 2 * (d.outline_m.at(-1)?.[1] ?? 0)));
  const length = Math.max(...designs.map((d) => -(d.outline_m.at(-1)?.[0] ?? 0)));
  svg.closest("figure").hidden = !(beam > 0);
  if (!(beam > 0)) return;
  svg.setAttribute("viewBox", `${-length - 1} ${-beam / 2 - 1} ${length + 2} ${beam + 2}`);
  svg.innerHTML = designs.map((design, k) => {
    const half = design.outline_m, path = [...[...half].reverse(), ...half.map(([x, y]) => [x, -y])];
    return `<path class="bow-${k}" d="M${path.map(([x, y]) => `${x} ${y}`).join("L")}"/>`;
  }).join("");
}

function part(design, selector) {
  const holder = document.createElement("div");
  holder.innerHTML = bodyOf(design.id);
  return [...holder.querySelectorAll(selector)];
}

function show() {
  const designs = chosen.map((id) => data.designs.find((design) => design.id === id));
  fillTable(designs);
  sayDifference(designs);
  drawBows(designs);
  const records = designs.filter((design) => design.histories.length > 0);
  const chart = document.getElementById("chart-compare");
  chart.hidden = records.length === 0;
  if (records.length > 0) drawRecords(chart, records, data.unit, {}, 300);
  const lines = designs.map((design) => part(design, "svg.lines-plan")[0]);
  const place = document.getElementById("compare-lines");
  place.hidden = lines.some((svg) => !svg);
  place.replaceChildren(...lines.filter(Boolean));
  // Ids of the drawings stand in the cards already.
  place.querySelectorAll("svg").forEach((svg, k) => {
    svg.querySelectorAll("[id]").forEach((node) => { node.id += `-compare-${k}`; });
    svg.querySelectorAll("[clip-path]").forEach((node) =>
      node.setAttribute("clip-path", node.getAttribute("clip-path").replace(")", `-compare-${k})`)));
    for (const key of ["aria-labelledby", "aria-describedby"]) svg.removeAttribute(key);
  });
  const pictures = designs.map((design) => part(design, "figure.picture").at(-1));
  document.getElementById("compare-pictures").replaceChildren(...pictures.filter(Boolean));
}

export function setUpCompare(all) {
  data = all;
  const selects = ["a", "b"].map((side) => document.getElementById(`compare-${side}`));
  if (selects.includes(null)) return;
  const ranked = data.designs.filter((design) => design.rank > 0);
  const baseline = ranked.find((design) => design.name === "baseline" && design.rank > 1) ?? ranked[1];
  selects.forEach((select, k) => {
    select.append(...ranked.map(option));
    select.value = (k === 0 ? baseline : ranked[0]).id;
    select.addEventListener("change", () => { chosen = selects.map((other) => other.value); show(); });
  });
  chosen = selects.map((select) => select.value);
}

export function redrawCompare() { if (chosen.length === 2) show(); }
