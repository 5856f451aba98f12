"""Opens sample reports in headless Chromium: no script error, every chart drawn. browser_test.py WRITE_SAMPLE_REPORT"""

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
CHARTS = {"": {"chart-loads", "chart-scatter", "chart-angles", "chart-history"},
          "unfinished": {"chart-loads", "chart-scatter", "chart-angles", "chart-history"},
          "formula": set()}


def page_in_browser(browser, html):
    with tempfile.TemporaryDirectory() as profile:
        command = [browser, *FLAGS, "--user-data-dir=" + profile, "file://" + html]
        result = subprocess.run(command, capture_output=True, text=True, timeout=100)
    return result.stdout


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
        if place < 0 or "<svg" not in drawing or drawing.count("<path") < 5:
            mistakes.append(f"{chart} was not drawn")
    if dom.count('data-drawn="true"') != (len(charts) + 3 if charts else 0):  # four panels of angles
        mistakes.append(f"{dom.count('data-drawn=')} charts drawn")
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
            mistakes = mistakes_of(page_in_browser(browser, os.path.join(study, "report.html")), charts)
            print(kind or "finished", "ok" if not mistakes else mistakes)
            failed = failed or bool(mistakes)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
