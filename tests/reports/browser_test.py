"""Opens sample reports in headless Chromium: no script error, every chart drawn, the page's interactions work.

    browser_test.py WRITE_SAMPLE_REPORT AXE_MIN_JS ICEBOW

axe-core looks at every page in light and dark: what it finds fails the test. Every page is laid out for a desktop, a
small laptop and a phone: layout.js tells what is cut, sticks out or overlaps.
"""

import base64
import csv
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--virtual-time-budget=10000", "--window-size=1300,2000", "--dump-dom"]
FULL = {"chart-loads", "chart-scatter", "chart-parallel", "chart-angles", "chart-effects", "chart-response", "chart-history",
        "chart-compare"}
CHARTS = {"": FULL, "pareto": FULL | {"chart-front"}, "unfinished": FULL,
          "many": {"chart-loads", "chart-parallel", "chart-angles", "chart-effects", "chart-response"},
          "cycle": FULL - {"chart-effects", "chart-response"},
          "formula": {"chart-loads", "chart-parallel", "chart-angles", "chart-effects", "chart-response"}}

TWO = {"/bow/stem_deg": {"min": 20, "max": 26}, "/bow/waterline_deg": {"min": 20, "max": 26}}
NINE = {**TWO, "/bow/buttock_deg": {"min": 26, "max": 30}, "/ice/thickness_m": {"min": 0.7, "max": 0.9},
        "/ice/flexural_strength_kPa": {"min": 450, "max": 550}, "/ice/elastic_modulus_GPa": {"min": 1.2, "max": 1.4},
        "/ice/friction": {"min": 0.09, "max": 0.11}, "/operation/speed_kn": {"min": 2, "max": 4}, "/bow/draft_m": {"min": 7.4, "max": 7.6}}

# Of four bows, the best three with their cards, each of which has less than three pages, and nine parameters. It prints on 14.
MOST_PAGES = 15

# What a reader does, in the page itself; each line of `done` is a check that held.
READER = """
const done = [], $ = (id) => document.getElementById(id);
const check = (what, holds) => done.push(`${holds ? "ok" : "FAILED"} ${what}`);
const type = (field, value) => { field.value = value; field.dispatchEvent(new Event("input", { bubbles: true })); };
const rows = () => [...document.querySelectorAll("table.ranking tbody tr")].filter((row) => !row.hidden);
const until = async (holds) => { for (let k = 0; k < 200 && !holds(); ++k) await new Promise((go) => setTimeout(go, 20)); };
(async () => {
  await until(() => document.documentElement.dataset.ready);
  const all = rows().length;
  type($("filter-name"), "th");
  check("a name typed over the table leaves its designs", rows().length > 0 && rows().every((row) => /th/i.test(row.cells[1].textContent)));
  check("their number is said", $("filter-said").textContent.startsWith(`${rows().length} of ${all} designs`));
  $("filter-clear").click();
  check("one button shows all again", rows().length === all);
  const from = document.querySelector("#parallel-ranges input");
  type(from, "22");
  check("a range of numbers chooses designs in the table", rows().length > 0 && rows().length < all);
  check("and is said in numbers", /22 to/.test($("filter-said").textContent));
  check("the parallel coordinates grey the others", new Set([...document.querySelectorAll("#chart-parallel polyline")].map((line) => line.getAttribute("stroke"))).size > 1);
  $("filter-clear").click();
  check("the range is cleared too", from.value === "" && rows().length === all);
  const stem = [...document.querySelectorAll("table.ranking button.sort")].find((button) => button.textContent === "Stem");
  stem.click();
  const angles = rows().map((row) => Number(row.cells[2].dataset.sort));
  check("a heading sorts", angles.every((value, i) => i === 0 || value >= angles[i - 1]));
  for (const [side, name] of [["a", "Thyssen-Waas"], ["b", "high flare"]]) {
    const select = $(`compare-${side}`);
    select.value = [...select.options].find((option) => option.textContent.includes(name)).value;
    select.dispatchEvent(new Event("change"));
  }
  check("two designs are compared in words", /high flare is [0-9.]+ % above Thyssen-Waas/.test($("compare-said").textContent));
  check("with numbers of both", $("compare-table").rows.length > 5);
  check("with both waterlines", $("compare-bows").querySelectorAll("path").length === 2);
  check("Welch's test has the p of the program", Math.abs(Number($("compare-said").dataset.p) - P_VALUE) < 1e-6);
  $("theme").click();
  check("the theme changes", ["light", "dark"].includes(document.documentElement.dataset.theme));
  // The records end at 62.49 m, the steady part at 62.5 m: a line to a place beyond the axis is not drawn.
  const means = () => [...$("chart-history").querySelectorAll('path[stroke-width="2.2"]')].map((line) => line.getBBox().width);
  check("each record that is shown has its mean as a line", means().length === 2 && means().every((width) => width > 200));
  const card = document.querySelectorAll("details.card")[5];
  location.hash = card.id;
  await until(() => card.open);
  check("a link opens its card", card.open);
  const zoom = document.querySelector("button.zoom");
  zoom?.click();
  check("a picture enlarges", !zoom || $("lightbox").open);
})().catch((error) => done.push(`FAILED ${error}`)).finally(() => { document.documentElement.dataset.reader = done.join("|"); });
"""


