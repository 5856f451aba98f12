// Which charts there are, and when they are drawn again.
import { drawAngles } from "./angles.js";
import { drawEffects, drawResponse } from "./effects.js";
import { drawFront } from "./front.js";
import { drawHistory, setUpHistory } from "./history.js";
import { drawLoads } from "./loads.js";
import { drawParallel, setUpParallel } from "./parallel.js";
import { drawScatter } from "./scatter.js";
import { drawSearch } from "./search.js";
import { forEachChart } from "./kit.js";
import { onChoice } from "../selection.js";
import { redrawCompare, setUpCompare } from "../compare.js";

const CHOOSING = [drawLoads, drawFront, drawParallel, drawScatter, drawAngles, drawResponse];
const ALL = [drawSearch, ...CHOOSING, drawEffects, drawHistory];
let data = null;

// Each chart is drawn when it comes near the window, or before the page is printed.
const waiting = new Map();

function place(draw) { return document.getElementById(PLACES.get(draw)); }

const PLACES = new Map([[drawSearch, "chart-search"], [drawLoads, "chart-loads"], [drawFront, "chart-front"], [drawParallel, "chart-parallel"],
  [drawScatter, "chart-scatter"], [drawAngles, "chart-angles"], [drawResponse, "chart-response"],
  [drawEffects, "chart-effects"], [drawHistory, "chart-history"]]);

export function setUpCharts(all) {
  data = all;
  setUpHistory(data, () => drawHistory(data, {}));
  setUpParallel(data);
  setUpCompare(data);
  onChoice(() => CHOOSING.filter((draw) => !waiting.has(draw)).forEach((draw) => draw(data, {})));
  const watcher = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      watcher.unobserve(target);
      target.awaited?.();
    }
  }, { rootMargin: "600px" });
  for (const draw of ALL) {
    const element = place(draw);
    if (!element) continue;
    waiting.set(draw, true);
    element.awaited = () => { if (waiting.delete(draw)) draw(data, {}); };
    watcher.observe(element);
  }
  const compare = document.getElementById("compare");
  const atOnce = location.hash.includes("charts=all"); // for tests, and pictures of a whole page
  if (compare) {
    compare.awaited = () => redrawCompare();
    watcher.observe(compare);
  }
  if (!atOnce) return;
  ALL.forEach((draw) => place(draw)?.awaited());
  compare?.awaited();
}

export function redrawCharts(options = {}) {
  if (!data) return;
  for (const draw of ALL) {
    if (options.paper) waiting.delete(draw);
    if (!waiting.has(draw)) draw(data, options);
  }
  if (document.getElementById("chart-compare")?.dataset.drawn) redrawCompare();
}

export function resizeCharts() {
  forEachChart((chart) => chart.resize());
  if (data && !waiting.has(drawParallel)) drawParallel(data, {});
}
