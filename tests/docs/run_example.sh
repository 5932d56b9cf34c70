#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# run_example.sh PROGRAM SOURCE: what it prints must be the `// > ` lines at the end of its source.
set -eu
sed -n 's|^// > ||p' "$2" > "$1.expected"
"$1" > "$1.printed"
diff "$1.expected" "$1.printed"
