"""compiled_before.py copies an object that the compiler would make again, and no other."""

import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

RULE = """rule cxx
  command = {launcher}{compiler} {flags} -I{source} -MD -MF $out.d -o $out -c $in
  depfile = $out.d
  deps = gcc
build a.o: cxx {source}/a.cpp
"""
LAUNCHER = Path(__file__).resolve().parent / "compiled_before.py"


class CompiledBefore(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name).resolve()
        # Writes down that it runs.
        self.compiler = self.folder / "compiler"
        self.compiler.write_text(f'#!/bin/sh\necho >>{self.folder}/runs\nexec c++ "$@"\n')
        self.compiler.chmod(0o700)
        self.old, self.new = self.folder / "old", self.folder / "elsewhere/new"
        self.old.mkdir()
        (self.old / "a.cpp").write_text('#include "a.h"\n#include <cstddef>\nint a() { return number; }\n')
        (self.old / "a.h").write_text("const int number = 1;\n")
        (self.old / "unused.h").write_text("const int number = 1;\n")
        self.build(self.old, self.old / "build")
        shutil.copytree(self.old, self.new, ignore=shutil.ignore_patterns("build"))

    def runs(self):
        file = self.folder / "runs"
        return len(file.read_text()) if file.exists() else 0

    def build(self, source, place, launcher="", flags="-O1"):
        place.mkdir(exist_ok=True)
        (place / "CMakeCache.txt").write_text(f"#\nCMAKE_HOME_DIRECTORY:INTERNAL={source}\n#\n")
        rule = RULE.format(launcher=launcher, compiler=self.compiler, flags=flags, source=source)
        (place / "build.ninja").write_text(rule)
        subprocess.run(["ninja"], cwd=place, check=True, capture_output=True)

    def compiles(self, **options):
        """Whether a build elsewhere, which is then complete, has run the compiler."""
        runs = self.runs()
        place = self.new / "build/deep"
        place.parent.mkdir(exist_ok=True)
        shutil.rmtree(place, ignore_errors=True)
        self.build(self.new, place, f"{sys.executable} {LAUNCHER} {self.old}/build ", **options)
        done = subprocess.run(["ninja"], cwd=place, check=True, capture_output=True, text=True)
        self.assertIn("no work to do", done.stdout)
        if "flags" not in options:
            self.returns(place / "a.o", (self.new / "a.h").read_text().split()[-1].strip(";"))
        return self.runs() > runs

    def returns(self, file, number):
        main = self.folder / "main.cpp"
        main.write_text(f"int a();\nint main() {{ return a() != {number}; }}\n")
        subprocess.run(["c++", main, file, "-o", self.folder / "main"], check=True)
        subprocess.run([self.folder / "main"], check=True)

    def test_the_same_is_copied(self):
        self.assertEqual(self.runs(), 1)
        self.assertFalse(self.compiles())
        (self.new / "unused.h").unlink()
        self.assertFalse(self.compiles())

    def test_after_the_copy_ninja_knows_the_headers(self):
        self.assertFalse(self.compiles())
        (self.new / "a.h").write_text("const int number = 2;\n")
        subprocess.run(["ninja"], cwd=self.new / "build/deep", check=True, capture_output=True)
        self.returns(self.new / "build/deep/a.o", 2)

    def test_another_header_source_or_option_is_compiled(self):
        (self.new / "a.h").write_text("const int number = 2;\n")
        self.assertTrue(self.compiles())
        shutil.copy(self.old / "a.h", self.new / "a.h")
        self.assertFalse(self.compiles())
        with (self.new / "a.cpp").open("a") as file:
            file.write("\n")
        self.assertTrue(self.compiles())
        shutil.copy(self.old / "a.cpp", self.new / "a.cpp")
        self.assertTrue(self.compiles(flags="-O0"))

    def test_a_missing_header_fails(self):
        (self.new / "a.h").unlink()
        with self.assertRaises(subprocess.CalledProcessError):
            self.compiles()

    def test_an_object_older_than_its_header_is_not_taken(self):
        time.sleep(0.01)
        for tree in [self.old, self.new]:
            (tree / "a.h").write_text("const int number = 2;\n")
        self.assertTrue(self.compiles())

    def test_without_an_earlier_build_the_compiler_runs(self):
        shutil.rmtree(self.old / "build")
        self.assertTrue(self.compiles())


if __name__ == "__main__":
    unittest.main()
