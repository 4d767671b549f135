"""Stands before a compiler that compiles the same sources again: compiled_before.py BUILD COMPILER WORD...

If Ninja has made the object in the folder BUILD by the same command from the same bytes, this copies it.
Else it runs the compiler. Where sources and builds lie may differ.
"""

import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path


class Build:
    """A folder in which Ninja builds, and the sources that CMake has found for it."""

    def __init__(self, folder):
        self.folder = folder.resolve()
        cache = (folder / "CMakeCache.txt").read_text()
        self.source = cache.split("\nCMAKE_HOME_DIRECTORY:INTERNAL=")[1].split("\n")[0]

    def moved(self, text, other):
        """A text with the paths of another build instead of those of this one."""
        return text.replace(str(self.folder), str(other.folder)).replace(self.source, other.source)

    def ask(self, *question):
        command = ["ninja", "-t", *question]
        options = {"cwd": self.folder, "capture_output": True, "text": True, "check": True}
        return subprocess.run(command, **options).stdout

    def command(self, output):
        """How it makes an object."""
        for rule in json.loads(self.ask("compdb")):
            if rule["output"] == output:
                return shlex.split(rule["command"])
        return []

    def read_for(self, output):
        """The files that the compiler has read for an object; none if nobody knows."""
        first, *files = self.ask("deps", output).split("\n    ")
        return [Path(file.strip()) for file in files] if "(VALID)" in first else []


def object_of(old, new, command):
    """What the command would make, in the old build, and from what it is made in the new one. Or None."""
    output = command[command.index("-o") + 1]
    words = [new.moved(word, old) for word in command]
    made = old.folder / output
    if old.command(output)[-len(words) :] != words:
        return None
    files = old.read_for(output)
    if not files:
        return None
    # Precompiled headers are no file that the compiler reports.
    files += [Path(word) for word in words if word.startswith("/") and Path(word).is_file()]
    here = []
    for file in files:
        file = old.folder / file
        if file.stat().st_mtime > made.stat().st_mtime:
            return None
        here.append(Path(old.moved(str(file), new)))
        if here[-1] != file and new.moved(here[-1].read_text(), old) != file.read_text():
            return None
    return made, here


def main():
    old, command = Path(sys.argv[1]), sys.argv[2:]
    try:
        found = object_of(Build(old), Build(Path.cwd()), command)
    except (OSError, ValueError, IndexError, subprocess.CalledProcessError):
        found = None
    if found is None:
        os.execvp(command[0], command)
    made, files = found
    output = command[command.index("-o") + 1]
    shutil.copyfile(made, output)
    if "-MF" in command:
        Path(command[command.index("-MF") + 1]).write_text(f"{output}: {' '.join(map(str, files))}\n")


if __name__ == "__main__":
    main()
