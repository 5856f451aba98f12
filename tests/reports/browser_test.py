"""Opens sample reports in headless Chromium: no script error, every chart drawn, the page's interactions work.

    browser_test.py WRITE_SAMPLE_REPORT
"""

import base64
import csv
import hashlib
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
CHARTS = {"": FULL, "unfinished": FULL,
          "formula": {"chart-loads", "chart-parallel", "chart-angles", "chart-effects", "chart-response"}}

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
  const card = document.querySelectorAll("details.card")[5];
  location.hash = card.id;
  await until(() => card.open);
  check("a link opens its card", card.open);
  const zoom = document.querySelector("button.zoom");
  zoom?.click();
  check("a picture enlarges", !zoom || $("lightbox").open);
})().catch((error) => done.push(`FAILED ${error}`)).finally(() => { document.documentElement.dataset.reader = done.join("|"); });
"""


def page_in_browser(browser, html):
    with tempfile.TemporaryDirectory() as profile:
        command = [browser, *FLAGS, "--user-data-dir=" + profile, "file://" + html + "#charts=all"]
        result = subprocess.run(command, capture_output=True, text=True, timeout=100)
    return result.stdout


def with_reader(html, script):
    """The page with one more script in it, which its policy knows by the digest."""
    text = open(html, encoding="utf-8").read()
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    text = text.replace("script-src '", f"script-src 'sha256-{digest}' '", 1)
    path = html.replace(".html", "_reader.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace("</body>", f"<script>{script}</script></body>"))
    return path


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
    with tempfile.TemporaryDirectory() as directory:
        for kind, charts in CHARTS.items():
            study = os.path.join(directory, kind or "finished")
            subprocess.run([sys.argv[1], study, kind], check=True)
            html = os.path.join(study, "report.html")
            mistakes = mistakes_of(page_in_browser(browser, html), charts)
            print(kind or "finished", "ok" if not mistakes else mistakes)
            failed = failed or bool(mistakes)
            if kind:
                continue
            with open(os.path.join(study, "ranking.csv"), encoding="utf-8", newline="") as file:
                p_best = next(row["p_best"] for row in csv.DictReader(file) if row["design"] == "high flare")
            dom = page_in_browser(browser, with_reader(html, READER.replace("P_VALUE", p_best)))
            done = re.search(r'data-reader="([^"]*)"', dom)
            steps = done[1].split("|") if done else ["FAILED: the reader's script did not run"]
            print("\n".join(steps))
            failed = failed or any(not step.startswith("ok") for step in steps)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
