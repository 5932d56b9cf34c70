#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# orders_over_page.sh JOUNCE: what a browser would send, to a real executor.
set -eu
. "$(dirname "$0")/../cli/namespace.sh"
. "$(dirname "$0")/with_panel.sh"
python3 "$(dirname "$0")/orders_over_page.py" "$address" || fail "see above"
kill -INT $executor
wait $executor || fail "the executor ended badly"
grep -q "live page" "$scratch/said"
