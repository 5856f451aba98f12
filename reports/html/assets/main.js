// The page reads without this script; it adds charts, sorting, themes, downloads and the enlarged pictures.
import { redrawCharts, resizeCharts, setUpCharts } from "./charts/charts.js";
import { setUpCards } from "./cards.js";
import { setUpDownloads } from "./downloads.js";
import { setUpFilter } from "./filter.js";
import { setUpFolding } from "./folding.js";
import { setUpSorting } from "./sorting.js";
import { setUpTheme } from "./theme.js";

// What went wrong, for the tests and for a curious reader.
const errors = [];
function report(message) {
  errors.push(String(message));
  document.documentElement.dataset.errors = errors.join(" | ");
}
window.addEventListener("error", (event) => report(event.message));
window.addEventListener("unhandledrejection", (event) => report(event.reason));

async function start() {
  const data = JSON.parse(document.getElementById("icebow-data").textContent);
  setUpTheme(redrawCharts);
  setUpFolding();
  setUpSorting();
  await setUpCards(resizeCharts);
  setUpDownloads(data);
  setUpFilter(data);
  // Labels are measured when drawn: the typeface has to be there.
  await Promise.all(["400", "600"].map((weight) => document.fonts.load(`${weight} 12px "Source Sans 3 Variable"`)));
  setUpCharts(data);
}

start()
  .catch((error) => report(error.stack ?? error))
  .finally(() => { document.documentElement.dataset.ready = "true"; });
