// ECharts with the parts this report needs, and what its charts share.
import { CustomChart, LineChart, ScatterChart } from "echarts/charts";
import { DataZoomComponent, GridComponent, MarkAreaComponent, MarkLineComponent, TooltipComponent } from "echarts/components";
import { init, getInstanceByDom, use } from "echarts/core";
import { LabelLayout } from "echarts/features";
import { CanvasRenderer, SVGRenderer } from "echarts/renderers";
import { isChosen } from "../selection.js";

use([CustomChart, LineChart, ScatterChart, DataZoomComponent, GridComponent, MarkAreaComponent, MarkLineComponent,
  TooltipComponent, LabelLayout, CanvasRenderer, SVGRenderer]);

const PAPER_WIDTH = 680; // px that A4 leaves between its margins
const drawn = new Set();

export function forEachChart(action) {
  for (const element of drawn) action(getInstanceByDom(element));
}

// Draws into the element from scratch: a theme or paper changes every colour.
// `canvas`: for hundreds of points, each of which would be an element of the page.
export function draw(element, option, { paper = false, share = 1, height, canvas = false } = {}) {
  getInstanceByDom(element)?.dispose();
  drawn.add(element);
  const size = { renderer: canvas && !paper ? "canvas" : "svg" };
  if (height) element.style.height = `${height}px`;
  if (paper) size.width = Math.floor(PAPER_WIDTH * share);
  const chart = init(element, null, size);
  chart.setOption({ animation: false, textStyle: { fontFamily: FONT }, ...option });
  element.dataset.drawn = "true";
  return chart;
}

export const FONT = '"Source Sans 3 Variable", system-ui, sans-serif';

// A colour of the style sheet, as the browser resolves it in the present theme.
export function colour(name) {
  const probe = document.createElement("i");
  probe.style.color = `var(--${name})`;
  document.body.append(probe);
  const value = getComputedStyle(probe).color;
  probe.remove();
  return value;
}

export function palette() {
  const names = ["ink", "muted", "rule", "panel", "paper", "accent", "tied", "plain", "lindqvist", "band", "alert"];
  return Object.fromEntries(names.map((name) => [name, colour(name)]));
}

export function axis(p, name, more = {}) {
  return {
    type: "value", name, nameLocation: "middle", nameGap: 30, scale: false,
    nameTextStyle: { color: p.muted, fontSize: 13 },
    axisLabel: { color: p.muted, fontSize: 12, hideOverlap: true },
    axisLine: { show: true, lineStyle: { color: p.muted } },
    axisTick: { show: true, lineStyle: { color: p.muted } },
    splitLine: { lineStyle: { color: p.rule } },
    ...more,
  };
}

export function tooltip(p, more = {}) {
  return {
    confine: true, backgroundColor: p.panel, borderColor: p.rule, padding: [8, 12],
    textStyle: { color: p.ink, fontSize: 13, fontFamily: FONT }, ...more,
  };
}

// Ends on whole steps, so that no odd number closes an axis. `count`: about how many steps.
export function nice(lowest, highest, count = 5) {
  const rough = (highest - lowest || Math.abs(highest) || 1) / count, power = 10 ** Math.floor(Math.log10(rough));
  const interval = power * [1, 2, 2.5, 5, 10].find((step) => step * power >= rough * 0.999);
  const whole = (value) => Number((value * interval).toPrecision(12));
  return { min: whole(Math.floor(lowest / interval + 1e-6)), max: whole(Math.ceil(highest / interval - 1e-6)), interval };
}

// An axis of loads begins at zero, or at the lowest of those that are below it.
export const fromZero = (values) => Math.min(0, ...values.filter(isNumber));

export const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

export function format(value, decimals) {
  return isNumber(value) ? value.toFixed(decimals).replace("-", "−") : "–";
}

export function escaped(text) {
  return text.replace(/[&<>"']/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" })[c]);
}

export function withInterval(design, unit) {
  const mean = format(design.mean_N / unit.newtons, unit.decimals);
  return isNumber(design.ci95_N) ? `${mean} ± ${format(design.ci95_N / unit.newtons, unit.decimals)}` : mean;
}

