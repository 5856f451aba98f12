// An optimiser's way: each design it tried, in order, and the best so far.
import { axis, describe, draw, format, isNumber, nice, palette, title, tooltip } from "./kit.js";

// "stem, deg at its lowest", for each parameter within half a percent of an end of its range.
function onBounds(design, bounds) {
  return Object.entries(bounds).flatMap(([pointer, [low, high]]) => {
    const value = design.parameters[pointer], near = 0.005 * (high - low);
    if (!isNumber(value) || Math.min(value - low, high - value) >= near) return [];
    return [`${title(pointer)} at its ${value - low < near ? "lowest" : "highest"}`];
  }).join("; ");
}

const marginOf = ({ smallest_margin: m }) => (m ? `${m.name} = ${Number(m.value.toPrecision(3))}` : "");

const MOST_STEPS = 12;

// The designs that were better than all before them, the last ones first.
function tellSteps(data, tried, good) {
  let best = Infinity;
  const steps = good.filter((design) => design.value < best && ((best = design.value), true)).reverse();
  const body = document.querySelector("#search-steps tbody");
  body.replaceChildren(...steps.slice(0, MOST_STEPS).map((design) => {
    const row = document.createElement("tr");
    for (const [k, words] of [design.order, design.name, format(design.value / scaleOf(data), data.unit.decimals), onBounds(design, data.bounds) || "none",
      marginOf(design) || "none given"].entries()) {
      const cell = row.appendChild(document.createElement("td"));
      cell.textContent = words;
      if (k === 0 || k === 2) cell.className = "num";
    }
    return row;
  }));
  document.getElementById("search-value").textContent = `Value, ${data.rank_by === "mean_load_per_beam" ? "kN/m" : data.unit.name}`;
  const count = (status) => tried.filter((design) => design.status === status).length;
  document.getElementById("search-said").textContent = `${tried.length} designs were tried, ${good.length} of them ranked, `
    + `${count("infeasible")} infeasible, ${count("failed")} failed; ${steps.length} bettered all before them`
    + (steps.length > MOST_STEPS ? `, the last ${MOST_STEPS} of which are listed.` : ".");
}

const scaleOf = (data) => (data.rank_by === "mean_load_per_beam" ? 1e3 : data.unit.newtons);

export function drawSearch(data, options) {
  const element = document.getElementById("chart-search");
  if (!element) return;
  const p = palette(), scale = 1 / scaleOf(data);
  const tried = [...data.designs].filter((design) => design.order > 0).sort((a, b) => a.order - b.order);
  const good = tried.filter((design) => design.rank > 0), values = good.map((design) => design.value * scale);
  if (good.length === 0) return;
  tellSteps(data, tried, good);
  const ends_y = nice(Math.min(...values.map((value) => value - 0.02 * Math.abs(value))), Math.max(...values), 5);
  let best = Infinity;
  const line = good.map((design) => { best = Math.min(best, design.value * scale); return [design.order, best]; });
  line.push([tried.at(-1).order, best]);
  const tell = (design) => [describe(design, data.unit), onBounds(design, data.bounds), marginOf(design) && `smallest margin ${marginOf(design)}`].filter(Boolean).join("<br>");
  const at = (list, symbol, style) => ({ type: "scatter", symbol, symbolSize: 9, itemStyle: style,
    data: list.map((design) => ({ value: [design.order, design.rank > 0 ? design.value * scale : ends_y.min], design })) });
  draw(element, {
    grid: { left: 58, right: 24, top: 16, bottom: 48 },
    tooltip: tooltip(p, { trigger: "item", formatter: (item) => (item.data.design ? tell(item.data.design) : "") }),
    xAxis: axis(p, "Design, in order of evaluation", { min: 0, minInterval: 1 }),
    yAxis: axis(p, `${data.quantity}, ${data.rank_by === "mean_load_per_beam" ? "kN/m" : data.unit.name}`, { ...ends_y, nameGap: 42 }),
    series: [
      { type: "line", step: "end", symbol: "none", silent: true, data: line, lineStyle: { color: p.accent, width: 2 } },
      at(good, "circle", { color: p.plain }),
      at(tried.filter((design) => design.status === "infeasible"), "triangle", { color: "transparent", borderColor: p.alert, borderWidth: 1.4 }),
      at(tried.filter((design) => design.status === "failed"), "path://M0,0L8,8M8,0L0,8", { color: "transparent", borderColor: p.alert, borderWidth: 2 }),
    ],
  }, { ...options, height: 320 });
}
