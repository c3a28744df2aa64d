#include "linalg/profile.hpp"

#include <algorithm>
#include <array>

#include "linalg/petsc.hpp"

namespace soft::linalg {

namespace {

constexpr std::array<const char*, 8> phase_events{"Residual", "Tangent",   "Measures",   "Contact",
                                                  "Writing",  "LdltOrder", "LdltFactor", "LdltSolve"};

constexpr const char* name_of(Phase phase) { return phase_events[static_cast<std::size_t>(phase)]; }

PetscLogEvent event_of(Phase phase) {
    // PETSc assigns event ids once per process; a registered name keeps its id.
    static const std::array<PetscLogEvent, phase_events.size()> events = [] {
        std::array<PetscLogEvent, phase_events.size()> ids{};
        for (std::size_t i = 0; i < ids.size(); ++i)
            SOFT_PETSC(PetscLogEventRegister(phase_events[i], KSP_CLASSID, &ids[i]));
        return ids;
    }();
    return events[static_cast<std::size_t>(phase)];
}

PetscEventPerfInfo logged(const char* event) {
    PetscLogEvent id = -1;
    PetscEventPerfInfo info{};
    SOFT_PETSC(PetscLogEventGetId(event, &id));
    if (id >= 0) SOFT_PETSC(PetscLogEventGetPerfInfo(0, id, &info));
    return info;
}

ProfileRow row(const char* what, std::initializer_list<const char*> events) {
    ProfileRow result{what, 0, 0};
    for (const char* event : events) {
        const PetscEventPerfInfo info = logged(event);
        result.calls += info.count;
        result.seconds += info.time;
    }
    return result;
}

}  // namespace

ScopedTimer::ScopedTimer(Phase phase) : event_(event_of(phase)) {
    (void)PetscLogEventBegin(event_, nullptr, nullptr, nullptr, nullptr);
}

ScopedTimer::~ScopedTimer() { (void)PetscLogEventEnd(event_, nullptr, nullptr, nullptr, nullptr); }

void start_profile() {
    SOFT_PETSC(PetscLogDefaultBegin());
    for (std::size_t i = 0; i < phase_events.size(); ++i) (void)event_of(static_cast<Phase>(i));
}

std::vector<ProfileRow> profile_rows() {
    const ProfileRow triangular = row("triangular solves", {"MatSolve", name_of(Phase::factor_solve)});
    ProfileRow krylov = row("Krylov iterations, without triangular solves", {"KSPSolve"});
    krylov.seconds -= triangular.seconds;
    std::vector<ProfileRow> rows{
        row("residual assembly: cells, facets, loads", {name_of(Phase::residual)}),
        row("tangent assembly: cells, facets", {name_of(Phase::tangent)}),
        row("volumes, outputs, stretches", {name_of(Phase::measures)}),
        row("ordering of the unknowns", {"MatLUFactorSym", "MatCholFctrSym", name_of(Phase::ordering)}),
        row("factorisations", {"MatLUFactorNum", "MatCholFctrNum", name_of(Phase::factorization)}),
        triangular,
        krylov,
        row("contact search", {name_of(Phase::contact)}),
        row("writing of the result", {name_of(Phase::writing)}),
    };
    std::erase_if(rows, [](const ProfileRow& r) { return r.calls == 0; });
    return rows;
}

}  // namespace soft::linalg
