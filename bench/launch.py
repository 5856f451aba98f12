"""What the comparing benchmarks share: running bench/kernel under mpirun, and clear errors."""
import json
import os
import pathlib
import subprocess
import sys

KERNEL = pathlib.Path(__file__).resolve().with_name("kernel")
# One thread a rank, for every program alike.
ENVIRONMENT = {**os.environ, "OMP_NUM_THREADS": "1"}


class Failed(Exception):
    pass


def tail(text, lines=15):
    return "\n".join(text.strip().splitlines()[-lines:])


def mpirun(ranks, *command, cwd=None, log=None):
    """Standard output of `command` on `ranks` ranks; `log` is a file to quote if it fails."""
    words = ["mpirun", "-n", str(ranks), *map(str, command)]
    try:
        result = subprocess.run(words, cwd=cwd, env=ENVIRONMENT, text=True, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    except FileNotFoundError:
        raise Failed("mpirun is not installed (Debian: openmpi-bin)") from None
    if result.returncode:
        said = [tail(text) for text in (result.stdout, result.stderr) if text.strip()]
        if log and log.exists():
            said.append(f"end of its log:\n{tail(log.read_text(errors='replace'))}")
        raise Failed(f"`{' '.join(words)}` failed with code {result.returncode}\n" + "\n".join(said))
    return result.stdout


def kernel(ranks, *options):
    """One run of bench/kernel: its JSON object without the machine."""
    if not KERNEL.exists():
        raise Failed(f"{KERNEL} is missing: build the target bench_kernel")
    run = json.loads(mpirun(ranks, KERNEL, "--json", *options).splitlines()[-1])
    run.pop("machine")
    return run


def machine():
    # Not under mpirun, which would pin the program to one core.
    return json.loads(subprocess.run([KERNEL, "--machine"], check=True, text=True, stdout=subprocess.PIPE).stdout)


def usable_cores():
    return len(os.sched_getaffinity(0))


def positive(text):
    """Type of an option for argparse, as the next one."""
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def rank_counts(text):
    return sorted({positive(word) for word in text.split(",")})


def announce(text):
    """Progress, on stderr: standard output is the result alone."""
    print(text, file=sys.stderr, flush=True)


def run_main(main):
    try:
        main()
    except Failed as error:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
