#!/usr/bin/env bash
# Grades a class on a cluster: submit.sh PARTS DIR OUT SECRET [options of ./tumble grade]
#
# Three jobs, one after the other: the kit is built and proves itself; PARTS jobs grade a part of the
# class each; a last one writes the summary of all, and tries again whatever failed. DIR, OUT and the
# kit must lie where every node sees them. Options of sbatch, such as a partition, go by the
# environment: SBATCH_PARTITION, SBATCH_ACCOUNT.
set -euo pipefail
if [ $# -lt 4 ] || ! [[ $1 =~ ^[1-9][0-9]{0,3}$ ]] || [ ! -d "$2" ] || [ ! -r "$4" ]; then
  echo "submit.sh: give PARTS (1 to 9999) DIR OUT SECRET [options], with DIR and SECRET readable" >&2
  exit 2
fi
parts=$1
class=$(realpath "$2")
out=$(realpath -m "$3")
secret=$(realpath "$4")
shift 4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
kit=$(realpath "$here/../../..")
mkdir -p "$out/.logs"

send() {
  sbatch --parsable --kill-on-invalid-dep=yes --output="$out/.logs/%x-%A-%a.txt" "$@"
}
check=$(send "$here/grade.sbatch" "$kit" --check --out "$out" --secret "$secret" "$@")
grade=$(send --array="1-$parts" --dependency="afterok:$check" "$here/grade.sbatch" "$kit" \
  "$class" --out "$out" --secret "$secret" "$@")
collect=$(send --dependency="afterany:$grade" "$here/grade.sbatch" "$kit" \
  "$class" --out "$out" --secret "$secret" "$@")
echo "jobs $check (proof), $grade ($parts parts), $collect (summary); logs in $out/.logs"
