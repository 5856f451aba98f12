// Which charts there are, and when they are drawn again.
import { drawAngles } from "./angles.js";
import { drawHistory, setUpHistory } from "./history.js";
import { drawLoads } from "./loads.js";
import { drawScatter } from "./scatter.js";
import { forEachChart } from "./kit.js";

let data = null;

export function setUpCharts(all) {
  data = all;
  setUpHistory(data, () => drawHistory(data, {}));
  redrawCharts();
}

export function redrawCharts(options = {}) {
  if (!data) return;
  drawLoads(data, options);
  drawScatter(data, options);
  drawAngles(data, options);
  drawHistory(data, options);
}

export function resizeCharts() {
  forEachChart((chart) => chart.resize());
}
