#!/bin/sh
# pages_in_namespace.sh JOUNCE PAGE.md...: run_snippets.py with multicast, in a network of its own.
set -eu
. "$(dirname "$0")/../cli/namespace.sh"
# An executor that a page has left running ends with the shell that is its process namespace's first process.
unshare --pid --fork --kill-child --mount-proc sh -c 'python3 "$@"; exit $?' - "$(dirname "$0")/run_snippets.py" "$@"
