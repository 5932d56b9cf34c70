#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""report_security.py JOUNCE ROOT: a report allows its own script only, requests nothing, and shows hostile names as text.

The hash in the Content-Security-Policy is compared with that of the script as the page has it.
"""
import base64
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

jounce, root = sys.argv[1], pathlib.Path(sys.argv[2])
EVIL = "</script><script>alert(1)</script><!--<script>"
BYTES_OF_A_CAM = 400_000


def page_of(spec, folder, *options):
    out = folder / "page.html"
    subprocess.run([jounce, "report", str(spec), "-o", str(out), *options], stdout=subprocess.DEVNULL)
    return out.read_text()


def check(page):
    scripts = re.findall(r"<script([^>]*)>(.*?)</script>", page, re.S)
    assert [attributes for attributes, _ in scripts] == [' type="application/json"', ""], [a for a, _ in scripts]
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page)[1]
    own = base64.b64encode(hashlib.sha256(scripts[1][1].encode()).digest()).decode()
    assert [part.strip() for part in policy.split(";")] == [
        "default-src 'none'", "style-src 'unsafe-inline'", "img-src data:", "base-uri 'none'", "form-action 'none'",
        f"script-src 'sha256-{own}'"], policy
    for word in ("fetch(", "XMLHttpRequest", "import(", "eval(", "innerHTML", "document.write", "WebSocket"):
        assert word not in scripts[1][1], word
    addresses = set(re.findall(r"https?://[^\"')\s<]*", page))
    assert addresses <= {"http://www.w3.org/2000/svg"}, addresses  # the name of SVG, which is not loaded
    return json.loads(scripts[0][1])


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    given = root / "examples" / "packaging-pusher" / "cam.toml"
    for spec in given, root / "examples" / "pmc600-cam" / "cam.toml":
        page = page_of(spec, folder)
        check(page)
        assert len(page.encode()) < BYTES_OF_A_CAM, len(page)
        assert page == page_of(spec, folder), "equal inputs give equal pages"
    hostile = folder / "hostile.toml"
    hostile.write_text(given.read_text().replace('"packaging pusher"', f"'{EVIL}'").replace('"push"', f"'{EVIL}'"))
    page = page_of(hostile, folder, "--before", str(given))
    data = check(page)
    assert data["name"] == EVIL
    assert any(EVIL in segment[2] for segment in data["views"][0]["segments"]), data["views"][0]["segments"]
    assert "<script>alert" not in page
