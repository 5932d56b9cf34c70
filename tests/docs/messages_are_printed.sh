#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# messages_are_printed.sh JOUNCE DOCS: docs/reference/messages.md is what `jounce explain` prints.
set -eu
"$1" explain --markdown | diff - "$2/reference/messages.md"
