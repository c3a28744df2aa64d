#!/usr/bin/env bash
# Runs the ```sh blocks of a document in order, each in a new shell, in a scratch folder with copies of the given folders.
#   run_blocks.sh DOCUMENT BIN [FOLDER...]      BIN is prepended to PATH
# A block directly below  <!-- not run: reason -->  is skipped and listed. Fails if a block fails, a fence is not closed, a block is skipped
# without a reason, or README.md has no block that runs.
set -uo pipefail
document=$(realpath "$1")
bin=$(realpath "$2")
shift 2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/blocks" "$work/tree"
for folder in "$@"; do cp -R "$folder" "$work/tree/" || exit 1; done

# One file per block: run-LINE.sh, or skip-LINE.sh whose first line is the reason.
awk -v out="$work/blocks/" '
    /^```/ && inside { inside = 0; close(file); next }
    /^```sh[ \t]*$/ {
        inside = 1; opened = NR
        file = sprintf("%s%s-%05d.sh", out, mark ? "skip" : "run", NR)
        if (mark) print "# " reason >file; else printf "" >file
        mark = 0; next
    }
    inside { print >file; next }
    /^```/ { other = !other; next }
    /^[ \t]*<!-- not run:.*-->[ \t]*$/ {
        reason = $0; sub(/.*not run:[ \t]*/, "", reason); sub(/[ \t]*-->.*/, "", reason); mark = 1
        if (reason == "") { print "line " NR ": left out without a reason"; bad = 1 }
        next
    }
    NF { mark = 0 }
    END { if (inside) { print "line " opened ": this block is never closed"; bad = 1 } exit bad }
' "$document" || exit 1

unset BUILD_DIR JOBS   # as in the shell of a reader
export PATH="$bin:$PATH"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
cd "$work/tree" || exit 1
ran=0
failed=0
for block in "$work"/blocks/*.sh; do
    [[ -e $block ]] || break
    line=$(basename "$block" .sh)
    line=${line#*-}
    case $(basename "$block") in
        skip-*) echo "line $((10#$line)): not run: $(sed -n '1s/^# //p' "$block")" ;;
        *)
            ran=$((ran + 1))
            if bash -euo pipefail "$block" >"$work/output" 2>&1 </dev/null; then
                echo "line $((10#$line)): passed"
            else
                echo "line $((10#$line)): FAILED with exit code $?:"
                sed 's/^/  > /' "$block"
                tail -n 20 "$work/output" | sed 's/^/  | /'
                failed=$((failed + 1))
            fi ;;
    esac
done
echo "$ran blocks run, $failed failed"
[[ $ran -gt 0 || $document != */README.md ]] && ((failed == 0))
