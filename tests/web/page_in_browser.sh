#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# page_in_browser.sh JOUNCE: the page of a live axis in headless Chromium; 77: there is none.
set -eu
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || { echo "skipped: no Chromium is installed"; exit 77; }
. "$(dirname "$0")/../cli/namespace.sh"
. "$(dirname "$0")/with_panel.sh"
timeout 500 python3 "$(dirname "$0")/page_in_browser.py" "$browser" "$scratch" "$address" || fail "see above"
