// Mean load of each design with its interval, its peak and Lindqvist's value: one line a design, best on top.
import { axis, describe, draw, fromZero, halfOf, intervals, isNumber, loadOf, look, measured, palette, tooltip } from "./kit.js";
import { isChosen, isChoosing } from "../selection.js";

const MOST = 40;

// The best ones, and the baseline whatever its rank; of a choice those that are chosen.
function shown(all) {
  const chosen = isChoosing() ? all.filter(isChosen) : all;
  const head = chosen.slice(0, MOST), baseline = chosen.find((design) => design.name === "baseline");
  if (baseline && !head.includes(baseline)) head.push(baseline);
  const note = document.getElementById("loads-left-out");
  if (note) note.textContent = head.length < all.length ? ` ${head.length} of ${all.length} designs are shown.` : "";
  return head;
}

export function drawLoads(data, options) {
  const element = document.getElementById("chart-loads");
  const all = element ? measured(data) : [];
  if (all.length === 0) return;
  const designs = shown(all);
  const p = palette(), unit = data.unit, scale = 1 / unit.newtons;
  const points = (key) => designs.map((design, i) => [design[key] * scale, i]).filter(([x], i) => isNumber(designs[i][key]) && isNumber(x));
  const best = all[0];
  const band = isNumber(halfOf(best)) && [[{ xAxis: (best.mean_N - best.ci95_N) * scale }, { xAxis: (best.mean_N + best.ci95_N) * scale }]];
  const foot = fromZero(designs.map(loadOf)); // an interval alone may end below zero, unseen
  const label = (name) => (name.length > 22 ? `${name.slice(0, 21)}…` : name);
  const row = options.paper ? Math.min(26, 820 / designs.length) : 26; // on one sheet of paper
  draw(element, {
    grid: { left: 8, right: 24, top: 8, bottom: 44, containLabel: true },
    tooltip: tooltip(p, { trigger: "item", formatter: (item) => describe(designs[item.value[1]], unit) }),
    xAxis: axis(p, `Load, full scale, ${unit.name}`, foot < 0 ? {} : { min: 0 }),
    yAxis: axis(p, "", {
      type: "category", inverse: true, data: designs.map((design) => label(design.name)),
      axisLine: { show: false }, axisTick: { show: false }, splitLine: { show: true, lineStyle: { color: p.rule, type: [1, 4] } },
      axisLabel: { color: p.ink, fontSize: 13, interval: 0 },
    }),
    series: [
      { ...intervals(p, designs.flatMap((d, i) => isNumber(halfOf(d)) ? [[i, (d.mean_N - d.ci95_N) * scale, (d.mean_N + d.ci95_N) * scale]] : []), false),
        encode: { x: [1, 2], y: 0 } },
      { type: "scatter", z: 3, data: designs.map((d, i) => ({ value: [loadOf(d) * scale, i], ...look(d, p) })),
        markArea: band ? { silent: true, itemStyle: { color: p.band }, data: band } : undefined },
      { type: "scatter", z: 1, symbol: "triangle", symbolSize: 8, data: points("max_N"),
        itemStyle: { color: "transparent", borderColor: p.muted, borderWidth: 1.2 } },
      { type: "scatter", z: 1, symbol: "diamond", symbolSize: 11, data: best.mean_N === null ? [] : points("lindqvist_N"), itemStyle: { color: p.lindqvist, opacity: 1 } },
    ],
  }, { ...options, height: row * Math.max(3, designs.length) + 64 });
}
