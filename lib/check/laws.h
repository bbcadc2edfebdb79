#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "trace/reason.h"
#include "trace/world.h"

/// The model as a table of steps, each of which can be exchanged for a convention or a mistake.
///
/// The tracer computes a tree in one go. Here the same is cut into the steps in which a student
/// computes it, so that each can be done anew from the student's own inputs: a wrong number is then
/// blamed on the step that made it and not on those that used it. `model_laws()` grows the trees
/// that the tracer grows, to the last bit (tests/check).
namespace raytree::check {

using Vec = Vec3<double>;
using Spectrum = Rgb<double>;
using Place = World<double>;

/// A ray on its way, and its hit as far as it is worked out. Steps are done in the order of the
/// members.
struct Step {
    const Step* parent = nullptr;  ///< the ray that hit, where this one starts
    RayKind kind = RayKind::primary;
    int level = 1;
    int pixel_i = 0, pixel_j = 0;
    Vec origin{}, direction{};
    double length = 1;  ///< that the direction has in programs that do not make it unit
    Spectrum weight{1.0};
    PrimitiveId leaving = no_primitive;
    double path = 0;                   ///< length from the eye to the origin
    std::vector<std::uint32_t> media;  ///< materials that it is inside, the last entered at the end

    double t = 0;
    PrimitiveId primitive = no_primitive;  ///< that it hits; none: nothing below is known
    std::uint32_t material_id = 0;
    const Material* material = nullptr;
    const WorldMaterial<double>* ready = nullptr;  ///< the material's products
    Vec outward{}, shading{};                      ///< unit normals, not yet turned to the ray
    Vec point{};
    /// The shape that what is sent from here starts on: none where the point lies beside it.
    PrimitiveId surface = no_primitive;
    bool front = true;
    Vec normal{};
    double eta1 = 1, eta2 = 1, sin2_transmitted = 0, cos2_transmitted = 1;
    Spectrum kr, kt;
    double attenuation = 1;

    bool hits() const { return primitive != no_primitive; }
    bool total_reflection() const { return ready->transmissive && cos2_transmitted < 0; }
    double cosine() const { return -inner(direction, normal); }
};

/// A light as it is seen from a hit.
struct Shine {
    std::size_t light = 0;
    const WorldLight<double>* ready = nullptr;
    Vec towards{};  ///< L
    double distance = Real<double>::infinity;
    double cosine = 0;  ///< n . L
    double blocker_t = 0;
    PrimitiveId blocker = no_primitive;
    Spectrum transmittance{1.0};
};

struct Beam {
    Vec origin{}, direction{};
};
struct Turned {
    Vec normal{};
    bool front = true;
};
struct Indices {
    double eta1 = 1, eta2 = 1;
};
struct Towards {
    Vec towards{};
    double distance = Real<double>::infinity;
};
struct Passage {
    Spectrum transmittance{1.0};
    PrimitiveId blocker = no_primitive;
    double t = 0;
};
/// What is added up for a hit's intensity. A branch that was not grown adds nothing.
struct Terms {
    struct Branch {
        bool grown = false;
        double attenuation = 1;
        Spectrum coefficient, intensity;
    };
    Spectrum ambient, diffuse, specular;
    Branch reflected, refracted;
};

/// One function for each step. They see the world and the ray with all steps before.
struct Laws {
    Beam (*primary)(const Place&, const Step&);
    Interval<double> (*interval)(const Place&, const Step&);
    std::optional<Hit<double>> (*meet)(const Place&, const Step&, Interval<double>);
    Vec (*point)(const Place&, const Step&, const Vec& on_surface);
    Turned (*normal)(const Place&, const Step&);
    Indices (*indices)(const Place&, const Step&);
    double (*fade)(const Place&, const Step&);  ///< f of the way to the hit
    Spectrum (*coefficient)(const Place&, const Step&, RayKind);
    Spectrum (*ambient)(const Place&, const Step&);
    Towards (*towards)(const Place&, const Step&, std::size_t light);
    bool (*faces)(const Step&, const Shine&);              ///< whether the light is asked at all
    Vec (*sent)(const Place&, const Step&, const Shine&);  ///< the direction of the shadow ray
    Passage (*shadow)(const Place&, const Step&, const Shine&);
    Spectrum (*diffuse)(const Place&, const Step&, const Shine&);
    Spectrum (*specular)(const Place&, const Step&, const Shine&);
    std::optional<Reason> (*why_not)(const Place&, const Step&, RayKind, const Spectrum& weight);
    Vec (*start)(const Place&, const Step&, RayKind);  ///< of a branch or a shadow ray
    Vec (*offset)(const Step&, RayKind);  ///< the way in which programs may put the start off
    int (*level)(const Place&, const Step&, RayKind);  ///< of a branch
    Vec (*reflected)(const Place&, const Step&);
    Vec (*refracted)(const Place&, const Step&);
    Spectrum (*miss)(const Place&, const Step&);
    Spectrum (*combine)(const Place&, const Step&, const Terms&);
    Spectrum (*weight)(const Step&, RayKind);  ///< of a branch
    /// By kind: whether a ray may meet the very surface it starts on, as rounding has it.
    std::array<bool, 4> may_meet_start{};

