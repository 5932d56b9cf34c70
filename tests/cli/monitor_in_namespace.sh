#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# monitor_in_namespace.sh JOUNCE EXAMPLE_DIR: the dashboard in a terminal, in a network of its own.
set -eu
. "$(dirname "$0")/namespace.sh"
cp "$2/axis.toml" "$scratch"
patient "$scratch/axis.toml"
python3 "$(dirname "$0")/monitor_in_pty.py" "$1" "$scratch/axis.toml" "$2/cam.toml"
