#!/bin/sh
# Submits the runs and ends; options are passed on to sbatch, such as
#   sh submit.sh --time=10 --cpus-per-task=2
# `tolman sweep status` reads what became of them.
set -e
here=$(cd "$(dirname "$0")" && pwd)
after=
for list in "$here/runs-1.txt" "$here/runs-2.txt"; do
  runs=$(wc -l <"$list")
  [ "$runs" -gt 0 ] || continue
  id=$(sbatch --parsable --job-name=@NAME@ --array=1-"$runs" --output=/dev/null $after "$@" \
    "$here/array.sh" "$list")
  echo "$id"
  after=--dependency=afterany:${id%%;*}
done
