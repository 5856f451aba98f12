"""docs/your_ship.md, typed word for word: tutorial_test.py ICEBOW

Behind "$" stands a command, below it what it prints, "..." for any lines. Words are compared letter by letter, numbers
within 3 %: the last digits are the processor's. The documents' links lead to files.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


def blocks(text, kind):
    return re.findall(rf"^```{kind}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def commands(text):
    """(command, lines it prints) in order."""
    for block in blocks(text, ""):
        for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            first, *rest = part.splitlines()
            yield first, [line for line in rest if line.strip()]


def same(said, wanted):
    said, wanted = said.split(), wanted.split()
    return len(said) == len(wanted) and all(map(same_word, said, wanted))


def same_word(said, wanted):
    try:
        return abs(float(said) - float(wanted)) <= 0.03 * abs(float(wanted))
    except ValueError:
        return said == wanted


def mismatch(printed, wanted):
    """The first wanted line that is not there, in order; "..." stands for any lines."""
    at, anywhere = 0, False
    for line in wanted:
        if line.strip() == "...":
            anywhere = True
            continue
        last = len(printed) if anywhere else min(at + 1, len(printed))
        found = next((k for k in range(at, last) if same(printed[k], line)), None)
        if found is None:
            return line
        at, anywhere = found + 1, False
    return None if anywhere or at == len(printed) else "(nothing more)"


def broken_links():
    for file in [*DOCS.glob("*.md"), DOCS.parent / "README.md"]:
        for link in re.findall(r"\]\(([^)#]+)", file.read_text(encoding="utf-8")):
            if "://" not in link and not (file.parent / link).exists():
                yield f"{file.name}: no {link}"


def main():
    text = (DOCS / "your_ship.md").read_text(encoding="utf-8")
    faults = list(broken_links())
    indexed = (DOCS / "index.md").read_text(encoding="utf-8")
    faults += [f"docs/index.md does not list {f.name}" for f in DOCS.glob("*.md") if f"({f.name})" not in indexed and f.name != "index.md"]
    environment = {**os.environ, "PATH": f"{pathlib.Path(sys.argv[1]).resolve().parent}:{os.environ['PATH']}", "NO_COLOR": "1"}
    with tempfile.TemporaryDirectory(prefix="icebow_tutorial_") as folder:
        environment["XDG_CACHE_HOME"] = folder
        number = 0
        for number, (command, wanted) in enumerate(commands(text), 1):
            result = subprocess.run(command, shell=True, cwd=folder, env=environment, text=True, capture_output=True)
            printed = [line for line in (result.stdout + result.stderr).splitlines() if line.strip()]
            missing = mismatch(printed, wanted)
            if result.returncode or missing:
                faults.append(f"$ {command}\nexit code {result.returncode}, missing: {missing}\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
        if number < 9:
            faults.append(f"{number} commands were found")
        python = blocks(text, "python")
        try:
            import pandas  # noqa: F401
        except ImportError:
            print("pandas is not installed (Debian: python3-pandas): its lines were not run")
            python = []
        for program in python:
            result = subprocess.run([sys.executable, "-c", program], cwd=folder, text=True, capture_output=True)
            if result.returncode or "d005" not in result.stdout or "mean_load_N" not in result.stdout:
                faults.append(f"{program}\n{result.stdout}{result.stderr}")
    print("\n".join(faults) or f"{number} commands and {len(python)} program as written")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
