# Snakemake workflow of a sweep: one job per design, with declared files, so that it runs with any storage and executor.
# `scripts/sweep SWEEP.yaml --engine snakemake -- --profile CLOUD` prepares the folder and starts the workflow. Manually, in the folder:
#     snakemake --snakefile .../scripts/sweep.smk --cores all --config worker=.../scripts/sweep-design
# A failed design is a valid result with empty files; its status gives the reason.
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
