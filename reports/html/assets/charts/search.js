// An optimiser's way: each design it tried, in order, and the best so far.
import { axis, describe, draw, isNumber, nice, palette, title, tooltip } from "./kit.js";

// "stem_deg on its bound; smallest margin g1 = 0.02".
function ends(design, bounds) {
  const words = Object.entries(bounds).flatMap(([pointer, [low, high]]) => {
    const value = design.parameters[pointer];
    return isNumber(value) && Math.min(value - low, high - value) < 0.005 * (high - low) ? [`${title(pointer)} on its bound`] : [];
  });
  const margin = design.smallest_margin;
  if (margin) words.push(`smallest margin ${margin.name} = ${Number(margin.value.toPrecision(3))}`);
  return words.join("; ");
}

export function drawSearch(data, options) {
  const element = document.getElementById("chart-search");
  if (!element) return;
  const p = palette(), scale = 1 / (data.rank_by === "mean_load_per_beam" ? 1e3 : data.unit.newtons);
  const tried = [...data.designs].filter((design) => design.order > 0).sort((a, b) => a.order - b.order);
  const good = tried.filter((design) => design.rank > 0), values = good.map((design) => design.value * scale);
  if (good.length === 0) return;
  const ends_y = nice(Math.min(...values) * 0.98, Math.max(...values), 5);
  let best = Infinity;
  const line = good.map((design) => { best = Math.min(best, design.value * scale); return [design.order, best]; });
  line.push([tried.at(-1).order, best]);
  const tell = (design) => `${describe(design, data.unit)}<br>${ends(design, data.bounds)}`;
  const at = (list, symbol, style) => ({ type: "scatter", symbol, symbolSize: 9, itemStyle: style,
    data: list.map((design) => ({ value: [design.order, design.rank > 0 ? design.value * scale : ends_y.min], design })) });
  draw(element, {
    grid: { left: 58, right: 24, top: 16, bottom: 48 },
    tooltip: tooltip(p, { trigger: "item", formatter: (item) => (item.data.design ? tell(item.data.design) : "") }),
    xAxis: axis(p, "Design, in order of evaluation", { min: 0, minInterval: 1 }),
    yAxis: axis(p, data.quantity, { ...ends_y, nameGap: 42 }),
    series: [
      { type: "line", step: "end", symbol: "none", silent: true, data: line, lineStyle: { color: p.accent, width: 2 } },
      at(good, "circle", { color: p.plain }),
      at(tried.filter((design) => design.status === "infeasible"), "triangle", { color: "transparent", borderColor: p.alert, borderWidth: 1.4 }),
      at(tried.filter((design) => design.status === "failed"), "path://M0,0L8,8M8,0L0,8", { color: "transparent", borderColor: p.alert, borderWidth: 2 }),
    ],
  }, { ...options, height: 320 });
}