# axe-core's findings, each with its first place.
AXE = """
(async () => {
  for (let k = 0; k < 400 && !document.documentElement.dataset.ready; ++k) await new Promise((go) => setTimeout(go, 20));
  document.getElementById("open-all")?.click();
  const { violations } = await axe.run(document, { resultTypes: ["violations"] });
  return violations.map((v) => `${v.id}: ${v.help} (${v.nodes.length} places, ${v.nodes[0].target}: ${v.nodes[0].failureSummary.replace(/\\s+/g, " ")})`);
})().catch((error) => [`axe did not run: ${error}`]).then((found) => {
  document.documentElement.dataset.axe = found.length ? found.join(" | ").replaceAll('"', "'") : "nothing";
});
"""


# The same on a page of many designs.
READER_OF_MANY = """
const done = [], $ = (id) => document.getElementById(id);
const check = (what, holds) => done.push(`${holds ? "ok" : "FAILED"} ${what}`);
const until = async (holds) => { for (let k = 0; k < 200 && !holds(); ++k) await new Promise((go) => setTimeout(go, 20)); };
const rows = () => document.querySelectorAll("table.ranking tbody tr");
(async () => {
  await until(() => document.documentElement.dataset.ready);
  check("a long table shows its first rows", rows().length === 25);
  const last = [...document.querySelectorAll("details.card")].at(-1);
  check("a late card is empty", last.querySelector(".card-body").childElementCount === 0);
  location.hash = last.id;
  await until(() => last.open);
  check("it is filled when it opens", /Lindqvist's formula/.test(last.textContent));
  document.querySelector("table.ranking button.sort").click();
  check("a table that is sorted is whole", rows().length === 41 && !$("show-all-rows"));
  const height = () => $("chart-loads").querySelector("svg").getBoundingClientRect().height;
  check("on the screen each of forty designs has its line", height() > 26 * 40);
  dispatchEvent(new Event("beforeprint"));
  check("on paper they share one sheet", height() > 400 && height() < 930);
  dispatchEvent(new Event("afterprint"));
  check("and after it the screen has its own again", height() > 26 * 40);
})().catch((error) => done.push(`FAILED ${error}`)).finally(() => { document.documentElement.dataset.reader = done.join("|"); });
"""