export function describe(design, unit) {
  const lines = [`<b>${escaped(design.name)}</b>, rank ${design.rank}`];
  if (isNumber(design.mean_N)) lines.push(`mean ${withInterval(design, unit)} ${unit.name}`);
  if (isNumber(design.max_N)) lines.push(`peak ${format(design.max_N / unit.newtons, unit.decimals)} ${unit.name}`);
  if (isNumber(design.lindqvist_N)) lines.push(`Lindqvist ${format(design.lindqvist_N / unit.newtons, unit.decimals)} ${unit.name}`);
  const angles = ["stem", "waterline", "buttock", "flare"].map((key) => `${key} ${format(design.angles_deg[key], 1)}°`);
  return lines.concat(angles.join(", ")).join("<br>");
}

// Best: filled accent circle; tied with it: ring; the others: plain dot. The shape says it without the colour.
// Not among the chosen ones: faint.
export function look(design, p) {
  if (!isChosen(design)) return { symbol: "circle", symbolSize: 6, itemStyle: { color: p.rule, opacity: 0.7 } };
  if (design.rank === 1) return { symbol: "circle", symbolSize: 12, itemStyle: { color: p.accent, opacity: 1 } };
  if (design.tied_with_best)
    return { symbol: "circle", symbolSize: 10, itemStyle: { color: p.panel, borderColor: p.accent, borderWidth: 2, opacity: 1 } };
  return { symbol: "circle", symbolSize: 8, itemStyle: { color: p.plain, opacity: 1 } };
}

// A custom series that draws one interval with caps for each item: value = [position, from, to].
export function intervals(p, data, upright = true) {
  return {
    type: "custom", silent: true, z: 2, data, clip: true,
    renderItem(params, api) {
      const at = api.value(0), a = api.coord(upright ? [at, api.value(1)] : [api.value(1), at]);
      const b = api.coord(upright ? [at, api.value(2)] : [api.value(2), at]);
      const style = { stroke: p.muted, lineWidth: 1.4, fill: null };
      const line = (x1, y1, x2, y2) => ({ type: "line", shape: { x1, y1, x2, y2 }, style });
      const cap = 4, [dx, dy] = upright ? [cap, 0] : [0, cap];
      return { type: "group", children: [line(a[0], a[1], b[0], b[1]),
        line(a[0] - dx, a[1] - dy, a[0] + dx, a[1] + dy), line(b[0] - dx, b[1] - dy, b[0] + dx, b[1] + dy)] };
    },
  };
}

// What the charts show of a design: its mean load, or by the formula alone what it is ranked by.
export const loadOf = (design) => design.mean_N ?? design.value;
export const halfOf = (design) => (design.mean_N === null ? null : design.ci95_N);

export const measured = (data) => data.designs.filter((design) => design.rank > 0 && isNumber(loadOf(design)));
export const MANY = 120; // designs from which charts are drawn on a canvas

const UNITS = { deg: "deg", m: "m", m2: "m²", m3: "m³", kg: "kg", kn: "kn", N: "N", Pa: "Pa", kPa: "kPa", MPa: "MPa", GPa: "GPa", s: "s" };

// "/ice/thickness_m" reads "ice thickness, m".
export function title(pointer) {
  const parts = pointer.split("/").filter(Boolean);
  const words = (parts[0] === "bow" ? parts.slice(1) : parts).join(" ").split("_");
  const unit = words.length > 1 && UNITS[words.at(-1)];
  return unit ? `${words.slice(0, -1).join(" ")}, ${unit}` : words.join(" ");
}

// Parameters of the study that differ among the designs, then measured angles that are no parameter.
export function variables(designs) {
  const pointers = [...new Set(designs.flatMap((d) => Object.keys(d.parameters)))];
  const list = pointers.map((pointer) => ({ key: pointer, title: title(pointer), of: (d) => d.parameters[pointer] ?? null }));
  for (const key of ["stem", "waterline", "buttock", "flare"])
    if (!pointers.some((pointer) => pointer.endsWith(`/${key}_deg`)))
      list.push({ key, title: `${key}, deg (measured)`, of: (d) => d.angles_deg[key] });
  return list.filter(({ of, key }) => {
    const values = designs.map(of).filter(isNumber);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    // An angle read off a mesh has an error of hundredths of a degree: that is no variation.
    return values.length > 1 && high - low > (key.startsWith("/") ? 1e-9 : 0.1);
  });
}
