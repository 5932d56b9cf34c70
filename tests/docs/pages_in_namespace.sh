#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pages_in_namespace.sh JOUNCE PAGE.md...: run_snippets.py where programs meet, in a network of its own.
set -eu
. "$(dirname "$0")/../cli/namespace.sh"
snippets=$(dirname "$0")/run_snippets.py
# An executor that a page has left running ends with the shell that is its process namespace's first process; where
# there is no namespace, it ends when the folder in which programs meet is removed.
case $JOUNCE_BUS in
unix:*) python3 "$snippets" "$@" ;;
*) unshare --pid --fork --kill-child --mount-proc sh -c 'python3 "$@"; exit $?' - "$snippets" "$@" ;;
esac
