"""What a deposit consists of: the metadata agree, ARTIFACT.md says what happens, and
`./reproduce archive` packs the same bytes each time, and nothing else.

Usage: deposit.py SOURCES PLPROVE PLCHECK
"""

import csv
import hashlib
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import yaml

SOURCES = pathlib.Path(sys.argv[1])
PLPROVE, PLCHECK = sys.argv[2:4]


def text(name):
    return (SOURCES / name).read_text(encoding="utf-8")


def run(command, folder, **more):
    return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, **more)


def repository():
    """Whether the sources are in a repository: an unpacked archive is in none."""
    return run(["git", "rev-parse", "HEAD"], SOURCES).returncode == 0


class Metadata(unittest.TestCase):
    def setUp(self):
        self.citation = yaml.safe_load(text("CITATION.cff"))
        self.codemeta = json.loads(text("codemeta.json"))
        self.zenodo = json.loads(text(".zenodo.json"))
        self.package = json.loads(text("datapackage.json"))

    def test_all_agree(self):
        def each(citation, codemeta, zenodo, package):
            self.assertTrue(citation)
            self.assertEqual([codemeta, zenodo, package], [citation] * 3)

        c, m, z, p = self.citation, self.codemeta, self.zenodo, self.package
        each(c["title"], m["name"], z["title"], p["title"])
        each(c["abstract"], m["description"], z["description"], p["description"])
        each(c["version"], m["version"], z["version"], p["version"])
        each(c["keywords"], m["keywords"], z["keywords"], p["keywords"])
        each([a["name"] for a in c["authors"]], [a["name"] for a in m["author"]],
             [a["name"] for a in z["creators"]],
             [a["title"] for a in p["contributors"] if a["role"] == "author"])
        each(c["license"], m["license"].removeprefix("https://spdx.org/licenses/"), z["license"],
             p["licenses"][0]["name"])
        self.assertEqual(str(c["date-released"]), m["datePublished"])
        self.assertEqual(str(c["date-released"]), z["publication_date"])
        self.assertTrue(text("LICENSE").startswith(c["license"]))
        (paper,) = c["references"]
        self.assertEqual(m["referencePublication"]["name"], paper["title"])
        self.assertEqual(m["referencePublication"]["url"], paper["url"])
        self.assertEqual(p["sources"], [{"title": paper["title"], "path": paper["url"]}])
        self.assertEqual(z["related_identifiers"][0]["identifier"], paper["identifiers"][0]["value"])

    def test_version_is_that_of_the_project(self):
        (version,) = re.findall(r"^project\(.* VERSION (\S+) ", text("CMakeLists.txt"), re.M)
        self.assertEqual(self.citation["version"], version)

    def test_columns_are_those_of_the_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            catalogue = pathlib.Path(folder) / "catalogue.csv"
            self.assertEqual(run([PLPROVE, "export", "--csv", catalogue], folder).returncode, 0)
            paths = {"degrees": SOURCES / "certs/degrees.csv",
                     "groups": SOURCES / "certs/groups.csv",
                     "family-degrees": SOURCES / "certs/family-degrees.csv",
                     "family-groups": SOURCES / "certs/family-groups.csv",
                     "three-views-in-part": SOURCES / "certs/three-views-in-part.csv",
                     "catalogue": catalogue}
            self.assertEqual([r["name"] for r in self.package["resources"]], list(paths))
            for resource in self.package["resources"]:
                with self.subTest(resource["name"]):
                    self.assertTrue(paths[resource["name"]].match(resource["path"]))
                    self.table(resource, paths[resource["name"]])

    def table(self, resource, path):
        """Every value has the type of its column, and keeps to the constraints."""
        comment = resource["dialect"].get("commentChar")
        with path.open(encoding="utf-8", newline="") as file:
            rows = list(csv.reader(line for line in file
                                   if comment is None or not line.startswith(comment)))
        fields = resource["schema"]["fields"]
        self.assertEqual([f["name"] for f in fields], rows[0])
        self.assertGreater(len(rows), 100)
        for field, column in zip(fields, zip(*rows[1:], strict=True), strict=True):
            allowed = field.get("constraints", {})
            values = set(column)
            with self.subTest(field["name"]):
                self.assertEqual(allowed.get("required", False) and "" in values, False)
                values.discard("")
                if field["type"] == "integer":
                    numbers = [int(value) for value in values]
                    self.assertGreaterEqual(min(numbers), allowed.get("minimum", 0))
                    self.assertLessEqual(max(numbers), allowed.get("maximum", max(numbers)))
                elif field["type"] == "boolean":
                    self.assertEqual(values, {*field["trueValues"], *field["falseValues"]})
                else:
                    self.assertEqual(field["type"], "string")
                    self.assertLessEqual(values, set(allowed.get("enum", values)))
                    if "pattern" in allowed:
                        self.assertTrue(all(re.fullmatch(allowed["pattern"], v) for v in values))
        key = resource["schema"]["primaryKey"]
        key = [rows[0].index(name) for name in ([key] if isinstance(key, str) else key)]
        self.assertEqual(len({tuple(row[i] for i in key) for row in rows[1:]}), len(rows) - 1)

    def test_meanings_of_the_catalogue_are_those_of_its_page(self):
        page = text("certs/CATALOGUE.md")
        start = page.index("**`classes`**")
        table = page[start : page.index("\n\n", page.index("| column |", start))]
        meanings = re.findall(r"^\| `(\w+)` \| (.*) \|$", table, re.M)
        fields = self.package["resources"][-1]["schema"]["fields"]
        self.assertEqual([(f["name"], f["description"]) for f in fields], meanings)


