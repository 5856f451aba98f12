// What each parameter does by itself: change over its range, and the fitted response with its error and the designs.
import { axis, colour, draw, format, intervals, isNumber, look, MANY, nice, palette, title, tooltip } from "./kit.js";
import { bounds, places } from "./angles.js";

export function drawEffects(data, options) {
  const element = document.getElementById("chart-effects");
  if (!element || !data.fit) return;
  const p = palette(), scale = 1 / data.unit.newtons, effects = data.fit.effects;
  const ends = effects.flatMap((e) => [(e.change - e.ci95) * scale, (e.change + e.ci95) * scale, 0]);
  const wide = options.paper || element.clientWidth > 520; // a phone leaves the names of the parameters half of it
  const words = (e) => `${title(e.pointer)}: ${format(e.lower, 1)} to ${format(e.upper, 1)}`;
  draw(element, {
    grid: { left: 8, right: 24, top: 8, bottom: 44, containLabel: true },
    tooltip: tooltip(p, { trigger: "item", formatter: ({ dataIndex: i }) =>
      `${words(effects[i])}<br>${format(effects[i].change * scale, 3)} ± ${format(effects[i].ci95 * scale, 3)} ${data.unit.name}` }),
    xAxis: axis(p, `Change of the load${wide ? " over the range" : ""}, ${data.unit.name}`, nice(Math.min(...ends), Math.max(...ends), 6)),
    yAxis: axis(p, "", {
      type: "category", inverse: true, data: effects.map(words), axisTick: { show: false },
      axisLine: { show: true, lineStyle: { color: p.muted }, onZero: true }, axisLabel: { color: p.ink, fontSize: 13, lineHeight: 14, interval: 0, ...(wide ? {} : { width: 0.42 * element.clientWidth, overflow: "break" }) },
    }),
    series: [
      { type: "scatter", z: 3, symbolSize: 11, data: effects.map((e, i) => ({ value: [e.change * scale, i],
        itemStyle: { color: Math.abs(e.change) > e.ci95 ? p.accent : p.panel, borderColor: p.accent, borderWidth: 2 } })) },
      { ...intervals(p, effects.map((e, i) => [i, (e.change - e.ci95) * scale, (e.change + e.ci95) * scale]), false), encode: { x: [1, 2], y: 0 } },
    ],
  }, { ...options, height: 34 * effects.length + 70 });
}

export function drawResponse(data, options) {
  const host = document.getElementById("chart-response");
  if (!host || !data.fit) return;
  const p = palette(), scale = 1 / data.unit.newtons, stroke = colour("series-0");
  const designs = data.fit.names.map((name) => data.designs.find((design) => design.name === name));
  const elements = places(host, data.fit.effects.length);
  data.fit.effects.forEach((effect, k) => {
    const low = effect.at.map((x, i) => [x, (effect.value[i] - effect.half_width[i]) * scale]);
    const width = effect.at.map((x, i) => [x, 2 * effect.half_width[i] * scale]);
    const points = designs.map((design, i) => ({ value: [design.parameters[effect.pointer], effect.moved[i] * scale], ...look(design, p) }));
    const all = [...points.map(({ value }) => value[1]), ...low.map(([, y]) => y), ...effect.value.map((y) => y * scale)].filter(isNumber);
    const line = { type: "line", symbol: "none", silent: true };
    draw(elements[k], {
      grid: { left: 52, right: 14, top: 12, bottom: 46 },
      tooltip: tooltip(p, { trigger: "item", formatter: (item) => `${designs[item.dataIndex].name}` }),
      xAxis: axis(p, title(effect.pointer), bounds(effect.at)),
      yAxis: axis(p, `Load, ${data.unit.name}`, { ...nice(Math.min(...all), Math.max(...all), 4), nameGap: 38 }),
      series: [
        { ...line, stack: "band", stackStrategy: "all", data: low, lineStyle: { opacity: 0 } },
        { ...line, stack: "band", stackStrategy: "all", data: width, lineStyle: { opacity: 0 }, areaStyle: { color: stroke, opacity: 0.22 } },
        { ...line, data: effect.at.map((x, i) => [x, effect.value[i] * scale]), lineStyle: { color: stroke, width: 2 } },
        { type: "scatter", z: 3, data: points },
      ],
    }, { ...options, share: 0.48, height: options.paper ? 200 : 230, canvas: designs.length > MANY });
  });
}
