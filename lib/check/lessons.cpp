#include "check/lessons.h"

#include <algorithm>
#include <array>

namespace raytree::check {
namespace {

constexpr std::array<Lesson, 14> lessons = {{
    {3, "The ray through a pixel"},
    {4, "A ray and a sphere"},
    {5, "A ray and a polygon"},
    {6, "World space and eye space"},
    {7, "Hidden surfaces, by rays and by z-buffer"},
    {8, "The first ray tree"},
    {9, "The reflected direction"},
    {10, "The refracted direction and total internal reflection"},
    {11, "Shadows by rays"},
    {12, "Illumination of the tree, from the bottom up"},
    {13, "Attenuation by distance"},
    {14, "Where a tree ends"},
    {16, "Why nothing can be culled"},
    {21, "When numbers fail"},
}};

struct Rule {
    std::string_view prefix;  ///< of the mistake's id; the first that fits holds
    int lesson;
};

constexpr Rule rules[] = {
    {"cam.lookat", 6},
    {"cam.looks", 6},
    {"cam.up", 6},
    {"cam.right", 6},
    {"cam.forward", 6},
    {"cam.", 3},
    {"num.int", 3},
    {"isect.plane", 5},
    {"isect.polygon", 5},
    {"isect.last", 7},
    {"isect.first", 7},
    {"isect.farthest", 7},
    {"isect.backface", 16},
    {"isect.t_int", 21},
    {"isect.bool", 3},
    {"isect.", 4},
    {"eps.", 21},
    {"num.", 21},
    {"hit.beyond", 3},
    {"hit.point_from_eye", 9},
    {"hit.near", 16},
    {"hit.primary", 3},
    {"hit.", 4},
    {"nrm.flat", 5},
    {"nrm.inverted", 9},
    {"nrm.", 4},
    {"shd.no_offset", 21},
    {"shd.offset", 21},
    {"shd.skip_self", 21},
    {"shd.only_first_light", 12},
    {"shd.directional", 16},
    {"shd.", 11},
    {"lit.att", 13},
    {"lit.", 12},
    {"refl.no_offset", 21},
    {"refl.offset", 21},
    {"refl.kr", 12},
    {"refl.ks", 12},
    {"refl.kt", 12},
    {"refl.times", 12},
    {"refl.not_added", 12},
    {"refl.missing", 8},
    {"refl.only", 8},
    {"refl.from_eye", 8},
    {"refl.", 9},
    {"refr.no_offset", 21},
    {"refr.offset", 21},
    {"refr.kr", 12},
    {"refr.kt", 12},
    {"refr.times", 12},
    {"refr.one_minus", 12},
    {"refr.not_added", 12},
    {"refr.missing", 8},
    {"refr.only", 8},
    {"refr.from_eye", 8},
    {"refr.", 10},
    {"rec.fade", 13},
    {"rec.depth", 14},
    {"rec.min_weight", 14},
    {"rec.max_distance", 14},
    {"rec.never_ends", 14},
    {"rec.distance", 14},
    {"rec.", 12},
    {"bg.", 14},
    {"out.row", 3},
    {"out.column", 3},
    {"out.turned", 3},
    {"out.", 12},
    {"", 8},
};

}  // namespace

std::string Lesson::name() const {
    return (number < 10 ? "0" : "") + std::to_string(number) + ' ' + std::string(title);
}

const Lesson& lesson_of(std::string_view mistake) {
    const Rule& rule = *std::ranges::find_if(
        rules, [&](const Rule& each) { return mistake.starts_with(each.prefix); });
    return *std::ranges::find(lessons, rule.lesson, &Lesson::number);
}

}  // namespace raytree::check