# The search of an optimiser: its axis begins near the lowest value, and marks what has no load at the foot.
READER_OF_SEARCH = """
const done = [], $ = (id) => document.getElementById(id);
const check = (what, holds) => done.push(`${holds ? "ok" : "FAILED"} ${what}`);
const until = async (holds) => { for (let k = 0; k < 200 && !holds(); ++k) await new Promise((go) => setTimeout(go, 20)); };
(async () => {
  await until(() => document.documentElement.dataset.ready);
  const data = JSON.parse($("icebow-data").textContent), ranked = data.designs.filter((design) => design.rank > 0);
  const values = ranked.map((design) => design.value / data.unit.newtons), lowest = Math.min(...values), highest = Math.max(...values);
  const labels = [...$("chart-search").querySelectorAll('svg text[text-anchor="end"]')].map((label) => Number(label.textContent)).filter(Number.isFinite);
  const foot = Math.min(...labels), top = Math.max(...labels);
  check(`the search's axis, ${foot} to ${top}, holds its values, ${lowest} to ${highest}`, labels.length > 2 && foot <= lowest && top >= highest);
  check("and does not begin far below them", foot > lowest - 0.6 * (highest - lowest) - 0.05 * lowest);
  check("the steps that bettered all before are listed, the best first", Math.abs(Number($("search-steps").tBodies[0].rows[0].cells[2].textContent) - lowest) < 0.001);
})().catch((error) => done.push(`FAILED ${error}`)).finally(() => { document.documentElement.dataset.reader = done.join("|"); });
"""


WIDTHS = (1440, 1024, 390)
# The page in a frame of each width; what its layout.js says, in one attribute.
FRAMES = """<!doctype html><html><body><script>
const said = [];
addEventListener("message", ({ data }) => {
  said.push(data.wrong.length ? `${data.wide} px: ${data.wrong.slice(0, 8).join("; ")}` : "");
  if (said.length === %d) document.documentElement.dataset.layout = said.filter(Boolean).join(" | ") || "nothing";
});
</script>%s</body></html>"""


def page_in_browser(browser, html, address="#charts=all"):
    with tempfile.TemporaryDirectory() as profile:
        command = [browser, *FLAGS, "--user-data-dir=" + profile, "file://" + html + address]
        result = subprocess.run(command, capture_output=True, text=True, timeout=100)
    return result.stdout


def pages_on_paper(browser, html):
    """How many sheets of A4 the page prints on, charts drawn."""
    with tempfile.TemporaryDirectory() as folder:
        pdf = os.path.join(folder, "page.pdf")
        flags = [flag for flag in FLAGS if flag != "--dump-dom"]
        subprocess.run([browser, *flags, "--user-data-dir=" + folder, "--no-pdf-header-footer", "--print-to-pdf=" + pdf,
                        "file://" + html], capture_output=True, timeout=100)
        with open(pdf, "rb") as file:
            return len(re.findall(rb"/Type\s*/Page\b", file.read()))


def write_study(kind, study, directory):
    """A made-up study; "cycle" is a real one, with the process of the breaking in its cards; "many" has 41 designs."""
    if kind not in ("cycle", "many", "search"):
        subprocess.run([sys.argv[1], study, kind], check=True)
        return
    file = os.path.join(directory, f"{kind}.json")
    ship = ["--length", "110", "--beam", "22", "--draft", "7.5", "--thickness", "0.8", "--speed", "3", "--samples", "3" if kind == "cycle" else "40"]
    asked = [] if kind == "cycle" else ["--set", '/evaluators=["lindqvist"]', "--set", "/ranking={\"by\": \"lindqvist_breaking\"}"]
    subprocess.run([sys.argv[3], "new", file, *ship], check=True, capture_output=True)
    if kind == "cycle":  # ten scales side by side
        asked = ["--set", "/ice/friction=0.1", "--set", "/method/variables=" + json.dumps(NINE)]
    if kind == "search":
        asked = ["--set", "/method=" + json.dumps({"type": "optimise", "max_evaluations": 20, "seed": 1, "variables": TWO})]
    subprocess.run([sys.argv[3], "run", file, "--out", study, *asked], check=True, capture_output=True)


