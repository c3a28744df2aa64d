#!/usr/bin/env bash
# scripts/sweep --engine snakemake: the workflow is valid and gives the same rows as the other engines.   sweep_snakemake.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
sweep=$here/../../scripts/sweep
needs snakemake snakemake
export XDG_CACHE_HOME=$PWD/cache
# mesh-gen rejects one of the two designs, because the face has no support; designs with invalid geometry are not started.
cat designs/rod.yaml - >pulled.yaml <<'END'
  pull: {face: fixed, along: x, measure: force}
END
cat >rods.yaml <<'END'
design: pulled.yaml
vary: {outputs.pull.face: [fixed, end]}
set: {mesh.size: 50 mm, path.until.steps: 3}
END
run "$sweep rods.yaml --engine snakemake --folder cloud -- --dry-run"
claim "a dry run of the workflow computes nothing" [ -z "$(find cloud -name status)" ]
claim "the rows state that" [ "$(grep -c ',not_computed,,$' cloud/results.csv)" -eq 2 ]
claim "the exit code is 2" exits 2
runs "$sweep rods.yaml --engine snakemake --folder cloud --jobs 2"
claim "one design is done" grep -q ',fixed,.*,done,0,$' cloud/results.csv
claim "a rejected design does not end the sweep" grep -q ',end,.*,refused,65,.*outputs.pull' cloud/results.csv
runs "$sweep rods.yaml --engine snakemake --folder cloud"
claim "nothing is computed twice" grep -q ' 2 designs, 0 to compute ' "$seen/err"
