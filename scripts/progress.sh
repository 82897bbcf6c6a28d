#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Show a build's output: on a terminal one line that is rewritten for each step, elsewhere every 20th
# step; compiler messages always. Reads standard input; for ninja with NINJA_STATUS='[%f/%t] '.
set -u
step='^\[([0-9]+)/([0-9]+)\] '
pending=
while IFS= read -r line; do
  if [[ $line =~ $step ]]; then
    if [ -t 1 ]; then
      printf '\r\033[K%.100s' "$line"
      pending=yes
    elif ((BASH_REMATCH[1] % 20 == 0 || BASH_REMATCH[1] == BASH_REMATCH[2])); then
      printf '%.160s\n' "$line"
    fi
  else
    [ -n "$pending" ] && printf '\n'
    pending=
    printf '%s\n' "$line"
  fi
done
[ -n "$pending" ] && printf '\n'
exit 0