class Artifact(unittest.TestCase):
    """The table of claims in ARTIFACT.md."""

    def setUp(self):
        table = text("ARTIFACT.md").split("| claim | command | minutes | expected last line |")[1]
        self.rows = [[cell.strip() for cell in line[1:-1].split(" | ")]
                     for line in table.split("\n\n")[0].splitlines()[2:]]
        self.assertGreater(len(self.rows), 9)
        self.programs = os.pathsep.join([str(pathlib.Path(PLPROVE).parent),
                                         str(pathlib.Path(PLCHECK).parent), os.environ["PATH"]])

    def test_commands_print_what_is_expected(self):
        usage = run(["./reproduce", "--help"], SOURCES).stdout
        for _, command, minutes, expected in self.rows:
            with self.subTest(command):
                command, expected = command.strip("`"), expected[1:-1]
                self.assertGreater(float(minutes), 0)
                if command.startswith("./reproduce"):
                    self.assertIn(f"\n  {command} ", usage)
                    continue
                command = command.replace("build/bin/plcheck", PLCHECK)
                if float(minutes) > 1:
                    program = shutil.which(command.split()[0], path=self.programs)
                    self.assertIsNotNone(program)
                    continue
                outcome = run(command, SOURCES, shell=True,
                              env={**os.environ, "PATH": self.programs})
                self.assertEqual(outcome.returncode, 0, outcome.stderr)
                pattern = ".*".join(re.escape(part) for part in expected.split("..."))
                self.assertRegex(outcome.stdout.rstrip("\n").rsplit("\n", 1)[-1], f"^{pattern}$")

    def test_last_line_of_the_tests_is_that_of_the_script(self):
        (expected,) = [row[3] for row in self.rows if row[1] == "`./reproduce test`"]
        (printed,) = re.findall(r"printf '(passed: .*)\\n'", text("reproduce"))
        (cases,) = re.findall(r'printf "(%d test cases.*)", cases', text("reproduce"))
        line = printed.replace("%s", cases, 1).replace("%d", "...").replace("%s", "...")
        self.assertEqual(expected.strip("`"), line)


class Book(unittest.TestCase):
    """What `./reproduce book` makes a PDF of. TeX itself is not run here: it takes half a minute,
    and a large installation."""

    def setUp(self):
        sys.dont_write_bytecode = True
        loader = importlib.machinery.SourceFileLoader("book", str(SOURCES / "packaging/book"))
        self.book = importlib.util.module_from_spec(importlib.util.spec_from_loader("book", loader))
        loader.exec_module(self.book)

    def test_every_page_of_proofs_is_in_the_book_once(self):
        written = [str(file.relative_to(SOURCES / "proofs"))
                   for file in (SOURCES / "proofs").rglob("*.md")]
        self.assertGreater(len(written), 20)
        self.assertEqual(sorted(self.book.pages()), sorted(written))
        self.assertEqual(self.book.pages()[:2], ["README.md", "classification.md"])

    def test_links_lead_somewhere(self):
        inside = 0
        for page in self.book.pages():
            for target in self.book.targets(text(f"proofs/{page}")):
                if re.match("https?:", target):
                    continue
                path, _, anchor = target.partition("#")
                file = self.book.resolved(page, path) if path else f"proofs/{page}"
                self.assertTrue((SOURCES / file).exists(), f"{page}: {target}")
                inside += file.removeprefix("proofs/") in self.book.pages()
                if anchor and file.endswith(".md"):
                    headings = re.findall("^#+ (.*)$", text(file), re.M)
                    self.assertIn(anchor, [re.sub(r"[^\w -]", "", heading).lower().replace(" ", "-")
                                           for heading in headings], f"{page}: {target}")
        self.assertGreater(inside, 100)

    def test_the_fonts_have_every_character(self):
        for page in self.book.pages():
            for character in text(f"proofs/{page}"):
                self.assertTrue(character.isascii() or character in self.book.LETTERS
                                or character in self.book.SIGNS, f"{page}: {character!r}")

    def test_title_is_that_of_the_citation(self):
        citation = yaml.safe_load(text("CITATION.cff"))
        self.assertEqual(self.book.cited("title"), [citation["title"]])
        self.assertEqual(self.book.cited("version"), [citation["version"]])
        self.assertEqual(self.book.cited("name"), [author["name"] for author in citation["authors"]])

    def test_links_become_places_of_the_book_or_paths(self):
        def link(target):
            return {"t": "Link", "c": [["", [], []], [{"t": "Str", "c": "here ∎"}], [target, ""]]}

        (inside,) = self.book.rewritten("three_views/1_spaces.md", [link("../degrees.md#2-a")])
        self.assertEqual(inside["c"][2], ["#degrees-md--2-a", ""])
        (outside,) = self.book.rewritten("models.md", [link("https://a.b/c")])
        self.assertEqual(outside["c"][2], ["https://a.b/c", ""])
        source = self.book.rewritten("three_views/1_spaces.md", [link("../../checker/file")])
        self.assertEqual(source[-1]["c"], ["latex", r"(\path{checker/file})"])
        self.assertEqual(source[1]["c"], ["latex", r"\rule{1ex}{1ex}"])


