#include "material/catalogue.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "material/response.hpp"

namespace soft::material {
namespace {

template <class... L>
std::vector<LawInfo> infos_of(std::tuple<L...>*) {
    return {L::info()...};
}

[[noreturn]] void refuse(std::string_view location, const std::string& problem, const std::string& remedy = {}) {
    throw Error(ExitCode::bad_input, std::string(location), problem, remedy);
}

double fallback_value(const Parameter& parameter) {
    double value = 0;  // a plain number, or one in the SI unit: checked by catalogue_test
    std::from_chars(parameter.fallback.data(), parameter.fallback.data() + parameter.fallback.size(), value);
    return value;
}

/// The constants with default values added. Throws unless all parameters are present and in range, and nothing else is given.
Constants checked(const LawInfo& law, const Constants& given) {
    Constants constants;
    for (const Parameter& parameter : law.parameters) {
        const auto found = given.find(parameter.name);
        if (found == given.end() || found->second.empty()) {
            if (parameter.fallback.empty())
                refuse(parameter.name, "the law " + std::string(law.name) + " needs this constant",
                       "for example " + std::string(parameter.example));
            constants[std::string(parameter.name)] = {fallback_value(parameter)};
            continue;
        }
        if (found->second.size() > static_cast<std::size_t>(parameter.max_count))
            refuse(parameter.name, std::to_string(found->second.size()) + " values are too many",
                   "at most " + std::to_string(parameter.max_count));
        for (const double value : found->second) {
            const bool low = parameter.min_open ? !(value > parameter.min) : !(value >= parameter.min);
            if (low || !(value <= parameter.max))
                refuse(parameter.name, core::number_text(value) + " (SI) is outside its range",
                       std::string(parameter.meaning));
        }
        constants[std::string(parameter.name)] = found->second;
    }
    for (const auto& [name, values] : given)
        if (!constants.contains(name)) refuse(name, "the law " + std::string(law.name) + " has no such constant");
    return constants;
}

void check(const Fibers& fibers) {
    constexpr double right_angle_rad = 1.5707963267948966;
    if (!(fibers.angle_rad >= 0.0 && fibers.angle_rad <= right_angle_rad))
        refuse("fibers.angle", core::number_text(fibers.angle_rad) + " rad is outside its range",
               "use 0 to 90 degrees from the axis");
    if (!(fibers.k1_Pa > 0.0)) refuse("fibers.k1", core::number_text(fibers.k1_Pa) + " Pa is not positive");
    if (!(fibers.k2 > 0.0)) refuse("fibers.k2", core::number_text(fibers.k2) + " is not positive");
    if (fibers.families != 1 && fibers.families != 2)
        refuse("fibers.families", std::to_string(fibers.families) + " is not supported", "use 1 or 2");
}

template <Law L>
std::optional<Fibers> fibers_in(const Constants& constants, const Description& description) {
    const std::string law = "the law " + std::string(L::info().name);
    if constexpr (FiberLaw<L>) {
        if (description.fibers) refuse("fibers", law + " already has fibres", "use a law without fibres");
        return L::fibers_from(constants);
    } else {
        if (!description.fibers) return std::nullopt;
        if (!MayHaveFibers<L>)
            refuse("fibers", law + " has no finite-strain energy to which fibres can be added",
                   "use neo-hookean, for example");
        check(*description.fibers);
        return description.fibers;
    }
}

void check(const Inelastic& inelastic) {
    constexpr const char* times = "viscoelastic.times";
    if (inelastic.moduli.size() != inelastic.times_s.size())
        refuse(times,
               std::to_string(inelastic.times_s.size()) + " times for " + std::to_string(inelastic.moduli.size()) +
                   " moduli",
               "write one time for each modulus");
    for (const double g : inelastic.moduli)
        if (!(g >= 0.0)) refuse("viscoelastic.moduli", core::number_text(g) + " is negative");
    for (const double tau : inelastic.times_s)
        if (!(tau > 0.0)) refuse(times, core::number_text(tau) + " s is not positive");
    if (!inelastic.softening) return;
    const auto& [r, m_Pa, beta] = *inelastic.softening;
    if (!(r > 1.0))
        refuse("softening.r", core::number_text(r) + " is not above 1", "at 1 the rubber could lose all its stiffness");
    if (!(m_Pa > 0.0)) refuse("softening.m", core::number_text(m_Pa) + " Pa is not positive");
    if (!(beta >= 0.0)) refuse("softening.beta", core::number_text(beta) + " is negative");
}

template <Law L>
std::optional<Inelastic> inelastic_in(const Description& description) {
    if (!description.inelastic) return std::nullopt;
    if (!MayBeInelastic<L>)
        refuse(description.inelastic->moduli.empty() ? "softening" : "viscoelastic",
               "the law " + std::string(L::info().name) + " has no isochoric energy that could relax or soften",
               "use neo-hookean, yeoh or ogden, for example");
    check(*description.inelastic);
    return description.inelastic;
}

template <Law L>
Rubber<L> rubber_of(const Constants& constants, const Description& description) {
    Rubber<L> rubber{L::from(constants),
                     description.volumetric,
                     0.0,
                     description.fiber_frame,
                     fibers_in<L>(constants, description),
                     inelastic_in<L>(description)};
    if (!(rubber.law.initial_shear_modulus_Pa() > 0.0))
        refuse(L::info().parameters.front().name, "the initial shear modulus is not positive",
               "check the signs of the constants");
    if (!description.bulk_modulus_Pa) {
        if (L::info().bulk == Bulk::finite)
            refuse("kappa", "the law " + std::string(L::info().name) + " has no incompressible form",
                   "give a bulk modulus");
        return rubber;
    }
    double modulus_Pa = *description.bulk_modulus_Pa;
    if constexpr (requires { rubber.law.dilatation_modulus_Pa(modulus_Pa); })
        modulus_Pa = rubber.law.dilatation_modulus_Pa(modulus_Pa);
    if (!(modulus_Pa > 0.0))
        refuse("kappa",
               core::number_text(*description.bulk_modulus_Pa) + " Pa is too small for the law " +
                   std::string(L::info().name),
               "use a bulk modulus far above the shear modulus");
    if constexpr (requires { rubber.law.kappa_Pa; }) rubber.law.kappa_Pa = modulus_Pa;
    rubber.inverse_bulk_modulus = 1.0 / modulus_Pa;
    return rubber;
}

/// make(L*) of the law L with this entry of the table.
template <class Make, class... L>
AnyRubber made_by(const Make& make, const LawInfo& law, std::tuple<L...>*) {
    static constexpr std::array<AnyRubber (*)(const Make&), sizeof...(L)> makers{
        [](const Make& m) -> AnyRubber { return m(static_cast<L*>(nullptr)); }...};
    return makers.at(static_cast<std::size_t>(&law - laws().data()))(make);
}

}  // namespace

std::span<const LawInfo> laws() {
    static const std::vector<LawInfo> table = infos_of(static_cast<LawList*>(nullptr));
    return table;
}

const LawInfo* find_law(std::string_view name) {
    const auto table = laws();
    const auto law = std::ranges::find(table, name, &LawInfo::name);
    return law == table.end() ? nullptr : &*law;
}

AnyRubber make_rubber(const Description& description) {
    const LawInfo* law = find_law(description.law);
    if (law == nullptr) {
        std::vector<std::string> names;
        for (const LawInfo& known : laws()) names.emplace_back(known.name);
        refuse("law", "no law is called '" + std::string(description.law) + "'",
               core::did_you_mean(description.law, names));
    }
    const Constants constants = checked(*law, description.constants);
    return made_by([&]<class L>(L*) { return rubber_of<L>(constants, description); }, *law,
                   static_cast<LawList*>(nullptr));
}

AnyRubber make_unchecked_rubber(std::string_view law, Constants constants) {
    const LawInfo& info = *find_law(law);
    for (const Parameter& parameter : info.parameters)
        if (!parameter.fallback.empty())
            constants.try_emplace(std::string(parameter.name), 1, fallback_value(parameter));
    return made_by([&]<class L>(L*) { return Rubber<L>{.law = L::from(constants)}; }, info,
                   static_cast<LawList*>(nullptr));
}

std::string explain_incompatibility(const AnyRubber& rubber, Form form) {
    const LawInfo& law = info_of(rubber);
    const std::string name = "the law " + std::string(law.name);
    if (form == Form::mixed)
        return law.mixed ? ""
                         : name + " is a stress without an energy and has no mixed form; use formulation displacement";
    if (form == Form::f_bar && !law.f_bar)
        return name + " has no F-bar form; use formulation displacement" + (law.mixed ? " or mixed" : "");
    if (bulk_modulus_Pa(rubber)) return {};
    return "an incompressible rubber needs the pressure as an unknown; use formulation mixed, or give kappa";
}

double initial_shear_modulus_Pa(const AnyRubber& rubber) {
    return std::visit([](const auto& r) { return r.law.initial_shear_modulus_Pa(); }, rubber);
}

std::optional<double> bulk_modulus_Pa(const AnyRubber& rubber) {
    const double inverse = std::visit([](const auto& r) { return r.inverse_bulk_modulus; }, rubber);
    return inverse > 0.0 ? std::optional(1.0 / inverse) : std::nullopt;
}

const LawInfo& info_of(const AnyRubber& rubber) { return laws()[rubber.index()]; }

double reference_stress_Pa(const AnyRubber& rubber) {
    double largest = 0;
    std::visit(
        [&]<class L>(const Rubber<L>& r) {
            if constexpr (StressLaw<L>) {  // laws with an energy are free of stress in the undeformed state
                PointResponse point;
                displacement_response(r, {}, identity_tensor, Wanted::stress, point);
                for (const double P : point.first_piola) largest = std::max(largest, std::abs(P));
            }
        },
        rubber);
    return largest;
}

const std::optional<Fibers>& fibers_of(const AnyRubber& rubber) {
    return std::visit([](const auto& r) -> const std::optional<Fibers>& { return r.fibers; }, rubber);
}

const Inelastic* inelastic_of(const AnyRubber& rubber) {
    return std::visit([](const auto& r) { return r.inelastic ? &*r.inelastic : nullptr; }, rubber);
}

bool has_symmetric_tangent(const AnyRubber& rubber) {
    return std::visit([]<class L>(const Rubber<L>&) { return !StressLaw<L>; }, rubber);
}

}  // namespace soft::material