def with_reader(html, script):
    """The page with one more script in it, which its policy knows by the digest."""
    text = open(html, encoding="utf-8").read()
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    text = text.replace("script-src '", f"script-src 'sha256-{digest}' '", 1)
    path = html.replace(".html", "_reader.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace("</body>", f"<script>{script}</script></body>"))
    return path


def findings_of(browser, html, axe):
    """What axe-core finds in light and in dark."""
    page = with_reader(html, axe + AXE)
    found = []
    for theme in ("light", "dark"):
        said = re.search(r'data-axe="([^"]*)"', page_in_browser(browser, page, f"#charts=all&theme={theme}"))
        if not said or said[1] != "nothing":
            found.append(f"axe-core, {theme}: {said[1] if said else 'did not run'}")
    return found


def badly_laid_out(browser, html):
    """What layout.js finds at each width."""
    with open(os.path.join(os.path.dirname(__file__), "layout.js"), encoding="utf-8") as file:
        page = os.path.basename(with_reader(html, file.read()))
    frames = os.path.join(os.path.dirname(html), "frames.html")
    with open(frames, "w", encoding="utf-8") as file:
        file.write(FRAMES % (len(WIDTHS), "".join(
            f'<iframe src="{page}#charts=all" width="{width}" height="1000"></iframe>' for width in WIDTHS)))
    said = re.search(r'data-layout="([^"]*)"', page_in_browser(browser, frames, ""))
    if not said or said[1] != "nothing":
        return [f"layout: {said[1] if said else 'was not looked at'}"]
    return []


def steps_of(browser, html, reader):
    """What the reader's script has checked."""
    done = re.search(r'data-reader="([^"]*)"', page_in_browser(browser, with_reader(html, reader)))
    return done[1].split("|") if done else ["FAILED: the reader's script did not run"]


def mistakes_of(dom, charts):
    root = re.search(r"<html[^>]*>", dom)
    if not root:
        return ["the browser gave no page"]
    mistakes = []
    if 'data-ready="true"' not in root[0]:
        mistakes.append("the page never became ready: " + root[0])
    if "data-errors" in root[0]:
        mistakes.append("script errors: " + root[0])
    for chart in charts:
        place = dom.find(f'id="{chart}"')
        drawing = dom[place:dom.find("</figure>", place)]
        if place < 0 or "<svg" not in drawing or drawing.count("<path") + drawing.count("<polyline") < 4:
            mistakes.append(f"{chart} was not drawn")
    return mistakes


def main():
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if not browser:
        print("skipped: no Chromium on the path; install it to test the report's scripts")
        return SKIPPED
    failed = False
    with open(sys.argv[2], encoding="utf-8") as file:
        axe = file.read()
    with tempfile.TemporaryDirectory() as directory:
        for kind, charts in CHARTS.items():
            study = os.path.join(directory, kind or "finished")
            write_study(kind, study, directory)
            html = os.path.join(study, "report.html")
            mistakes = mistakes_of(page_in_browser(browser, html), charts)
            mistakes += findings_of(browser, html, axe) + badly_laid_out(browser, html)
            if kind == "cycle" and not 0 < pages_on_paper(browser, html) <= MOST_PAGES:
                mistakes.append(f"on paper it has {pages_on_paper(browser, html)} pages, at most {MOST_PAGES} are right")
            print(kind or "finished", "ok" if not mistakes else mistakes)
            failed = failed or bool(mistakes)
            if kind not in ("", "many"):
                continue
            reader = READER_OF_MANY
            if not kind:
                with open(os.path.join(study, "ranking.csv"), encoding="utf-8", newline="") as file:
                    p_best = next(row["p_best"] for row in csv.DictReader(file) if row["design"] == "high flare")
                reader = READER.replace("P_VALUE", p_best)
            steps = steps_of(browser, html, reader)
            print("\n".join(steps))
            failed = failed or any(not step.startswith("ok") for step in steps)
        study = os.path.join(directory, "search")
        write_study("search", study, directory)
        steps = steps_of(browser, os.path.join(study, "report.html"), READER_OF_SEARCH)
        print("\n".join(steps))
        failed = failed or any(not step.startswith("ok") for step in steps)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
