#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""repository_test.py JOUNCE ROOT: a git repository with motions, checked as a CI system does.

It reads the formats with parsers of others (jsonschema, junitparser, xmllint), and runs the files of examples/ci."""
import copy
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import jsonschema
import junitparser
import yaml

JOUNCE, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
CI = ROOT / "examples/ci"
SCHEMA = json.loads((pathlib.Path(__file__).parent / "sarif_subset.schema.json").read_text())

CAM = """jounce = 1
kind = "cam"
name = "{name}"
units = {{ master = "deg", position = "mm" }}
start = {{ master = 0, slave = 0 }}

[[segment]]
name = "rise"
law = "345"
end = {{ master = {master}, slave = 50 }}

[limits]
geo_velocity = 1
position_max = 60
"""
GOOD, BROKEN = 100, 80  # Cv of the polynomial 3-4-5 is 1.875: 50 mm need 93.75 deg


class Repository(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name) / "repository"
        home = pathlib.Path(self.scratch.name) / "home"
        (home / "bin").mkdir(parents=True)
        (home / "bin/jounce").symlink_to(JOUNCE)
        self.env = {"PATH": f"{home}/bin:/usr/bin:/bin", "HOME": str(home), "LC_ALL": "C.UTF-8",
                    "GIT_CONFIG_NOSYSTEM": "1", "TMPDIR": str(home)}
        self.folder.mkdir()
        self.git("init", "-q", "-b", "main")
        self.git("config", "user.name", "test")
        self.git("config", "user.email", "test@localhost")
        self.write("cams/feeder.toml", CAM.format(name="feeder", master=GOOD))
        self.write("cams/knife.toml", CAM.format(name="knife", master=120))
        self.write("axes/drive.toml", (ROOT / "cli/templates/drive.toml").read_text())
        self.write("pyproject.toml", "[tool.black]\nline-length = 120\n")
        self.write("package.json", "{}")
        self.commit()

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def run_in(self, *words, folder=None, **more):
        return subprocess.run(words, cwd=folder or self.folder, env=self.env | more, capture_output=True, text=True,
                              timeout=100)

    def git(self, *words, **more):
        done = self.run_in("git", *words, **more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "motions")

    def jounce(self, *words, status=0, **more):
        done = self.run_in("jounce", *words, **more)
        self.assertEqual(done.returncode, status, f"{words}: {done.stdout}{done.stderr}")
        return done

    # ---- files, statuses, formats ---------------------------------------------------------------------------------

    def test_a_good_repository(self):
        done = self.jounce("check", ".")
        self.assertRegex(done.stdout, r"^3 files: 3 good(; \d+ warnings?)?\n$")
        self.assertEqual(done.stderr, "")
        self.assertEqual(self.jounce("check", ".", "--quiet").stdout, "")

    def test_one_file_keeps_its_whole_answer(self):
        text = self.jounce("check", "cams/feeder.toml").stdout
        self.assertTrue(text.startswith("feeder: all limits hold; the closest: geo_velocity"), text)
        self.assertIn("max |geo_velocity|", text)
        document = json.loads(self.jounce("check", "cams/feeder.toml", "--json").stdout)
        self.assertEqual(list(document)[:2], ["ok", "findings"])
        self.assertIn("segments", document)

    def test_a_foreign_file_is_refused_where_it_is_named(self):
        done = self.jounce("check", "pyproject.toml", "cams/feeder.toml", status=2)
        self.assertIn("pyproject.toml", done.stdout)
        self.assertIn("[input/key]", done.stdout)
        done = self.jounce("check", "*.toml", status=2)
        self.assertIn("contains no Jounce files", done.stderr)

    def test_errors_of_one_file_are_all_reported(self):
        self.write("bad.toml", CAM.format(name="x", master='"3 kg"').replace("geo_velocity = 1", 'geo_velocity = "a"'))
        done = self.jounce("check", "bad.toml", status=2)
        self.assertRegex(done.stderr, r"^jounce: bad.toml:10:18: segment\[1\].end.master = .*\n"
                                      r"jounce: bad.toml:13:16: limits.geo_velocity = .*\n$")
        document = json.loads(self.jounce("check", "bad.toml", "--json", status=2).stdout)
        self.assertEqual(document["status"], 2)
        self.assertEqual([(f["line"], f["column"], f["rule"]) for f in document["findings"]],
                         [(10, 18, "input/key"), (13, 16, "input/key")])

    def test_strict_counts_warnings(self):
        self.write("free.toml", CAM.format(name="free", master=GOOD).split("[limits]")[0])
        self.assertIn("[warning/no_limits]", self.jounce("check", ".").stdout)
        self.jounce("check", ".", "--strict", status=1)
        self.jounce("check", "free.toml")
        self.jounce("check", "free.toml", "--strict", status=1)

    def broken(self):
        self.write("cams/feeder.toml", CAM.format(name="feeder", master=BROKEN))
        self.write("cams/bad, or not.toml", "jounce = 1\nkind = \"cam\"\nunits = { master = \"dg\" }\n")

    def test_json(self):
        self.broken()
        for verb in ("check", "validate"):
            run = json.loads(self.jounce(verb, ".", "--format", "json", status=2).stdout)
            self.assertEqual(run["status"], 2)
            for finding in (f for file in run["files"] for f in file["findings"]):
                for key in "rule severity file line column message value limit margin".split():
                    self.assertIn(key, finding)
        run = json.loads(self.jounce("check", ".", "--json", status=2).stdout)
        files = {file["file"]: file for file in run["files"]}
        self.assertEqual(sorted(files), ["axes/drive.toml", "cams/bad, or not.toml", "cams/feeder.toml", "cams/knife.toml"])
        self.assertEqual([files[f]["status"] for f in sorted(files)], [0, 2, 1, 0])
        worst = files["cams/feeder.toml"]["findings"][0]
        self.assertEqual((worst["rule"], worst["line"], worst["limit_line"], worst["limit"]),
                         ("limit/geo_velocity", 7, 13, 1))
        self.assertAlmostEqual(worst["value"], 1.875 * 50 / BROKEN, 9)

    def test_github_annotations_are_relative_to_the_repository(self):
        self.broken()
        text = self.jounce("check", ".", "--format", "github", folder=self.folder / "cams", status=2).stdout
        commands = [line for line in text.splitlines() if line.startswith("::")]
        self.assertRegex(commands[0], r"^::error file=cams/bad%2C or not\.toml,title=input/key::start: is missing")
        self.assertRegex(commands[1], r"^::error file=cams/bad%2C or not\.toml,line=3,col=9,title=input/key::units.position: is missing")
        self.assertRegex(commands[2], r"^::error file=cams/bad%2C or not\.toml,line=3,")
        self.assertRegex(commands[3], r"^::error file=cams/feeder\.toml,line=7,col=1,title=limit/geo_velocity::")
        self.assertIn("17.2 %25", commands[3])

    def test_gitlab(self):
        self.broken()
        report = json.loads(self.jounce("check", ".", "--format", "gitlab", folder=self.folder / "cams", status=2).stdout)
        for finding in report:
            self.assertEqual(sorted(finding), ["check_name", "description", "fingerprint", "location", "severity"])
            self.assertIn(finding["severity"], ("info", "minor", "major", "critical", "blocker"))
            self.assertTrue((self.folder / finding["location"]["path"]).is_file())
        self.assertEqual(len({f["fingerprint"] for f in report}), len(report))

    def test_sarif(self):
        self.broken()
        sarif = json.loads(self.jounce("check", ".", "--format", "sarif", status=2).stdout)
        validator = jsonschema.Draft7Validator(SCHEMA)
        self.assertEqual([e.message for e in validator.iter_errors(sarif)], [])
        results = sarif["runs"][0]["results"]
        self.assertIn("limit/geo_velocity", [r["ruleId"] for r in results])
        for fault in (lambda r: r.update(level="fatal"),
                      lambda r: r["locations"][0]["physicalLocation"]["region"].update(startLine=0),
                      lambda r: r.pop("message")):
            wrong = copy.deepcopy(sarif)
            fault(next(r for r in wrong["runs"][0]["results"] if "region" in r["locations"][0]["physicalLocation"]))
            self.assertFalse(validator.is_valid(wrong), "the schema finds a fault")
        self.write("cams/feeder.toml", "# a comment\n" + CAM.format(name="feeder", master=BROKEN + 1))
        again = json.loads(self.jounce("check", ".", "--format", "sarif", status=2).stdout)
        names = [[r["partialFingerprints"] for r in s["runs"][0]["results"]] for s in (sarif, again)]
        self.assertEqual(*names, "an edit above the finding does not make another alert of it")

    def test_junit(self):
        self.broken()
        for verb in ("check", "validate"):
            text = self.jounce(verb, ".", "--format", "junit", status=2).stdout
            path = self.folder / "report.xml"
            path.write_text(text)
            self.assertEqual(self.run_in("xmllint", "--noout", str(path)).returncode, 0)
            suites = junitparser.JUnitXml.fromfile(str(path))
            cases = [case for suite in suites for case in suite]
            self.assertEqual(suites.tests, len(cases))
            self.assertEqual(suites.errors, 3)
            for suite in suites:
                names = [case.name for case in suite]
                self.assertEqual(len(names), len(set(names)), "a name is a case")
            failed = [case for case in cases for r in case.result if isinstance(r, junitparser.Failure)]
            self.assertEqual(suites.failures, len(failed))
            if verb == "check":
                self.assertEqual([case.name for case in failed], ["segment 1 rise: limit/geo_velocity"])

    # ---- accepted versions ----------------------------------------------------------------------------------------

    def changed(self):
        self.write("cams/feeder.toml", CAM.format(name="feeder", master=110))
        shutil.move(self.folder / "cams/knife.toml", self.folder / "cams/cutter.toml")
        self.write("cams/new.toml", CAM.format(name="new", master=GOOD))
        (self.folder / "axes/drive.toml").unlink()

    def test_a_revision_is_the_baseline(self):
        self.assertIn("3 the same", self.jounce("check", ".", "--baseline", "main").stdout)
        self.changed()
        index = (self.folder / ".git/index").read_bytes()
        done = self.jounce("check", ".", "--baseline", "main", "--summary", "out", status=1)
        self.assertIn("compared with main: 1 changed, 1 new, 1 removed, 1 renamed\n", done.stdout)
        for line in ("new: cams/new.toml", "removed: main:axes/drive.toml",
                     "renamed: main:cams/knife.toml -> cams/cutter.toml"):
            self.assertIn(line + "\n", done.stdout)
        self.assertRegex(done.stdout, r"cams/feeder.toml: error: position differs from the accepted version by .* "
                                      r"\[baseline/changed\]")
        self.assertEqual((self.folder / ".git/index").read_bytes(), index)
        self.assertEqual(list(pathlib.Path(self.env["TMPDIR"]).glob("jounce-baseline-*")), [])
        summary = (self.folder / "out/summary.md").read_text()
        pictures = re.findall(r"!\[\w+\]\((.*?)\)", summary)
        self.assertEqual(pictures, ["cams-feeder.toml.before.svg", "cams-feeder.toml.after.svg"])
        for picture in pictures:
            self.assertEqual(self.run_in("xmllint", "--noout", f"out/{picture}").returncode, 0)
            self.assertIn("main:cams/feeder.toml", (self.folder / "out" / picture).read_text())
        self.assertEqual(sorted(p.name for p in (self.folder / "out").iterdir()), sorted(pictures + ["summary.md"]))

    def test_a_revision_in_a_hook_and_in_a_folder(self):
        """In a hook git sets GIT_INDEX_FILE, and the index is that of the commit."""
        self.changed()
        self.git("add", "-A")
        index = (self.folder / ".git/index").read_bytes()
        done = self.jounce("check", ".", "--baseline", "HEAD", folder=self.folder / "cams", status=1,
                           GIT_INDEX_FILE=str(self.folder / ".git/index"))
        self.assertIn("compared with HEAD: 1 changed, 1 new, 1 renamed\n", done.stdout)
        self.assertIn("renamed: HEAD:cams/knife.toml -> cutter.toml\n", done.stdout)
        self.assertEqual((self.folder / ".git/index").read_bytes(), index)

    def test_a_tolerance_accepts_a_change(self):
        self.write("cams/feeder.toml", CAM.format(name="feeder", master=GOOD).replace("slave = 50 ", "slave = 50.01 "))
        self.jounce("check", ".", "--baseline", "main", status=1)
        self.jounce("check", ".", "--baseline", "main", "--tolerance", "position=1 mm")
        run = json.loads(self.jounce("check", ".", "--baseline", "main", "--tolerance", "position=1 um", "--json",
                                     status=1).stdout)
        finding = next(f for file in run["files"] for f in file["findings"] if f["rule"] == "baseline/changed")
        self.assertEqual((finding["quantity"], finding["unit"], finding["limit"]), ("position", "mm", 0.001))
        self.assertAlmostEqual(finding["value"], 0.01, 9)
        self.assertAlmostEqual(finding["margin"], -9, 6)

    def test_a_file_that_cannot_be_read_is_not_the_same(self):
        """The counts and the summary name a broken file, alone and beside a changed one."""
        path = self.folder / "cams" / "feeder.toml"
        path.write_text(path.read_text().replace("jounce = 1", "jounce = 1\nkindd = 2", 1))
        done = self.jounce("check", ".", "--baseline", "main", "--summary", "out", status=2)
        self.assertIn("compared with main: 1 not compared (wrong), 2 the same\n", done.stdout)
        self.assertIn("not compared (wrong): cams/feeder.toml\n", done.stdout)
        summary = (self.folder / "out" / "summary.md").read_text()
        self.assertIn("1 not compared (wrong), 2 the same", summary)
        self.assertRegex(summary, r"### not compared \(wrong\): `cams/feeder.toml`\n\n- cams/feeder.toml:\d+.*kindd")

    def test_a_folder_of_tables_is_the_baseline(self):
        (self.folder / "accepted/cams").mkdir(parents=True)
        for name in ("feeder", "knife"):
            self.jounce("design", f"cams/{name}.toml", "-o", f"accepted/cams/{name}.csv")
        self.assertIn("1 new, 2 the same", self.jounce("check", ".", "--baseline", "accepted").stdout)
        self.write("cams/feeder.toml", CAM.format(name="feeder", master=110))
        (self.folder / "cams/knife.toml").unlink()
        done = self.jounce("check", ".", "--baseline", "accepted", status=1)
        self.assertIn("1 changed, 1 new, 1 removed", done.stdout)
        self.assertIn("removed: accepted/cams/knife.csv", done.stdout)

    def test_a_wrong_baseline(self):
        for name, rule in (("nowhere", "is neither a folder nor a revision of git"), ("--output=x", "has no value after it")):
            done = self.jounce("check", ".", f"--baseline={name}", status=2)
            self.assertIn(rule, done.stderr)
        self.jounce("check", ".", "--summary", "out", status=2)

    # ---- examples/ci ----------------------------------------------------------------------------------------------

    def steps(self):
        workflow = yaml.safe_load((CI / "github-actions.yml").read_text())
        return [step for step in workflow["jobs"]["motions"]["steps"]
                if "run" in step and not step["name"].startswith("Install")]

    def run_workflow(self):
        """Runs the steps as GitHub does, and returns the status of each."""
        statuses = {}
        for step in self.steps():
            done = self.run_in("bash", "-e", "-c", step["run"], BASE="main",
                               GITHUB_STEP_SUMMARY=str(self.folder / "step.md"))
            statuses[step["name"]] = done.returncode
        return statuses

    def test_the_github_workflow(self):
        self.assertEqual(self.run_workflow(), {"Check": 0, "Prove": 0, "SARIF": 0})
        self.changed()
        self.write("cams/new.toml", CAM.format(name="new", master=BROKEN))
        self.assertEqual(self.run_workflow(), {"Check": 1, "Prove": 0, "SARIF": 0})
        self.assertIn("## Motions compared with `main`: 1 changed", (self.folder / "step.md").read_text())
        self.assertTrue(json.loads((self.folder / "jounce.sarif").read_text())["runs"][0]["results"])
        self.broken()
        self.assertEqual(self.run_workflow(), {"Check": 2, "Prove": 2, "SARIF": 0})

    def test_the_gitlab_job(self):
        job = yaml.safe_load((CI / "gitlab-ci.yml").read_text())["motions"]
        script = "\n".join(job["script"])
        self.assertEqual(self.run_in("bash", "-e", "-c", script, BASE="main").returncode, 0)
        self.broken()
        self.assertEqual(self.run_in("bash", "-e", "-c", script, BASE="main").returncode, 2)
        reports = job["artifacts"]["reports"]
        self.assertTrue(json.loads((self.folder / reports["codequality"]).read_text()))
        for name in reports["junit"]:
            self.assertGreater(junitparser.JUnitXml.fromfile(str(self.folder / name)).tests, 0)

    def test_the_pre_commit_hooks(self):
        config = yaml.safe_load((CI / "pre-commit-config.yaml").read_text())
        entry = config["repos"][0]["hooks"][0]["entry"]
        self.assertEqual(self.run_in("sh", "-c", entry).returncode, 0)
        shutil.copy(CI / "pre-commit", self.folder / ".git/hooks/pre-commit")
        self.write("cams/feeder.toml", CAM.format(name="feeder", master=105))
        self.commit()
        self.broken()
        self.git("add", "-A")
        done = self.run_in("git", "commit", "-q", "-m", "broken")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("limit/geo_velocity", done.stdout + done.stderr)
        self.assertNotEqual(self.run_in("sh", "-c", entry).returncode, 0)
        if shutil.which("pre-commit"):
            shutil.copy(CI / "pre-commit-config.yaml", self.folder / ".pre-commit-config.yaml")
            self.git("add", "-A")
            done = self.run_in("pre-commit", "run", "--all-files")
            self.assertIn("limit/geo_velocity", done.stdout + done.stderr)

    def test_the_drivers_of_git_diff(self):
        shutil.copy(CI / "gitattributes", self.folder / ".gitattributes")
        self.write("cams/feeder.toml", CAM.format(name="", master=110))
        self.write("pyproject.toml", "[tool.black]\nline-length = 100\n")
        self.git("config", "diff.jounce.textconv", str(CI / "jounce-textconv"))
        text = self.git("diff")
        self.assertRegex(text, r"(?m)^-.*1 rise .* 0\.9375 @ 50")
        self.assertRegex(text, r"(?m)^\+.*1 rise .* 0\.852273 @ 55")
        self.assertIn("+line-length = 100", text)
        self.git("config", "diff.jounce.command", str(CI / "jounce-git-diff"))
        text = self.git("diff")
        self.assertIn("a/cams/feeder.toml -> b/cams/feeder.toml: they differ", text)
        self.assertIn("geo_velocity", text)
        self.assertIn("+line-length = 100", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
