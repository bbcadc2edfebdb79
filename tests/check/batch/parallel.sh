#!/bin/sh
# Checks every file of a folder with GNU parallel, a process for each, and joins the reports.
#   parallel.sh CLASS SCENE REPORT.json [what else raytree check is to be told]
set -eu
class=$1 scene=$2 report=$3
shift 3
parts=$(mktemp -d)
trap 'rm -r "$parts"' EXIT
export scene parts
# Exit code 1 says that a submission is wrong; the report says which.
find "$class" -name '*.json' | sort |
    parallel --will-cite \
        'raytree check {} --scene "$scene" --threads 1 --as json -o "$parts"/{#}.json '"$*"' || [ $? = 1 ]'
raytree check --as json -o "$report" --merge "$parts" || [ $? = 1 ]
