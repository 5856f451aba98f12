#!/usr/bin/env python3
"""reports/paraview/icebow_view.py in Debian's ParaView, without a window: a picture with ice, damage and pressure.

    paraview_test.py PROGRAM        ends with 77 (skipped) where pvpython or xvfb-run is missing
"""
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
HERE = pathlib.Path(__file__).resolve().parent
SCRIPT = HERE.parents[1] / "reports/paraview/icebow_view.py"


def pixels(path):
    """Of an 8-bit RGB or RGBA PNG: rows of (r, g, b)."""
    data, at, packed, width, height, channels = path.read_bytes(), 8, b"", 0, 0, 3
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
            channels = 4 if colour == 6 else 3
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride, before = zlib.decompress(packed), width * channels, bytes(width * channels)
    for y in range(height):
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        filtered = raw[y * (stride + 1)]
        for i in range(stride):
            a, b, c = line[i - channels] if i >= channels else 0, before[i], before[i - channels] if i >= channels else 0
            paeth = min((a, b, c), key=lambda v: (abs(a + b - c - v), (a, b, c).index(v)))
            line[i] = (line[i] + (0, a, b, (a + b) // 2, paeth)[filtered]) & 255
        before = bytes(line)
        yield [tuple(line[i:i + 3]) for i in range(0, stride, channels)]


# What the window does with a macro: its own name for the module, no words, the run that is open.
AS_A_MACRO = """
import sys
from paraview import simple as pv
pv.OpenDataFile(sys.argv[1])
script = sys.argv[2]
sys.argv = [""]
exec(compile(open(script).read(), script, "exec"), {"__name__": "__vtkconsole__"})
print("layout", pv.GetLayoutByName("Icebow") is not None)
"""


def without_a_window(*words):
    return subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1600x900x24 -noreset", "pvpython", *map(str, words)],
                          capture_output=True, text=True, timeout=150)


def main():
    missing = [name for name in ("pvpython", "xvfb-run") if not shutil.which(name)]
    if missing:
        print(f"skipped: no {' and no '.join(missing)} (Debian: paraview, python3-paraview, xvfb)")
        return 77
    faults = []
    with tempfile.TemporaryDirectory(prefix="icebow_paraview_") as folder:
        for output in ("vtp", "vtkhdf"):
            run = pathlib.Path(folder) / output
            subprocess.run([PROGRAM, "simulate", str(HERE / "tiny.json"), "--out", str(run), "--set", "/output/snapshots=2",
                            "--set", f"/output/format={output}"], check=True, capture_output=True)
            picture = run / "paraview.png"
            said = without_a_window(SCRIPT, run, "--picture", picture)
            if said.returncode or "rror" in said.stderr or not picture.exists():
                faults.append(f"{output}: {said.returncode}\n{said.stdout}{said.stderr}")
                continue
            rows = list(pixels(picture))
            half = len(rows[0]) // 2
            left, right = ([p for row in rows for p in row[part]] for part in (slice(0, half), slice(half, None)))
            for what, where, holds in (
                    ("whole ice, near white", left, lambda r, g, b: min(r, g, b) > 215),
                    ("open water, dark blue", left, lambda r, g, b: b > r + 40 and r < 60),
                    ("damaged ice, orange or brown", left, lambda r, g, b: r > g + 50 and g > b + 20),
                    ("hull, grey", right, lambda r, g, b: abs(r - b) < 25 and 60 < g < 200),
                    ("pressed hull, yellow to red", right, lambda r, g, b: r > b + 60)):
                count = sum(holds(*pixel) for pixel in where)
                if count < 60:  # a spot of 8 by 8 pixels
                    faults.append(f"{output}: {count} pixels of {what}")
        macro = pathlib.Path(folder) / "as_a_macro.py"
        macro.write_text(AS_A_MACRO)
        said = without_a_window(macro, pathlib.Path(folder) / "vtp/ice.pvd", SCRIPT)
        if "layout True" not in said.stdout:
            faults.append(f"as a macro: {said.returncode}\n{said.stdout}{said.stderr}")
    print("\n".join(faults) or "two pictures with ice, water, damage, hull and pressure; the macro makes its layout")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
