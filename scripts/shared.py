"""Shared by the Python scripts of this folder: command line, messages and the programs of the build."""
import csv
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from types import SimpleNamespace

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
BUILD = os.path.join(ROOT, os.environ.get("BUILD_DIR", "build"))
NAME = os.path.basename(sys.argv[0])
os.environ.update(LC_ALL="C", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def say(text):
    print(f"{NAME}: {text}", file=sys.stderr, flush=True)


def fail(code, text):
    say(text)
    sys.exit(code)


def usage(problem):
    fail(64, f"{problem}; see `scripts/{NAME} --help`")


def parse(help_text, **defaults):
    """Options and their values, other words, and the words after `--`. An option is a flag if its default is False, and may be repeated
    if it is a list."""
    options, others, words = defaults, [], iter(sys.argv[1:])
    for word in words:
        name = word[2:].replace("-", "_")
        if word in ("--help", "-h"):
            signal.signal(signal.SIGPIPE, signal.SIG_DFL)   # no message if `head` has closed the pipe
            print(help_text)
            sys.exit(0)
        elif word == "--":
            break
        elif word.startswith("--") and isinstance(options.get(name), bool):
            options[name] = True
        elif word.startswith("--") and name in options:
            value = next(words, None)
            if value is None:
                usage(f"{word} needs a value")
            options[name] = options[name] + [value] if isinstance(options[name], list) else value
        elif word.startswith("-"):
            usage(f"unknown option '{word}'")
        else:
            others.append(word)
    return SimpleNamespace(**options), others, list(words)


def use_build(*programs, first=True, code=1):
    """Adds the programs of the build to the PATH, before or after the others; fails with this exit code if one does not exist."""
    paths = [os.path.join(BUILD, "bin"), os.environ["PATH"]]
    os.environ["PATH"] = ":".join(paths if first else reversed(paths))
    for program in programs:
        if not shutil.which(program):
            fail(code, f"{program} is not built; run make build")


def run(*command, ok=(0,), **options):
    """Runs a program; ends this script with the exit code of the program if it fails."""
    done = subprocess.run(command, **options)
    if done.returncode not in ok:
        sys.exit(exit_code(done))
    return done


def run_renamed(*command):
    """As run, but prints the messages of the program under the name of this script."""
    done = subprocess.run(command, stderr=subprocess.PIPE)
    sys.stderr.buffer.write(re.sub(rb"(?m)^%s: " % command[0].encode(), f"{NAME}: ".encode(), done.stderr))
    sys.stderr.flush()
    if done.returncode != 0:
        sys.exit(exit_code(done))


def run_in_scratch(main):
    """Ends with the exit code of main(scratch folder); removes the folder also after Ctrl-C and kill."""
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    try:
        with tempfile.TemporaryDirectory() as scratch:
            sys.exit(main(scratch))
    except KeyboardInterrupt:
        sys.exit(130)
    except OSError as error:
        fail(73, f"{error.filename or 'output'}: {error.strerror}")


def exit_code(done):
    """As in a shell: 128 + N if signal N has killed the program."""
    return done.returncode if done.returncode >= 0 else 128 - done.returncode


def children_cpu():
    """User and system seconds of the ended child processes."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def curve(result, *at):
    """Columns of a curve by name, at all steps or, with `--at ...`, at the given values."""
    rows = list(csv.DictReader(run("postprocess", result, "--quiet", *at, stdout=subprocess.PIPE, text=True).stdout.splitlines()))
    return {name: [float(row[name] or 0) for row in rows] for name in rows[0]}
