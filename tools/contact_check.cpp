#include "contact_check.hpp"

#include <mpi.h>

#include <memory>

#include "linalg/profile.hpp"
#include "surface/contact.hpp"

namespace soft::cli {
namespace {

/// nullopt: none. The length -1 stands for that on the way.
std::optional<std::string> from_first_rank(const std::optional<std::string>& found, MPI_Comm comm) {
    int length = found ? static_cast<int>(found->size()) : -1;
    MPI_Bcast(&length, 1, MPI_INT, 0, comm);
    if (length < 0) return std::nullopt;
    std::string text = found.value_or("");
    text.resize(static_cast<std::size_t>(length));
    MPI_Bcast(text.data(), length, MPI_CHAR, 0, comm);
    return text;
}

}  // namespace

solver::ContactCheck contact_check(assembly::System& system) {
    if (system.input().path.contact == model::Contact::ignore) return {};
    int rank = 0;
    MPI_Comm_rank(system.comm(), &rank);
    // std::function copies what it holds; a finder is made once and cannot be copied.
    const auto finder = rank == 0 ? std::make_shared<const surface::ContactFinder>(system.input()) : nullptr;
    return [&system, finder](Vec x) {
        const auto fields = system.gather_fields(x);
        std::optional<std::string> found;
        const linalg::Timed timed(linalg::Phase::contact);
        if (finder)
            if (auto contact = finder->find(fields.displacement_m)) found = std::move(contact->text);
        return from_first_rank(found, system.comm());
    };
}

}  // namespace soft::cli
