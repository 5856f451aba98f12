// Load against each parameter that varies, and each measured angle: small multiples on one load axis.
import { axis, describe, draw, fromZero, halfOf, intervals, isNumber, loadOf, look, MANY, measured, nice, palette, tooltip, variables } from "./kit.js";

export function bounds(values) {
  const lowest = Math.min(...values), highest = Math.max(...values), margin = 0.06 * (highest - lowest) || 1;
  return nice(lowest - margin, highest + margin, 4);
}

// Places for so many small charts, before any is drawn: a chart measures its width then.
export function places(host, count) {
  while (host.children.length < count) host.appendChild(document.createElement("div")).className = "chart";
  return [...host.children];
}

export function drawAngles(data, options) {
  const host = document.getElementById("chart-angles");
  const all = measured(data);
  if (!host || all.length === 0) return;
  const p = palette(), unit = data.unit, scale = 1 / unit.newtons;
  const top = Math.max(0, ...all.map((d) => (loadOf(d) + (halfOf(d) ?? 0)) * scale));
  const foot = fromZero(all.map((d) => loadOf(d) * scale));
  const list = variables(all);
  host.closest("figure").hidden = list.length === 0;
  const elements = places(host, list.length);
  list.forEach((panel, k) => {
    const designs = all.filter((d) => isNumber(panel.of(d)));
    draw(elements[k], {
      grid: { left: 44, right: 14, top: 12, bottom: 46 },
      tooltip: tooltip(p, { trigger: "item", formatter: (item) => describe(designs[item.dataIndex], unit) }),
      xAxis: axis(p, panel.title, bounds(designs.map(panel.of))),
      yAxis: axis(p, `Load, ${unit.name}`, { ...nice(1.04 * foot, 1.04 * top, 4), nameGap: 32 }),
      series: [
        { ...intervals(p, designs.length > MANY ? [] : designs.flatMap((d) => isNumber(halfOf(d))
          ? [[panel.of(d), (loadOf(d) - halfOf(d)) * scale, (loadOf(d) + halfOf(d)) * scale]] : [])), encode: { x: 0, y: [1, 2] } },
        { type: "scatter", z: 3, data: designs.map((d) => ({ value: [panel.of(d), loadOf(d) * scale], ...look(d, p) })) },
      ],
    }, { ...options, share: 0.48, height: options.paper ? 200 : 230, canvas: designs.length > MANY });
  });
}
