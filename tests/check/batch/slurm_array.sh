#!/bin/sh
# A task of a Slurm array checks one line of a list of files:
#   find class -name '*.json' | sort > files.txt
#   sbatch --array=1-$(wc -l < files.txt) slurm_array.sh files.txt SCENE PARTS
# and when all are done:
#   raytree check --as json -o report.json --merge PARTS
#SBATCH --ntasks=1 --cpus-per-task=1 --mem=1G --time=5
set -eu
file=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$1")
mkdir -p "$3"
# Exit code 1 says that the submission is wrong; to Slurm the task has not failed.
raytree check "$file" --scene "$2" --threads 1 --as json -o "$3/$SLURM_ARRAY_TASK_ID.json" ||
    [ $? = 1 ]
