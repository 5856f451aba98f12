// Mean load against each angle, and against every other parameter the study varied: small multiples on one load axis.
import { axis, describe, draw, intervals, isNumber, look, measured, nice, palette, tooltip } from "./kit.js";

const ANGLES = { stem: "Stem angle, deg", waterline: "Waterline angle, deg", buttock: "Buttock angle, deg", flare: "Flare angle, deg" };
const UNITS = { deg: "deg", m: "m", kn: "kn", Pa: "Pa", s: "s" };

// "/ice/thickness_m" reads "ice thickness, m".
function title(pointer) {
  const words = pointer.split("/").filter(Boolean).join(" ").split("_");
  const unit = words.length > 1 && UNITS[words.at(-1)];
  return unit ? `${words.slice(0, -1).join(" ")}, ${unit}` : words.join(" ");
}

function panels(designs) {
  const list = Object.keys(ANGLES).map((key) => ({ title: ANGLES[key], of: (d) => d.angles_deg[key] }));
  const pointers = new Set(designs.flatMap((d) => Object.keys(d.parameters)));
  for (const pointer of pointers) {
    if (Object.keys(ANGLES).some((key) => pointer.endsWith(`/${key}_deg`))) continue;
    list.push({ title: title(pointer), of: (d) => d.parameters[pointer] });
  }
  return list.filter(({ of }) => designs.some((d) => isNumber(of(d))));
}

function bounds(values) {
  const lowest = Math.min(...values), highest = Math.max(...values), margin = 0.06 * (highest - lowest) || 1;
  return nice(lowest - margin, highest + margin, 4);
}

export function drawAngles(data, options) {
  const host = document.getElementById("chart-angles");
  const all = measured(data);
  if (!host || all.length === 0) return;
  const p = palette(), unit = data.unit, scale = 1 / unit.newtons;
  const top = Math.max(...all.map((d) => (d.mean_N + (d.ci95_N ?? 0)) * scale));
  const list = panels(all);
  // All places first: a chart measures its width when it is drawn.
  while (host.children.length < list.length) host.appendChild(document.createElement("div")).className = "chart";
  list.forEach((panel, k) => {
    const element = host.children[k];
    const designs = all.filter((d) => isNumber(panel.of(d)));
    draw(element, {
      grid: { left: 44, right: 14, top: 12, bottom: 46 },
      tooltip: tooltip(p, { trigger: "item", formatter: (item) => describe(designs[item.dataIndex], unit) }),
      xAxis: axis(p, panel.title, bounds(designs.map(panel.of))),
      yAxis: axis(p, `Mean load, ${unit.name}`, { ...nice(0, 1.04 * top, 4), nameGap: 32 }),
      series: [
        { ...intervals(p, designs.flatMap((d) => isNumber(d.ci95_N)
          ? [[panel.of(d), (d.mean_N - d.ci95_N) * scale, (d.mean_N + d.ci95_N) * scale]] : [])), encode: { x: 0, y: [1, 2] } },
        { type: "scatter", z: 3, data: designs.map((d) => ({ value: [panel.of(d), d.mean_N * scale], ...look(d, p) })) },
      ],
    }, { ...options, share: 0.48, height: options.paper ? 200 : 230 });
  });
}
