#!/bin/sh
# One task of a Slurm array: the run in line SLURM_ARRAY_TASK_ID of the list.
folder=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$1")
exec @COMMAND@ "$folder"
