// Parallel coordinates: a line for each design through its parameters and its load; ranges are typed as numbers.
import { colour, escaped, format, isNumber, loadOf, measured, variables } from "./kit.js";
import { chooseRange, isChosen, isChoosing, onChoice } from "../selection.js";

const HEIGHT = 300, TOP = 34, BOTTOM = 30, NARROWEST = 52; // px between two scales
const widthOf = (words) => 6.7 * words.length; // of 13 px type, about

function axes(data) {
  const designs = measured(data), unit = data.unit;
  const list = variables(designs).filter(({ key }) => key.startsWith("/"));
  if (data.second)
    list.push({ key: "second", title: `${data.second.words}${data.second.unit ? `, ${data.second.unit}` : ""}`, of: (d) => (isNumber(d.second) ? d.second / data.second.size : null) });
  list.push({ key: "load", title: `load, ${unit.name}`, of: (d) => loadOf(d) / unit.newtons });
  return list.map((axis) => {
    const values = designs.map(axis.of).filter(isNumber);
    return { ...axis, low: Math.min(...values), high: Math.max(...values) };
  });
}

const digits = ({ low, high }) => Math.max(0, Math.min(4, 2 - Math.floor(Math.log10(high - low || 1))));

function input(axis, side, change) {
  const element = document.createElement("input");
  element.type = "number"; element.step = "any";
  element.placeholder = format(axis[side], digits(axis));
  element.setAttribute("aria-label", `${axis.title}, ${side === "low" ? "from" : "to"}`);
  element.addEventListener("input", change);
  return element;
}

export function setUpParallel(data) {
  const host = document.getElementById("parallel-ranges");
  if (!host) return;
  for (const axis of axes(data)) {
    const group = document.createElement("span"), label = document.createElement("b");
    label.textContent = axis.title;
    const change = () => {
      const [from, to] = [low.value, high.value].map((text) => (text === "" ? null : Number(text)));
      const words = `${axis.title} ${from ?? "…"} to ${to ?? "…"}`;
      chooseRange(axis.key, from === null && to === null ? null : { of: axis.of, from: from ?? -Infinity, to: to ?? Infinity, words });
    };
    const low = input(axis, "low", change), high = input(axis, "high", change);
    group.append(label, low, " to ", high);
    host.append(group);
  }
  onChoice(() => { if (!isChoosing()) host.querySelectorAll("input").forEach((field) => { field.value = ""; }); });
}

export function drawParallel(data, options) {
  const element = document.getElementById("chart-parallel");
  if (!element) return;
  const list = axes(data), designs = [...measured(data)].reverse(); // the best on top
  const left = Math.max(60, 0.5 * widthOf(list[0].title)), right = Math.max(60, 0.5 * widthOf(list.at(-1).title)), gaps = Math.max(1, list.length - 1);
  // Many scales on a phone are wider than it, and scroll.
  const width = options.paper ? 680 : Math.max(320, element.clientWidth, left + right + NARROWEST * gaps), step = (width - left - right) / gaps;
  // Titles that have no room side by side stand on several lines.
  const lines = Math.ceil((Math.max(...list.map((axis) => widthOf(axis.title))) + 8) / step), top = TOP + 16 * (lines - 1), height = HEIGHT + top - TOP;
  const x = (k) => left + k * step, y = (axis, value) => top + (height - top - BOTTOM) * (1 - (value - axis.low) / (axis.high - axis.low || 1));
  const ink = { best: colour("accent"), on: colour("tied"), off: colour("rule"), text: colour("ink"), muted: colour("muted") };
  const line = (design) => {
    const points = list.map((axis, k) => (isNumber(axis.of(design)) ? `${x(k).toFixed(1)},${y(axis, axis.of(design)).toFixed(1)}` : null)).filter(Boolean);
    const on = isChosen(design), best = design.rank === 1 && on;
    return `<polyline points="${points.join(" ")}" fill="none" stroke="${best ? ink.best : on ? ink.on : ink.off}" stroke-width="${best ? 2.6 : 1}" stroke-opacity="${on ? 0.75 : 0.45}"><title>${escaped(design.name)}</title></polyline>`;
  };
  const scale = (axis, k) => `<line x1="${x(k)}" x2="${x(k)}" y1="${top}" y2="${height - BOTTOM}" stroke="${ink.muted}"/>`
    + `<text x="${x(k)}" y="${14 + 16 * (k % lines)}" text-anchor="middle" fill="${ink.text}" font-size="13">${escaped(axis.title)}</text>`
    + `<text x="${x(k)}" y="${top - 6}" text-anchor="middle" fill="${ink.muted}" font-size="12">${format(axis.high, digits(axis))}</text>`
    + `<text x="${x(k)}" y="${height - BOTTOM + 15}" text-anchor="middle" fill="${ink.muted}" font-size="12">${format(axis.low, digits(axis))}</text>`;
  const order = [...designs.filter((d) => !isChosen(d)), ...designs.filter(isChosen)];
  element.innerHTML = `<svg width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">${order.map(line).join("")}${list.map(scale).join("")}</svg>`;
  element.dataset.drawn = "true";
}
