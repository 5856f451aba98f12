"""What `cmake --install` puts down works from there: install_test.py CMAKE BUILD_DIRECTORY"""
import os
import pathlib
import subprocess
import sys
import tempfile

CMAKE, BUILD = sys.argv[1:]


def run(*words, **options):
    result = subprocess.run([*map(str, words)], text=True, capture_output=True, timeout=200, **options)
    assert result.returncode == 0, f"{words}\n{result.stdout}\n{result.stderr}"
    return result.stdout


def main():
    with tempfile.TemporaryDirectory(prefix="icebow_install_") as folder:
        prefix, work = pathlib.Path(folder, "prefix"), pathlib.Path(folder, "work")
        work.mkdir()
        run(CMAKE, "--install", BUILD, "--prefix", prefix)
        for file in ("share/man/man1/icebow.1", "share/bash-completion/completions/icebow",
                     "share/zsh/site-functions/_icebow", "share/zsh/vendor-completions/_icebow",
                     "share/fish/vendor_completions.d/icebow.fish",
                     "share/icebow/studies/quickstart.json", "share/doc/icebow/README.md"):
            assert (prefix / file).stat().st_size > 100, file
        program, studies = prefix / "bin/icebow", prefix / "share/icebow/studies"
        # A Latin hypercube is drawn by a part that is loaded from the installed folder.
        assert "designs: 201" in run(program, "check", studies / "quickstart.json", cwd=work)
        run(program, "new", "mine.json", "--samples", "3", cwd=work, stdin=subprocess.DEVNULL)
        run(program, "run", "mine.json", "--out", "out", cwd=work)
        assert (work / "out/report.html").stat().st_size > 100_000
        # A program of somebody else's on the installed libraries.
        example = prefix / "share/icebow/examples/link_icebow"
        run(CMAKE, "-S", example, "-B", work / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
        run(CMAKE, "--build", work / "build")
        assert "mean load of the model" in run(work / "build/bow_in_ice", cwd=work)


if __name__ == "__main__":
    os.environ["XDG_CACHE_HOME"] = tempfile.mkdtemp(prefix="icebow_cache_")
    main()
