"""What `pip install .` installs, offline: pip_install.py SOURCE BUILD.

Makes the source archive and from it the wheel, installs this in an environment of its own, and runs
what docs/python.md shows. Then the same for `cmake --install BUILD --component python`.
"""

import os
import re
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

SHOW = "import pointline; print(pointline.__file__); pointline.problem('5*P/P').solver()"


def run(*command, **options):
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, **options
    )
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}: failed\n{done.stdout}{done.stderr}")
    return done.stdout


def first_block(page):
    """The first Python of a page."""
    return page.read_text().split("```python\n")[1].split("```")[0]


def archive_of(source, folder):
    """Packs what is in the working tree without writing there."""
    tree = folder / "tree"
    files = run("git", "-C", source, "ls-files", "-co", "--exclude-standard", "-z")
    for name in filter(None, files.split("\0")):
        # Certificates are no part of it, and large.
        if (source / name).is_file() and not name.endswith(".plc"):
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            (tree / name).write_bytes((source / name).read_bytes())
    place = str(folder / "dist")
    sdist = f"import setuptools.build_meta as backend; backend.build_sdist({place!r})"
    run(sys.executable, "-c", sdist, cwd=tree)
    (archive,) = (folder / "dist").glob("pointline-*.tar.gz")
    return archive


def main():
    source, build = Path(sys.argv[1]), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        environment = dict(os.environ, XDG_CACHE_HOME=str(folder / "cache"))
        environment.pop("PYTHONPATH", None)
        # What the archive has like BUILD is not compiled again.
        if (build / "build.ninja").exists():
            launcher = [sys.executable, Path(__file__).with_name("compiled_before.py"), build]
            environment["CMAKE_CXX_COMPILER_LAUNCHER"] = ";".join(map(str, launcher))
            environment["CMAKE_GENERATOR"] = "Ninja"
        archive = archive_of(source, folder)
        with tarfile.open(archive) as packed:
            names = packed.getnames()
        assert not [name for name in names if name.endswith(".plc")]
        project = (source / "CMakeLists.txt").read_text()
        version = re.search(r"project\(\S+ VERSION ([0-9.]+)", project)[1]
        assert archive.name == f"pointline-{version}.tar.gz"

        python = folder / "venv/bin/python"
        run(sys.executable, "-m", "venv", "--system-site-packages", folder / "venv")
        offline = ["--no-index", "--no-build-isolation", "--no-deps", "--no-cache-dir"]
        run(python, "-m", "pip", "wheel", *offline, "-w", folder / "dist", archive, env=environment)
        (wheel,) = (folder / "dist").glob("pointline-*.whl")
        files = {Path(name).name for name in zipfile.ZipFile(wheel).namelist()}
        assert {"py.typed", "__init__.py", "__init__.pyi", "_pointline.pyi"} <= files, files
        assert sum(name.startswith("libpointline.so.") for name in files) == 1, files

        run(python, "-m", "pip", "install", *offline, wheel, env=environment)
        place = run(python, "-c", SHOW, env=environment, cwd=folder)
        assert place.startswith(str(folder / "venv")), place
        page = first_block(source / "docs/python.md")
        shown = run(python, "-c", page, env=environment, cwd=folder)
        assert "off by less than 0.5 degrees: True" in shown, shown

        prefix = folder / "prefix"
        run("cmake", "--install", build, "--component", "python", "--prefix", prefix)
        (package,) = prefix.glob("lib/python3*/*-packages")
        environment["PYTHONPATH"] = str(package)
        place = run(sys.executable, "-c", SHOW, env=environment, cwd=folder)
        assert place.startswith(str(prefix)), place


if __name__ == "__main__":
    main()
