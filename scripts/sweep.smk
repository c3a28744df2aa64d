# The designs of a sweep as a Snakemake workflow: one job a design, files declared so that any storage and executor serves.
# `scripts/sweep SWEEP.yaml --engine snakemake -- --profile CLOUD` prepares the folder and starts it there; by hand, in it:
#     snakemake --snakefile .../scripts/sweep.smk --cores all --config worker=.../scripts/sweep-design
# A failed design is a result too, with files that are empty: its status says why.
with open("waiting") as listing:
    ids = listing.read().split()

wildcard_constraints:
    id="[0-9a-f]{16}",

rule all:
    input:
        expand("{id}/status", id=ids),

rule design:
    input:
        "designs/{id}.yaml",
    output:
        "{id}/status",
        "{id}/design.yaml",
        "{id}/log",
        touch("{id}/summary.json"),
        touch("{id}/result.h5"),
    threads: 1
    shell:
        "{config[worker]:q} . {wildcards.id} && test -s {output[0]}"
