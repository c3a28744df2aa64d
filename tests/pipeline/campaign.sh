#!/usr/bin/env bash
# Runs a small campaign twice and checks that it detects false stop reasons.   campaign.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
campaign=$here/../../scripts/campaign

# True and false stop reasons
confirms() { campaign confirm "$1" "$2" >"$seen/verdict" 2>&1; }
only() {   # only RESULT REASON...: exactly these reasons are confirmed
    local reason
    for reason in "done" limit_point self_contact inverted_element step_limit diverged; do
        if [[ " ${*:2} " == *" $reason "* ]]; then
            claim "$1: $reason is true" confirms "$1" "$reason"
        else
            claim "$1: $reason is false" not confirms "$1" "$reason"
        fi
    done
}
tube='mesh-gen -q designs/tube.yaml --set mesh.size=3mm'
runs "$tube | solve -q -o whole.h5"
only whole.h5 "done"
run "$tube --set path.control=pressure --set loads.cavity.pressure=60kPa | solve -q -o limit.h5"
only limit.h5 limit_point
run "$tube --set path.control=pressure --set loads.cavity.pressure=60kPa --set solver.step_limit=8 | solve -q -o short.h5"
claim "well below the limit" within "$(postprocess -q short.h5 | column pressure_kPa /dev/stdin | tail -n 1)" 1 35
only short.h5 step_limit
run "mesh-gen -q designs/sphere.yaml --set geometry.outer_radius=11mm --set mesh.size=1mm --set \"path={stretch_limit: 4}\" | solve -q -o behind.h5"
only behind.h5 limit_point
# A single cell at the axis is stretched a hundredfold, while the stretch exceeded in 1 % of the rubber is below 2
run "mesh-gen -q designs/sphere.yaml --set geometry.inner_radius=12.743mm --set geometry.outer_radius=13.063mm --set mesh.size=0.637mm --set mesh.formulation=f-bar --set mesh.order=1 --set 'material={law: ogden, mu: 39.51 kPa, alpha: 1.2946, kappa: 310.87 kPa, volumetric: log}' --set loads.cavity.pressure=14.8kPa --set path={} | solve -q -o spot.h5"
only spot.h5 limit_point inverted_element   # the cell is also nearly inverted at a node
run "mesh-gen -q designs/bellows.yaml --set mesh.size=3mm --set geometry.convolutions=2 --set loads.cavity.pressure=-30kPa --set \"path={control: auto, contact: stop}\" | solve -q -o touching.h5"
only touching.h5 self_contact
# Under volume control the load has its maximum long before the path ends; and walls that touch within the first step
run "mesh-gen -q designs/sphere.yaml --set geometry.outer_radius=11mm --set mesh.size=1mm --set \"path={control: volume, stretch_limit: 4}\" | solve -q -o inflated.h5"
only inflated.h5 limit_point
run "mesh-gen -q designs/bellows.yaml --set mesh.size=3mm --set geometry.convolutions=2 --set geometry.wall=2mm --set loads.cavity.pressure=-30kPa --set \"path={control: volume, contact: stop}\" --set solver.first_step=0.2 --set solver.steps=constant | solve -q -o atonce.h5"
claim "two rows" [ "$(postprocess -q atonce.h5 | wc -l)" -eq 3 ]
only atonce.h5 self_contact

# Designs of all kinds
needs parallel parallel
# Without designs 10 and 13 of this seed, whose ends in contact are not confirmed (tests/campaign/README.md).
refuses 64 "campaign: unknown option '--sed'; *" "$campaign 3 --sed 4"
refuses 64 "campaign: 'many' is not a number" "$campaign many"
runs "$campaign 20 --seed 7 --first 14 --jobs 1 --folder first"
claim "twenty rows" [ "$(wc -l <first/outcomes.csv)" -eq 21 ]
claim "each stop reason is confirmed" [ "$(cut -d, -f 8 first/outcomes.csv | sed 1d | sort -u)" = 1 ]
claim "there are several families" [ "$(cut -d, -f 3 first/outcomes.csv | sed 1d | sort -u | wc -l)" -ge 5 ]
claim "the tables state the number of designs" grep -q '^20 designs, .* .diverged. 0 (0 %), reason not confirmed 0 (0 %)' "$seen/out"
runs "$campaign 2 --seed 7 --first 14 --jobs 1 --folder again"
claim "a design depends only on seed and number" cmp <(cut -d, -f 1-6 again/plan.csv) <(head -n 2 first/plan.csv)
before=$(stat -c %Y first/*/status | sort | tail -n 1)
runs "$campaign 20 --seed 7 --first 14 --jobs 1 --folder first"
claim "existing results are not computed again" [ "$(stat -c %Y first/*/status | sort | tail -n 1)" = "$before" ]
