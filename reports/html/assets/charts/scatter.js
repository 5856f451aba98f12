// Mean load against Lindqvist's formula.
import { axis, describe, draw, format, fromZero, intervals, isNumber, look, MANY, measured, nice, palette, tooltip } from "./kit.js";

// One range for both axes: the 1:1 line is the diagonal.
function range(designs, scale) {
  const low = designs.flatMap((d) => [d.mean_N - (d.ci95_N ?? 0), d.lindqvist_N]), high = designs.flatMap((d) => [d.mean_N + (d.ci95_N ?? 0), d.lindqvist_N]);
  const lowest = Math.min(...low) * scale, highest = Math.max(...high) * scale, margin = 0.1 * (highest - lowest);
  const foot = fromZero(designs.map((d) => d.mean_N * scale)) || 0;
  return nice(foot < 0 ? lowest - margin : Math.max(0, lowest - margin), highest + margin, 6);
}

// A name stands on the side of its point that faces away from the 1:1 line.
function labelled(design, p, scale) {
  const above = design.mean_N > design.lindqvist_N;
  return { value: [design.lindqvist_N * scale, design.mean_N * scale], name: design.name, ...look(design, p),
    label: { position: above ? "left" : "right", align: above ? "right" : "left" } };
}

function sayCorrelation(data) {
  const target = document.getElementById("spearman");
  if (!target || !isNumber(data.spearman)) return;
  target.textContent = `Spearman’s rank correlation ρ = ${format(data.spearman, 2)} over ${data.spearman_n} designs`
    + (data.spearman_n < 6 ? ", too few to weigh it." : ".");
}

export function drawScatter(data, options) {
  const element = document.getElementById("chart-scatter");
  const designs = measured(data).filter((design) => isNumber(design.lindqvist_N) && isNumber(design.mean_N));
  if (!element || designs.length === 0) return;
  sayCorrelation(data);
  const p = palette(), unit = data.unit, scale = 1 / unit.newtons;
  const ends = range(designs, scale);
  draw(element, {
    grid: { left: 56, right: 28, top: 16, bottom: 52 },
    tooltip: tooltip(p, { trigger: "item", formatter: (item) => describe(designs[item.dataIndex], unit) }),
    xAxis: axis(p, `Lindqvist, ${data.compared}, ${unit.name}`, ends),
    yAxis: axis(p, `Mean load, ${unit.name}`, { ...ends, nameGap: 38 }),
    series: [
      { type: "line", silent: true, symbol: "none", data: [[ends.min, ends.min], [ends.max, ends.max]], lineStyle: { color: p.muted, type: [6, 5], width: 1.2 },
        endLabel: { show: true, formatter: "1 : 1", color: p.muted, fontSize: 12, offset: [-14, 30] } },
      { ...intervals(p, designs.length > MANY ? [] : designs.flatMap((d) => isNumber(d.ci95_N)
        ? [[d.lindqvist_N * scale, (d.mean_N - d.ci95_N) * scale, (d.mean_N + d.ci95_N) * scale]] : [])), encode: { x: 0, y: [1, 2] } },
      { type: "scatter", z: 3, labelLayout: { hideOverlap: true },
        data: designs.map((d) => labelled(d, p, scale)),
        label: { show: designs.length <= 40, distance: 7, formatter: "{b}", color: p.ink, fontSize: 12, width: 130, overflow: "truncate", textBorderColor: p.paper, textBorderWidth: 3 } },
    ],
  }, { ...options, height: options.paper ? 390 : Math.min(500, Math.max(340, 0.86 * element.clientWidth)), canvas: designs.length > MANY });
}