    bool operator==(const Laws&) const = default;
};

const Laws& model_laws();

/// The steps of the model, for those that change a little of them.
namespace model {
Beam primary(const Place&, const Step&);
Interval<double> interval(const Place&, const Step&);
std::optional<Hit<double>> meet(const Place&, const Step&, Interval<double>);
Turned normal(const Place&, const Step&);
Indices indices(const Place&, const Step&);
Spectrum coefficient(const Place&, const Step&, RayKind);
Towards towards(const Place&, const Step&, std::size_t light);
Vec sent(const Place&, const Step&, const Shine&);
Passage shadow(const Place&, const Step&, const Shine&);
Spectrum diffuse(const Place&, const Step&, const Shine&);
Spectrum specular(const Place&, const Step&, const Shine&);
std::optional<Reason> why_not(const Place&, const Step&, RayKind, const Spectrum& weight);
Vec offset(const Step&, RayKind);
Vec reflected(const Place&, const Step&);
Vec refracted(const Place&, const Step&);
Spectrum miss(const Place&, const Step&);
Spectrum combine(const Place&, const Step&, const Terms&);
Spectrum weight(const Step&, RayKind);

/// What of the light comes through the surfaces between a point and the light: all those hits that
/// lie in between, sorted by t.
Passage through(const Place& place, std::span<const Hit<double>> hits);

/// The largest power of two roundings that an origin may have.
double origin_error(const Vec& origin);
/// `v` made unit; as it is where it is that to the last bits, and where it has no direction.
Vec unit(const Vec& v);
}  // namespace model

/// How far from a surface a point may be, of the size of the ray's numbers, to be one of it: more
/// than rounding to a few digits does, less than any mistake.
constexpr double on_the_surface = 1e-4;

/// Works out what follows from a ray's hit on `primitive` at `t`: material and normals.
void land(const Place& place, const Laws& laws, Step& step, PrimitiveId primitive, double t);
/// Snell's law at the hit; of a normal that is not unit as the formulas with c1 have it.
void bend(Step& step, const Indices& indices);
/// The light `light` as the laws see it from the hit, before anything is in between.
Shine shine_of(const Place& place, const Laws& laws, const Step& step, std::size_t light);
/// Coefficients and indices at the hit, once the normal is known.
void settle(const Place& place, const Laws& laws, Step& step);
/// The branch that grows from a hit, its direction and origin by the laws.
Step branch_of(const Place& place, const Laws& laws, const Step& from, RayKind kind,
               const Spectrum& weight);

}  // namespace raytree::check
