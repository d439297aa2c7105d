#!/usr/bin/env bash
# Prints one table: casteljau beside FLINT (as `pip install python-flint` gives it) and SymPy. Needs cargo, python3, and Linux.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

venv=target/venv
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/pip" install --quiet --disable-pip-version-check python-flint==0.9.0 sympy==1.14.0

FLINT_LIBRARY=$(find "$PWD/$venv" -path '*/python_flint.libs/libflint*.so*' -print -quit)
[ -n "$FLINT_LIBRARY" ] || { echo "the python-flint wheel has no libflint*.so beside it" >&2; exit 1; }

cargo build --release --quiet
SYMPY_POINTS=$("$venv/bin/python" sympy_points.py)
export FLINT_LIBRARY SYMPY_POINTS
cargo run --release --quiet --bin peers
exec cargo run --release --quiet --bin memory
