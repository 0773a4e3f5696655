#!/bin/sh
# Runs all runs of the archive again and compares the results, byte for byte. data.txt lists the variables
# for data that lie elsewhere now:
#   TOLMAN=/usr/bin/tolman DATA_1=/data/00 sh rerun.sh
# The new runs go to $AGAIN, what they say beside them. The exit code is 0 where all
# results are the same, 2 where a run could not be made, otherwise 1.
for name in @VARIABLES@; do  # relative paths would change their meaning below
  eval "path=\${$name-/}"
  case $path in /*) ;; *) export "$name=$PWD/$path" ;; esac
done
cd "$(dirname "$0")" || exit 2
TOLMAN=${TOLMAN:-tolman}
AGAIN=${AGAIN:-$PWD/again}
export AGAIN
ended=0
mkdir -p "$AGAIN"
while read -r run; do
  said="$AGAIN/$run.txt"
  rm -f "$AGAIN/$run/results.sha256"
  if "$TOLMAN" rerun "runs/$run" --force --out "$AGAIN/$run" --verify </dev/null >"$said" 2>&1
  then echo "same     $run"
  elif [ -f "$AGAIN/$run/results.sha256" ]
  then [ $ended = 2 ] || ended=1; echo "differs  $run (see $said)"
  else ended=2; echo "not run  $run (see $said)"; tail -n 3 "$said" >&2
  fi
done <<RUNS
@RUNS@RUNS
exit $ended
