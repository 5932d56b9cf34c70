#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# edit_in_browser.sh SCRIPT JOUNCE [ARGUMENT...]: a script of this folder with the editor in headless Chromium; 77: there is none.
set -eu
here=$(dirname "$0")
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || { echo "skipped: no Chromium is installed"; exit 77; }
script=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
PYTHONPATH="$here/../web" timeout 280 python3 "$here/$script" "$browser" "$scratch" "$@"
