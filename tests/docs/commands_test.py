"""Every command of README.md, CONTRIBUTING.md and docs, tried: commands_test.py ICEBOW BUILD [--list]

Commands are the lines of blocks without a language, and code within a line that begins with a program's name. Words in
capitals (STUDY, DIR ...) stand for files that are made here. A command of icebow is run and must end with 0; of run,
simulate and calibrate, which take minutes, the study is checked instead, and each option must stand in the command's
help. Scripts, presets, tests and benchmarks that are named must exist, and know the options that they are given.
docs/your_ship.md is tutorial_test.py's.
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PATIENCE = float(os.environ.get("ICEBOW_TEST_PATIENCE", 1))  # more under sanitizers
LONG = {"run", "simulate", "calibrate"}
SYSTEM = {"apt-get", "cd", "cpack", "cut", "head", "stat"}  # not ours
PLACEHOLDERS = {"STUDY": "studies/quickstart.json", "FILE": "studies/quickstart.json", "HULL": "ship.stl",
                "HULL.stl": "ship.stl", "F.obj": "f.obj", "R": "out", "R1": "out", "R2": "out", "DIR": "out",
                "OTHER": "out", "DESIGN": "d005", "M": "7", "DEG": "0", "S": "1", "N": "3", "LAYERS": "3", "COMMAND": "run",
                "RUN": "pictures", "study.json": "studies/quickstart.json"}
INSIDE_A_WORD = {"FAMILY": "concave", "=N": "=3", "/usr/share/icebow/": ""}


def spans(text):
    """Code within lines, and the lines of blocks without a language."""
    blocks = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    for language, block in blocks.findall(text):
        lines = block.splitlines() if not language else []
        prompted = [line[2:] for line in lines if re.match(r"[$#] \S", line)]
        for line in prompted or lines:
            first, *rest = re.split(r"\s{2,}", line.strip())
            if first and not first.startswith("#"):
                yield first, True
            yield from ((part, False) for part in rest if part.startswith("icebow "))
    for span in re.findall(r"`([^`]+)`", blocks.sub("", text)):
        yield " ".join(span.split()), False


def parts(line):
    """Of a chain the commands, without those behind a pipe."""
    for command in re.split(r"\s+&&\s+", line):
        command = re.split(r"\s\|\s", command)[0]
        words = shlex.split(re.sub(r"\[(-[^]]*)\]", r"\1", command))
        yield [word.split("|")[0] for word in words] if words[:1] == ["scripts/campaign"] else words


def filled(word):
    for name, value in INSIDE_A_WORD.items():
        word = word.replace(name, value)
    return PLACEHOLDERS.get(word, word)


class Tried:
    def __init__(self, icebow, build, folder):
        self.icebow, self.build, self.folder = icebow, build, folder
        self.presets = json.loads((ROOT / "CMakePresets.json").read_text())

    def call(self, *words):
        environment = {**os.environ, "NO_COLOR": "1", "XDG_CACHE_HOME": str(self.folder / "cache")}
        return subprocess.run([self.icebow, *words], cwd=self.folder, text=True, capture_output=True,
                              timeout=100 * PATIENCE, env=environment)

    def made(self, *words):
        result = self.call(*words)
        if result.returncode:
            raise SystemExit(f"icebow {' '.join(words)}\n{result.stdout}{result.stderr}")

    def prepare(self):
        """Files that the commands are about."""
        shutil.copytree(ROOT / "studies", self.folder / "studies")
        self.made("new", "my_ship.json", "--length", "110", "--beam", "22", "--draft", "7.5", "--thickness", "0.8",
                  "--speed", "3", "--samples", "12")
        self.made("run", "my_ship.json", "--out", "out")
        shutil.copytree(self.folder / "out", self.folder / "out/sweep")
        self.made("hull", "my_ship.json", "--out", "ship.stl")
        self.made("simulate", str(ROOT / "tests/cli/tiny.json"), "--out", "pictures", "--set", "/output/pictures=2")

    def fault(self, words):
        """What is wrong with the command, or None."""
        words = [word for word in words if word != "..."]
        while words and (words[0] == "sudo" or re.fullmatch(r"[A-Z_]+=\S*", words[0])):
            words = words[1:]
        if words[:1] == ["xvfb-run"]:
            words = words[words.index("pvpython"):]
        if words[:1] == ["mpirun"]:
            words = words[words.index("icebow"):] if "icebow" in words else ["mpirun"]
        program, arguments = words[0], words[1:]
        if program == "icebow":
            return self.fault_of_icebow([filled(word) for word in arguments])
        if program in ("ctest", "cmake"):
            return self.fault_of_tests(program, arguments)
        if program == "pvpython":
            return None if (ROOT / arguments[0]).exists() else f"no {arguments[0]}"
        if program == "mpirun" or program in SYSTEM:
            return None
        return self.fault_of_own(program, arguments)

    def fault_of_icebow(self, words):
        if not words or words == ["evaluate-design"]:  # which no reader types
            return None
        command = words[0]
        described = self.call("help", *([] if command.startswith("-") or command == "help" else [command]))
        if described.returncode:
            return described.stderr
        known = described.stdout + "--help --man --completion --version"
        unknown = [word for word in words if word.startswith("--") and word.split("=")[0] not in known]
        if unknown:
            return f"`icebow help {command}` does not know {unknown[0]}"
        if len(words) == 1 and not command.startswith("-"):
            return None  # named only
        if command == "picture":
            words = ["pictures" if word == "out" else word for word in words]
        if command == "new":
            (self.folder / words[1]).unlink(missing_ok=True)
        if command in LONG:
            sets = [word for n, word in enumerate(words) if word == "--set" or n and words[n - 1] == "--set"]
            words = ["check", words[1] if len(words) > 1 and not words[1].startswith("-") else "my_ship.json", *sets]
        elif len(words) > 1 and words[1].startswith("-") and command in ("hull", "cycle", "resistance"):
            words.insert(1, "my_ship.json")
        elif len(words) > 1 and words[1].startswith("-") and command in ("rank", "show", "export", "status", "report"):
            words[1:1] = ["out", "d005"] if command == "show" else ["out"]
        result = self.call(*words)
        return f"icebow {shlex.join(words)} ends with {result.returncode}\n{result.stderr[-600:]}" if result.returncode else None

    def fault_of_tests(self, program, arguments):
        if "--preset" in arguments:
            name = arguments[arguments.index("--preset") + 1]
            kind = "testPresets" if program == "ctest" else "configurePresets"
            if name not in [preset["name"] for preset in self.presets[kind]]:
                return f"CMakePresets.json has no {name}"
            return None
        if program == "cmake":
            return None if arguments[0] == "--install" else "what does it do?"
        chosen = [word for word in arguments if word not in ("-j", "2")]
        said = subprocess.run(["ctest", "-N", *chosen], cwd=self.build, text=True, capture_output=True).stdout
        return None if re.search(r"Total Tests: [1-9]", said) else f"no such test\n{said[-300:]}"

    def fault_of_own(self, program, arguments):
        """A script, a benchmark or a test's program."""
        path = re.sub(r"^build/release/(bench/)?", r"\1", program)
        if path.startswith("test_"):
            if not (self.build / path).exists():
                return f"{self.build} has no {path}"
            names = [word for word in arguments if not word.startswith("-")]
            listed = subprocess.run([self.build / path, "--list-tests", *names], text=True, capture_output=True).stdout
            return None if re.search(r"^[1-9]\d* (matching )?test case", listed, re.MULTILINE) else f"no such test case\n{listed}"
        sources = [ROOT / (path + ending) for ending in ("", ".cpp", ".py") if (ROOT / (path + ending)).is_file()]
        if not sources:
            return f"no {path}"
        text = "".join(source.read_text(encoding="utf-8") for source in sources)
        unknown = [word for word in arguments if word.startswith("--") and word.split("=")[0] not in text]
        return f"{path} does not know {unknown[0]}" if unknown else None


def ours(span):
    return re.match(r"(icebow|mpirun|ctest|cmake|pvpython|xvfb-run) |(icebow|mpirun)$|(scripts|bench|build/release)/\w", span)


def commands():
    for file in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]:
        if file.name == "your_ship.md":
            continue
        for span, of_a_block in spans(file.read_text(encoding="utf-8")):
            if of_a_block or ours(span):
                yield from ((file.name, words) for words in parts(span))


def main():
    icebow, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    found = list(dict.fromkeys((name, tuple(words)) for name, words in commands() if words))
    if "--list" in sys.argv:
        print("\n".join(f"{name}: {shlex.join(words)}" for name, words in found))
        return 0
    with tempfile.TemporaryDirectory(prefix="icebow_commands_") as folder:
        tried = Tried(icebow, build, pathlib.Path(folder))
        tried.prepare()
        faults = [f"{name}: {shlex.join(words)}\n  {fault}" for name, words in found if (fault := tried.fault(list(words)))]
    if len(found) < 80:
        faults.append(f"{len(found)} commands were found")
    print("\n".join(faults) or f"{len(found)} commands")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
