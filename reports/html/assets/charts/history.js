// Load records of the chosen designs.
import { axis, colour, draw, escaped, format, isNumber, nice, palette, tooltip } from "./kit.js";

const STYLES = [["solid", 0], [[7, 4], 1], [[2, 3], 2], [[10, 3, 2, 3], 3], [[5, 2], 4], [[12, 5], 5]];
const chosen = []; // ids; a place in this list is a line style, kept while the design stays chosen

const recorded = (data) => data.designs.filter((design) => design.histories.length > 0);
const styleOf = (id) => STYLES[chosen.indexOf(id) % STYLES.length];

function choose(id, on) {
  if (!on) chosen[chosen.indexOf(id)] = null;
  else if (chosen.includes(null)) chosen[chosen.indexOf(null)] = id;
  else chosen.push(id);
}

// The best and the baseline at first: more lines hide each other.
function firstChoice(designs) {
  const baseline = designs.find((design) => design.name === "baseline");
  return new Set([designs[0], baseline ?? designs[1]].filter(Boolean));
}

function paintSwatch(label, id) {
  const line = label.querySelector("line"), style = chosen.includes(id) && styleOf(id);
  line.style.stroke = style ? `var(--series-${style[1]})` : "var(--rule)";
  line.setAttribute("stroke-dasharray", style && style[0] !== "solid" ? style[0].join(" ") : "");
}

export function setUpHistory(data, redraw) {
  const picker = document.getElementById("history-picker");
  if (!picker) return;
  const designs = recorded(data), unit = data.unit;
  firstChoice(designs).forEach((design) => choose(design.id, true));
  for (const design of designs) {
    const label = document.createElement("label"), box = document.createElement("input");
    box.type = "checkbox";
    box.checked = chosen.includes(design.id);
    const mean = isNumber(design.mean_N) ? `<span class="mean">${format(design.mean_N / unit.newtons, 2)}</span>` : "";
    label.append(box);
    label.insertAdjacentHTML("beforeend", `<svg width="26" height="8" aria-hidden="true"><line x1="0" x2="26" y1="4" y2="4" stroke-width="2.5"/></svg>${escaped(design.name)}${mean}`);
    box.addEventListener("change", () => { choose(design.id, box.checked); paintSwatch(label, design.id); redraw(); });
    paintSwatch(label, design.id);
    picker.append(label);
  }
}

// A line for each run; the mean of all, within the record: an axis hides a line that ends beyond it.
function series(design, unit, shade, style) {
  const [dash, hue] = style, stroke = colour(`series-${hue}`), scale = 1 / unit.newtons;
  return design.histories.map(({ advance_m: x, load_N: load }, run) => {
    const mean = design.record_mean_N * scale, inside = (at) => Math.min(Math.max(at, x[0]), x.at(-1));
    const [from, to] = (design.steady_m ?? [x[0], x.at(-1)]).map(inside);
    return {
      name: design.histories.length > 1 ? `${design.name}, run ${run + 1}` : design.name,
      type: "line", symbol: "none", data: x.map((at, i) => [at, load[i] * scale]),
      lineStyle: { color: stroke, width: 1, type: "solid", opacity: run === 0 ? 0.75 : 0.35 }, itemStyle: { color: stroke }, emphasis: { disabled: true },
      markLine: run === 0 && isNumber(mean) ? {
        silent: true, symbol: "none", lineStyle: { color: stroke, width: 2.2, type: dash },
        label: { show: false },
        data: [[{ coord: [from, mean] }, { coord: [to, mean] }]],
      } : undefined,
      markArea: run === 0 && shade && design.steady_m ? { silent: true, itemStyle: { color: shade }, data: [[{ xAxis: from }, { xAxis: to }]] } : undefined,
    };
  });
}

function heading(items, unit) {
  const rows = items.map((item) => `${item.marker}${escaped(item.seriesName)} ${format(item.value[1], unit.decimals)} ${unit.name}`);
  return items.length ? `advance ${format(items[0].value[0], 1)} m<br>${rows.join("<br>")}` : "";
}

// Both load axes carry the same ticks: the right one reads them at model scale, where all designs share one scale.
function loadAxes(p, designs, unit) {
  const loads = designs.flatMap((d) => d.histories.flatMap((run) => run.load_N));
  const highest = loads.reduce((a, b) => Math.max(a, b), 0) / unit.newtons;
  const lowest = loads.reduce((a, b) => Math.min(a, b), 0) / unit.newtons;
  const ends = nice(lowest, highest || 1);
  const scales = new Set(designs.map((d) => d.lambda)), lambda = designs[0]?.lambda;
  const isModel = scales.size === 1 && lambda > 1; // the breaking cycle sails at full scale
  return [
    axis(p, `Ice load, full scale, ${unit.name}`, { ...ends, nameGap: 40 }),
    axis(p, "model, N", {
      ...ends, nameGap: 44, splitLine: { show: false }, show: isModel,
      axisLabel: { color: p.muted, fontSize: 12, formatter: (value) => format((value * unit.newtons) / lambda ** 3, 0) },
    }),
  ];
}

export function drawHistory(data, options) {
  const element = document.getElementById("chart-history");
  const all = element ? recorded(data) : [];
  if (all.length === 0) return;
  const designs = all.filter((design) => chosen.includes(design.id));
  drawRecords(element, designs, data.unit, options, options.paper ? 300 : 400, (design) => styleOf(design.id));
}

export function drawRecords(element, designs, unit, options, height, style = (design, i) => STYLES[i]) {
  const p = palette();
  const lines = designs.flatMap((design, i) => series(design, unit, i === 0 && p.band, style(design, i)));
  // The right axis appears only where a series uses it.
  lines.push({ type: "line", yAxisIndex: 1, data: [], silent: true });
  draw(element, {
    grid: { left: 58, right: 64, top: 16, bottom: options.paper ? 50 : 92 },
    tooltip: tooltip(p, { trigger: "axis", formatter: (items) => heading(items, unit), axisPointer: { lineStyle: { color: p.muted } } }),
    xAxis: axis(p, "Advance since first touch, full scale, m", { splitLine: { show: false }, max: "dataMax", axisLabel: { color: p.muted, fontSize: 12, formatter: (v) => String(Math.round(v)), showMaxLabel: false } }),
    yAxis: loadAxes(p, designs, unit),
    dataZoom: options.paper ? [] : [
      { type: "inside", filterMode: "none", zoomOnMouseWheel: "ctrl", moveOnMouseWheel: false },
      { type: "slider", filterMode: "none", height: 22, bottom: 8, borderColor: p.rule, fillerColor: p.band, textStyle: { color: p.muted },
        dataBackground: { lineStyle: { color: p.muted }, areaStyle: { color: p.rule } }, labelFormatter: (v) => `${Math.round(v)} m` },
    ],
    series: lines,
  }, { ...options, height, canvas: false });
}
