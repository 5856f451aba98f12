// Two objectives: each design by both numbers, and the front that no design surpasses in both.
import { axis, describe, draw, format, intervals, isNumber, MANY, nice, palette, tooltip } from "./kit.js";
import { isChosen } from "../selection.js";

// The shape says it without the colour: filled on the front, a ring where the place is open, else a dot.
function mark(design, p) {
  if (!isChosen(design)) return { symbol: "circle", symbolSize: 6, itemStyle: { color: p.rule, opacity: 0.7 } };
  if (design.front === "front") return { symbol: "circle", symbolSize: 12, itemStyle: { color: p.accent } };
  if (design.front === "open")
    return { symbol: "circle", symbolSize: 10, itemStyle: { color: p.panel, borderColor: p.accent, borderWidth: 2 } };
  return { symbol: "circle", symbolSize: 7, itemStyle: { color: p.plain } };
}

function ends(values, halves) {
  const low = Math.min(...values.map((value, i) => value - halves[i])), high = Math.max(...values.map((value, i) => value + halves[i]));
  const margin = 0.06 * (high - low) || Math.abs(high) * 0.05 || 1;
  return nice(low - margin, high + margin, 5);
}

export function drawFront(data, options) {
  const element = document.getElementById("chart-front");
  if (!element || !data.second) return;
  const p = palette(), scale = 1 / (data.rank_by === "mean_load_per_beam" ? 1e3 : data.unit.newtons), size = data.second.size;
  const designs = data.designs.filter((design) => design.front && isNumber(design.second));
  if (designs.length === 0) return;
  const x = (d) => d.second / size, y = (d) => d.value * scale;
  const halfX = (d) => (isNumber(d.second_ci95) ? d.second_ci95 / size : 0), halfY = (d) => (isNumber(d.value_ci95) ? d.value_ci95 * scale : 0);
  const shown = designs.length > MANY ? designs.filter((d) => d.front === "front") : designs;
  const front = designs.filter((d) => d.front === "front").sort((a, b) => x(a) - x(b));
  const unit = data.second.unit ? `, ${data.second.unit}` : "";
  draw(element, {
    grid: { left: 62, right: 28, top: 16, bottom: 52 },
    tooltip: tooltip(p, { trigger: "item", formatter: ({ data: item }) => (item.design
      ? `${describe(item.design, data.unit)}<br>${data.second.words} ${format(x(item.design), 2)} ${data.second.unit}` : "") }),
    xAxis: axis(p, `${data.second.words}${unit} (${data.second.best} is best)`, ends(designs.map(x), designs.map(halfX))),
    yAxis: axis(p, data.quantity, { ...ends(designs.map(y), designs.map(halfY)), nameGap: 44 }),
    series: [
      { type: "line", silent: true, symbol: "none", step: data.second.best === "largest" ? "start" : "end",
        data: front.map((d) => [x(d), y(d)]), lineStyle: { color: p.accent, width: 1.6 } },
      { ...intervals(p, shown.filter((d) => halfY(d) > 0).map((d) => [x(d), y(d) - halfY(d), y(d) + halfY(d)])), encode: { x: 0, y: [1, 2] } },
      { ...intervals(p, shown.filter((d) => halfX(d) > 0).map((d) => [y(d), x(d) - halfX(d), x(d) + halfX(d)]), false), encode: { x: [1, 2], y: 0 } },
      { type: "scatter", z: 3, labelLayout: { hideOverlap: true },
        data: designs.map((design) => ({ value: [x(design), y(design)], name: design.name, design, ...mark(design, p),
          label: { show: design.front === "front" && isChosen(design) } })),
        label: { position: "right", distance: 8, formatter: "{b}", color: p.ink, fontSize: 12, width: 130, overflow: "truncate",
          textBorderColor: p.paper, textBorderWidth: 3 } },
    ],
  }, { ...options, height: options.paper ? 380 : 420, canvas: designs.length > MANY });
}
