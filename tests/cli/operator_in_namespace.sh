#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# operator_in_namespace.sh JOUNCE ORDERS SEED: three operators send random orders to a machine; see random_operator.py.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
cd "$scratch"
python3 "$here/random_operator.py" "$@"