@unittest.skipUnless(repository(), "the sources are in no repository")
class Archive(unittest.TestCase):
    """`./reproduce archive`, in a clone."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.clone = pathlib.Path(self.folder.name) / "clone"
        run(["git", "clone", "--quiet", SOURCES, self.clone], SOURCES, check=True)
        shutil.copy(SOURCES / "reproduce", self.clone / "reproduce")
        self.commit = self.git("rev-parse", "HEAD")

    def git(self, *arguments, folder=None):
        return run(["git", *arguments], folder or self.clone, check=True).stdout.strip()

    def archive(self, **environment):
        return run(["./reproduce", "archive"], self.clone, env={**os.environ, **environment})

    def packed(self):
        return {file.name: hashlib.sha256(file.read_bytes()).hexdigest()
                for file in (self.clone / "build/archive").iterdir()}

    def write(self, name, content):
        file = self.clone / "build" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content)
        return file

    def large(self):
        file = self.clone / "build/large/4-64-0.plc"
        file.parent.mkdir(parents=True, exist_ok=True)
        run([PLPROVE, "degree", "4", "--at-least", "64", "--seed", "0", "-o", file], self.clone,
            check=True, env={**os.environ, "XDG_CACHE_HOME": self.folder.name})
        return file

    def test_the_same_bytes_each_time(self):
        names = ["atlas/index.html", *(f"atlas/{name}.html" for name in "hbfdBgaecD")]
        for name in names:
            self.write(name, f"<p>{self.commit}\n")
        self.write("book.pdf", f"<< /Commit ({self.commit}) >>\n")
        large = self.large()
        first = self.archive()
        self.assertEqual(first.returncode, 0, first.stderr)
        digests = self.packed()
        self.assertEqual(sorted(digests), ["SHA256SUMS", "SWHID", "atlas.tar.gz", "book.pdf",
                                           "large.tar.gz", "point-line-certificates.tar.gz"])
        # Written in another order, at another time, for others to read or not.
        shutil.rmtree(self.clone / "build/atlas")
        for name in reversed(names):
            file = self.write(name, f"<p>{self.commit}\n")
            os.utime(file, (1, 1))
            file.chmod(0o600)
        os.utime(large, (2, 2))
        self.git("config", "tar.umask", "0077")
        second = self.archive(TZ="Asia/Tokyo", LC_ALL="C.UTF-8")
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertEqual(self.packed(), digests)
        self.assertEqual(first.stdout, second.stdout)
        # A folder may list its files in the same order twice, by chance.
        listed = run(["tar", "-tzf", "build/archive/atlas.tar.gz"], self.clone).stdout.splitlines()
        self.assertEqual(listed, sorted(["atlas/", *names]))

    def test_what_it_packs_can_be_checked(self):
        self.assertEqual(self.archive().returncode, 0)
        out = self.clone / "build/archive"
        self.assertEqual(sorted(self.packed()),
                         ["SHA256SUMS", "SWHID", "point-line-certificates.tar.gz"])
        run(["sha256sum", "--check", "--strict", "SHA256SUMS"], out, check=True)
        run(["tar", "-xzf", "point-line-certificates.tar.gz"], out, check=True)
        inside = out / "point-line-certificates"
        # As docs/archive.md says: the identifier of the folder, from its files.
        self.git("init", "-q", folder=inside)
        self.git("add", "-A", "-f", folder=inside)
        self.assertEqual((out / "SWHID").read_text().split(),
                         [f"swh:1:rev:{self.commit}",
                          f"swh:1:dir:{self.git('write-tree', folder=inside)}"])

    def test_what_does_not_belong_is_refused(self):
        file = self.large()
        file.write_text(file.read_text() + "# tampered\n")
        outcome = self.archive()
        self.assertEqual(outcome.returncode, 1)
        self.assertIn("4-64-0.plc", outcome.stderr)
        self.assertFalse((self.clone / "build/archive").exists())
        shutil.rmtree(file.parent)
        for commit in ["0" * 40, self.commit + "-dirty"]:
            self.write("atlas/index.html", f"<p>{commit}</p>\n")
            outcome = self.archive()
            self.assertEqual(outcome.returncode, 1)
            self.assertIn("build/atlas is not of the last commit", outcome.stderr)
        shutil.rmtree(self.clone / "build/atlas")
        for commit in ["0" * 40, self.commit + "-dirty"]:
            self.write("book.pdf", f"<< /Commit ({commit}) >>\n")
            outcome = self.archive()
            self.assertEqual(outcome.returncode, 1)
            self.assertIn("build/book.pdf is not of the last commit", outcome.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
