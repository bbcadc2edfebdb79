#include <algorithm>
#include <cmath>

#include "check/branch_laws.h"
#include "check/catalogue.h"
#include "trace/shading.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "reflection";

const MistakeRow rows[] = {
    {"refl.plus", "d + 2 (d . n) n is written for d - 2 (d . n) n.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, 1, -2 * step.cosine());
         };
     }},
    {"refl.no_factor2", "The factor 2 is missing: the ray slides along the surface.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, 1, step.cosine());
         };
     }},
    {"refl.reversed", "The reflected ray is reversed: 2 (n . d) n - d.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, -1, -2 * step.cosine());
         };
     }},
    {"refl.componentwise", "d * n is multiplied component by component instead of d . n.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return step.direction - 2.0 * (step.direction * step.normal) * step.normal;
         };
     }},
    {"refl.swapped_args", "The arguments of reflect are exchanged: n - 2 (n . d) d.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             return mixed(step, 2 * step.cosine(), 1);
         };
     }},
    {"refl.along_normal", "The reflected ray goes along the normal.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) { return step.normal; };
     }},
    {"refl.backwards", "The reflected ray goes back where it came from.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) { return -step.direction; };
     }},
    {"refl.straight", "The reflected ray goes on straight.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) { return step.direction; };
     }},
    {"refl.uses_point", "The hit point is used for the normal.", topic,
     [](Laws& laws) {
         laws.reflected = [](const Place&, const Step& step) {
             const Vec n = model::unit(step.point);
             return step.direction - 2 * inner(step.direction, n) * n;
         };
     }},
    {"refl.no_offset",
     "The reflected ray meets the surface that it starts on.",
     topic,
     [](Laws& laws) { laws.meet = own_surface<RayKind::reflected>; },
     {may_meet_own_start<RayKind::reflected>}},
    {"refl.offset_inside",
     "The reflected ray starts a little below the surface and meets it again.", topic,
     on_the_wrong_side<RayKind::reflected>},
    {"refl.from_eye", "The reflected ray starts at the eye.", topic,
     [](Laws& laws) { laws.start = from_eye<RayKind::reflected>; }},
    {"refl.kr_missing", "What is reflected is not multiplied by kr.", topic,
     [](Laws& laws) {
         share_by<RayKind::reflected>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(1.0); });
     }},
    {"refl.kr_squared", "What is reflected is multiplied by kr twice.", topic,
     [](Laws& laws) {
         share_by<RayKind::reflected>(laws, [](const Step&, const Spectrum& k) { return k * k; });
     }},
    {"refl.times_base", "What is reflected takes the surface's colour.", topic,
     [](Laws& laws) {
         share_by<RayKind::reflected>(
             laws, [](const Step& step, const Spectrum& k) { return step.material->color * k; });
     }},
    {"refl.ks_for_kr", "What is reflected is multiplied by ks instead of kr.", topic,
     [](Laws& laws) {
         share_by<RayKind::reflected>(
             laws, [](const Step& step, const Spectrum&) { return step.material->ks; });
     }},
    {"refl.kt_for_kr", "What is reflected is multiplied by kt instead of kr.", topic,
     [](Laws& laws) {
         share_by<RayKind::reflected>(
             laws, [](const Step& step, const Spectrum&) { return step.material->kt; });
     }},
    {"refl.not_added", "What is reflected is traced but not added.", topic,
     [](Laws& laws) {
         share_by<RayKind::reflected>(laws,
                                      [](const Step&, const Spectrum&) { return Spectrum(0.0); });
     }},
    {"refl.only_outside", "Nothing is reflected on the inside of a surface.", topic,
     [](Laws& laws) { laws.why_not = without<RayKind::reflected, true>; }},
    {"refl.missing_child", "No reflected rays are sent.", topic,
     [](Laws& laws) { laws.why_not = without<RayKind::reflected, false>; }},
};

}  // namespace

std::span<const MistakeRow> reflection_mistakes() { return rows; }

}  // namespace raytree::check
