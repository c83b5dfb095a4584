#!/usr/bin/env bash
# format.sh [--fix] - whether the C, C++ and OpenCL sources are as .clang-format says; --fix makes
# them so. Left out: include/rsh/*.h, whose fields and comments stand in columns like a table.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mode=(--dry-run -Werror)
if [ "${1:-}" = --fix ]; then mode=(-i); fi
mapfile -t files < <(git ls-files --cached --others --exclude-standard \
    '*.cpp' '*.hpp' '*.c' '*.h' '*.cl' '*.cu' '*.cuh' | grep -v '^include/rsh/.*\.h$')
clang-format "${mode[@]}" "${files[@]}"
echo "${#files[@]} files are formatted"
